// SPDX-License-Identifier: MIT
//
// Scaled blit: stretches or shrinks a picture to a rectangle of a surface.
//
// Rule: the centre of a destination pixel, carried back, says which source pixel it shows. For a source of w
// columns and a destination of W columns from x0 on, column x shows the source's column
//   floor((2 (x - x0) + 1) w / 2W),   x0 <= x < x0 + W,
// and rows alike. That lies in 0 .. w-1, so nothing outside the source is ever read; W = k w shows every
// column k times, W = w is a plain blit. The rule of blit.hpp (colour key, table) says what becomes of it.
//
// Columns step by quotient and remainder from the first visible one, which is divided out exactly: no drift
// at any length, and a clipped or banded picture is the whole one, cut.
//
// Bit budget: w <= 2^20, W <= 2^21; (2 (x - x0) + 1) w < 2^42; remainders stay below 2W <= 2^22.
// Error: none. Cost: two short divisions for columns and for rows, then every visible pixel once; what isn't
// visible costs nothing.
// Worst known input: 1x1 stretched to 2^21 x 2^21 around a small window.
#pragma once

#include <intaglio/image/lookup.hpp>
#include <intaglio/image/surface.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/number/long_division.hpp>
#include <intaglio/status.hpp>

#include <cstdint>

namespace intaglio::image {

namespace detail {

/// Which source pixel is shown, along one axis. Copied to begin a row anew.
class ScaleStep {
 public:
  /// Stands on destination pixel `first`. Precondition: 0 <= first < to <= 2^21, 1 <= from <= 2^20.
  [[nodiscard]] static ScaleStep at(int first, int from, int to) noexcept {
    const auto source = static_cast<std::uint32_t>(from);
    const std::uint32_t divisor = 2U * static_cast<std::uint32_t>(to);
    const std::uint64_t centre = 2U * static_cast<std::uint64_t>(first) + 1U;
    return {number::long_divide(centre * source, divisor), number::long_divide(2U * source, divisor),
            divisor};
  }
  /// Stands between the source pixels index() - 1 and index(), which may not exist, `part()` of the way from
  /// one's centre to the other's. Preconditions as `at`.
  [[nodiscard]] static ScaleStep between(int first, int from, int to) noexcept {
    ScaleStep step = at(first, from, to);
    step.place_.remainder += static_cast<std::uint32_t>(to);
    if (step.place_.remainder >= step.divisor_) {
      step.place_.remainder -= step.divisor_;
      ++step.place_.quotient;
    }
    return step;
  }
  /// Of `whole()`.
  [[nodiscard]] std::uint32_t part() const noexcept { return place_.remainder; }
  [[nodiscard]] std::uint32_t whole() const noexcept { return divisor_; }
  /// The source pixel, counted from 0.
  [[nodiscard]] int index() const noexcept { return static_cast<int>(place_.quotient); }
  /// On to the next destination pixel.
  void advance() noexcept {
    place_.quotient += step_.quotient;
    place_.remainder += step_.remainder;
    if (place_.remainder < divisor_) return;
    place_.remainder -= divisor_;
    ++place_.quotient;
  }

 private:
  ScaleStep(number::LongDivision place, number::LongDivision step, std::uint32_t divisor) noexcept
      : place_(place), step_(step), divisor_(divisor) {}

  number::LongDivision place_;
  number::LongDivision step_;
  std::uint32_t divisor_;
};

}  // namespace detail

/// Shows `source` in `destination`, a rectangle in the coordinates of `target`, by the rule at the head of
/// this file; pixels outside the target's bounds or outside `clip` stay as they are. A destination without a
/// pixel draws nothing.
/// Errors: position (the destination's corner is outside the domain), size (its width or height is beyond
/// 2^21), rectangle (the clip is outside the domain), colour, table, mask (as `blit`), mismatched source (the
/// memory between the first and last visible pixel of the target meets the memory between the first and last
/// byte of the source: so do neighbours in one frame). Nothing is drawn on error.
template <PixelFormat F, PixelFormat G, class Byte, class Rule = Everything>
requires(Rule::template converts<F, G>) Status
    blit_scaled(const Surface<F>& target, const linear::Rect& destination, const PixelView<G, Byte>& source,
                const Rule& rule = {}, const linear::Rect& clip = everywhere)
noexcept {
  if (!linear::in_domain(linear::Point{destination.x, destination.y}))
    return {Error::out_of_domain, Argument::position};
  if (!linear::in_domain(destination)) return {Error::out_of_domain, Argument::size};
  const auto show_part = [to = destination, from = source.size()](const linear::Rect& part, const auto show) {
    const auto first_column = detail::ScaleStep::at(part.x - to.x, from.width, to.width);
    auto row = detail::ScaleStep::at(part.y - to.y, from.height, to.height);
    for (int y = part.y; y < part.bottom(); ++y, row.advance()) {
      auto column = first_column;
      for (int x = part.x; x < part.right(); ++x, column.advance()) show(x, y, column.index(), row.index());
    }
  };
  return detail::blit_by_lookup(target, destination, source, rule, clip, show_part);
}

}  // namespace intaglio::image
