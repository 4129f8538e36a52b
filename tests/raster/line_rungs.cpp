// SPDX-License-Identifier: MIT
#include <intaglio/raster/line_rungs.hpp>
#include <tests/oracle/integer.hpp>
#include <tests/oracle/random.hpp>
#include <tests/oracle/recording_sink.hpp>
#include <tests/oracle/samples.hpp>

#include <climits>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <type_traits>
#include <utility>

namespace {

using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::linear::Point;
using intaglio::linear::Rect;
using intaglio::linear::SubPoint;
using intaglio::raster::DistanceLine;
using intaglio::raster::draw_line;
using intaglio::raster::draw_line_by;
using intaglio::raster::ExactLine;
using intaglio::raster::LineSlope;
using intaglio::raster::RoundedLine;
using intaglio::raster::SplitErrorLine;
using intaglio::raster::SubPixelLine;
using oracle::RecordingSink;
using oracle::Wide;

constexpr int limit = 1 << 20;

template <class... Rungs>
testing::Types<Rungs...> types_of(intaglio::number::Family<Rungs...>);
using Family = decltype(types_of(intaglio::raster::LineFamily{}));

// j(k) by definition: of the exact line, or of one whose slope is rounded to `bits` fraction bits.
int row_of(const LineSlope& slope, int bits, int k) {
  if (slope.major == 0) return 0;
  const Wide major = slope.major;
  const Wide tie = slope.tie;
  if (bits == 0)
    return static_cast<int>(oracle::floor_quotient(2 * Wide{slope.minor} * k + major - tie, 2 * major));
  const Wide one = Wide{1} << bits;
  const Wide scaled = slope.minor * one;
  const Wide rounded =
      tie != 0 ? oracle::floor_quotient(scaled, major) : oracle::ceil_quotient(scaled, major);
  return static_cast<int>(oracle::floor_quotient(rounded * k + one / 2 - tie, one));
}
template <class Rung>
constexpr int bits_of = std::is_same_v<Rung, RoundedLine>      ? 16
                        : std::is_same_v<Rung, SplitErrorLine> ? 32
                                                               : 0;

// What of a rung's claims a line breaks; empty if none.
template <class Rung>
std::string broken_claim(const LineSlope& slope) {
  const auto length = static_cast<int>(slope.major);
  typename Rung::Stairs stairs(slope);
  stairs.start(0);
  const Wide allowed = 2 * Wide{slope.major} * Rung::bound_for(length).thousandths;
  int row = 0;
  int wrong = 0;
  for (int k = 0; k <= length; ++k) {
    if (k > 0) row += stairs.next() ? 1 : 0;
    // Twice the length times the distance from the line, less that of half a pixel, in thousandths.
    const Wide off = 2 * (Wide{slope.major} * row - Wide{slope.minor} * k);
    if (1000 * ((off < 0 ? -off : off) - slope.major) > allowed) return "too far off at " + std::to_string(k);
    if (2 * Wide{slope.minor} * k + slope.major - slope.tie < 2 * Wide{slope.major} * row ||
        2 * Wide{slope.minor} * k + slope.major - slope.tie >= 2 * Wide{slope.major} * (row + 1))
      ++wrong;
  }
  if (wrong > Rung::wrong_pixels(length)) return std::to_string(wrong) + " wrong pixels";
  if (row != Rung{}(slope, length)) return "steps that don't end where they should";
  return "";
}

template <class Rung>
class LineRungs : public testing::Test {};
TYPED_TEST_SUITE(LineRungs, Family);

TYPED_TEST(LineRungs, KeepTheirBoundsOnEveryShortLine) {
  const unsigned longest = oracle::samples(260U, 1000U);
  for (unsigned major = 1; major <= longest; major += major < 190 ? 1 : 7)
    for (unsigned minor = 0; minor <= major; ++minor)
      for (const unsigned tie : {0U, 1U})
        ASSERT_EQ(broken_claim<TypeParam>({major, minor, tie}), "") << major << " " << minor << " " << tie;
}

TYPED_TEST(LineRungs, KeepTheirBoundsOnLongLines) {
  oracle::Random random(27);
  const int count = oracle::samples(30, 1000);
  for (int i = 0; i < count; ++i) {
    const int major = random.between(1, 2 * limit >> random.between(0, 6));
    // Next to a ratio of small numbers, or anywhere.
    const int q = random.between(2, 12);
    const long near = static_cast<long>(major) * random.between(0, q) / q;
    const int minor = i % 2 == 0 ? random.between(0, major)
                                 : std::clamp(static_cast<int>(near) + random.between(-2, 2), 0, major);
    const LineSlope slope{static_cast<unsigned>(major), static_cast<unsigned>(minor), i % 3 == 0 ? 1U : 0U};
    ASSERT_EQ(broken_claim<TypeParam>(slope), "") << random.seed_text() << ": " << major << " " << minor;
  }
}

// The pixels of a rung's line in a window by definition, compared with what is drawn.
template <class Rung>
std::string fault(Point a, Point b, const Rect& clip) {
  RecordingSink sink(clip);
  RecordingSink expected(clip);
  const std::string name =
      std::to_string(a.x) + "," + std::to_string(a.y) + " " + std::to_string(b.x) + "," + std::to_string(b.y);
  if (!draw_line_by<Rung>(sink, a, b).ok()) return name + " refused";
  if (!sink.violation().empty()) return name + sink.violation();
  if (a.x > b.x) std::swap(a, b);
  const int dx = b.x - a.x;
  const int dy = std::abs(b.y - a.y);
  const int down = b.y < a.y ? -1 : 1;
  const bool steep = dy > dx;
  const LineSlope slope{static_cast<unsigned>(steep ? dy : dx), static_cast<unsigned>(steep ? dx : dy),
                        down < 0 && !steep ? 1U : 0U};
  // Only the steps beside the window.
  const int from = steep ? (down > 0 ? clip.y - a.y : a.y - clip.bottom()) : clip.x - a.x;
  const int to = from + (steep ? clip.height : clip.width) + 1;
  for (int k = std::max(from, 0); k <= std::min(to, static_cast<int>(slope.major)); ++k) {
    const int j = row_of(slope, bits_of<Rung>, k);
    const int x = a.x + (steep ? j : k);
    const int y = a.y + down * (steep ? k : j);
    if (x >= clip.x && x < clip.right() && y >= clip.y && y < clip.bottom()) expected.span(y, x, x + 1);
  }
  return sink.all_writes() == expected.all_writes() ? "" : name + "\n" + sink.ascii() + expected.ascii();
}

TYPED_TEST(LineRungs, DrawEveryShortLineAsTheDefaultDoesInAllOctants) {
  const int reach = oracle::samples(25, 128);
  int faults = 0;
  RecordingSink rung({-reach, -reach, 2 * reach + 1, 2 * reach + 1});
  RecordingSink exact = rung;
  for (int dy = -reach; dy <= reach; ++dy)
    for (int dx = -reach; dx <= reach; ++dx) {
      rung.clear();
      exact.clear();
      EXPECT_TRUE(draw_line_by<TypeParam>(rung, {0, 0}, {dx, dy}).ok());
      EXPECT_TRUE(draw_line(exact, {0, 0}, {dx, dy}).ok());
      faults += rung.all_writes() != exact.all_writes() || !rung.violation().empty() ? 1 : 0;
    }
  EXPECT_EQ(faults, 0);
}

TYPED_TEST(LineRungs, ClippingChangesNoPixelOfLongLines) {
  oracle::Random random(28);
  const auto point = [&](int reach) {
    return Point{random.between(-reach, reach), random.between(-reach, reach)};
  };
  int visible = 0;
  const int count = oracle::samples(2000, 100000);
  for (int i = 0; i < count; ++i) {
    const int reach = limit >> random.between(0, 14);
    const Point a = point(reach);
    const Point b = point(reach);
    const long along = random.between(0, 1000);
    const int x = static_cast<int>(a.x + (long{b.x} - a.x) * along / 1000);
    const int y = static_cast<int>(a.y + (long{b.y} - a.y) * along / 1000);
    const int size = random.between(1, 30);
    const Rect clip{std::clamp(x - random.between(-3, size), -limit, limit - size),
                    std::clamp(y - random.between(-3, size), -limit, limit - size), size, size};
    ASSERT_EQ(fault<TypeParam>(a, b, clip), "") << random.seed_text();
    ASSERT_EQ(fault<TypeParam>(b, a, clip), "") << random.seed_text();
    RecordingSink sink(clip);
    ASSERT_TRUE(draw_line_by<TypeParam>(sink, a, b).ok());
    visible += sink.touched() > 0 ? 1 : 0;
  }
  EXPECT_GT(visible, count / 2);
}

TYPED_TEST(LineRungs, RefuseWhatIsOutsideTheDomain) {
  RecordingSink sink({-10, -10, 20, 20});
  const Status point{Error::out_of_domain, Argument::point};
  for (const int bad : {limit + 1, -limit - 1, INT_MAX, INT_MIN}) {
    EXPECT_EQ(draw_line_by<TypeParam>(sink, {bad, 0}, {0, 0}), point);
    EXPECT_EQ(draw_line_by<TypeParam>(sink, {0, 0}, {0, bad}), point);
  }
  EXPECT_EQ(sink.spans(), 0);
  EXPECT_TRUE(draw_line_by<TypeParam>(RecordingSink({0, 0, 0, 0}), {-9, -9}, {9, 9}).ok());
  EXPECT_TRUE(draw_line_by<TypeParam>(sink, {3, 3}, {3, 3}).ok());
  EXPECT_EQ(sink.touched(), 1);
}

TEST(SubPixelLine, TakesEndsBesideTheMiddlesOfPixelsToo) {
  RecordingSink drawn({0, 0, 40, 40});
  RecordingSink expected({0, 0, 40, 40});
  const SubPoint a{700, -5000};
  const SubPoint b{9001, 12345};
  EXPECT_TRUE(SubPixelLine{}(drawn, a, b).ok());
  EXPECT_TRUE(draw_line(expected, a, b).ok());
  EXPECT_GT(drawn.touched(), 10);
  EXPECT_EQ(drawn.all_writes(), expected.all_writes());
}

TEST(LineRungBounds, AreNeitherLooserNorTighterThanTheRungs) {
  // The longest line, with a slope whose error is nearly one unit of its last place: line1 ends 16 rows off.
  const LineSlope slope{2 * limit, limit + 1, 0};
  EXPECT_EQ(RoundedLine{}(slope, 2 * limit) - ExactLine{}(slope, 2 * limit), 31);
  EXPECT_EQ(RoundedLine::bound.thousandths, 32000);
  EXPECT_EQ(SplitErrorLine::bound.thousandths, 1);
  EXPECT_TRUE(ExactLine::bound.exact());
  EXPECT_TRUE(DistanceLine::bound.exact());
  EXPECT_TRUE(SubPixelLine::bound.exact());
  // Up to these lengths all are exact.
  EXPECT_EQ(RoundedLine::wrong_pixels(181), 0);
  EXPECT_EQ(SplitErrorLine::wrong_pixels(46340), 0);
  EXPECT_GT(RoundedLine::wrong_pixels(182), 0);
  // A line that isn't.
  int wrong = 0;
  for (int k = 0; k <= 1000; ++k)
    wrong += RoundedLine{}({1000, 931, 0}, k) != ExactLine{}({1000, 931, 0}, k) ? 1 : 0;
  EXPECT_GT(wrong, 10);
}

}  // namespace
