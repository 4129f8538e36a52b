// SPDX-License-Identifier: MIT
//
// Ways to stretch a picture of values: rungs from the nearest pixel to bilinear interpolation.
//
// Rule: the source's indices are values, 0 .. 255 (a palette's ramp of greys, say). True is the bilinear
// interpolation: the centre of destination pixel x lies (2 (x - x0) + 1) w / 2W - 1/2 source pixels from the
// centre of the source's first column, rows alike; beyond the outermost centres the picture goes on evenly.
// The value is that of the four pixels around, weighted by nearness. The rungs:
// - `ScaleNearest` shows the nearest pixel, which is `blit_scaled`;
// - `ScaleBilinear4` and `ScaleBilinear8` round the two weights to 1/16 and 1/256, and the value once.
//
// Error, in values: of the nearest pixel 3/4 * 255, as its weight is at least a quarter; of the others 255
// for each weight's 2^-5 or 2^-9, another 2^-15 for the reciprocal that it is taken with, and 1/2 for the
// rounding. To shrink a picture to less than a half they skip pixels, as the nearest one does. Bit budget:
// sides up to 2^15, so parts have 16 bits, reciprocals 30 at most, and their product 31; values with two
// weights 24. Textbook: none. Worst known inputs: checkerboards.
#pragma once

#include <intaglio/image/blit.hpp>
#include <intaglio/image/overlap.hpp>
#include <intaglio/image/scale.hpp>
#include <intaglio/image/surface.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/number/bound.hpp>
#include <intaglio/status.hpp>

#include <cstdint>

namespace intaglio::image {

/// The longest side of pictures that are interpolated, and of where they are shown.
inline constexpr int bilinear_side_limit = 1 << 15;

namespace detail {

/// A weight of so many bits, 0 .. 2^bits, and the two pixels that it is for.
template <unsigned bits>
struct BilinearPair {
  int low;
  int high;
  unsigned weight;  ///< Of the high one.

  BilinearPair(const ScaleStep& step, int size, std::uint32_t reciprocal) noexcept
      : low(step.index() > 0 ? step.index() - 1 : 0),
        high(step.index() < size ? step.index() : size - 1),
        weight((step.part() * reciprocal + (1U << (30U - bits))) >> (31U - bits)) {}
};

/// Bilinear interpolation with weights of so many bits.
template <unsigned bits>
struct BilinearScale {
  /// Shows `source` in `destination`, where that is in the target's bounds and in `clip`.
  /// Errors: position, size, rectangle, source as `blit_scaled`; too_large size or source: a side above 2^15.
  /// Cost: a division for columns and for rows, then about 40 instructions a visible pixel.
  template <class Byte>
  Status operator()(const Surface<Indexed8>& target, const linear::Rect& destination,
                    const PixelView<Indexed8, Byte>& source,
                    const linear::Rect& clip = everywhere) const noexcept {
    if (!linear::in_domain(linear::Point{destination.x, destination.y}))
      return {Error::out_of_domain, Argument::position};
    if (!linear::in_domain(destination)) return {Error::out_of_domain, Argument::size};
    if (!linear::in_domain(clip)) return {Error::out_of_domain, Argument::rectangle};
    if (destination.width > bilinear_side_limit || destination.height > bilinear_side_limit)
      return {Error::too_large, Argument::size, bilinear_side_limit};
    const linear::Size size = source.size();
    if (size.width > bilinear_side_limit || size.height > bilinear_side_limit)
      return {Error::too_large, Argument::source, bilinear_side_limit};
    const linear::Rect part = linear::intersect(linear::intersect(destination, target.bounds()), clip);
    if (part.empty() || source.empty()) return {};
    const Picture<Indexed8> picture = source;
    if (bytes_meet(target, part, picture)) return {Error::mismatched, Argument::source};

    const auto first = ScaleStep::between(part.x - destination.x, size.width, destination.width);
    auto row = ScaleStep::between(part.y - destination.y, size.height, destination.height);
    const std::uint32_t across = (1U << 31U) / first.whole();
    const std::uint32_t down = (1U << 31U) / row.whole();
    const linear::Rect& from = picture.bounds();
    for (int y = part.y; y < part.bottom(); ++y, row.advance()) {
      const BilinearPair<bits> rows(row, size.height, down);
      const std::uint8_t* const above = picture.byte_at(from.x, from.y + rows.low);
      const std::uint8_t* const below = picture.byte_at(from.x, from.y + rows.high);
      std::uint8_t* to = target.byte_at(part.x, y);
      auto column = first;
      for (int left = part.width; left > 0; --left, column.advance()) {
        const BilinearPair<bits> columns(column, size.width, across);
        const auto mixed = [&columns](const std::uint8_t* values) {
          return values[columns.low] * (one - columns.weight) + values[columns.high] * columns.weight;
        };
        const unsigned value = mixed(above) * (one - rows.weight) + mixed(below) * rows.weight;
        *to++ = static_cast<std::uint8_t>((value + one * one / 2U) >> (2U * bits));
      }
    }
    return {};
  }

 private:
  static constexpr unsigned one = 1U << bits;
};

}  // namespace detail

/// The nearest pixel; the default, for it needs no ramp.
struct ScaleNearest {
  static constexpr number::Bound bound{191'250, number::Unit::palette_level};
  /// As `blit_scaled`.
  template <class Byte>
  Status operator()(const Surface<Indexed8>& target, const linear::Rect& destination,
                    const PixelView<Indexed8, Byte>& source,
                    const linear::Rect& clip = everywhere) const noexcept {
    return blit_scaled(target, destination, source, Everything{}, clip);
  }
};
/// Bilinear, weights in 1/16.
struct ScaleBilinear4 : detail::BilinearScale<4> {
  static constexpr number::Bound bound{16'460, number::Unit::palette_level};
};
/// Bilinear, weights in 1/256.
struct ScaleBilinear8 : detail::BilinearScale<8> {
  static constexpr number::Bound bound{1'512, number::Unit::palette_level};
};

/// The rungs of stretching, cheapest first.
using ScaleFamily = number::Family<ScaleNearest, ScaleBilinear4, ScaleBilinear8>;

}  // namespace intaglio::image
