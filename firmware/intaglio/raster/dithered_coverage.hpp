// SPDX-License-Identifier: MIT
//
// Coverage where pixels are on or off: ordered dithering.
//
// Rule: a pixel is drawn iff its level is above the threshold of its place, 4*k + 1, where k of 0 .. 63 is
// the place's number in Bayer's 8x8 matrix, which repeats over the plane from pixel (0, 0) on (bands and
// sub-surfaces that keep the frame's coordinates show the frame's pattern). The reversed pattern has 63 - k
// in place of k. So a whole pixel is always drawn, and of 64 neighbours with the level c the nearest number
// to 64*c/255 is, spread as evenly as can be.
//
// What is promised where two polygons share an edge: drawn one with the normal, the other with the reversed
// pattern, each pixel that only the two of them share is drawn: there is no hole. For if the levels add up to
// 255, c > 4k + 1 fails exactly where 255 - c > 253 - 4k holds, and then none is drawn twice, either. The
// levels of `fill_coverage` add up to 255 or, where both are rounded up, 256: 128 and 128, to which no
// threshold is equal, or (for areas within 2^-24 of one that ends in half a level) others, of which every
// fourth pair draws its pixel of the tile twice. Where three or more polygons meet in a pixel, or both use
// one pattern, nothing is promised: draw the colour below all of them first.
//
// It hands spans on to any span sink, so it dithers for every format, and for exclusive-or as well.
// Bit budget: levels have 8 bits. Error: at most 1/2 pixel of an aligned 8x8 tile.
// Textbook: section 2.8. Worst known input: a level of 1, a quarter of a pixel in a
// tile: never drawn.
#pragma once

#include <intaglio/image/bayer.hpp>
#include <intaglio/raster/coverage.hpp>
#include <intaglio/raster/sink.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace intaglio::raster {

/// Which of two complementary patterns dithering uses.
enum class DitherPattern : std::uint8_t { normal, reversed };

namespace detail {

using DitherMatrix = std::array<std::array<std::uint8_t, 8>, 8>;

[[nodiscard]] consteval DitherMatrix make_dither_thresholds() {
  DitherMatrix thresholds{};
  for (unsigned y = 0; y < 8; ++y)
    for (unsigned x = 0; x < 8; ++x)
      thresholds[y][x] = static_cast<std::uint8_t>(4 * image::bayer_number(x, y, 3) + 1);
  return thresholds;
}

inline constexpr DitherMatrix dither_thresholds = make_dither_thresholds();

}  // namespace detail

/// Draws the pixels whose coverage is above their threshold with another sink (a value, or a reference).
template <SpanSink S>
class DitheredCoverage {
 public:
  constexpr explicit DitheredCoverage(S sink, DitherPattern pattern = DitherPattern::normal) noexcept
      // 4*(63 - k) + 1 has the bits of 4*k + 1 that say k turned over.
      : sink_(std::forward<S>(sink)), flip_(pattern == DitherPattern::reversed ? 252U : 0U) {}

  /// Where it can draw.
  [[nodiscard]] constexpr linear::Rect clip() const noexcept { return sink_.clip(); }
  /// True if a pixel of this level is drawn.
  [[nodiscard]] constexpr bool draws(int x, int y, int coverage) const noexcept {
    return static_cast<unsigned>(coverage) > (row(y)[static_cast<unsigned>(x) & 7U] ^ flip_);
  }
  /// Hands on what is drawn of the pixels x_begin .. x_end-1 of row y.
  void span(int y, int x_begin, int x_end, int coverage) {
    if (coverage == full_coverage) {
      sink_.span(y, x_begin, x_end);
      return;
    }
    for (int x = x_begin; x < x_end; ++x) {
      if (!draws(x, y, coverage)) continue;
      const int begin = x;
      while (++x < x_end && draws(x, y, coverage)) {
      }
      sink_.span(y, begin, x);
    }
  }

 private:
  [[nodiscard]] static constexpr const std::array<std::uint8_t, 8>& row(int y) noexcept {
    return detail::dither_thresholds[static_cast<unsigned>(y) & 7U];
  }

  S sink_;
  unsigned flip_;
};

static_assert(CoverageSink<DitheredCoverage<Solid<image::Indexed1>>>);

}  // namespace intaglio::raster
