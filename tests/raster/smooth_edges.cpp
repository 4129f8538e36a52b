// SPDX-License-Identifier: MIT
//
// Antialiased lines, and edges whose levels are Bresenham's error term.
#include <intaglio/raster/convex.hpp>
#include <intaglio/raster/pitteway.hpp>
#include <intaglio/raster/smooth_line.hpp>
#include <tests/oracle/coverage.hpp>
#include <tests/oracle/level_sink.hpp>
#include <tests/oracle/random.hpp>
#include <tests/oracle/samples.hpp>
#include <tests/raster/contours.hpp>
#include <tests/raster/half_planes.hpp>

#include <climits>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace intaglio;
using linear::Rect;
using linear::SubPoint;
using oracle::Contour;
using oracle::LevelSink;
using oracle::Random;
using raster::Cap;
using raster::CoverageCell;
using raster::draw_smooth_line;
using raster::fill_convex_pitteway;
using tests::half_plane;

constexpr int limit = 1 << 28;

LevelSink line_levels(SubPoint a, SubPoint b, int width, Cap cap, const Rect& clip) {
  LevelSink sink(clip);
  const std::size_t edges = cap == Cap::round ? raster::smooth_line_vertices : 4;
  std::vector<CoverageCell> workspace(raster::coverage_cells(edges, clip.width));
  EXPECT_TRUE(draw_smooth_line(sink, a, b, width, cap, workspace).ok());
  EXPECT_FALSE(sink.bad());
  return sink;
}

/// The true rectangle of a line, to 60 binary places.
oracle::CutContour rectangle(SubPoint a, SubPoint b, int width, bool square) {
  const long double dx = static_cast<long double>(b.x) - a.x;
  const long double dy = static_cast<long double>(b.y) - a.y;
  const long double length = std::sqrt(dx * dx + dy * dy);
  const auto part = [&](long double d) -> mpq_class {
    return mpq_class(static_cast<long>(std::round(std::ldexp(d / length * width / 2, 40)))) / (1L << 40);
  };
  const mpq_class x = part(dx);
  const mpq_class y = part(dy);
  const int out = square ? 1 : 0;
  return {{a.x - out * x - y, a.y - out * y + x},
          {b.x + out * x - y, b.y + out * y + x},
          {b.x + out * x + y, b.y + out * y - x},
          {a.x - out * x + y, a.y - out * y - x}};
}

TEST(SmoothLine, LevelsAreTheAreaOfTheLinesTrueWidth) {
  Random random(51);
  mpq_class worst = 0;
  for (int i = 0; i < oracle::samples(60, 3000); ++i) {
    const SubPoint a{random.between(-1500, 1500), random.between(-1500, 1500)};
    const SubPoint b{random.between(-1500, 1500), i % 5 == 0 ? a.y + i % 3 : random.between(-1500, 1500)};
    if (a == b) continue;
    const int width = random.between(1, i % 2 == 0 ? 300 : 1200);
    const Cap cap = i % 3 == 0 ? Cap::square : Cap::butt;
    const LevelSink sink = line_levels(a, b, width, cap, {-8, -8, 17, 17});
    const auto ideal = rectangle(a, b, width, cap == Cap::square);
    for (int y = -8; y < 9; ++y)
      for (int x = -8; x < 9; ++x)
        worst =
            std::max<mpq_class>(worst, abs(255 * abs(oracle::signed_area(ideal, x, y)) - sink.level(x, y)));
  }
  // Half a level, and one for each of four sides.
  EXPECT_LE(worst.get_d(), 4.5) << random.seed_text();
  EXPECT_GT(worst.get_d(), 0.5);  // the corners are rounded: a bound of half a level would be a lie
}

/// The area of a pixel within half of `width` of the line from `a` to `b`, in pixels: rows of no height, each
/// as wide as the disc of one end or the other or what is between them is.
double round_area(SubPoint a, SubPoint b, int width, int x, int y) {
  constexpr int rows = 1024;
  const double r = width / 512.0;
  const double ax = a.x / 256.0;
  const double ay = a.y / 256.0;
  const double dx = b.x / 256.0 - ax;
  const double dy = b.y / 256.0 - ay;
  const double length = std::hypot(dx, dy);
  double area = 0;
  for (int i = 0; i < rows; ++i) {
    const double row = y - 0.5 + (i + 0.5) / rows;
    double left = 1e9;
    double right = -1e9;
    const auto reach = [&](double from, double to) {
      left = std::min(left, from);
      right = std::max(right, to);
    };
    for (const double t : {0.0, 1.0}) {
      const double down = row - (ay + t * dy);
      const double half = std::sqrt(std::max(0.0, r * r - down * down));
      if (std::abs(down) < r) reach(ax + t * dx - half, ax + t * dx + half);
    }
    if (length > 0) {
      const double nx = -dy / length * r;
      const double ny = dx / length * r;
      const std::array<std::array<double, 2>, 4> corners{{{ax + nx, ay + ny},
                                                          {ax + dx + nx, ay + dy + ny},
                                                          {ax + dx - nx, ay + dy - ny},
                                                          {ax - nx, ay - ny}}};
      for (std::size_t k = 0; k < 4; ++k) {
        const auto& p = corners[k];
        const auto& q = corners[(k + 1) % 4];
        if ((p[1] <= row) == (q[1] <= row)) continue;
        const double at = p[0] + (q[0] - p[0]) * (row - p[1]) / (q[1] - p[1]);
        reach(at, at);
      }
    }
    area += std::max(0.0, std::min(right, x + 0.5) - std::max(left, x - 0.5)) / rows;
  }
  return area;
}

TEST(SmoothLine, RoundEndsAreTheAreaWithinHalfTheWidth) {
  Random random(54);
  double worst = 0;
  for (int i = 0; i < oracle::samples(20, 3000); ++i) {
    const SubPoint a{random.between(-1500, 1500), random.between(-1500, 1500)};
    const SubPoint b = i % 5 == 0 ? a : SubPoint{random.between(-1500, 1500), random.between(-1500, 1500)};
    const int width = random.between(1, i % 3 == 0 ? 300 : i % 3 == 1 ? 1200 : 6000);
    const LevelSink sink = line_levels(a, b, width, Cap::round, {-8, -8, 17, 17});
    for (int y = -8; y < 9; ++y)
      for (int x = -8; x < 9; ++x)
        worst = std::max(worst, std::abs(255 * round_area(a, b, width, x, y) - sink.level(x, y)));
  }
  // What smooth_line.hpp says was found.
  EXPECT_LE(worst, 2.1) << random.seed_text();
  EXPECT_GT(worst, 0.5);
}

TEST(SmoothLine, AlongRowsAndColumnsLevelsAreExact) {
  // Half a pixel wide, from 1/4 into column 1 to the middle of column 4.
  const LevelSink flat = line_levels({192, 512}, {1024, 512}, 128, Cap::butt, {0, 0, 8, 8});
  const LevelSink steep = line_levels({512, 192}, {512, 1024}, 128, Cap::butt, {0, 0, 8, 8});
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) {
      const int expected = y != 2 || x < 1 || x > 4 ? 0 : x == 1 ? 96 : x == 4 ? 64 : 128;
      EXPECT_EQ(flat.level(x, y), expected);
      EXPECT_EQ(steep.level(y, x), expected);
    }
}

TEST(SmoothLine, FromBothEndsItIsTheSameLine) {
  Random random(52);
  int wrong = 0;
  for (int i = 0; i < 300; ++i) {
    const SubPoint a{random.between(-2000, 2000) << i % 16, random.between(-2000, 2000) << i % 16};
    const SubPoint b{-a.x + random.between(0, 300), -a.y + random.between(0, 300)};
    const Cap cap = static_cast<Cap>(i % 3);
    const LevelSink there = line_levels(a, b, 1 + i, cap, {-8, -8, 17, 17});
    const LevelSink back = line_levels(b, a, 1 + i, cap, {-8, -8, 17, 17});
    for (int y = -8; y < 9; ++y)
      for (int x = -8; x < 9; ++x) wrong += there.level(x, y) != back.level(x, y) ? 1 : 0;
  }
  EXPECT_EQ(wrong, 0) << random.seed_text();
}

TEST(SmoothLine, BadArgumentsAreNamedAndNothingIsHandedOver) {
  LevelSink sink({0, 0, 20, 20});
  std::vector<CoverageCell> workspace(raster::coverage_cells(4, 20));
  const auto draw = [&](SubPoint a, int width, Cap cap = Cap::butt) {
    return draw_smooth_line(sink, a, {2560, 2560}, width, cap, workspace);
  };
  for (const int bad : {limit + 1, INT_MAX, INT_MIN}) {
    EXPECT_EQ(draw({bad, 0}, 256), (Status{Error::out_of_domain, Argument::point}));
    EXPECT_EQ(draw({0, 0}, bad), (Status{Error::out_of_domain, Argument::width}));
  }
  EXPECT_EQ(draw({0, 0}, 256, static_cast<Cap>(7)), (Status{Error::out_of_range, Argument::rule}));
  EXPECT_EQ(draw({limit, 0}, 256, Cap::round), (Status{Error::out_of_domain, Argument::point}));
  workspace.resize(3);
  EXPECT_EQ(draw({0, 0}, 256), (Status{Error::too_small, Argument::workspace,
                                       static_cast<std::uint32_t>(raster::coverage_cells(4, 11))}));
  EXPECT_EQ(sink.spans(), 0);
}

LevelSink pitteway(const Contour& contour, const Rect& clip) {
  LevelSink sink(clip);
  EXPECT_TRUE(fill_convex_pitteway(sink, contour).ok()) << tests::text(oracle::Contours{contour});
  EXPECT_FALSE(sink.bad()) << tests::text(oracle::Contours{contour});
  return sink;
}

TEST(Pitteway, OnePixelAStepIsAtMostAnEighthOfTheSlopeFromTheArea) {
  Random random(53);
  std::string fault;
  mpq_class worst = 0;
  for (int i = 0; i < oracle::samples(150, 5000) && fault.empty(); ++i) {
    const int size = 6000 << i % 14;
    SubPoint a{random.between(-size, size), random.between(-size, size)};
    if (std::abs(a.x) < size / 2) a.x = a.x < 0 ? -size : size;
    if (i % 7 == 0) a.y = a.x + random.between(-5, 5);  // 45 degrees is the worst
    if (i % 11 == 0) a.y = 0;
    if (i % 2 == 0) std::swap(a.x, a.y);
    const SubPoint b{-a.x + random.between(0, 400), -a.y + random.between(0, 400)};
    const Contour contour = half_plane(a, b);
    const LevelSink sink = pitteway(contour, {-6, -6, 13, 13});
    const long dx = std::labs(long{b.x} - a.x);
    const long dy = std::labs(long{b.y} - a.y);
    const mpq_class slope(std::min(dx, dy), std::max(dx, dy));
    for (int y = -6; y < 7; ++y)
      for (int x = -6; x < 7; ++x) {
        const mpq_class off = abs(255 * oracle::coverage({contour}, true, x, y) - sink.level(x, y));
        worst = std::max(worst, off);
        if (off > 255 * slope / 8 + mpq_class(1, 2))
          fault = tests::text(oracle::Contours{contour}) + " pixel " + std::to_string(x) + "," +
                  std::to_string(y) + " off by " + std::to_string(off.get_d());
      }
    // Along the major axis no step has a second pixel between nothing and full.
    for (int step = -6; step < 7; ++step) {
      int between = 0;
      for (int across = -6; across < 7; ++across) {
        const int level = dx >= dy ? sink.level(step, across) : sink.level(across, step);
        between += level != 0 && level != 255 ? 1 : 0;
      }
      if (between > 1)
        fault = tests::text(oracle::Contours{contour}) + ": two pixels in step " + std::to_string(step);
    }
  }
  EXPECT_EQ(fault, "") << random.seed_text();
  EXPECT_GT(worst.get_d(), 30.0);  // so the bound says something
}

TEST(Pitteway, EdgesAlongRowsAndColumnsAreExact) {
  const Contour box{{-320, -700}, {450, -700}, {450, 333}, {-320, 333}};
  const LevelSink sink = pitteway(box, {-5, -5, 11, 11});
  int wrong = 0;
  for (int y = -5; y < 6; ++y)
    for (int x = -5; x < 6; ++x) {
      if ((x == -1 || x == 2) && (y == -3 || y == 1)) continue;  // corners
      const mpq_class off = abs(255 * oracle::coverage({box}, true, x, y) - sink.level(x, y));
      wrong += off > mpq_class(1, 2) ? 1 : 0;
    }
  EXPECT_EQ(wrong, 0);
}

TEST(Pitteway, AtTheCornersOfConvexPolygonsTheErrorStaysBounded) {
  Random random(54);
  mpq_class worst = 0;
  for (int i = 0; i < oracle::samples(150, 3000); ++i) {
    Contour contour;
    const int corners = i % 2 == 0 ? 3 : random.between(3, 12);
    const double turn = random.between(0, 999);
    const int radius = random.between(200, 1700);
    for (int n = 0; n < corners; ++n) {
      const double angle = turn + 2 * 3.14159265 * n / corners;
      contour.push_back(
          {static_cast<int>(radius * std::cos(angle)), static_cast<int>(radius * std::sin(angle))});
      if (i % 2 == 0) contour.back() = {random.between(-1400, 1400), random.between(-1400, 1400)};
    }
    if (!raster::is_convex(contour)) continue;  // rounding
    const LevelSink sink = pitteway(contour, {-7, -7, 15, 15});
    for (int y = -7; y < 8; ++y)
      for (int x = -7; x < 8; ++x)
        worst =
            std::max<mpq_class>(worst, abs(255 * oracle::coverage({contour}, true, x, y) - sink.level(x, y)));
  }
  EXPECT_LE(worst.get_d(), 72.0) << random.seed_text();
  EXPECT_GT(worst.get_d(), 40.0);
}

TEST(Pitteway, PolygonsThatShareAnEdgeAddUpToFull) {
  Random random(55);
  int wrong = 0;
  for (int i = 0; i < 400; ++i) {
    const int bound = 2048 << i % 17;
    const int step = i % 3 == 0 ? 128 : 1;  // ties
    const SubPoint a{-bound, random.between(-bound, bound) / step * step};
    const SubPoint b{bound, random.between(-bound, bound) / step * step};
    const bool upright = i % 2 == 0;
    const auto turned = [&](SubPoint p) { return upright ? SubPoint{p.y, p.x} : p; };
    const LevelSink top =
        pitteway({turned(a), turned({-bound, -bound}), turned({bound, -bound}), turned(b)}, {-7, -7, 15, 15});
    const LevelSink bottom =
        pitteway({turned(b), turned({bound, bound}), turned({-bound, bound}), turned(a)}, {-7, -7, 15, 15});
    for (int y = -7; y < 8; ++y)
      for (int x = -7; x < 8; ++x) wrong += top.level(x, y) + bottom.level(x, y) != 255 ? 1 : 0;
  }
  EXPECT_EQ(wrong, 0) << random.seed_text();
}

TEST(Pitteway, VerticesAlongASideAndRepeatedOnesChangeNothing) {
  const Contour plain{{-900, -500}, {1200, -300}, {300, 1500}};
  Contour halves{{-900, -500}, {-900, -500}, {150, -400}, {1200, -300}, {900, 300}, {750, 600}, {300, 1500}};
  const LevelSink expected = pitteway(plain, {-8, -8, 17, 17});
  for (int i = 0; i < 7; ++i) {
    std::rotate(halves.begin(), halves.begin() + 1, halves.end());
    const LevelSink sink = pitteway(halves, {-8, -8, 17, 17});
    std::reverse(halves.begin(), halves.end());
    const LevelSink back = pitteway(halves, {-8, -8, 17, 17});
    std::reverse(halves.begin(), halves.end());
    int wrong = 0;
    for (int y = -8; y < 9; ++y)
      for (int x = -8; x < 9; ++x)
        wrong += sink.level(x, y) != expected.level(x, y) || back.level(x, y) != expected.level(x, y) ? 1 : 0;
    EXPECT_EQ(wrong, 0) << i;
  }
}

TEST(Pitteway, AnyWindowSeesTheUnclippedLevels) {
  Random random(56);
  int wrong = 0;
  for (int i = 0; i < 60; ++i) {
    Contour contour;
    for (int n = 0; n < 3; ++n)
      contour.push_back({random.between(-3000, 3000) << i % 12, random.between(-3000, 3000) << i % 12});
    const LevelSink whole = pitteway(contour, {-12, -12, 25, 25});
    for (int n = 0; n < 10; ++n) {
      const Rect clip{random.between(-12, 8), random.between(-12, 8), random.between(1, 4),
                      random.between(1, 4)};
      const LevelSink part = pitteway(contour, clip);
      for (int y = clip.y; y < clip.bottom(); ++y)
        for (int x = clip.x; x < clip.right(); ++x) wrong += part.level(x, y) != whole.level(x, y) ? 1 : 0;
    }
  }
  EXPECT_EQ(wrong, 0) << random.seed_text();
}

TEST(Pitteway, ToTheDomainsEdgeAndBeyondIt) {
  const Contour all{{-limit, -limit}, {limit, -limit}, {limit, limit}, {-limit, limit}};
  const LevelSink full = pitteway(all, {-3, -3, 7, 7});
  for (int x = -3; x < 4; ++x) EXPECT_EQ(full.level(x, 0), 255);
  const int edge = (1 << 20) - 2;
  const LevelSink corner = pitteway(all, {edge, edge, 3, 3});
  EXPECT_EQ(corner.level(edge + 1, edge), 255);
  EXPECT_EQ(corner.level(edge + 2, edge), 127);  // a tie, and the right edge doesn't own it
  LevelSink sink({0, 0, 9, 9});
  for (const int bad : {limit + 1, INT_MAX, INT_MIN})
    EXPECT_EQ(fill_convex_pitteway(sink, Contour{{0, 0}, {2000, bad}, {0, 2000}}),
              (Status{Error::out_of_domain, Argument::vertices}));
  EXPECT_EQ(fill_convex_pitteway(sink, Contour{{0, 0}, {2000, 0}, {500, 500}, {0, 2000}}),
            (Status{Error::malformed, Argument::vertices}));
  EXPECT_TRUE(fill_convex_pitteway(sink, Contour{}).ok());
  EXPECT_TRUE(fill_convex_pitteway(sink, Contour{{0, 0}, {2000, 2000}, {1000, 1000}}).ok());
  EXPECT_EQ(sink.spans(), 0);
}

}  // namespace
