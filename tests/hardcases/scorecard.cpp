// SPDX-License-Identifier: MIT
//
// The scorecard: four things that no other library that was tried passes all of. Printed with its figures,
// and compared with the lines that README.md shows; to bring those up to date:
//     build/host-release/bin/test_hardcases --gtest_filter='Scorecard.*' | grep '^[1-4]\. ' >
//         tests/hardcases/scorecard.txt
//     tests/check/readme --write
#include <tests/oracle/recording_sink.hpp>
#include <tests/oracle/span_list.hpp>
#include <tests/raster/every_primitive.hpp>
#include <tests/raster/meshes.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <string>

namespace {

using intaglio::linear::Rect;
using intaglio::raster::draw_circle;
using intaglio::raster::draw_ellipse;
using intaglio::raster::draw_line;
using oracle::RecordingSink;

std::string thousands(std::int64_t n) {
  std::string digits = std::to_string(n);
  for (int at = static_cast<int>(digits.size()) - 3; at > 0; at -= 3)
    digits.insert(static_cast<std::size_t>(at), ",");
  return digits;
}

// How far the centre of a pixel is from the ellipse, along the row or the column, whichever is less.
long double distance(int a, int b, int x, int y) {
  const auto along = [](long double p, long double q, long double at_p, long double at_q) {
    const long double rest = 1 - at_p * at_p / (p * p);
    return rest < 0 ? 1e9L : std::fabs(at_q - q * std::sqrt(rest));
  };
  return std::min(along(a, b, std::abs(x), std::abs(y)), along(b, a, std::abs(y), std::abs(x)));
}

std::string ellipses() {
  long double worst = 0;
  int count = 0;
  for (int a = 160; a <= 400; a += 4)
    for (int b = 120; b <= 240; b += 4) {
      oracle::SpanList outline;
      EXPECT_TRUE(draw_ellipse(outline, {0, 0}, a, b).ok());
      for (const oracle::Span& span : outline.spans())
        for (int x = span.begin; x < span.end; ++x) worst = std::max(worst, distance(a, b, x, span.y));
      ++count;
    }
  EXPECT_LE(worst, 0.5L + 1e-12L);
  char text[160];
  std::snprintf(
      text, sizeof text,
      "1. Ellipses that fill a screen, from 320x240 to 800x480: of %s the furthest pixel is %.4f px "
      "from the curve.",
      thousands(count).c_str(), static_cast<double>(worst));
  return text;
}

std::string clips() {
  oracle::Random random(4400);
  const Rect all{0, 0, 64, 48};
  std::int64_t figures = 0;
  std::int64_t differ = 0;
  const auto& primitives = tests::every_primitive<RecordingSink>();
  for (const auto& primitive : primitives)
    for (int i = 0; i < 150; ++i) {
      const tests::Figure figure = tests::random_figure(random, 1 << (8 + i % 13));
      RecordingSink whole(all);
      if (!primitive.draw(whole, figure).ok()) continue;
      ++figures;
      const Rect clip{random.between(0, 40), random.between(0, 30), random.between(1, 24),
                      random.between(1, 18)};
      RecordingSink part(clip);
      primitive.draw(part, figure).ignore();
      for (int y = clip.y; y < clip.y + clip.height; ++y)
        for (int x = clip.x; x < clip.x + clip.width; ++x)
          differ += part.writes(x, y) != whole.writes(x, y) ? 1 : 0;
    }
  EXPECT_EQ(differ, 0);
  EXPECT_GT(figures, 4000);
  return "2. Figures up to 2^20 px, most of them far off the window: of " + thousands(figures) + " of " +
         std::to_string(primitives.size()) + " primitives, " + thousands(differ) +
         " pixels differ between clipped and unclipped.";
}

std::string partitions() {
  const tests::Cover cover = tests::cover_by_meshes(200);
  EXPECT_EQ(cover.twice + cover.missing + cover.refused, 0);
  return "3. Fans, strips and Voronoi-like meshes: of " + thousands(cover.pixels) + " pixels under " +
         thousands(cover.meshes) + " meshes of " + thousands(cover.cells) + " cells, " +
         thousands(cover.twice) + " are drawn twice and " + thousands(cover.missing) + " are missing.";
}

std::string symmetries() {
  int lines = 0;
  int differ = 0;
  for (int dy = -60; dy <= 60; ++dy)
    for (int dx = -60; dx <= 60; ++dx) {
      oracle::SpanList there;
      oracle::SpanList back;
      EXPECT_TRUE(draw_line(there, intaglio::linear::Point{0, 0}, {dx, dy}).ok());
      EXPECT_TRUE(draw_line(back, intaglio::linear::Point{dx, dy}, {0, 0}).ok());
      ++lines;
      differ += there.joined() != back.joined() ? 1 : 0;
    }
  int radii = 0;
  int lost = 0;
  for (int r = 0; r <= 1000; ++r, ++radii) {
    oracle::SpanList circle;
    EXPECT_TRUE(draw_circle(circle, {0, 0}, r).ok());
    const auto runs = circle.joined();
    bool twice = false;  // what is drawn twice vanishes under exclusive-or
    for (std::size_t i = 1; i < runs.size(); ++i)
      twice = twice || (runs[i].y == runs[i - 1].y && runs[i].begin < runs[i - 1].end);
    lost += twice ? 1 : 0;
  }
  EXPECT_EQ(differ + lost, 0);
  return "4. From A to B and from B to A: " + std::to_string(differ) + " of " + thousands(lines) +
         " lines differ; under exclusive-or " + std::to_string(lost) + " of " + thousands(radii) +
         " circles lose a pixel.";
}

TEST(Scorecard, HasTheFourLinesThatTheReadmeShows) {
  const std::string card = ellipses() + "\n" + clips() + "\n" + partitions() + "\n" + symmetries() + "\n";
  std::cout << card;
  std::ifstream file(INTAGLIO_SOURCE "/tests/hardcases/scorecard.txt");
  const std::string shown{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(card, shown) << "see the head of scorecard.cpp";
}

}  // namespace
