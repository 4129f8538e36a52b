// SPDX-License-Identifier: MIT
//
// What is visible of polygons one behind the other: exactly, and by masks.
#include <intaglio/raster/mask_buffer.hpp>
#include <intaglio/raster/triangle.hpp>
#include <intaglio/raster/visible_area.hpp>
#include <tests/oracle/coverage.hpp>
#include <tests/oracle/level_sink.hpp>
#include <tests/oracle/polygon.hpp>
#include <tests/oracle/random.hpp>
#include <tests/oracle/samples.hpp>
#include <tests/oracle/visible_area.hpp>
#include <tests/raster/contours.hpp>
#include <tests/raster/half_planes.hpp>

#include <climits>
#include <gtest/gtest.h>

#include <algorithm>
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
using oracle::Contours;
using oracle::LevelSink;
using oracle::Random;
using raster::cover_by_masks;
using raster::cover_front_to_back;
using raster::DepthPolygon;
using raster::Enlargement;
using raster::FillRule;
using raster::MaskCell;
using raster::MaskGrid;
using raster::VisibleEntry;
using tests::worst_edge;

/// One memory of levels a layer, and one for their sum.
class LayerLevels {
 public:
  LayerLevels(const Rect& clip, std::size_t layers) : clip_(clip), layers_(layers, LevelSink(clip)) {}
  [[nodiscard]] const Rect& clip() const { return clip_; }
  void span(int layer, int y, int x_begin, int x_end, int coverage) {
    layers_.at(static_cast<std::size_t>(layer)).span(y, x_begin, x_end, coverage);
  }
  [[nodiscard]] int level(std::size_t layer, int x, int y) const { return layers_.at(layer).level(x, y); }
  [[nodiscard]] int sum(int x, int y) const {
    int all = 0;
    for (const LevelSink& layer : layers_) all += layer.level(x, y);
    return all;
  }
  [[nodiscard]] bool bad() const {
    return std::any_of(layers_.begin(), layers_.end(), [](const LevelSink& layer) { return layer.bad(); });
  }
  [[nodiscard]] bool untouched() const {
    return std::all_of(layers_.begin(), layers_.end(), [](const LevelSink& l) { return l.spans() == 0; });
  }

 private:
  Rect clip_;
  std::vector<LevelSink> layers_;
};

/// Layers of contours; a layer is what an odd number of them, or any of them, has.
using Layers = std::vector<std::pair<Contours, bool>>;

/// Contours in one array, all the same way round.
tests::FlatContours flat(Contours contours) {
  for (Contour& contour : contours) {
    oracle::CutContour exact;
    for (const SubPoint p : contour) exact.emplace_back(p.x, p.y);
    if (oracle::twice_area(exact) < 0) std::reverse(contour.begin(), contour.end());
  }
  return tests::flat(contours);
}

LayerLevels visible(const Layers& layers, const Rect& clip) {
  std::vector<tests::FlatContours> arrays;
  for (const auto& layer : layers) arrays.push_back(flat(layer.first));
  std::vector<DepthPolygon> polygons;
  std::size_t needed = layers.size();
  for (std::size_t i = 0; i < layers.size(); ++i) {
    polygons.push_back(
        {layers[i].second ? FillRule::even_odd : FillRule::non_zero, arrays[i].vertices, arrays[i].lengths});
    needed += arrays[i].vertices.size();
  }
  LayerLevels sink(clip, layers.size());
  std::vector<VisibleEntry> workspace(needed);
  EXPECT_TRUE(cover_front_to_back(sink, polygons, workspace).ok());
  EXPECT_FALSE(sink.bad());
  return sink;
}

std::string text(const Layers& layers) {
  std::string out;
  for (const auto& [contours, odd] : layers) out += (odd ? "\nodd " : "\nany ") + tests::text(contours);
  return out;
}

/// How far levels are at most from 255 times the exact areas; the first layer's may be half a level.
mpq_class worst(const Layers& layers, const Rect& clip) {
  const LayerLevels sink = visible(layers, clip);
  mpq_class most = 0;
  for (int y = clip.y; y < clip.bottom(); ++y)
    for (int x = clip.x; x < clip.right(); ++x) {
      const auto areas = oracle::visible_areas(layers, x, y);
      mpq_class sum = 0;
      for (std::size_t i = 0; i < layers.size(); ++i) {
        sum += areas[i];
        const mpq_class off = abs(255 * areas[i] - sink.level(i, x, y));
        most = std::max<mpq_class>(most, i == 0 ? mpq_class(2 * off) : off);
      }
      // The sum is as near as one layer alone would be.
      most = std::max<mpq_class>(most, 2 * abs(255 * sum - sink.sum(x, y)));
    }
  return most;
}

Contour triangle(Random& random, int bound, int step) {
  return tests::random_contour(random, 3, bound, step);
}

TEST(VisibleArea, IsTheExactAreaLessWhatIsInFront) {
  Random random(81);
  for (int i = 0; i < oracle::samples(40, 2000); ++i) {
    // On halves of pixels edges and corners fall together.
    const int step = i % 3 == 0 ? 128 : i % 3 == 1 ? 37 : 1;
    Layers layers;
    for (int n = random.between(1, 4); n > 0; --n) {
      Contours contours;
      for (int m = random.between(1, 3); m > 0; --m) contours.push_back(triangle(random, 256 << i % 4, step));
      layers.emplace_back(contours, n % 2 == 0);
    }
    const mpq_class off = worst(layers, {-3, -3, 7, 7});
    ASSERT_LE(off.get_d(), 1.0 + 0.001) << text(layers) << "\n" << random.seed_text();
  }
}

TEST(VisibleArea, IsExactToTheDomainsEdge) {
  constexpr int limit = 1 << 28;
  Random random(82);
  for (int i = 0; i < oracle::samples(60, 2000); ++i) {
    Layers layers;
    const int bound = limit >> random.between(0, 18);
    for (int n = 0; n < 3; ++n) layers.emplace_back(Contours{triangle(random, bound, 1)}, n == 1);
    const Contour& front = layers[0].first[0];
    const mpq_class off =
        worst(layers, tests::window_on_edge(front[0], front[1], random.between(0, 1024), 3, 3));
    ASSERT_LE(off.get_d(), 1.0 + 0.001) << text(layers) << "\n" << random.seed_text();
  }
}

TEST(VisibleArea, ManySliversInOnePixelAreExact) {
  Random random(83);
  for (int i = 0; i < oracle::samples(6, 200); ++i) {
    Layers layers;
    for (int n = 0; n < 8; ++n) layers.emplace_back(Contours{triangle(random, 150, 1)}, true);
    const mpq_class off = worst(layers, {-1, -1, 3, 3});
    ASSERT_LE(off.get_d(), 1.0 + 0.01) << text(layers) << "\n" << random.seed_text();
  }
}

/// A fan of triangles around a place, which covers all of the picture.
Layers fan(Random& random) {
  const SubPoint middle{random.between(-600, 600), random.between(-600, 600)};
  const int reach = 6000;
  Contour rim{{-reach, -reach}, {random.between(-900, 900), -reach},
              {reach, -reach},  {reach, random.between(-900, 900)},
              {reach, reach},   {random.between(-900, 900), reach},
              {-reach, reach},  {-reach, random.between(-900, 900)}};
  Layers layers;
  for (std::size_t i = 0; i < rim.size(); ++i)
    layers.emplace_back(Contours{{middle, rim[i], rim[(i + 1) % rim.size()]}}, true);
  return layers;
}

TEST(VisibleArea, APartitionOfThePlaneIsFullEverywhere) {
  Random random(84);
  int wrong = 0;
  for (int i = 0; i < 60; ++i) {
    const LayerLevels sink = visible(fan(random), {-5, -5, 11, 11});
    for (int y = -5; y < 6; ++y)
      for (int x = -5; x < 6; ++x) wrong += sink.sum(x, y) != 255 ? 1 : 0;
  }
  EXPECT_EQ(wrong, 0) << random.seed_text();
}

TEST(VisibleArea, AnyWindowSeesTheUnclippedLevels) {
  Random random(85);
  int wrong = 0;
  for (int i = 0; i < 30; ++i) {
    Layers layers;
    for (int n = 0; n < 4; ++n) layers.emplace_back(Contours{triangle(random, 400 << i % 9, 1)}, true);
    const LayerLevels whole = visible(layers, {-5, -5, 11, 11});
    const Rect clip{random.between(-5, 2), random.between(-5, 2), random.between(1, 3), random.between(1, 3)};
    const LayerLevels part = visible(layers, clip);
    for (std::size_t n = 0; n < 4; ++n)
      for (int y = clip.y; y < clip.bottom(); ++y)
        for (int x = clip.x; x < clip.right(); ++x)
          wrong += part.level(n, x, y) != whole.level(n, x, y) ? 1 : 0;
  }
  EXPECT_EQ(wrong, 0) << random.seed_text();
}

TEST(VisibleArea, BadArgumentsAreNamedAndNothingIsHandedOver) {
  std::vector<SubPoint> square{{0, 0}, {2560, 0}, {2560, 2560}, {0, 2560}};
  std::vector<int> lengths{4};
  std::vector<DepthPolygon> polygons{{FillRule::even_odd, square, lengths},
                                     {FillRule::non_zero, square, lengths}};
  LayerLevels sink({0, 0, 20, 20}, 2);
  std::vector<VisibleEntry> workspace(10);
  const auto cover = [&] { return cover_front_to_back(sink, polygons, workspace); };
  lengths[0] = 5;
  EXPECT_EQ(cover(), (Status{Error::mismatched, Argument::contours}));
  lengths[0] = 4;
  for (const int bad : {(1 << 28) + 1, INT_MAX, INT_MIN}) {
    square[1].x = bad;
    EXPECT_EQ(cover(), (Status{Error::out_of_domain, Argument::vertices}));
  }
  square[1].x = 2560;
  polygons[1].rule = static_cast<FillRule>(5);
  EXPECT_EQ(cover(), (Status{Error::out_of_range, Argument::rule}));
  polygons[1].rule = FillRule::non_zero;
  workspace.resize(9);
  EXPECT_EQ(cover(), (Status{Error::too_small, Argument::workspace, 10}));
  workspace.resize(10);
  EXPECT_TRUE(sink.untouched());
  EXPECT_TRUE(cover_front_to_back(sink, {}, {}).ok());
  const std::vector<DepthPolygon> many((1U << 16U) + 1);
  EXPECT_EQ(cover_front_to_back(sink, many, {}), (Status{Error::too_large, Argument::count, 1U << 16U}));
  EXPECT_TRUE(cover().ok());
  EXPECT_EQ(sink.level(0, 5, 5), 255);
  EXPECT_EQ(sink.level(1, 5, 5), 0);
}

/// Triangles, one a layer, by masks.
LayerLevels masked(const Layers& layers, MaskGrid grid, const Rect& clip) {
  const Enlargement by(4, static_cast<int>(grid));
  LayerLevels sink(clip, layers.size());
  std::vector<MaskCell> workspace(static_cast<std::size_t>(clip.width));
  EXPECT_TRUE(
      cover_by_masks(sink, grid, static_cast<int>(layers.size()), workspace, [&](int layer, auto& parts) {
        Status status;
        for (const Contour& t : layers.at(static_cast<std::size_t>(layer)).first)
          for (std::size_t i = 2; i < t.size() && status.ok(); ++i)
            status = raster::fill_triangle(parts, by.place(t[0]), by.place(t[i - 1]), by.place(t[i]));
        return status;
      }).ok());
  EXPECT_FALSE(sink.bad());
  return sink;
}

TEST(Masks, LevelsAreThePartsThatNoLayerInFrontHas) {
  Random random(86);
  int wrong = 0;
  for (int i = 0; i < oracle::samples(60, 3000); ++i) {
    const int step = i % 2 == 0 ? 32 : 1;
    Layers layers;
    for (int n = random.between(1, 5); n > 0; --n)
      layers.emplace_back(Contours{triangle(random, 900, step)}, true);
    const Rect clip{random.between(-5, 0), random.between(-5, 0), random.between(1, 7), random.between(1, 7)};
    for (const MaskGrid grid : {MaskGrid::four_by_four, MaskGrid::four_by_eight}) {
      const int rows = static_cast<int>(grid);
      const LayerLevels sink = masked(layers, grid, clip);
      for (int y = clip.y; y < clip.bottom(); ++y)
        for (int x = clip.x; x < clip.right(); ++x) {
          std::vector<bool> taken(static_cast<std::size_t>(4 * rows));
          int before = 0;
          int count = 0;
          for (std::size_t n = 0; n < layers.size(); ++n) {
            const Contour& t = layers[n].first[0];
            for (int part = 0; part < 4 * rows; ++part) {
              // Middles of parts in 1/2048 pixel; the oracle asks at multiples of 256, so vertices move
              // there.
              const int px = 2048 * x + 512 * (part % 4) + 256 - 1024;
              const int py = 2048 * y + 2048 / rows * (part / 4) + 1024 / rows - 1024;
              const auto moved = [&](SubPoint p) { return SubPoint{8 * p.x - px, 8 * p.y - py}; };
              if (!oracle::in_triangle(moved(t[0]), moved(t[1]), moved(t[2]), 0, 0)) continue;
              count += taken[static_cast<std::size_t>(part)] ? 0 : 1;
              taken[static_cast<std::size_t>(part)] = true;
            }
            const int level = (2 * 255 * count + 4 * rows) / (8 * rows);
            wrong += sink.level(n, x, y) != level - before ? 1 : 0;
            before = level;
          }
        }
    }
  }
  EXPECT_EQ(wrong, 0) << random.seed_text();
}

TEST(Masks, AtEdgesTheyKeepTheirBound) {
  for (const MaskGrid grid : {MaskGrid::four_by_four, MaskGrid::four_by_eight}) {
    const mpq_class most = worst_edge(87, oracle::samples(80, 3000), [&](const Contour& c, const Rect& clip) {
      LevelSink sink(clip);
      const LayerLevels levels = masked({{{c}, true}}, grid, clip);
      for (int y = clip.y; y < clip.bottom(); ++y)
        for (int x = clip.x; x < clip.right(); ++x)
          if (levels.level(0, x, y) != 0) sink.span(y, x, x + 1, levels.level(0, x, y));
      return sink;
    });
    EXPECT_LE(most.get_d(), 255.0 / 8 + 0.5);
    EXPECT_GE(most.get_d(), 255.0 / 8 * 0.9);
  }
}

TEST(Masks, APartitionOfThePlaneIsFullEverywhereAndNothingShowsThrough) {
  Random random(88);
  int wrong = 0;
  for (int i = 0; i < 60; ++i)
    for (const MaskGrid grid : {MaskGrid::four_by_four, MaskGrid::four_by_eight}) {
      Layers layers = fan(random);
      // Behind them something that fills all.
      layers.emplace_back(Contours{{{-6000, -6000}, {6000, -6000}, {6000, 6000}, {-6000, 6000}}}, true);
      const LayerLevels sink = masked(layers, grid, {-5, -5, 11, 11});
      for (int y = -5; y < 6; ++y)
        for (int x = -5; x < 6; ++x)
          wrong += sink.sum(x, y) != 255 || sink.level(layers.size() - 1, x, y) != 0 ? 1 : 0;
    }
  EXPECT_EQ(wrong, 0) << random.seed_text();
}

TEST(Masks, LayersThatNothingIsSeenOfAreNotDrawn) {
  LayerLevels sink({0, 0, 40, 30}, 9);
  std::vector<MaskCell> workspace(40);
  int drawn = 0;
  EXPECT_TRUE(cover_by_masks(sink, MaskGrid::four_by_four, 9, workspace, [&](int layer, auto& parts) {
                ++drawn;
                const Rect all = parts.clip();
                EXPECT_LE(layer, 1);
                for (int y = all.y; y < all.bottom(); ++y)
                  parts.span(y, all.x + (layer == 0 ? 7 : 0), all.right());
                return Status{};
              }).ok());
  EXPECT_EQ(drawn, 60);
  EXPECT_EQ(sink.level(1, 0, 0), 255);
  EXPECT_EQ(sink.level(1, 1, 0), 191);
  EXPECT_EQ(sink.level(0, 1, 0), 64);
}

TEST(Masks, BadArgumentsAreNamedAndNothingIsHandedOver) {
  LayerLevels sink({0, 0, 20, 20}, 1);
  std::vector<MaskCell> workspace(20);
  int drawn = 0;
  const auto run = [&](MaskGrid grid, int layers, Status answer = {}) {
    return cover_by_masks(sink, grid, layers, workspace, [&](int, auto&) {
      ++drawn;
      return answer;
    });
  };
  EXPECT_EQ(run(static_cast<MaskGrid>(5), 1), (Status{Error::out_of_range, Argument::rule}));
  for (const int bad : {-1, INT_MIN, INT_MAX})
    EXPECT_EQ(run(MaskGrid::four_by_four, bad), (Status{Error::out_of_range, Argument::count}));
  workspace.resize(19);
  EXPECT_EQ(run(MaskGrid::four_by_four, 1), (Status{Error::too_small, Argument::workspace, 20}));
  workspace.resize(20);
  EXPECT_EQ(drawn, 0);
  const Status failure{Error::out_of_domain, Argument::radius};
  EXPECT_EQ(run(MaskGrid::four_by_eight, 1, failure), failure);
  EXPECT_EQ(drawn, 1);
  EXPECT_TRUE(sink.untouched());
}

}  // namespace
