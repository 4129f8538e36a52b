// SPDX-License-Identifier: MIT
#include <intaglio/raster/disc.hpp>
#include <intaglio/raster/ring.hpp>
#include <intaglio/raster/round_rect.hpp>
#include <tests/oracle/circle.hpp>
#include <tests/oracle/random.hpp>
#include <tests/oracle/recording_sink.hpp>
#include <tests/oracle/samples.hpp>
#include <tests/oracle/span_list.hpp>

#include <climits>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::linear::Point;
using intaglio::linear::Rect;
using intaglio::raster::CornerRadii;
using intaglio::raster::draw_round_rect;
using intaglio::raster::fill_disc;
using intaglio::raster::fill_ring;
using intaglio::raster::fill_round_rect;
using oracle::RecordingSink;

constexpr int limit = 1 << 20;

bool in_disc(int radius, int dx, int dy) { return std::abs(dx) <= oracle::outline_reach(radius, dy); }

// The four radii clockwise from the top left, made to fit: all multiplied by the smallest length/sum.
std::array<int, 4> fitted(int width, int height, const CornerRadii& given) {
  const std::array<int, 4> r{given.top_left, given.top_right, given.bottom_right, given.bottom_left};
  oracle::Wide n = 1;
  oracle::Wide d = 1;
  for (std::size_t side = 0; side < 4; ++side) {
    const oracle::Wide length = (side % 2 == 0 ? width : height) - 1;
    const oracle::Wide sum = oracle::Wide{r[side]} + r[(side + 1) % 4];
    if (length * d < n * sum) n = length, d = sum;
  }
  std::array<int, 4> result{};
  for (std::size_t i = 0; i < 4; ++i) result[i] = static_cast<int>(r[i] * n / d);
  return result;
}

bool in_round_rect(const Rect& rect, const std::array<int, 4>& radii, int x, int y) {
  if (x < rect.x || y < rect.y || x >= rect.x + rect.width || y >= rect.y + rect.height) return false;
  for (std::size_t corner = 0; corner < 4; ++corner) {
    // Seen from the corner, inwards.
    const bool right = corner == 1 || corner == 2;
    const bool lower = corner >= 2;
    const int column = right ? rect.x + rect.width - 1 - x : x - rect.x;
    const int row = lower ? rect.y + rect.height - 1 - y : y - rect.y;
    const int r = radii[corner];
    if (column < r && row < r && !in_disc(r, column - r, row - r)) return false;
  }
  return true;
}

std::string fault(const Rect& rect, const CornerRadii& radii, const Rect& clip) {
  RecordingSink filled(clip);
  RecordingSink outline(clip);
  const std::string name = std::to_string(rect.width) + "x" + std::to_string(rect.height) + " radii " +
                           std::to_string(radii.top_left) + " " + std::to_string(radii.top_right) + " " +
                           std::to_string(radii.bottom_right) + " " + std::to_string(radii.bottom_left) +
                           ": ";
  if (!fill_round_rect(filled, rect, radii).ok() || !draw_round_rect(outline, rect, radii).ok())
    return name + "refused";
  if (!filled.violation().empty() || !outline.violation().empty())
    return name + filled.violation() + outline.violation();
  const auto fit = fitted(rect.width, rect.height, radii);
  const auto in = [&](int x, int y) { return in_round_rect(rect, fit, x, y); };
  for (int y = clip.y; y < clip.y + clip.height; ++y)
    for (int x = clip.x; x < clip.x + clip.width; ++x) {
      const bool inside = in(x, y);
      const bool edge = inside && !(in(x - 1, y) && in(x + 1, y) && in(x, y - 1) && in(x, y + 1));
      if (filled.writes(x, y) != (inside ? 1 : 0) || outline.writes(x, y) != (edge ? 1 : 0))
        return name + "pixel " + std::to_string(x) + "," + std::to_string(y) + "\n" + filled.ascii() +
               outline.ascii();
    }
  return "";
}

TEST(RoundRect, SmallOnesWithOneRadiusAreExactWhateverTheRadius) {
  std::string first_fault;
  for (int w = 1; w <= 14; ++w)
    for (int h = 1; h <= 14; ++h)
      for (int r = 0; r <= 16 && first_fault.empty(); ++r)
        first_fault = fault({2, 3, w, h}, CornerRadii::all(r), {0, 0, 18, 19});
  EXPECT_EQ(first_fault, "");
}

TEST(RoundRect, RandomOnesWithFourRadiiAndWindowsAreExact) {
  oracle::Random random(33);
  std::string first_fault;
  for (int i = 0; i < oracle::samples(3000, 40000) && first_fault.empty(); ++i) {
    const Rect rect{random.between(-9, 9), random.between(-9, 9), random.between(1, 40),
                    random.between(1, 40)};
    const auto radius = [&] { return random.between(0, 3) == 0 ? 0 : random.between(0, 50); };
    const int a = radius();
    const int b = radius();
    const int c = radius();
    const CornerRadii radii{a, b, c, radius()};
    first_fault = fault(
        rect, radii,
        {random.between(-12, 20), random.between(-12, 20), random.between(1, 60), random.between(1, 60)});
  }
  EXPECT_EQ(first_fault, "") << random.seed_text();
}

TEST(RoundRect, LargestOnesAreExactAtTheirCorners) {
  std::string first_fault;
  const Rect rect{-limit, -limit, 2 * limit, 2 * limit};
  for (const int r : {0, 100, 70000, limit - 1, limit})
    for (const int x : {-limit, limit - 60})
      for (const int y : {-limit, limit - 60, -limit / 3})
        if (first_fault.empty()) first_fault = fault(rect, {r, r / 2, r / 3, r}, {x, y, 60, 60});
  EXPECT_EQ(first_fault, "");
}

TEST(RoundRect, ASquareWithTheLargestRadiusIsTheDisc) {
  for (int r = 0; r <= 40; ++r) {
    RecordingSink square({0, 0, 90, 90});
    RecordingSink disc({0, 0, 90, 90});
    ASSERT_TRUE(fill_round_rect(square, {4, 5, 2 * r + 1, 2 * r + 1}, CornerRadii::all(r + r / 2)).ok());
    ASSERT_TRUE(fill_disc(disc, {4 + r, 5 + r}, r).ok());
    ASSERT_EQ(square.all_writes(), disc.all_writes()) << r;
  }
}

TEST(RoundRect, BadArgumentsAreNamedAndNothingIsDrawn) {
  RecordingSink sink({0, 0, 8, 8});
  const Status bad_radius{Error::out_of_domain, Argument::radius};
  const Status bad_rectangle{Error::out_of_domain, Argument::rectangle};
  for (const int r : {-1, INT_MIN, limit + 1, INT_MAX})
    for (const CornerRadii radii : {CornerRadii{r, 0, 0, 0}, {0, r, 0, 0}, {0, 0, r, 0}, {0, 0, 0, r}}) {
      EXPECT_EQ(fill_round_rect(sink, {0, 0, 8, 8}, radii), bad_radius);
      EXPECT_EQ(draw_round_rect(sink, {0, 0, 8, 8}, radii), bad_radius);
    }
  for (const Rect rect :
       {Rect{INT_MIN, 0, 3, 3}, {0, limit + 1, 3, 3}, {0, 0, INT_MAX, 3}, {0, 0, 3, INT_MIN}}) {
    EXPECT_EQ(fill_round_rect(sink, rect, {}), bad_rectangle);
    EXPECT_EQ(draw_round_rect(sink, rect, {}), bad_rectangle);
  }
  for (const Rect rect : {Rect{1, 1, 0, 4}, {1, 1, 4, 0}, {1, 1, -3, 4}, {1, 1, 4, -2 * limit}}) {
    EXPECT_TRUE(fill_round_rect(sink, rect, CornerRadii::all(2)).ok());
    EXPECT_TRUE(draw_round_rect(sink, rect, CornerRadii::all(2)).ok());
  }
  EXPECT_EQ(sink.spans(), 0);
}

TEST(Ring, IsTheOuterDiscWithoutTheInnerOneForAllRadiiTo40) {
  for (int outer = 0; outer <= 40; ++outer)
    for (int inner = 0; inner <= outer; ++inner) {
      RecordingSink sink({-42, -42, 80, 85});
      ASSERT_TRUE(fill_ring(sink, {0, 0}, inner, outer).ok());
      ASSERT_EQ(sink.violation(), "");
      bool same = true;
      for (int y = -42; y < 43; ++y) {
        const int outer_reach = oracle::outline_reach(outer, y);
        const int inner_reach = oracle::outline_reach(inner, y);
        for (int x = -42; x < 38; ++x)
          same =
              same && sink.writes(x, y) == (std::abs(x) <= outer_reach && std::abs(x) > inner_reach ? 1 : 0);
      }
      ASSERT_TRUE(same) << inner << "," << outer;
    }
}

// Every outer radius with the inner radii next to it and next to nothing, and some between: all the rows, by
// the reaches of the two discs.
TEST(Ring, EveryOuterRadiusTo3000IsExactWithManyInnerOnes) {
  constexpr int largest = 3000;
  const int all = oracle::samples(150, largest);
  std::vector<std::vector<int>> reaches;  // by radius and row
  for (int r = 0; r <= largest; ++r) {
    reaches.emplace_back();
    if (r <= all || r % 59 == 0)
      for (int y = 0; y <= r; ++y) reaches.back().push_back(oracle::outline_reach(r, y));
  }
  oracle::Random random(34);
  oracle::SpanList list;
  std::vector<oracle::Span> expected;
  for (int outer = 0; outer <= largest; ++outer) {
    std::vector<int> inners{0, 1, 2, 3, outer / 2, outer - 3, outer - 2, outer - 1, outer};
    for (int i = 0; i < 8; ++i) inners.push_back(random.between(0, outer));
    for (const int inner : inners) {
      if (inner < 0 || inner > outer) continue;
      const auto& far = reaches[static_cast<std::size_t>(outer)];
      const auto& near = reaches[static_cast<std::size_t>(inner)];
      if (far.empty() || near.empty()) continue;
      expected.clear();
      for (int y = -outer; y <= outer; ++y) {
        const auto row = static_cast<std::size_t>(std::abs(y));
        const int to = far[row];
        const int from = row < near.size() ? near[row] : -1;
        if (from < 0) {
          expected.push_back({y, -to, to + 1});
        } else if (from < to) {
          expected.push_back({y, -to, -from});
          expected.push_back({y, from + 1, to + 1});
        }
      }
      list.clear();
      ASSERT_TRUE(fill_ring(list, {0, 0}, inner, outer).ok());
      ASSERT_TRUE(list.joined() == expected) << inner << "," << outer;
    }
  }
}

TEST(Ring, LargeOnesAreExactInWindows) {
  oracle::Random random(35);
  for (int i = 0; i < oracle::samples(300, 20000); ++i) {
    const int outer = random.between(1000, limit);
    const int inner = outer - random.between(0, 30);
    const int dy = random.between(-outer, outer);
    const Point centre{random.between(-50, 50), -dy};
    const int reach = oracle::outline_reach(outer, dy);
    const Rect clip{std::clamp(centre.x - reach - 10, -limit, limit), 0, 60, 12};
    RecordingSink sink(clip);
    ASSERT_TRUE(fill_ring(sink, centre, inner, outer).ok());
    for (int y = 0; y < 12; ++y) {
      const int outer_reach = oracle::outline_reach(outer, y - centre.y);
      const int inner_reach = oracle::outline_reach(inner, y - centre.y);
      for (int x = clip.x; x < clip.x + 60; ++x) {
        const int distance = std::abs(x - centre.x);
        ASSERT_EQ(sink.writes(x, y), distance <= outer_reach && distance > inner_reach ? 1 : 0)
            << random.seed_text() << " " << i;
      }
    }
  }
}

TEST(Ring, BadArgumentsAreNamedAndNothingIsDrawn) {
  RecordingSink sink({0, 0, 8, 8});
  EXPECT_EQ(fill_ring(sink, {4, 4}, -1, 3), (Status{Error::out_of_domain, Argument::radius}));
  EXPECT_EQ(fill_ring(sink, {4, 4}, 1, INT_MAX), (Status{Error::out_of_domain, Argument::radius}));
  EXPECT_EQ(fill_ring(sink, {INT_MIN, 4}, 1, 3), (Status{Error::out_of_domain, Argument::point}));
  EXPECT_EQ(fill_ring(sink, {4, 4}, 3, 2), (Status{Error::mismatched, Argument::radius}));
  EXPECT_EQ(sink.spans(), 0);
}

}  // namespace
