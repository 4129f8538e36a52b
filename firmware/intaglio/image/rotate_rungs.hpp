// SPDX-License-Identifier: MIT
//
// Ways to turn a picture of values: rungs from whole pixels to bilinear interpolation.
//
// Rule: true is the bilinear interpolation of the source at the place that a pixel's centre comes from,
// turned by the exact angle. The rungs:
// - `RotateNearest` shows the nearest pixel, which is `blit_rotozoom` at scale 1;
// - `RotateThreeShear` moves whole rows and columns, which is `blit_three_shear`;
// - `RotateBilinear` interpolates with weights of 1/256 on the pixels that `RotateNearest` draws, beyond the
//   outermost centres evenly.
//
// Error: how far the place that a pixel shows lies from the one that its centre comes from, in pixels of the
// source, for pictures up to 128 pixels from their pivot, between the outermost centres. Columns and rows are
// off by at most 0.007 for the sine (rotozoom.hpp): of the nearest pixel half a pixel and that, along both;
// of the last 2^-9 + 2^-16 for the weight, 1/510 for the rounding of the value, and that. Shears round
// three times, by e1, e2, e3 <= 1/2, which is e1 cos r - e2 tan(r/2) + e3 along one axis and e2 + e1 sin r
// along the other: sqrt(5)/2 for small r, and 0.0133 along both for the sine. What shears leave open or show
// beside the picture, along its turned sides, isn't counted. Bit budget: sides up to 2^15, so places in 2^-16
// pixel have 31 bits. Textbook: the inverse mapping of an affine map. Worst known inputs: for shears angles
// next to none and to quarter turns, far from the pivot; for the others 45 degrees.
#pragma once

#include <intaglio/image/blit.hpp>
#include <intaglio/image/overlap.hpp>
#include <intaglio/image/rotozoom.hpp>
#include <intaglio/image/surface.hpp>
#include <intaglio/image/three_shear.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/number/bound.hpp>
#include <intaglio/status.hpp>

#include <cstdint>

namespace intaglio::image {

/// The nearest pixel; the default, for it needs no ramp.
struct RotateNearest {
  static constexpr number::Bound bound = number::pixels(718);
  /// As `blit_rotozoom`.
  template <class Byte>
  Status operator()(const Surface<Indexed8>& target, const ThreeShear& turn,
                    const PixelView<Indexed8, Byte>& source,
                    const linear::Rect& clip = everywhere) const noexcept {
    return blit_rotozoom(target, {turn.position, turn.pivot, turn.angle}, source, Everything{}, clip);
  }
};

/// By three shears.
struct RotateThreeShear {
  static constexpr number::Bound bound = number::pixels(1'137);
  /// As `blit_three_shear`.
  template <class Byte>
  Status operator()(const Surface<Indexed8>& target, const ThreeShear& turn,
                    const PixelView<Indexed8, Byte>& source,
                    const linear::Rect& clip = everywhere) const noexcept {
    return blit_three_shear(target, turn, source, Everything{}, clip);
  }
};

/// Bilinear, weights in 1/256.
struct RotateBilinear {
  static constexpr number::Bound bound = number::pixels(16);
  /// Errors: as `blit_rotozoom`; too_large source: a side above 2^15. Cost: as there, but about 45
  /// instructions a pixel shown.
  template <class Byte>
  Status operator()(const Surface<Indexed8>& target, const ThreeShear& turn,
                    const PixelView<Indexed8, Byte>& source,
                    const linear::Rect& clip = everywhere) const noexcept {
    const linear::Size size = source.size();
    const Rotozoom placement{turn.position, turn.pivot, turn.angle};
    if (const Status status = detail::check_rotozoom(placement, size); !status.ok()) return status;
    constexpr int limit = 1 << 15;
    if (size.width > limit || size.height > limit) return {Error::too_large, Argument::source, limit};
    if (!linear::in_domain(clip)) return {Error::out_of_domain, Argument::rectangle};
    const linear::Rect part = linear::intersect(target.bounds(), clip);
    if (part.empty() || source.empty()) return {};
    const Picture<Indexed8> picture = source;
    if (detail::bytes_meet(target, part, picture)) return {Error::mismatched, Argument::source};
    const detail::RotozoomMap map(placement, size);
    const linear::Rect& from = picture.bounds();
    for (int y = part.y; y < part.bottom(); ++y) {
      detail::RotozoomRun run = map.run(part.x, y, part.width);
      for (; run.first < run.last; ++run.first, run.column += map.column_step(), run.row += map.row_step()) {
        const Pair columns(run.column, size.width);
        const Pair rows(run.row, size.height);
        const std::uint8_t* const above = picture.byte_at(from.x, from.y + rows.low);
        const std::uint8_t* const below = picture.byte_at(from.x, from.y + rows.high);
        const auto mixed = [&columns](const std::uint8_t* values) {
          return values[columns.low] * (256U - columns.weight) + values[columns.high] * columns.weight;
        };
        const unsigned value = mixed(above) * (256U - rows.weight) + mixed(below) * rows.weight;
        *target.byte_at(part.x + run.first, y) = static_cast<std::uint8_t>((value + 32'768U) >> 16U);
      }
    }
    return {};
  }

 private:
  /// The pixels beside a place, and the weight of the high one in 1/256.
  struct Pair {
    int low;
    int high;
    unsigned weight;
    /// `place` in 2^-16, counted from the edge of the first pixel.
    Pair(std::uint32_t place, int size) noexcept {
      // From a pixel before the first one's centre, to nearest.
      const std::uint32_t steps = (place + 32'768U + 128U) >> 8U;
      const int after = static_cast<int>(steps >> 8U);
      low = after > 0 ? after - 1 : 0;
      high = after < size ? after : size - 1;
      weight = steps & 255U;
    }
  };
};

/// The rungs of turning.
using RotateFamily = number::Family<RotateNearest, RotateThreeShear, RotateBilinear>;

}  // namespace intaglio::image
