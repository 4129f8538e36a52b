// SPDX-License-Identifier: MIT
//
// Coverage by samples: regular, weighted, adaptive and jittered ones, against the samples counted one by one
// and against the exact area.
#include <intaglio/image/surface.hpp>
#include <intaglio/raster/adaptive.hpp>
#include <intaglio/raster/convex.hpp>
#include <intaglio/raster/ellipse.hpp>
#include <intaglio/raster/inside.hpp>
#include <intaglio/raster/stochastic.hpp>
#include <intaglio/raster/supersample.hpp>
#include <intaglio/raster/triangle.hpp>
#include <tests/oracle/coverage.hpp>
#include <tests/oracle/level_sink.hpp>
#include <tests/oracle/polygon.hpp>
#include <tests/oracle/random.hpp>
#include <tests/oracle/samples.hpp>
#include <tests/raster/half_planes.hpp>

#include <climits>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

using namespace intaglio;
using linear::Rect;
using linear::SubPoint;
using oracle::Contour;
using oracle::Contours;
using oracle::LevelSink;
using oracle::Random;
using raster::Enlargement;
using raster::SampleCell;
using raster::SampleFilter;
using raster::supersample;
using raster::Supersampling;
using raster::supersampling_rungs;
using tests::half_plane;
using tests::random_edge;
using tests::worst_edge;

std::string text(const Supersampling& grid) {
  return (grid.filter == SampleFilter::box ? "box " : "bartlett ") + std::to_string(grid.scale) + "/" +
         std::to_string(grid.width);
}

/// Draws with so many rows of memory.
template <class Draw>
LevelSink sampled(const Supersampling& grid, const Rect& clip, int rows, Draw draw) {
  LevelSink sink(clip);
  std::vector<SampleCell> workspace(static_cast<std::size_t>(clip.width * rows));
  EXPECT_TRUE(supersample(sink, grid, workspace, draw).ok());
  EXPECT_FALSE(sink.bad()) << text(grid);
  return sink;
}

Contour enlarged(const Contour& contour, int scale) {
  Contour out;
  for (const SubPoint p : contour) out.push_back(Enlargement(scale).place(p));
  return out;
}

LevelSink sampled_triangle(const Supersampling& grid, const Rect& clip, int rows, const Contour& t) {
  const Contour e = enlarged(t, grid.scale);
  return sampled(grid, clip, rows, [&](auto& sink) { return raster::fill_triangle(sink, e[0], e[1], e[2]); });
}

/// The level of a pixel, sample by sample: places and weights straight from the rule.
int counted_level(const Supersampling& grid, const Contour& contour, int x, int y) {
  // In units of 1/(256 * scale) pixel, of which a sample has 256, vertices and samples are whole.
  Contour scaled;
  for (const SubPoint p : contour) scaled.push_back({p.x * grid.scale, p.y * grid.scale});
  const auto weight = [&](int i) {
    return grid.filter == SampleFilter::box ? 1 : std::min(i + 1, grid.width - i);
  };
  int covered = 0;
  int total = 0;
  for (int v = 0; v < grid.width; ++v)
    for (int u = 0; u < grid.width; ++u) {
      // The middle of the window is the middle of the pixel. The oracle asks at whole multiples of 256, so
      // the polygon is moved instead of the sample.
      const int px = 256 * grid.scale * x + 256 * u - 128 * (grid.width - 1);
      const int py = 256 * grid.scale * y + 256 * v - 128 * (grid.width - 1);
      Contour moved = scaled;
      for (SubPoint& p : moved) p = {p.x - px, p.y - py};
      total += weight(u) * weight(v);
      if (oracle::in_triangle(moved[0], moved[1], moved[2], 0, 0)) covered += weight(u) * weight(v);
    }
  return (2 * 255 * covered + total) / (2 * total);
}

TEST(SampleLevels, AreTheNearestForEveryTotalInUse) {
  std::vector<int> totals{400};
  for (int total = 2; total <= 256; ++total) totals.push_back(total);
  int wrong = 0;
  for (const int total : totals)
    for (int covered = -1; covered <= total + 1; ++covered)
      wrong += raster::detail::SampleLevels(total)(covered) !=
                       (2 * 255 * std::clamp(covered, 0, total) + total) / (2 * total)
                   ? 1
                   : 0;
  EXPECT_EQ(wrong, 0);
}

TEST(Supersample, LevelsAreTheWeightsOfTheSamplesInside) {
  Random random(61);
  int wrong = 0;
  for (int i = 0; i < oracle::samples(8, 400); ++i)
    for (const auto& rung : supersampling_rungs) {
      Contour t;
      // Half of them on quarters of pixels, where samples lie on edges.
      const int step = i % 2 == 0 ? 64 : 1;
      for (int n = 0; n < 3; ++n)
        t.push_back({random.between(-900, 900) / step * step, random.between(-900, 900) / step * step});
      const Rect clip{random.between(-6, 0), random.between(-6, 0), random.between(1, 8),
                      random.between(1, 8)};
      const LevelSink sink = sampled_triangle(rung.grid, clip, random.between(1, clip.height + 1), t);
      for (int y = clip.y; y < clip.bottom(); ++y)
        for (int x = clip.x; x < clip.right(); ++x)
          wrong += sink.level(x, y) != counted_level(rung.grid, t, x, y) ? 1 : 0;
    }
  EXPECT_EQ(wrong, 0) << random.seed_text();
}

LevelSink sampled_polygon(const Supersampling& grid, const Contour& contour, const Rect& clip) {
  const Contour e = enlarged(contour, grid.scale);
  return sampled(grid, clip, clip.height, [&](auto& sink) { return raster::fill_convex(sink, e); });
}

TEST(Supersample, AtEdgesEveryRungKeepsItsBound) {
  for (const auto& rung : supersampling_rungs) {
    const auto levels = [&](const Contour& c, const Rect& clip) {
      return sampled_polygon(rung.grid, c, clip);
    };
    mpq_class worst = worst_edge(62, oracle::samples(40, 2000), levels);
    for (int off = 0; off < 256; ++off) {
      const SubPoint a{-9000, off};
      const SubPoint b{9000, off};
      const LevelSink level = levels(half_plane(a, b), {0, -1, 1, 3});
      for (int y = -1; y < 2; ++y)
        worst =
            std::max<mpq_class>(worst, abs(255 * oracle::half_plane_area(a, b, 0, y) - level.level(0, y)));
    }
    EXPECT_LE(worst.get_d(), 255 * rung.bound / 1000.0 + 0.5) << text(rung.grid);
    EXPECT_GE(worst.get_d(), 255 * rung.bound / 1000.0 * 0.9 - 0.5) << text(rung.grid);  // no idle bound
  }
}

TEST(Supersample, PartsThatShareAnEdgeAddUpToTheWholeWithinTheirRounding) {
  Random random(63);
  int most = 0;
  for (int i = 0; i < 60; ++i)
    for (const auto& rung : supersampling_rungs) {
      const auto [a, b] = random_edge(random, i);
      const LevelSink one = sampled_polygon(rung.grid, half_plane(a, b), {-4, -4, 9, 9});
      const LevelSink other = sampled_polygon(rung.grid, half_plane(b, a), {-4, -4, 9, 9});
      for (int y = -4; y < 5; ++y)
        for (int x = -4; x < 5; ++x)
          most = std::max(most, std::abs(one.level(x, y) + other.level(x, y) - 255));
    }
  EXPECT_LE(most, 1) << random.seed_text();
}

TEST(Supersample, DiscsAreEnlargedAboutTheirMiddleByOddAndEvenScales) {
  for (const auto& rung : supersampling_rungs) {
    const auto& grid = rung.grid;
    const int r = 6;
    const Rect square = Enlargement(grid.scale).area({-r, -r, 2 * r + 1, 2 * r + 1});
    const LevelSink sink = sampled(grid, {-9, -9, 19, 19}, 2, [&](auto& samples) {
      return raster::fill_disc_in(samples, {square.x, square.y}, square.width);
    });
    int wrong = 0;
    long sum = 0;
    for (int y = -9; y < 10; ++y)
      for (int x = -9; x < 10; ++x) {
        wrong += sink.level(x, y) != sink.level(-x, y) || sink.level(x, y) != sink.level(y, x) ? 1 : 0;
        sum += sink.level(x, y);
      }
    EXPECT_EQ(wrong, 0) << text(grid);
    EXPECT_EQ(sink.level(0, 0), 255);
    // The area of a disc with the radius 6.5, give or take half a sample around.
    EXPECT_NEAR(static_cast<double>(sum) / 255, 3.14159 * 6.5 * 6.5, 2 * 3.14159 * 6.5 / grid.scale / 2)
        << text(grid);
  }
}

TEST(Supersample, RowsMayComeInAnyOrderAndWindowsOfAnySize) {
  Random random(64);
  int wrong = 0;
  for (int i = 0; i < 40; ++i)
    for (const auto& rung : supersampling_rungs) {
      Contour t;
      for (int n = 0; n < 3; ++n) t.push_back({random.between(-3000, 3000), random.between(-3000, 3000)});
      const LevelSink whole = sampled_triangle(rung.grid, {-8, -8, 17, 17}, 17, t);
      const Rect clip{random.between(-8, 4), random.between(-8, 4), random.between(1, 4),
                      random.between(1, 4)};
      const LevelSink part = sampled_triangle(rung.grid, clip, 1, t);
      for (int y = clip.y; y < clip.bottom(); ++y)
        for (int x = clip.x; x < clip.right(); ++x) wrong += part.level(x, y) != whole.level(x, y) ? 1 : 0;
      // Spans from below upwards and from right to left.
      const LevelSink backwards = sampled(rung.grid, {-8, -8, 17, 17}, 5, [&](auto& sink) {
        const Rect area = sink.clip();
        const Contour e = enlarged(t, rung.grid.scale);
        for (int y = area.bottom() - 1; y >= area.y; --y)
          for (int x = area.right() - 1; x >= area.x; --x)
            if (oracle::in_triangle(e[0], e[1], e[2], x, y)) sink.span(y, x, x + 1);
        return Status{};
      });
      if (i < 2)
        for (int y = -8; y < 9; ++y)
          for (int x = -8; x < 9; ++x) wrong += backwards.level(x, y) != whole.level(x, y) ? 1 : 0;
    }
  EXPECT_EQ(wrong, 0) << random.seed_text();
}

TEST(Supersample, BadArgumentsAreNamedAndNothingIsHandedOver) {
  LevelSink sink({0, 0, 20, 20});
  std::vector<SampleCell> workspace(20);
  int drawn = 0;
  const auto run = [&](const Supersampling& grid, Status answer = {}) {
    return supersample(sink, grid, workspace, [&](auto&) {
      ++drawn;
      return answer;
    });
  };
  for (const int bad : {1, 9, 0, INT_MIN, INT_MAX})
    EXPECT_EQ(run({bad, bad, SampleFilter::box}), (Status{Error::out_of_range, Argument::steps}));
  for (const int bad : {3, 9, INT_MIN, INT_MAX})
    EXPECT_EQ(run({4, bad, SampleFilter::bartlett}), (Status{Error::out_of_range, Argument::width}));
  EXPECT_EQ(run({4, 5, SampleFilter::bartlett}), (Status{Error::mismatched, Argument::width}));
  EXPECT_EQ(run({4, 6, SampleFilter::box}), (Status{Error::mismatched, Argument::width}));
  EXPECT_EQ(run({4, 4, static_cast<SampleFilter>(3)}), (Status{Error::out_of_range, Argument::rule}));
  workspace.resize(19);
  EXPECT_EQ(run({}), (Status{Error::too_small, Argument::workspace, 20}));
  workspace.resize(20);
  EXPECT_EQ(drawn, 0);
  const Status failure{Error::out_of_domain, Argument::radius};
  EXPECT_EQ(run({}, failure), failure);
  EXPECT_EQ(drawn, 1);
  EXPECT_EQ(sink.spans(), 0);
}

TEST(Supersample, PlacesThatLeaveTheDomainEnlargedAreRefusedAndClipsAreCut) {
  constexpr int limit = 1 << 28;
  for (int scale = 2; scale <= 8; ++scale) {
    const Enlargement by(scale);
    for (const int c :
         {limit / scale + 300, limit, limit + 1, INT_MAX, INT_MIN, -limit, -limit / scale - 300}) {
      EXPECT_FALSE(linear::in_domain(by.place({c, 0}))) << scale << " " << c;
      EXPECT_FALSE(linear::in_domain(by.place({0, c}))) << scale << " " << c;
      EXPECT_FALSE(linear::in_domain(by.area({c, 0, 1, 1}))) << scale << " " << c;
      EXPECT_FALSE(linear::in_domain(by.area({0, 0, 1, c}))) << scale << " " << c;
    }
    EXPECT_TRUE(linear::in_domain(by.place({limit / scale - 1024, -limit / scale})));
    // A clip as large as can be; nothing is drawn, so its cells don't matter beyond the first row's.
    const Rect window = by.window({-(1 << 20), -(1 << 20), 1 << 21, 1 << 21});
    EXPECT_TRUE(linear::in_domain(by.area(window)));
    EXPECT_TRUE(by.window({1 << 20, 0, 5, 5}).empty());
  }
  LevelSink far({1 << 20, -(1 << 20), 4, 4});
  EXPECT_TRUE(supersample(far, {}, {}, [](auto&) { return Status{}; }).ok());
  EXPECT_EQ(far.spans(), 0);
}

/// Asks and counts.
template <class Cover>
LevelSink asked(const Contour& contour, int scale, const Rect& clip, int& questions, Cover cover) {
  const Contours e{enlarged(contour, scale)};
  LevelSink sink(clip);
  const auto inside = [&](SubPoint place) {
    ++questions;
    const int length = static_cast<int>(e[0].size());
    return raster::inside_polygon(raster::FillRule::non_zero, e[0], std::span<const int>(&length, 1), place)
        .value();
  };
  EXPECT_TRUE(cover(sink, inside).ok());
  EXPECT_FALSE(sink.bad());
  return sink;
}

LevelSink adaptive(const Contour& contour, int scale, const Rect& clip, int& questions) {
  return asked(contour, scale, clip, questions,
               [&](auto& sink, auto inside) { return raster::cover_adaptively(sink, clip, scale, inside); });
}

LevelSink stochastic(const Contour& contour, int scale, const Rect& clip, std::uint32_t seed) {
  int questions = 0;
  return asked(contour, scale, clip, questions, [&](auto& sink, auto inside) {
    return raster::cover_stochastically(sink, clip, scale, seed, inside);
  });
}

TEST(Adaptive, AtEdgesItIsTheBoxWithAFractionOfTheSamples) {
  Random random(65);
  int wrong = 0;
  for (int i = 0; i < 60; ++i)
    for (int scale = 2; scale <= 8; ++scale) {
      const auto [a, b] = random_edge(random, i);
      const Contour contour = half_plane(a, b);
      const Rect clip{-8, -8, 17, 17};
      int questions = 0;
      const LevelSink some = adaptive(contour, scale, clip, questions);
      const LevelSink all = sampled_polygon({scale, scale, SampleFilter::box}, contour, clip);
      for (int y = -8; y < 9; ++y)
        for (int x = -8; x < 9; ++x) wrong += some.level(x, y) != all.level(x, y) ? 1 : 0;
      // An edge crosses at most 2*17 - 1 of 17*17 pixels; it may touch corners of as many more.
      EXPECT_LE(questions, 17 * 17 * 3 + 17 * 2 + 2 * 33 * scale * scale);
    }
  EXPECT_EQ(wrong, 0) << random.seed_text();
}

TEST(Adaptive, LosesWhatPassesBetweenItsFirstSamples) {
  // A fifth of a pixel, beside the middle.
  const Contour sliver{{-2000, 40}, {2000, 40}, {2000, 90}, {-2000, 90}};
  int questions = 0;
  const LevelSink lost = adaptive(sliver, 8, {-3, -3, 7, 7}, questions);
  EXPECT_EQ(lost.spans(), 0);
  const LevelSink found = sampled_polygon({8, 8, SampleFilter::box}, sliver, {-3, -3, 7, 7});
  EXPECT_GT(found.level(0, 0), 0);
}

TEST(Stochastic, AtEdgesItKeepsItsBoundAndHasNoBias) {
  for (int scale = 2; scale <= 8; scale += scale < 4 ? 1 : 2) {
    std::uint32_t seed = 0;
    mpq_class sum = 0;
    int crossed = 0;
    const mpq_class worst =
        worst_edge(66, oracle::samples(60, 3000), [&](const Contour& c, const Rect& clip) {
          LevelSink sink = stochastic(c, scale, clip, ++seed);
          for (int y = -4; y < 5; ++y)
            for (int x = -4; x < 5; ++x) {
              const mpq_class area = oracle::half_plane_area(c[0], c[1], x, y);
              if (area == 0 || area == 1) continue;
              sum += sink.level(x, y) - 255 * area;
              ++crossed;
            }
          return sink;
        });
    EXPECT_LE(worst.get_d(), 255 * 1.44 / scale + 0.5) << scale;
    EXPECT_NEAR(sum.get_d() / crossed, 0.0, 1.5) << scale;
  }
}

TEST(Stochastic, IsTheSamePictureEveryTimeInAnyWindowAndAnotherForAnotherSeed) {
  const Contour t{{-3000, -2000}, {3500, -500}, {-500, 3300}};
  const LevelSink first = stochastic(t, 4, {-14, -14, 29, 29}, 7);
  const LevelSink again = stochastic(t, 4, {-14, -14, 29, 29}, 7);
  const LevelSink part = stochastic(t, 4, {-3, -9, 11, 6}, 7);
  const LevelSink other = stochastic(t, 4, {-14, -14, 29, 29}, 8);
  int wrong = 0;
  int differs = 0;
  for (int y = -14; y < 15; ++y)
    for (int x = -14; x < 15; ++x) {
      wrong += first.level(x, y) != again.level(x, y) ? 1 : 0;
      if (x >= -3 && x < 8 && y >= -9 && y < -3) wrong += first.level(x, y) != part.level(x, y) ? 1 : 0;
      differs += first.level(x, y) != other.level(x, y) ? 1 : 0;
    }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(differs, 20);
}

TEST(Stochastic, SamplesAreSpreadEvenlyOverTheirPart) {
  std::array<std::array<int, 8>, 8> cells{};
  int extremes = 0;
  for (int y = -100; y < 100; ++y)
    for (int x = -100; x < 100; ++x) {
      raster::PixelJitter jitter(1, x, y);
      for (int i = 0; i < 16; ++i) {
        const SubPoint p = jitter.next();
        extremes += p.x < -128 || p.x > 127 || p.y < -128 || p.y > 127 ? 1 : 0;
        ++cells.at(static_cast<std::size_t>((p.y + 128) / 32)).at(static_cast<std::size_t>((p.x + 128) / 32));
      }
    }
  EXPECT_EQ(extremes, 0);
  for (const auto& row : cells)
    for (const int count : row) EXPECT_NEAR(count, 10000, 500);  // five standard deviations
}

TEST(Samples, BadArgumentsAreNamedAndNothingIsHandedOver) {
  LevelSink sink({0, 0, 20, 20});
  const auto all = [](SubPoint) { return true; };
  for (const int bad : {1, 9, INT_MIN, INT_MAX}) {
    EXPECT_EQ(raster::cover_adaptively(sink, {0, 0, 9, 9}, bad, all),
              (Status{Error::out_of_range, Argument::steps}));
    EXPECT_EQ(raster::cover_stochastically(sink, {0, 0, 9, 9}, bad, 1, all),
              (Status{Error::out_of_range, Argument::steps}));
  }
  for (const Rect& bad : {Rect{INT_MIN, 0, 1, 1}, Rect{0, 0, INT_MAX, 1}, Rect{0, 1 << 21, 1, 1}}) {
    EXPECT_EQ(raster::cover_adaptively(sink, bad, 4, all),
              (Status{Error::out_of_domain, Argument::rectangle}));
    EXPECT_EQ(raster::cover_stochastically(sink, bad, 4, 1, all),
              (Status{Error::out_of_domain, Argument::rectangle}));
  }
  EXPECT_TRUE(raster::cover_adaptively(sink, {-5, -5, 3, 3}, 4, all).ok());
  EXPECT_TRUE(raster::cover_stochastically(sink, {5, 5, -3, 3}, 4, 1, all).ok());
  EXPECT_EQ(sink.spans(), 0);
  EXPECT_TRUE(raster::cover_adaptively(sink, {-5, 2, 300, 3}, 4, all).ok());
  EXPECT_EQ(sink.spans(), 3);  // a run a row
  EXPECT_EQ(sink.level(19, 4), 255);
}

}  // namespace
