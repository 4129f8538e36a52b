// SPDX-License-Identifier: MIT
//
// What every primitive must do, whatever it draws: each pixel once, the same pixels under any clip and in any
// band, and nothing left after drawing twice by exclusive-or.
#include <intaglio/image/surface.hpp>
#include <intaglio/raster/adaptive.hpp>
#include <intaglio/raster/coverage.hpp>
#include <intaglio/raster/enlargement.hpp>
#include <intaglio/raster/inside.hpp>
#include <intaglio/raster/pitteway.hpp>
#include <intaglio/raster/smooth_line.hpp>
#include <intaglio/raster/solid.hpp>
#include <intaglio/raster/stochastic.hpp>
#include <intaglio/raster/supersample.hpp>
#include <tests/oracle/level_sink.hpp>
#include <tests/oracle/recording_sink.hpp>
#include <tests/oracle/samples.hpp>
#include <tests/raster/every_primitive.hpp>
#include <tests/raster/text.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace {

using intaglio::linear::Rect;
using oracle::RecordingSink;
using tests::every_primitive;
using tests::Figure;
using Surface = intaglio::image::Surface<intaglio::image::Indexed8>;
using Ink = intaglio::raster::Xor<intaglio::image::Indexed8>;

constexpr int width = 64;
constexpr int height = 48;
constexpr Rect all{0, 0, width, height};

// Small ones, those that just fill the window, and up to the domain's edge.
int reach_of(int i) { return i % 4 == 0 ? 12 : i % 4 == 1 ? 50 : 1 << (6 + i / 4 % 15); }

int figures() { return oracle::samples(120, 4000); }

Rect random_part(oracle::Random& random) {
  const int x = random.between(0, width - 1);
  const int y = random.between(0, height - 1);
  return {x, y, random.between(1, width - x), random.between(1, height - y)};
}

TEST(EveryPrimitive, DrawsEachPixelOnceAndNoClipChangesAPixel) {
  for (const auto& primitive : every_primitive<RecordingSink>()) {
    oracle::Random random(4242);
    int seen = 0;
    std::string fault;
    for (int i = 0; i < figures() && fault.empty(); ++i) {
      const Figure figure = tests::random_figure(random, reach_of(i));
      RecordingSink whole(all);
      const auto status = primitive.draw(whole, figure);
      if (!whole.violation().empty()) fault = whole.violation();
      if (whole.most() > 1) fault = "a pixel twice\n" + whole.ascii();
      if (!status.ok() && whole.spans() != 0) fault = "refused, but drawn";
      seen += whole.touched() > 0 ? 1 : 0;
      for (int k = 0; k < 3 && fault.empty(); ++k) {
        const Rect clip = k == 0 ? Rect{0, 0, 0, 0} : random_part(random);
        RecordingSink part(clip);
        if (primitive.draw(part, figure) != status) fault = "another status in " + tests::text(clip);
        if (!part.violation().empty()) fault = part.violation();
        for (int y = clip.y; y < clip.bottom(); ++y)
          for (int x = clip.x; x < clip.right(); ++x)
            if (part.writes(x, y) != whole.writes(x, y)) fault = "differs in " + tests::text(clip);
      }
    }
    EXPECT_EQ(fault, "") << primitive.name << ", " << random.seed_text();
    EXPECT_GT(seen, figures() / 10) << primitive.name << ": the window hardly sees it, this proves nothing";
  }
}

TEST(EveryPrimitive, ExclusiveOrTwiceRestoresAndBandsMakeThePicture) {
  const auto& recorded = every_primitive<RecordingSink>();
  const auto& inked = every_primitive<Ink>();
  for (std::size_t n = 0; n < recorded.size(); ++n) {
    oracle::Random random(4243);
    int wrong = 0;
    for (int i = 0; i < figures(); ++i) {
      const Figure figure = tests::random_figure(random, reach_of(i));
      RecordingSink expected(all);
      recorded[n].draw(expected, figure).ignore();
      std::vector<std::uint8_t> memory(width * height);
      for (const int rows : {height, 1 + i % 11}) {
        // The second time in bands: what was drawn whole goes away again.
        for (int top = 0; top < height; top += rows) {
          const Rect band{0, top, width, std::min(rows, height - top)};
          const auto target =
              Surface::over_band(std::span(memory).subspan(static_cast<std::size_t>(top) * width), band);
          Ink ink(target.value(), 1);
          inked[n].draw(ink, figure).ignore();
        }
        for (std::size_t at = 0; at < memory.size(); ++at)
          wrong += memory[at] != (rows == height ? expected.all_writes()[at] : 0) ? 1 : 0;
      }
    }
    EXPECT_EQ(wrong, 0) << recorded[n].name << ", " << random.seed_text();
  }
}

TEST(EveryPrimitive, CoversEachPixelOnceAndNoClipOrBandChangesALevel) {
  using namespace intaglio::raster;
  using oracle::LevelSink;
  struct Named {
    const char* name;
    intaglio::Status (*draw)(LevelSink& sink, const Figure& f);
  };
  static constexpr std::array two_contours{3, 3};
  // For the ways that ask if a place is inside: whether one of a grid of scale x scale samples a pixel is.
  static constexpr auto inside_of = [](const Figure& f, int scale) {
    std::array<intaglio::linear::SubPoint, 6> enlarged{};
    std::transform(f.places.begin(), f.places.end(), enlarged.begin(),
                   [=](intaglio::linear::SubPoint p) { return Enlargement(scale).place(p); });
    return [=](intaglio::linear::SubPoint p) {
      const auto answer = inside_polygon(FillRule::even_odd, enlarged, two_contours, p);
      return answer.ok() && answer.value();
    };
  };
  static constexpr Rect asked{3, 2, width - 7, height - 4};
  constexpr Named list[] = {
      {"area of a polygon",
       [](LevelSink& s, const Figure& f) {
         std::array<CoverageCell, coverage_cells(6, width)> workspace;
         return fill_coverage(s, FillRule::even_odd, f.places, two_contours, workspace);
       }},
      {"smooth line",
       [](LevelSink& s, const Figure& f) {
         std::array<CoverageCell, coverage_cells(4, width)> workspace;
         return draw_smooth_line(s, f.places[0], f.places[1], f.width * 60, Cap::square, workspace);
       }},
      {"smooth line with round ends",
       [](LevelSink& s, const Figure& f) {
         std::array<CoverageCell, coverage_cells(smooth_line_vertices, width)> workspace;
         return draw_smooth_line(s, f.places[0], f.places[1], f.width * 60, Cap::round, workspace);
       }},
      {"convex polygon by Pitteway's way",
       [](LevelSink& s, const Figure& f) { return fill_convex_pitteway(s, std::span(f.places).first<3>()); }},
      {"polygon sampled adaptively",
       [](LevelSink& s, const Figure& f) { return cover_adaptively(s, asked, 3, inside_of(f, 3)); }},
      {"polygon sampled stochastically",
       [](LevelSink& s, const Figure& f) { return cover_stochastically(s, asked, 2, 7, inside_of(f, 2)); }},
      {"supersampled triangle", [](LevelSink& s, const Figure& f) {
         const Enlargement enlarge(4);
         std::array<SampleCell, 3 * width> workspace;
         return supersample(s, {}, workspace, [&](auto& samples) {
           return fill_triangle(samples, enlarge.place(f.places[0]), enlarge.place(f.places[1]),
                                enlarge.place(f.places[2]));
         });
       }}};
  for (const Named& primitive : list) {
    oracle::Random random(4245);
    int wrong = 0;
    int seen = 0;
    for (int i = 0; i < figures(); ++i) {
      const Figure figure = tests::random_figure(random, reach_of(i));
      LevelSink whole(all);
      const auto status = primitive.draw(whole, figure);
      wrong += whole.bad() ? 1 : 0;
      const Rect part = random_part(random);
      for (const Rect& clip : {part, Rect{0, part.y, width, part.height}, Rect{0, 0, 0, 0}}) {
        LevelSink clipped(clip);
        wrong += primitive.draw(clipped, figure) != status || clipped.bad() ? 1 : 0;
        for (int y = clip.y; y < clip.bottom(); ++y)
          for (int x = clip.x; x < clip.right(); ++x)
            wrong += clipped.level(x, y) != whole.level(x, y) ? 1 : 0;
      }
      seen += whole.spans() > 0 ? 1 : 0;
    }
    EXPECT_EQ(wrong, 0) << primitive.name << ", " << random.seed_text();
    EXPECT_GT(seen, figures() / 10) << primitive.name;
  }
}

// The pixels that four-connected steps from outside don't reach.
std::vector<int> closed_off(const RecordingSink& outline) {
  std::vector<int> inside(width * height, 1);
  std::vector<int> todo{0};
  while (!todo.empty()) {
    const int at = todo.back();
    todo.pop_back();
    const int x = at % width;
    const int y = at / width;
    if (inside[static_cast<std::size_t>(at)] == 0 || outline.writes(x, y) > 0) continue;
    inside[static_cast<std::size_t>(at)] = 0;
    if (x > 0) todo.push_back(at - 1);
    if (x + 1 < width) todo.push_back(at + 1);
    if (y > 0) todo.push_back(at - width);
    if (y + 1 < height) todo.push_back(at + width);
  }
  return inside;
}

TEST(EveryPrimitive, OutlineAndInteriorMakeTheFilledShape) {
  using namespace intaglio::raster;
  oracle::Random random(4244);
  for (int i = 0; i < oracle::samples(400, 20000); ++i) {
    const int a = random.between(0, 30);
    const int b = random.between(0, 22);
    const Rect box{random.between(1, 30), random.between(1, 20), random.between(1, 32),
                   random.between(1, 26)};
    const CornerRadii radii{random.between(0, 9), random.between(0, 20), random.between(0, 9), a};
    const auto same = [&](auto outline, auto fill) {
      RecordingSink edge(all);
      RecordingSink filled(all);
      return outline(edge).ok() && fill(filled).ok() && closed_off(edge) == filled.all_writes();
    };
    EXPECT_TRUE(same(
        [&](auto& s) {
          return draw_ellipse(s, {31, 23}, a, b);
        },
        [&](auto& s) {
          return fill_ellipse(s, {31, 23}, a, b);
        }))
        << a << "," << b;
    EXPECT_TRUE(same(
        [&](auto& s) {
          return draw_circle(s, {31, 23}, b);
        },
        [&](auto& s) {
          return fill_disc(s, {31, 23}, b);
        }))
        << b;
    EXPECT_TRUE(same(
        [&](auto& s) {
          return draw_circle_in(s, {1, 1}, 2 * b + 1 + i % 2);
        },
        [&](auto& s) {
          return fill_disc_in(s, {1, 1}, 2 * b + 1 + i % 2);
        }))
        << b;
    EXPECT_TRUE(same([&](auto& s) { return draw_rect(s, box); }, [&](auto& s) { return fill_rect(s, box); }))
        << tests::text(box);
    EXPECT_TRUE(same([&](auto& s) { return draw_round_rect(s, box, radii); },
                     [&](auto& s) { return fill_round_rect(s, box, radii); }))
        << tests::text(box);
  }
}

TEST(EveryPrimitive, EllipsesAreSymmetricInBothAxesAndCirclesUnderQuarterTurns) {
  using namespace intaglio::raster;
  const int most = oracle::samples(40, 120);
  for (int a = 0; a <= most; ++a)
    for (int b = a % 3; b <= most; b += a == b ? 1 : 3) {
      const Rect box{-most - 1, -most - 1, 2 * most + 3, 2 * most + 3};
      RecordingSink filled(box);
      RecordingSink outline(box);
      ASSERT_TRUE(fill_ellipse(filled, {0, 0}, a, b).ok());
      ASSERT_TRUE(draw_ellipse(outline, {0, 0}, a, b).ok());
      bool mirrored = true;
      bool turned = true;
      for (const RecordingSink* sink : {&filled, &outline})
        for (int y = 0; y <= most; ++y)
          for (int x = 0; x <= most; ++x) {
            const int here = sink->writes(x, y);
            mirrored = mirrored && here == sink->writes(-x, y) && here == sink->writes(x, -y);
            turned = turned && here == sink->writes(-y, x);
          }
      ASSERT_TRUE(mirrored) << a << "," << b;
      ASSERT_TRUE(turned || a != b) << a;
    }
  for (int r = 0; r <= most; ++r) {
    const Rect box{-most, -most, 2 * most + 1, 2 * most + 1};
    RecordingSink circle(box);
    RecordingSink disc(box);
    ASSERT_TRUE(draw_circle(circle, {0, 0}, r).ok());
    ASSERT_TRUE(fill_disc(disc, {0, 0}, r).ok());
    bool same = true;
    for (const RecordingSink* sink : {&circle, &disc})
      for (int y = 0; y <= r; ++y)
        for (int x = 0; x <= r; ++x)
          same =
              same && sink->writes(x, y) == sink->writes(-y, x) && sink->writes(x, y) == sink->writes(-x, y);
    ASSERT_TRUE(same) << r;
  }
}

// A pixel's mirror image is drawn, but for those exactly halfway between two: both lines take the larger row.
TEST(EveryPrimitive, LinesMirrorExactlyExceptAtTies) {
  const int most = oracle::samples(40, 100);
  const Rect box{-most - 1, -most - 1, 2 * most + 3, 2 * most + 3};
  int ties = 0;
  for (int dx = 1; dx <= most; ++dx)
    for (int dy = 0; dy <= dx; ++dy) {
      RecordingSink line(box);
      RecordingSink flipped(box);
      RecordingSink backwards(box);
      RecordingSink steep(box);
      ASSERT_TRUE(intaglio::raster::draw_line(line, intaglio::linear::Point{0, 0}, {dx, dy}).ok());
      ASSERT_TRUE(intaglio::raster::draw_line(flipped, intaglio::linear::Point{0, 0}, {dx, -dy}).ok());
      ASSERT_TRUE(intaglio::raster::draw_line(backwards, intaglio::linear::Point{0, 0}, {-dx, dy}).ok());
      ASSERT_TRUE(intaglio::raster::draw_line(steep, intaglio::linear::Point{0, 0}, {dy, dx}).ok());
      bool right = true;
      for (int x = 0; x <= dx; ++x) {
        const bool tie = 2 * dy * x % (2 * dx) == dx;
        const int y = (2 * dy * x + dx) / (2 * dx);  // of two as near, the larger
        const int mirrored = tie ? 1 - y : -y;       // of -y and 1 - y, the larger
        right = right && line.writes(x, y) == 1 && flipped.writes(x, mirrored) == 1 &&
                backwards.writes(-x, y) == 1 && steep.writes(y, x) == 1;
        ties += tie ? 1 : 0;
      }
      ASSERT_TRUE(right) << dx << "," << dy;
      ASSERT_EQ(line.touched() + flipped.touched() + backwards.touched() + steep.touched(), 4 * (dx + 1));
    }
  EXPECT_GT(ties, 500);
}

}  // namespace
