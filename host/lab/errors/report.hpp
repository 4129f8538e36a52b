// SPDX-License-Identifier: MIT
//
// How far off the rungs of a family are: the search for the worst input.
//
// Rule: a family's program (errors/FAMILY.cpp) says which points of the domain are looked at under a load,
// and how far off a rung is at one of them, reckoned without the library. All rungs see the same points. Kept
// are the worst error, where it was first met, and the mean over all points.
#pragma once

#include <intaglio/number/type_name.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <firmware/lab/family.hpp>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace host::lab {

using namespace ::lab;

/// How many random points a search takes.
class Effort {
 public:
  constexpr explicit Effort(bool full) noexcept : full_(full) {}
  /// True: all that the project promises. False: enough to see that every rung still works.
  [[nodiscard]] constexpr bool full() const noexcept { return full_; }
  /// So many points in a full search, a thousandth of them otherwise.
  [[nodiscard]] constexpr std::int64_t random(std::int64_t full_points) const noexcept {
    return full_ ? full_points : std::max<std::int64_t>(full_points / 1000, 100);
  }
  /// The step through an exhaustive search: every point, or one of so many (an odd number, so that all bits
  /// vary).
  [[nodiscard]] constexpr std::int64_t stride(std::int64_t quick_stride) const noexcept {
    return full_ ? 1 : quick_stride;
  }

 private:
  bool full_;
};

/// What a search found.
struct Measured {
  long double worst = 0;
  long double mean = 0;
  std::string worst_input;
  std::uint64_t points = 0;
  /// Which points these were, in words.
  std::string how;
};

struct RungReport {
  std::string name;
  std::string slack;                  ///< Why the bound isn't tight, if it isn't.
  std::string domain;                 ///< Which inputs it takes, if not all of the family's.
  std::vector<number::Bound> bounds;  ///< One a load.
  std::vector<bool> takes;            ///< Under which loads it is measured.
  std::function<Measured(int load, Effort effort)> measure;
  /// The error at one input, as printed by a search.
  std::function<long double(int load, std::string_view input)> replay;
  /// Draws what a count draws on the canvas.
  std::function<void(int load)> draw;
};

struct LoadReport {
  std::string name;
  int calls = 0;
  std::int64_t units = 0;
};

struct FamilyReport {
  std::string name;
  std::string title;
  std::string per;
  std::string default_rung;
  std::vector<LoadReport> loads;
  std::vector<RungReport> rungs;
};

namespace detail {

template <std::size_t N>
[[nodiscard]] std::string text_of(const std::array<std::int64_t, N>& numbers) {
  std::string text;
  for (const std::int64_t number : numbers) text += (text.empty() ? "" : " ") + std::to_string(number);
  return text;
}

template <std::size_t N>
[[nodiscard]] std::array<std::int64_t, N> numbers_of(std::string_view text) {
  std::array<std::int64_t, N> numbers{};
  const char* at = text.data();
  const char* end = at + text.size();
  for (std::int64_t& number : numbers) {
    while (at != end && *at == ' ') ++at;
    const auto [next, error] = std::from_chars(at, end, number);
    if (error != std::errc{}) throw std::runtime_error("an input here is " + std::to_string(N) + " integers");
    at = next;
  }
  if (at != end) throw std::runtime_error("an input here is " + std::to_string(N) + " integers");
  return numbers;
}

template <class E, class R>
[[nodiscard]] Measured search(int load, Effort effort) {
  Measured found;
  long double sum = 0;
  typename E::Case worst{};
  found.how = E::cases(load, effort, [&](const typename E::Case& c) {
    const long double error = E::template error<R>(load, c);
    if (error > found.worst || found.points == 0) {
      found.worst = error;
      worst = c;
    }
    sum += error;
    ++found.points;
  });
  if (found.points == 0) throw std::runtime_error("no point was looked at");
  found.mean = sum / static_cast<long double>(found.points);
  found.worst_input = text_of(worst);
  return found;
}

template <class E, class R>
[[nodiscard]] RungReport rung_report() {
  using F = typename E::Family;
  RungReport rung;
  rung.name = number::type_name<R>();
  rung.slack = slack<F, R>();
  if constexpr (requires { R::domain; }) rung.domain = R::domain;
  for (int load = 0; load < static_cast<int>(std::size(F::loads)); ++load) {
    rung.bounds.push_back(bound<F, R>(load));
    rung.takes.push_back(takes<F, R>(load));
  }
  rung.measure = search<E, R>;
  rung.replay = [](int load, std::string_view input) {
    return static_cast<long double>(
        E::template error<R>(load, numbers_of<std::tuple_size_v<typename E::Case>>(input)));
  };
  rung.draw = [](int load) {
    prepare<F>(load);
    if (!takes<F, R>(load)) return;
    for (int i = 0; i < F::loads[load].calls; ++i) F::template run<R>(F::input(load, i));
  };
  return rung;
}

template <class E, class... R>
[[nodiscard]] std::vector<RungReport> rung_reports(number::Family<R...> /*rungs*/) {
  return {rung_report<E, R>()...};
}

}  // namespace detail

/// All that there is to know of a family. E has `Family`, `Case` (an array of std::int64_t: a point of the
/// domain), `cases(load, effort, visit)`, which visits the points and says which they were, and
/// `error<R>(load, case)` in the unit of the bound.
template <class E>
[[nodiscard]] FamilyReport report() {
  using F = typename E::Family;
  FamilyReport family{std::string(F::name),
                      std::string(F::title),
                      std::string(per<F>()),
                      std::string(number::type_name<typename F::Default>()),
                      {},
                      detail::rung_reports<E>(typename F::Rungs{})};
  for (int load = 0; load < static_cast<int>(std::size(F::loads)); ++load) {
    LoadReport of_load{std::string(F::loads[load].name), F::loads[load].calls, 0};
    for (int i = 0; i < of_load.calls; ++i) of_load.units += units<F>(F::input(load, i));
    family.loads.push_back(std::move(of_load));
  }
  return family;
}

/// Each family's program defines this.
[[nodiscard]] FamilyReport family_report();

}  // namespace host::lab
