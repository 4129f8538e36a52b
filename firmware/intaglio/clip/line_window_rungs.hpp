// SPDX-License-Identifier: MIT
//
// Ways to clip a line segment to a window, with ends rounded to 1/256 pixel.
//
// Rule: what of a segment from a to b lies in the closed window, or nothing. The rungs are Liang and Barsky's
// way with parameters rounded to 16 or 32 fraction bits, and the three exact clippers of line_window.hpp,
// whose ends are rounded once.
//
// Error: how far an end is from its exact place, in pixels. An exact end lies on a side of the window, so one
// coordinate is rounded: 1/512. A rounded parameter is half a unit of its last place off, so an end by that
// share of the segment and by the rounding on each axis: sqrt(2) * (1/512 + L * 2^-(bits + 1)), where
// coordinates differ by up to L = 2^21 pixels. Bit budget: differences 2^29, products with parameters 2^62.
// Textbook: section 2.9.2. Worst known inputs: the longest segments along a diagonal, and, with 16 bits,
// segments through a corner, which are lost or found; so may be what crosses a window of negative extent.
#pragma once

#include <intaglio/clip/line_window.hpp>
#include <intaglio/linear/point.hpp>
#include <intaglio/linear/sub_rect.hpp>
#include <intaglio/number/bound.hpp>
#include <intaglio/number/long_division.hpp>
#include <intaglio/status.hpp>

#include <algorithm>
#include <cstdint>

namespace intaglio::clip {

/// The ends of what is inside, if anything is.
struct ClippedEnds {
  bool visible = false;
  linear::SubPoint from{};
  linear::SubPoint to{};
  friend constexpr bool operator==(const ClippedEnds&, const ClippedEnds&) noexcept = default;
};

namespace detail {

/// Parameters rounded to so many fraction bits, up to 32.
template <int fraction_bits>
struct RoundedParameters {
  /// Arguments and errors as `liang_barsky`.
  [[nodiscard]] Result<ClippedEnds> operator()(linear::SubPoint a, linear::SubPoint b,
                                               const linear::SubRect& window) const noexcept {
    if (!linear::in_domain(a) || !linear::in_domain(b)) return Status{Error::out_of_domain, Argument::point};
    if (!linear::in_domain(window)) return Status{Error::out_of_domain, Argument::rectangle};
    std::int64_t enter = 0;
    std::int64_t leave = one;
    const int dx = b.x - a.x;
    const int dy = b.y - a.y;
    if (!cut(-dx, a.x - window.x, enter, leave) || !cut(dx, window.right() - a.x, enter, leave) ||
        !cut(-dy, a.y - window.y, enter, leave) || !cut(dy, window.bottom() - a.y, enter, leave))
      return ClippedEnds{};
    return ClippedEnds{
        true, {along(a.x, dx, enter), along(a.y, dy, enter)}, {along(a.x, dx, leave), along(a.y, dy, leave)}};
  }

 private:
  static constexpr std::int64_t one = std::int64_t{1} << fraction_bits;

  /// Leaves the parameters t with t * p <= q; false if there are none.
  static bool cut(int p, int q, std::int64_t& enter, std::int64_t& leave) noexcept {
    if (p == 0) return q >= 0;
    const bool entering = p < 0;
    const int numerator = entering ? -q : q;
    const int denominator = entering ? -p : p;
    if (numerator <= 0) return entering || numerator == 0 ? stays(entering, 0, enter, leave) : false;
    if (numerator >= denominator)
      return !entering || numerator == denominator ? stays(entering, one, enter, leave) : false;
    const std::uint64_t scaled =
        (static_cast<std::uint64_t>(numerator) << static_cast<unsigned>(fraction_bits)) +
        static_cast<unsigned>(denominator) / 2;
    const std::int64_t t = number::long_divide(scaled, static_cast<std::uint32_t>(denominator)).quotient;
    return stays(entering, t, enter, leave);
  }
  static bool stays(bool entering, std::int64_t t, std::int64_t& enter, std::int64_t& leave) noexcept {
    if (entering)
      enter = std::max(enter, t);
    else
      leave = std::min(leave, t);
    return enter <= leave;
  }
  static int along(int from, int way, std::int64_t t) noexcept {
    return from + static_cast<int>((way * t + one / 2) >> static_cast<unsigned>(fraction_bits));
  }
};

/// What the exact clippers have in common.
template <auto clipper>
struct ExactClipper {
  static constexpr number::Bound bound = number::pixels(2);
  /// Arguments and errors as the clipper's.
  [[nodiscard]] Result<ClippedEnds> operator()(linear::SubPoint a, linear::SubPoint b,
                                               const linear::SubRect& window) const noexcept {
    const auto line = clipper(a, b, window);
    if (!line.ok()) return line.status();
    if (!line.value().visible) return ClippedEnds{};
    return ClippedEnds{true, nearest(line.value().from), nearest(line.value().to)};
  }
};

}  // namespace detail

struct Parameters16 : detail::RoundedParameters<16> {
  static constexpr number::Bound bound = number::pixels(22'631);
};
struct Parameters32 : detail::RoundedParameters<32> {
  static constexpr number::Bound bound = number::pixels(4);
};
struct LiangBarsky : detail::ExactClipper<liang_barsky> {};
struct CohenSutherland : detail::ExactClipper<cohen_sutherland> {};
struct Skala : detail::ExactClipper<skala> {};

/// The rungs of clipped lines, cheapest first.
using LineWindowFamily = number::Family<Parameters16, Parameters32, LiangBarsky, CohenSutherland, Skala>;

}  // namespace intaglio::clip
