// SPDX-License-Identifier: MIT
//
// The cheapest rung that is accurate enough, chosen at compile time.
//
// Each part of the library has its families beside what they compute (number/sine_rungs.hpp, raster/
// line_rungs.hpp, ...); this header and its table know them by name only.
//
// Rule: of the rungs of a family whose stated bound isn't above the one asked for, the one with the fewest
// instructions on a core, as the accuracy lab counted them; among equals the more accurate, then the first in
// the family's list. The figures are a table that ships with the library, so a program's choice follows when
// rungs are added or counted again, and the bound that it asked for still holds.
//
// What can't be answered doesn't compile, and the message says why: NoRungIsThatAccurate names the best there
// is and its bound, BoundIsInAnotherUnit the family's unit, RungIsNotMeasured a rung that the table lacks.
#pragma once

#include <intaglio/number/bound.hpp>
#include <intaglio/number/core.hpp>
#include <intaglio/number/measured_costs.hpp>
#include <intaglio/number/type_name.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <tuple>

namespace intaglio::number {

namespace detail {

template <class...>
inline constexpr bool never = false;

/// `Best` is the most accurate rung of the family, `thousandths` and `unit` its bound.
template <class Best, std::int32_t thousandths, Unit unit>
struct NoRungIsThatAccurate {
  static_assert(never<Best>,
                "no rung of this family meets the bound: NoRungIsThatAccurate<the best there is, its bound>");
};

template <Unit of_the_family, Unit of_the_bound>
struct BoundIsInAnotherUnit {
  static_assert(
      of_the_family == of_the_bound,
      "the bound is in another unit than the family's: BoundIsInAnotherUnit<the family's, the bound's>");
};

template <class Rung>
struct RungIsNotMeasured {
  static_assert(
      never<Rung>,
      "this rung isn't in the table of costs beside the others of the family: run `intaglio-lab run` and "
      "`intaglio-lab accept`");
};

struct Candidate {
  Bound bound;
  std::int64_t cost;
};

/// What a rung costs in a family of the table; below 0 if it has not exactly one row there.
template <std::size_t Rows>
[[nodiscard]] constexpr std::int64_t cost_of(std::string_view family, std::string_view rung, Core core,
                                             const std::array<MeasuredCost, Rows>& costs) noexcept {
  std::int64_t found = -1;
  for (const MeasuredCost& row : costs) {
    if (row.rung != rung || row.family != family) continue;
    if (found >= 0) return -1;
    found = row.hundredths[static_cast<std::size_t>(core)];
  }
  return found;
}

/// The family of the table that has all of these rungs, for a rung may stand in several; among such the one
/// with the fewest others. If there is none, one that has the first rung.
template <std::size_t N, std::size_t Rows>
[[nodiscard]] constexpr std::string_view family_of(const std::array<std::string_view, N>& rungs, Core core,
                                                   const std::array<MeasuredCost, Rows>& costs) noexcept {
  std::string_view found;
  std::size_t fewest = Rows + 1;
  for (const MeasuredCost& row : costs) {
    if (row.rung != rungs[0]) continue;
    std::size_t size = 0;
    for (const MeasuredCost& other : costs) size += other.family == row.family ? 1U : 0U;
    for (const std::string_view rung : rungs) {
      if (cost_of(row.family, rung, core, costs) < 0) size = Rows + 1;
    }
    if (size < fewest || found.empty()) {
      found = row.family;
      fewest = size;
    }
  }
  return found;
}

/// The unit that a family's errors are in: an exact rung's says nothing if there are others.
template <std::size_t N>
[[nodiscard]] constexpr Unit unit_of(const std::array<Candidate, N>& candidates) noexcept {
  for (const Candidate& candidate : candidates) {
    if (!candidate.bound.exact()) return candidate.bound.unit;
  }
  return candidates[0].bound.unit;
}

template <class Family, Core core, Bound asked, const auto& costs>
struct Cheapest;

template <class... R, Core core, Bound asked, const auto& costs>
struct Cheapest<Family<R...>, core, asked, costs> {
  static constexpr std::array<std::string_view, sizeof...(R)> names{type_name<R>()...};
  static constexpr std::string_view family = family_of(names, core, costs);
  static constexpr std::array<Candidate, sizeof...(R)> candidates{
      Candidate{R::bound, cost_of(family, type_name<R>(), core, costs)}...};
  static constexpr Unit unit = unit_of(candidates);

  /// The first of those candidates that no other is better than; `better(a, b)`: a is better than b.
  template <class Better>
  [[nodiscard]] static constexpr std::size_t best(Better better) noexcept {
    std::size_t found = 0;
    for (std::size_t i = 1; i < candidates.size(); ++i) {
      if (better(candidates[i], candidates[found])) found = i;
    }
    return found;
  }
  [[nodiscard]] static constexpr bool meets(const Candidate& candidate) noexcept {
    return candidate.bound.exact() ||
           (candidate.bound.unit == asked.unit && candidate.bound.thousandths <= asked.thousandths);
  }
  [[nodiscard]] static constexpr bool cheaper(const Candidate& a, const Candidate& b) noexcept {
    if (meets(a) != meets(b)) return meets(a);
    return a.cost < b.cost || (a.cost == b.cost && a.bound.thousandths < b.bound.thousandths);
  }
  [[nodiscard]] static constexpr bool finer(const Candidate& a, const Candidate& b) noexcept {
    return a.bound.thousandths < b.bound.thousandths;
  }
  [[nodiscard]] static constexpr std::size_t unmeasured() noexcept {
    std::size_t i = 0;
    while (i < candidates.size() && candidates[i].cost >= 0) ++i;
    return i;
  }

  template <std::size_t i>
  using At = std::tuple_element_t<i, std::tuple<R...>>;

  [[nodiscard]] static constexpr auto chosen() noexcept {
    if constexpr (unmeasured() < sizeof...(R)) {
      return RungIsNotMeasured<At<unmeasured()>>{};
    } else if constexpr (!asked.exact() && unit != asked.unit) {
      return BoundIsInAnotherUnit<unit, asked.unit>{};
    } else if constexpr (constexpr std::size_t first = best(cheaper); meets(candidates[first])) {
      return At<first>{};
    } else {
      constexpr std::size_t finest = best(finer);
      constexpr Bound bound = candidates[finest].bound;
      return NoRungIsThatAccurate<At<finest>, bound.thousandths, bound.unit>{};
    }
  }
};

}  // namespace detail

/// The rung of a family that costs the fewest instructions on a core and is off by at most `bound`:
/// `cheapest<SineFamily, Core::cortex_m3, lsb_q15(2000)>`. A bound of 0 asks for an exact rung and may be in
/// any unit. `costs` is an array of MeasuredCost with a row for each rung, where the library's own won't do.
template <class Family, Core core, Bound bound, const auto& costs = measured_costs>
using cheapest = decltype(detail::Cheapest<Family, core, bound, costs>::chosen());

}  // namespace intaglio::number
