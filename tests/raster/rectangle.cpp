// SPDX-License-Identifier: MIT
#include <intaglio/raster/pixel.hpp>
#include <intaglio/raster/rectangle.hpp>
#include <intaglio/raster/solid.hpp>
#include <tests/oracle/recording_sink.hpp>

#include <climits>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::linear::Point;
using intaglio::linear::Rect;
using namespace intaglio::raster;
using oracle::RecordingSink;

constexpr int limit = 1 << 20;
const Rect clip{-3, -2, 9, 8};

bool inside(const Rect& r, int x, int y) {
  return x >= r.x && y >= r.y && x < r.x + r.width && y < r.y + r.height;
}

TEST(Rectangle, EverySmallRectangleInsideAndAcrossTheClipIsExactAndDrawnOnce) {
  RecordingSink sink(clip);
  for (int y = -6; y < 9; ++y)
    for (int x = -6; x < 9; ++x)
      for (int h = -1; h < 12; ++h)
        for (int w = -1; w < 12; ++w) {
          const Rect r{x, y, w, h};
          const auto filled = [&](int px, int py) { return inside(r, px, py); };
          const auto outlined = [&](int px, int py) {
            return filled(px, py) &&
                   !(filled(px - 1, py) && filled(px + 1, py) && filled(px, py - 1) && filled(px, py + 1));
          };
          sink.clear();
          ASSERT_TRUE(fill_rect(sink, r).ok());
          ASSERT_EQ(sink.fault(filled), "") << x << " " << y << " " << w << " " << h;
          sink.clear();
          ASSERT_TRUE(draw_rect(sink, r).ok());
          ASSERT_EQ(sink.fault(outlined), "") << x << " " << y << " " << w << " " << h;
        }
}

TEST(Rectangle, EveryShortRowColumnAndPixelIsExact) {
  RecordingSink sink(clip);
  for (int y = -5; y < 9; ++y)
    for (int x = -6; x < 9; ++x)
      for (int n = -2; n < 16; ++n) {
        sink.clear();
        ASSERT_TRUE(draw_horizontal(sink, {x, y}, n).ok());
        ASSERT_EQ(sink.fault([&](int px, int py) { return inside({x, y, n, 1}, px, py); }), "");
        sink.clear();
        ASSERT_TRUE(draw_vertical(sink, {x, y}, n).ok());
        ASSERT_EQ(sink.fault([&](int px, int py) { return inside({x, y, 1, n}, px, py); }), "");
        sink.clear();
        ASSERT_TRUE(draw_pixel(sink, {x, y}).ok());
        ASSERT_EQ(sink.fault([&](int px, int py) { return px == x && py == y; }), "");
      }
}

TEST(Rectangle, TheWholeDomainIsARectangleAndWorkIsBoundedByTheClip) {
  RecordingSink sink(clip);
  EXPECT_TRUE(fill_rect(sink, {-limit, -limit, 2 * limit, 2 * limit}).ok());
  EXPECT_EQ(sink.touched(), clip.width * clip.height);
  EXPECT_EQ(sink.spans(), clip.height);
  sink.clear();
  EXPECT_TRUE(draw_rect(sink, {-limit, -limit, 2 * limit, 2 * limit}).ok());
  EXPECT_EQ(sink.touched(), 0);
  EXPECT_TRUE(draw_horizontal(sink, {-limit, 0}, 2 * limit).ok());
  EXPECT_TRUE(draw_vertical(sink, {0, -limit}, 2 * limit).ok());
  EXPECT_EQ(sink.touched(), clip.width + clip.height - 1);
}

TEST(Rectangle, BadArgumentsAreNamedAndNothingIsDrawn) {
  RecordingSink sink(clip);
  for (int bad : {limit + 1, -limit - 1, INT_MAX, INT_MIN})
    for (const Point p : {Point{bad, 0}, Point{0, bad}, Point{bad, bad}}) {
      const Status expected{Error::out_of_domain, Argument::point};
      EXPECT_EQ(draw_pixel(sink, p), expected);
      EXPECT_EQ(draw_horizontal(sink, p, 5), expected);
      EXPECT_EQ(draw_vertical(sink, p, 5), expected);
      EXPECT_EQ(fill_rect(sink, {p.x, p.y, 5, 5}), (Status{Error::out_of_domain, Argument::rectangle}));
      EXPECT_EQ(draw_rect(sink, {p.x, p.y, 5, 5}), (Status{Error::out_of_domain, Argument::rectangle}));
    }
  for (int bad : {2 * limit + 1, -2 * limit - 1, INT_MAX, INT_MIN}) {
    EXPECT_EQ(draw_horizontal(sink, {0, 0}, bad), (Status{Error::out_of_domain, Argument::width}));
    EXPECT_EQ(draw_vertical(sink, {0, 0}, bad), (Status{Error::out_of_domain, Argument::height}));
    for (const Rect r : {Rect{0, 0, bad, 5}, Rect{0, 0, 5, bad}}) {
      EXPECT_EQ(fill_rect(sink, r), (Status{Error::out_of_domain, Argument::rectangle}));
      EXPECT_EQ(draw_rect(sink, r), (Status{Error::out_of_domain, Argument::rectangle}));
    }
  }
  EXPECT_EQ(sink.spans(), 0);
}

TEST(Solid, ClipIsCutToTheSurfaceAndABadClipIsEmpty) {
  std::vector<std::uint8_t> memory(20);
  const auto surface = intaglio::image::Surface<intaglio::image::Indexed8>::over(memory, {5, 4});
  ASSERT_TRUE(surface.ok());
  EXPECT_EQ(Solid(surface.value(), 1).clip(), (Rect{0, 0, 5, 4}));
  EXPECT_EQ(Solid(surface.value(), 1, {-3, 1, 100, 100}).clip(), (Rect{0, 1, 5, 3}));
  EXPECT_TRUE(Solid(surface.value(), 1, {7, 1, 2, 2}).clip().empty());
  EXPECT_TRUE(Solid(surface.value(), 1, {INT_MIN, 1, INT_MAX, 2}).clip().empty());
  EXPECT_TRUE(Xor(surface.value(), 1, {1, 1, -2, INT_MAX}).clip().empty());
  EXPECT_TRUE(fill_rect(Solid(surface.value(), 1, {1, 1, -2, 3}), {0, 0, 5, 4}).ok());
  EXPECT_EQ(memory, std::vector<std::uint8_t>(20));
}

TEST(Solid, AnEmptySurfaceTakesEveryCallAndDrawsNothing) {
  const intaglio::image::Surface<intaglio::image::Indexed4> nothing;
  const Solid sink(nothing, 3);
  EXPECT_TRUE(draw_pixel(sink, {0, 0}).ok());
  EXPECT_TRUE(fill_rect(sink, {0, 0, 10, 10}).ok());
  EXPECT_TRUE(draw_rect(sink, {0, 0, 10, 10}).ok());
  EXPECT_TRUE(draw_horizontal(sink, {0, 0}, 10).ok());
}

}  // namespace
