// SPDX-License-Identifier: MIT
#include <intaglio/linear/sub_rect.hpp>
#include <tests/oracle/integer.hpp>
#include <tests/oracle/random.hpp>

#include <gtest/gtest.h>

#include <limits>

namespace {

using intaglio::linear::in_domain;
using intaglio::linear::pixels_of;
using intaglio::linear::Point;
using intaglio::linear::Rect;
using intaglio::linear::SubPoint;
using intaglio::linear::SubRect;
using intaglio::linear::to_pixel_floor;
using intaglio::linear::to_pixel_nearest;
using intaglio::linear::to_subpixel;

constexpr int limit = 1 << 28;

TEST(SubPoint, RoundsToThePixelThatTheNameSays) {
  oracle::Random random(51);
  for (int i = 0; i < 100'000; ++i) {
    // All fractions near zero and at both ends of the domain.
    const int x = i < 3000   ? i - 1500
                  : i < 4000 ? limit - (i - 3000)
                  : i < 5000 ? -limit + (i - 4000)
                             : random.between(-limit, limit);
    const SubPoint p{x, -x};
    ASSERT_EQ(to_pixel_nearest(p), (Point{static_cast<int>(oracle::nearest_quotient(x, 256)),
                                          static_cast<int>(oracle::nearest_quotient(-x, 256))}))
        << x;
    ASSERT_EQ(to_pixel_floor(p), (Point{static_cast<int>(oracle::floor_quotient(x, 256)),
                                        static_cast<int>(oracle::floor_quotient(-x, 256))}))
        << x;
  }
}

TEST(SubRect, OwnsThePixelsWhoseCentresItContains) {
  oracle::Random random(52);
  for (int i = 0; i < 20'000; ++i) {
    const SubRect r{random.between(-700, 700), random.between(-700, 700), random.between(-100, 900),
                    random.between(-100, 900)};
    const Rect pixels = pixels_of(r);
    bool same = true;
    for (int y = -4; y <= 8; ++y)
      for (int x = -4; x <= 8; ++x) {
        const bool centre_inside =
            x * 256 >= r.x && x * 256 < r.x + r.width && y * 256 >= r.y && y * 256 < r.y + r.height;
        const bool owned =
            x >= pixels.x && x < pixels.x + pixels.width && y >= pixels.y && y < pixels.y + pixels.height;
        same = same && centre_inside == owned;
      }
    ASSERT_TRUE(same) << r.x << ',' << r.y << ' ' << r.width << 'x' << r.height;
  }
}

TEST(SubRect, NeighboursShareNoPixelAndLeaveNoneOut) {
  for (int left = -300; left < 300; left += 7)
    for (int middle = left; middle < 600; middle += 11) {
      const Rect a = pixels_of({left, 0, middle - left, 256});
      const Rect b = pixels_of({middle, 0, 900 - middle, 256});
      const Rect both = pixels_of({left, 0, 900 - left, 256});
      ASSERT_EQ(a.width + b.width, both.width) << left << ' ' << middle;
      ASSERT_TRUE(a.empty() || b.empty() || a.right() == b.x) << left << ' ' << middle;
    }
}

TEST(SubRect, OfWholePixelsOwnsThosePixels) {
  constexpr int pixel_limit = 1 << 20;
  for (const Rect& r : {Rect{0, 0, 1, 1}, Rect{-5, 7, 30, 2},
                        Rect{pixel_limit, -pixel_limit, 2 * pixel_limit, 2 * pixel_limit}})
    EXPECT_EQ(pixels_of(to_subpixel(r)), r);
}

TEST(SubRect, DomainEndsWhereThatOfPixelsDoes) {
  constexpr int max = std::numeric_limits<int>::max();
  constexpr int min = std::numeric_limits<int>::min();
  EXPECT_TRUE(in_domain(SubRect{limit, -limit, 2 * limit, -2 * limit}));
  for (const SubRect& r : {SubRect{limit + 1, 0, 1, 1}, SubRect{0, -limit - 1, 1, 1},
                           SubRect{0, 0, 2 * limit + 1, 1}, SubRect{0, 0, 1, -2 * limit - 1},
                           SubRect{min, 0, 1, 1}, SubRect{0, 0, max, 1}, SubRect{0, 0, 1, min}})
    EXPECT_FALSE(in_domain(r));
}

}  // namespace
