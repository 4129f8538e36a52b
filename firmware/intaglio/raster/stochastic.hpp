// SPDX-License-Identifier: MIT
//
// Stochastic supersampling: jittered samples, the same picture every time.
//
// Rule: each of the scale x scale parts of a pixel has one sample at a random place in it, and the level is
// the number of samples that are inside, in 1/255 of all, rounded to nearest. The places follow from the seed
// and the pixel's coordinates alone (a hash, then a linear congruential sequence), so bands and clips show
// the same picture, and so does every machine. Regular samples turn what is too fine for them into patterns;
// jittered ones turn it into noise.
//
// Error bound: parts that no edge crosses are exact, so where one straight edge crosses the pixel the level
// is off by at most 1.44/scale of the pixel (found by trying all edges in steps of 0.05 degrees) and half a
// level; on the average over seeds it is the area, as every place of a part is as likely (but for 1/512 of a
// part). Bit budget: places within the domain; the hash is unsigned. Textbook: section 2.8.2. Worst known
// input: edges at 45 degrees, which cross the most parts.
#pragma once

#include <intaglio/raster/coverage.hpp>
#include <intaglio/raster/enlargement.hpp>
#include <intaglio/raster/sample_level.hpp>
#include <intaglio/status.hpp>

#include <concepts>
#include <cstdint>

namespace intaglio::raster {

/// The jitter of one pixel's samples.
class PixelJitter {
 public:
  constexpr PixelJitter(std::uint32_t seed, int x, int y) noexcept
      : state_(mixed(mixed(seed ^ mixed(static_cast<std::uint32_t>(x))) ^ static_cast<std::uint32_t>(y))) {}

  /// How far the next sample is from the middle of its part, in 1/256 of the part: -128 .. 127 along each
  /// axis.
  [[nodiscard]] constexpr linear::SubPoint next() noexcept {
    state_ = state_ * 1664525U + 1013904223U;
    return {static_cast<int>(state_ >> 24U) - 128, static_cast<int>(state_ >> 16U & 255U) - 128};
  }

 private:
  /// A bijection of 32 bits in which every bit of the result depends on every bit of the value.
  [[nodiscard]] static constexpr std::uint32_t mixed(std::uint32_t value) noexcept {
    value = (value ^ value >> 16U) * 0x85EBCA6BU;
    value = (value ^ value >> 13U) * 0xC2B2AE35U;
    return value ^ value >> 16U;
  }

  std::uint32_t state_;
};

/// Hands over the coverage of the pixels of `area` (in the domain) inside the sink's clip. `inside(place)`
/// says if a place is inside; places are in 1/256 of a pixel enlarged by `Enlargement(scale)`, 2 <= scale
/// <= 8. Errors: rectangle (outside the domain), steps (another scale); nothing is handed over then. Cost:
/// scale * scale questions a pixel.
template <CoverageSink S, std::predicate<linear::SubPoint> Inside>
Status cover_stochastically(S&& sink, const linear::Rect& area, int scale, std::uint32_t seed,
                            Inside inside) {
  if (!linear::in_domain(area)) return {Error::out_of_domain, Argument::rectangle};
  if (scale < 2 || scale > Enlargement::limit) return {Error::out_of_range, Argument::steps};
  const linear::Rect box = linear::intersect(Enlargement(scale).window(sink.clip()), area);
  const detail::SampleLevels levels(scale * scale);
  detail::CoverageRun run(sink);
  for (int y = box.y; y < box.bottom(); ++y)
    for (int x = box.x; x < box.right(); ++x) {
      PixelJitter jitter(seed, x, y);
      int covered = 0;
      for (int v = 0; v < scale; ++v)
        for (int u = 0; u < scale; ++u) {
          const linear::SubPoint off = jitter.next();
          covered += inside({(x * scale + u) * linear::subpixel_one + off.x,
                             (y * scale + v) * linear::subpixel_one + off.y})
                         ? 1
                         : 0;
        }
      run.add(y, x, x + 1, levels(covered));
    }
  run.flush();
  return {};
}

}  // namespace intaglio::raster
