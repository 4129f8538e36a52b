// SPDX-License-Identifier: MIT
//
// Enlarged coordinates: where the samples of a pixel are pixels themselves.
//
// Rule: enlarged n times along x, the pixel x is the n columns n*x .. n*x + n-1, and likewise along y. A
// pixel is a square around its centre, so the place x (in 1/256 pixel) goes to  n*x + 128*(n-1) : the middle
// of the pixel to the middle of its columns, which for odd n is the centre of one and for even n the side
// between two. That is whole for every n, so nothing is rounded and everything keeps its form. A shape of
// whole pixels is enlarged by the rectangle that it fills, from n*x on and n times as wide: a disc of radius
// r becomes the one with the diameter n*(2*r + 1), and a line one pixel wide becomes one of n.
//
// Places that leave the domain |c| <= 2^20 when enlarged stay outside it, so that what draws there says so.
// `window()` is the part of a clip that can be drawn on.
// Bit budget: products of int and 8 in int64, then saturated just outside the domain. Error: none.
// Textbook: section 2.8.2.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>

#include <algorithm>
#include <cstdint>

namespace intaglio::raster {

/// Enlarges by whole factors.
class Enlargement {
 public:
  /// The largest factor.
  static constexpr int limit = 8;

  /// Factors along x and y; taken as 1 .. `limit`.
  constexpr Enlargement(int across, int down) noexcept
      : across_(std::clamp(across, 1, limit)), down_(std::clamp(down, 1, limit)) {}
  constexpr explicit Enlargement(int factor) noexcept : Enlargement(factor, factor) {}

  [[nodiscard]] constexpr int across() const noexcept { return across_; }
  [[nodiscard]] constexpr int down() const noexcept { return down_; }

  /// A place in 1/256 pixel.
  [[nodiscard]] constexpr linear::SubPoint place(linear::SubPoint p) const noexcept {
    return {place(p.x, across_), place(p.y, down_)};
  }
  /// A width in 1/256 pixel, where both factors are the same.
  [[nodiscard]] constexpr int width(int w) const noexcept {
    return saturated(std::int64_t{w} * across_, linear::coordinate_limit * linear::subpixel_one);
  }
  /// The pixels that a rectangle of pixels becomes.
  [[nodiscard]] constexpr linear::Rect area(const linear::Rect& r) const noexcept {
    constexpr int far = linear::coordinate_limit;
    return {saturated(std::int64_t{r.x} * across_, far), saturated(std::int64_t{r.y} * down_, far),
            saturated(std::int64_t{r.width} * across_, 2 * far),
            saturated(std::int64_t{r.height} * down_, 2 * far)};
  }
  /// The part of a clip (in the domain) whose pixels, and a few around them, are in the domain enlarged; no
  /// shape reaches the rest.
  [[nodiscard]] constexpr linear::Rect window(const linear::Rect& clip) const noexcept {
    const int x_reach = linear::coordinate_limit / across_ - 2;
    const int y_reach = linear::coordinate_limit / down_ - 2;
    return linear::intersect(clip, {-x_reach, -y_reach, 2 * x_reach, 2 * y_reach});
  }

 private:
  [[nodiscard]] static constexpr int saturated(std::int64_t value, int far) noexcept {
    return static_cast<int>(std::clamp<std::int64_t>(value, -far - 1, far + 1));
  }
  [[nodiscard]] static constexpr int place(int c, int factor) noexcept {
    return saturated(std::int64_t{c} * factor + linear::subpixel_one / 2 * (factor - 1),
                     linear::coordinate_limit * linear::subpixel_one);
  }

  int across_;
  int down_;
};

static_assert(Enlargement(3).place({0, 0}) == linear::SubPoint{256, 256});
static_assert(Enlargement(2, 4).place({-128, -128}) == linear::SubPoint{-128, -128});

}  // namespace intaglio::raster
