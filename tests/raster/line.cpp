// SPDX-License-Identifier: MIT
#include <intaglio/raster/line.hpp>
#include <intaglio/raster/solid.hpp>
#include <tests/oracle/line.hpp>
#include <tests/oracle/random.hpp>
#include <tests/oracle/recording_sink.hpp>
#include <tests/oracle/samples.hpp>
#include <tests/raster/fault.hpp>
#include <tests/raster/text.hpp>

#include <climits>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace {

using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::linear::Point;
using intaglio::linear::Rect;
using intaglio::raster::draw_line;
using oracle::RecordingSink;

std::string text(Point a, Point b, const Rect& clip) {
  return tests::text(a) + "-" + tests::text(b) + " in " + tests::text(clip);
}

// What is wrong with the line in this window; empty if every pixel of the window is drawn once or not at all,
// as the definition says.
std::string fault(Point a, Point b, RecordingSink& sink) {
  sink.clear();
  return tests::fault(
      draw_line(sink, a, b), sink, [&] { return text(a, b, sink.clip()); },
      [&](int x, int y) { return oracle::on_line(a.x, a.y, b.x, b.y, x, y); });
}

std::string fault(Point a, Point b, const Rect& clip) {
  RecordingSink sink(clip);
  return fault(a, b, sink);
}

// The pixels of a line, sent one by one, in order.
class PixelList {
 public:
  explicit PixelList(const Rect& clip) : clip_(clip) {}
  [[nodiscard]] const Rect& clip() const { return clip_; }
  void span(int y, int begin, int end) {
    for (int x = begin; x < end; ++x) pixels.emplace_back(x, y);
  }
  std::vector<std::pair<int, int>> pixels;

 private:
  Rect clip_;
};

std::vector<std::pair<int, int>> pixels_of(Point a, Point b, const Rect& clip) {
  PixelList list(clip);
  EXPECT_TRUE(draw_line(list, a, b).ok());
  std::sort(list.pixels.begin(), list.pixels.end());
  return list.pixels;
}

// How far the exhaustive tests go along either axis.
int exhaustive() { return oracle::samples(48, 128); }

TEST(Line, EveryLineUpTo128PixelsIsExactInAllOctants) {
  // Compared column by column (row by row if steep): one pixel each, the right one, and nothing else.
  const Rect clip{-134, -134, 269, 269};
  const int reach = exhaustive();
  std::string first_fault;
  for (int dy = -reach; dy <= reach && first_fault.empty(); ++dy)
    for (int dx = -reach; dx <= reach && first_fault.empty(); ++dx) {
      const bool steep = std::abs(dy) > std::abs(dx);
      std::vector<std::pair<int, int>> expected;
      if (steep)
        for (int y = std::min(0, dy); y <= std::max(0, dy); ++y)
          expected.emplace_back(
              dy > 0 ? oracle::nearest_minor(0, 0, dy, dx, y) : oracle::nearest_minor(dy, dx, 0, 0, y), y);
      else
        for (int x = std::min(0, dx); x <= std::max(0, dx); ++x)
          expected.emplace_back(x, dx == 0  ? 0
                                   : dx > 0 ? oracle::nearest_minor(0, 0, dx, dy, x)
                                            : oracle::nearest_minor(dx, dy, 0, 0, x));
      std::sort(expected.begin(), expected.end());
      if (pixels_of({0, 0}, {dx, dy}, clip) != expected) first_fault = text({0, 0}, {dx, dy}, clip);
    }
  EXPECT_EQ(first_fault, "");
}

TEST(Line, FromAToBEqualsFromBToA) {
  const Rect clip{-134, -134, 269, 269};
  const int reach = exhaustive();
  for (int dy = -reach; dy <= reach; ++dy)
    for (int dx = -reach; dx <= reach; ++dx)
      ASSERT_EQ(pixels_of({0, 0}, {dx, dy}, clip), pixels_of({dx, dy}, {0, 0}, clip)) << dx << "," << dy;
}

TEST(Line, EveryShortLineInEveryWindowIsTheUnclippedLineRestricted) {
  std::string first_fault;
  for (int wy = -2; wy <= 2; ++wy)
    for (int wx = -2; wx <= 2; ++wx)
      for (const Rect clip : {Rect{wx, wy, 3, 2}, Rect{wx, wy, 1, 1}, Rect{wx, wy, 4, 5}}) {
        RecordingSink sink(clip);
        for (int code = 0; code < 9 * 9 * 9 * 9 && first_fault.empty(); ++code)
          first_fault = fault({code % 9 - 4, code / 9 % 9 - 4}, {code / 81 % 9 - 4, code / 729 - 4}, sink);
      }
  EXPECT_EQ(first_fault, "");
}

// Random end points up to `limit`, windows near the line so that most see it.
void random_lines(int limit, int count, unsigned seed) {
  count = oracle::samples(count, 20 * count);
  oracle::Random random(seed);
  const auto coordinate = [&](int bound) { return random.between(-bound, bound); };
  int visible = 0;
  for (int i = 0; i < count; ++i) {
    Point a{coordinate(limit), coordinate(limit)};
    Point b{coordinate(limit), coordinate(limit)};
    if (i % 8 == 1) b.y = std::clamp(a.y + coordinate(3), -limit, limit);     // almost level
    if (i % 8 == 2) b.x = std::clamp(a.x + coordinate(3), -limit, limit);     // almost upright
    if (i % 8 == 3) b = {std::clamp(a.x + (b.y - a.y), -limit, limit), b.y};  // almost diagonal
    // A window around a point of the line, or around one of its ends.
    const long t = i % 3 == 0 ? 0 : coordinate(1 << 10) + (1 << 10);
    const int cx = static_cast<int>(a.x + (static_cast<long>(b.x) - a.x) * t / (1 << 11));
    const int cy = static_cast<int>(a.y + (static_cast<long>(b.y) - a.y) * t / (1 << 11));
    const int width = 1 + std::abs(coordinate(19));
    const int height = 1 + std::abs(coordinate(19));
    const Rect clip{std::clamp(cx - std::abs(coordinate(21)), -(1 << 20), (1 << 20) - width),
                    std::clamp(cy - std::abs(coordinate(21)), -(1 << 20), (1 << 20) - height), width, height};
    RecordingSink sink(clip);
    ASSERT_EQ(fault(a, b, sink), "") << random.seed_text() << " line " << i;
    visible += sink.touched() > 0 ? 1 : 0;
  }
  EXPECT_GT(visible, count / 4) << "the windows hardly see the lines: the test proves nothing";
}

TEST(Line, RandomLinesInRandomWindowsAreExact) {
  random_lines(50, 4000, 1);
  random_lines(700, 4000, 2);
  random_lines(23170, 3000, 3);  // where 2*dx*dy leaves 32 bits: 46,340 = 2 * 23,170
  random_lines(24000, 3000, 4);
  random_lines(1 << 20, 4000, 5);
}

TEST(Line, LimitsOfSmallIntegersAreNothingSpecial) {
  for (int n : {127,   128,   181,   182,   215,   216,   255,   256,   645,   646,           16383,
                16384, 23170, 23171, 32767, 32768, 46340, 46341, 65535, 65536, (1 << 20) - 1, 1 << 20})
    for (const auto& [a, b] : {std::pair{Point{0, 0}, Point{n, n - 1}},
                               {Point{-n, 1}, Point{n, n - 7}},
                               {Point{n, -n}, Point{-n, n}},
                               {Point{-n, -n}, Point{n, n - 1}},
                               {Point{3, -n}, Point{-4, n}},
                               {Point{0, n}, Point{n, n}},
                               {Point{n, n}, Point{n, -n}}})
      for (const Point at : {Point{0, 0}, a, b, Point{(a.x + b.x) / 2, (a.y + b.y) / 2}}) {
        const Rect clip{std::min(at.x - 6, (1 << 20) - 12), std::min(at.y - 6, (1 << 20) - 12), 12, 12};
        const Rect window{std::max(clip.x, -(1 << 20)), std::max(clip.y, -(1 << 20)), 12, 12};
        EXPECT_EQ(fault(a, b, window), "") << n;
      }
}

TEST(Line, KnownRowsOfSmallLines) {
  // (3,1): rows 0 0 1 1; (1,0): 0 0; (2,1): a tie at x = 1, which goes to row 1.
  const Rect clip{0, 0, 4, 2};
  EXPECT_EQ(pixels_of({0, 0}, {3, 1}, clip),
            (std::vector<std::pair<int, int>>{{0, 0}, {1, 0}, {2, 1}, {3, 1}}));
  EXPECT_EQ(pixels_of({0, 0}, {1, 0}, clip), (std::vector<std::pair<int, int>>{{0, 0}, {1, 0}}));
  EXPECT_EQ(pixels_of({0, 0}, {2, 1}, clip), (std::vector<std::pair<int, int>>{{0, 0}, {1, 1}, {2, 1}}));
}

TEST(Line, KnownPixelsOfAShallowLine) {
  // By hand: (0,0)-(8,3) passes y = 3x/8; ties at x = 4 (1.5) go down to 2.
  const std::vector<std::pair<int, int>> expected{{0, 0}, {1, 0}, {2, 1}, {3, 1}, {4, 2},
                                                  {5, 2}, {6, 2}, {7, 3}, {8, 3}};
  EXPECT_EQ(pixels_of({0, 0}, {8, 3}, {0, 0, 9, 4}), expected);
  EXPECT_EQ(pixels_of({8, 3}, {0, 0}, {0, 0, 9, 4}), expected);
}

TEST(Line, TiesGoTowardsTheLargerCoordinateWhicheverWayTheLineRuns) {
  EXPECT_EQ(pixels_of({0, 0}, {2, 1}, {-5, -5, 11, 11}),
            (std::vector<std::pair<int, int>>{{0, 0}, {1, 1}, {2, 1}}));
  EXPECT_EQ(pixels_of({0, 0}, {2, -1}, {-5, -5, 11, 11}),
            (std::vector<std::pair<int, int>>{{0, 0}, {1, 0}, {2, -1}}));
  EXPECT_EQ(pixels_of({0, 0}, {-1, 2}, {-5, -5, 11, 11}),
            (std::vector<std::pair<int, int>>{{-1, 2}, {0, 0}, {0, 1}}));
}

TEST(Line, SlopeSurvivesTheStepFrom255To256) {  // H4: u8g2 keeps the error in eight bits
  EXPECT_EQ(fault({0, 0}, {255, 255}, Rect{0, 0, 300, 300}), "");
  EXPECT_EQ(fault({0, 0}, {256, 256}, Rect{0, 0, 300, 300}), "");
  EXPECT_EQ(fault({63, 31}, {255, 63}, Rect{0, 0, 300, 300}), "");  // H5: an endless loop at x = 255
}

TEST(Line, ALevelLineOf54PixelsHas54Pixels) {  // H19
  EXPECT_EQ(pixels_of({10, 5}, {63, 5}, {0, 0, 100, 10}).size(), 54U);
  EXPECT_EQ(pixels_of({5, 63}, {5, 10}, {0, 0, 100, 100}).size(), 54U);
}

TEST(Line, FourSidesOfASquareLeaveNoCornerOut) {  // H20
  RecordingSink sink({130, 90, 30, 30});
  const Point corners[] = {{140, 100}, {145, 100}, {145, 105}, {140, 105}};
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(draw_line(sink, corners[i], corners[(i + 1) % 4]).ok());
  EXPECT_EQ(sink.touched(), 20) << sink.ascii();
  for (const Point c : corners) EXPECT_EQ(sink.writes(c.x, c.y), 2);
}

TEST(Line, PublishedAsymmetricLinesAreSymmetric) {  // H23
  for (const auto& [a, b] : {std::pair{Point{0, 0}, Point{8, 3}},
                             {Point{9, 2}, Point{6, 4}},
                             {Point{3, 8}, Point{0, 0}},
                             {Point{1, 1}, Point{3, 7}}}) {
    EXPECT_EQ(pixels_of(a, b, {0, 0, 10, 10}), pixels_of(b, a, {0, 0, 10, 10}));
    EXPECT_EQ(fault(a, b, Rect{0, 0, 10, 10}), "");
  }
}

TEST(Line, WorkIsBoundedByTheVisiblePixels) {  // H24: a device hung on a line of 2e9 pixels
  RecordingSink sink({0, 0, 32, 32});
  for (int i = 0; i < 100000; ++i) {
    sink.clear();
    ASSERT_TRUE(draw_line(sink, {-(1 << 20), -(1 << 20) + i}, {1 << 20, 1 << 20}).ok());
    ASSERT_LE(sink.spans(), 32);
  }
  EXPECT_EQ(draw_line(sink, {1, 1}, {2000000000, 1000000000}),
            (Status{Error::out_of_domain, Argument::point}));
}

TEST(Line, EndsOutsideTheDomainAreRefusedAndNothingIsDrawn) {
  RecordingSink sink({-10, -10, 20, 20});
  constexpr int limit = 1 << 20;
  for (int bad : {limit + 1, -limit - 1, INT_MAX, INT_MIN})
    for (const auto& [a, b] : {std::pair{Point{bad, 0}, Point{0, 0}},
                               {Point{0, bad}, Point{0, 0}},
                               {Point{0, 0}, Point{bad, 0}},
                               {Point{0, 0}, Point{0, bad}},
                               {Point{bad, bad}, Point{bad, bad}}})
      EXPECT_EQ(draw_line(sink, a, b), (Status{Error::out_of_domain, Argument::point}));
  EXPECT_EQ(sink.spans(), 0);
}

TEST(Line, AnEmptyClipDrawsNothing) {
  RecordingSink sink({0, 0, 0, 0});
  EXPECT_TRUE(draw_line(sink, {-5, -5}, {5, 5}).ok());
  EXPECT_TRUE(draw_line(sink, {0, 0}, {0, 0}).ok());
  EXPECT_EQ(sink.spans(), 0);
}

}  // namespace
