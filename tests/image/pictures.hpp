// SPDX-License-Identifier: MIT
//
// What the tests of all blits share: rectangles, random parts and clips, and drawing in bands.
#pragma once

#include <intaglio/image/blit.hpp>
#include <tests/image/formats.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <span>
#include <string>

namespace tests {

inline bool inside(const intaglio::linear::Rect& r, int x, int y) {
  return x >= r.x && x - r.x < r.width && y >= r.y && y - r.y < r.height;
}

inline std::string text(const intaglio::linear::Rect& r) {
  return std::to_string(r.x) + ',' + std::to_string(r.y) + ' ' + std::to_string(r.width) + 'x' +
         std::to_string(r.height);
}

/// A part of width x height pixels that has some.
inline intaglio::linear::Rect random_part(oracle::Random& random, int width, int height) {
  const int x = random.between(0, width - 1);
  const int y = random.between(0, height - 1);
  return {x, y, random.between(1, width - x), random.between(1, height - y)};
}

/// Now and then one that cuts something off.
inline intaglio::linear::Rect random_clip(oracle::Random& random) {
  if (random.between(0, 1) == 0) return intaglio::image::everywhere;
  return {random.between(-5, 20), random.between(-3, 5), random.between(-1, 30), random.between(-1, 15)};
}

/// Draws between memories of random bytes and compares with what is expected. `expect(expected, from)` paints
/// that on a copy of the target and says how many pixels show anything, which is the answer.
inline int check_drawing(oracle::Random& random, oracle::Packed to, oracle::Packed from,
                         const std::string& what,
                         const std::function<int(oracle::Packed&, const oracle::Packed&)>& expect,
                         const std::function<intaglio::Status(oracle::Packed&, oracle::Packed&)>& draw) {
  to.randomize(random);
  from.randomize(random);
  oracle::Packed expected = to;
  const int shown = expect(expected, from);
  EXPECT_TRUE(draw(to, from).ok()) << what;
  EXPECT_EQ(to.bytes(), expected.bytes()) << what << ", " << random.seed_text();
  return shown;
}

/// `draw(surface)` on bands of every height, in memory of zeros, gives the picture `whole`.
template <class F, class Draw>
void expect_bands_give(const oracle::Packed& whole, int width, int height, Draw draw) {
  for (int rows = 1; rows <= height; ++rows) {
    oracle::Packed in_bands = packed_rows<F>(width, height);
    for (int y = 0; y < height; y += rows) {
      const auto rest = std::span(in_bands.bytes()).subspan(static_cast<std::size_t>(y * in_bands.stride()));
      const auto band =
          intaglio::image::Surface<F>::over_band(rest, {0, y, width, std::min(rows, height - y)});
      ASSERT_TRUE(band.ok());
      ASSERT_TRUE(draw(band.value()).ok());
    }
    ASSERT_EQ(in_bands.bytes(), whole.bytes()) << rows;
  }
}

}  // namespace tests
