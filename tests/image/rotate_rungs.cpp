// SPDX-License-Identifier: MIT
#include <intaglio/image/rotate_rungs.hpp>
#include <tests/oracle/random.hpp>
#include <tests/oracle/turned_place.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace {

using namespace intaglio::image;
using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::linear::Rect;
using intaglio::number::Angle;

constexpr int side = 180;

template <class R>
class RotateRungs : public testing::Test {};
using AllRotateRungs = testing::Types<RotateNearest, RotateThreeShear, RotateBilinear>;
TYPED_TEST_SUITE(RotateRungs, AllRotateRungs);

using Values = std::vector<std::uint8_t>;

TYPED_TEST(RotateRungs, ShowPlacesWithinTheBoundOfTheirOwn) {
  oracle::Random random(951);
  double worst = 0;
  for (int i = 0; i < 16; ++i) {
    const int w = random.between(1, 90);
    const int h = random.between(1, 90);
    const int steps = i == 0 ? 8192 : i == 1 ? 150 : random.between(-32768, 32767);
    const ThreeShear turn{{random.between(80 * 256, 100 * 256), random.between(80 * 256, 100 * 256)},
                          {128 * (w - 1), 128 * (h - 1)},
                          Angle::from_steps(steps)};
    const oracle::ShownPlaces shown(w, h, [&](const Values& source) {
      Values pixels(side * side);
      EXPECT_TRUE(TypeParam{}(Surface<Indexed8>::over(pixels, {side, side}).value(), turn,
                              Picture<Indexed8>::over(source, {w, h}).value())
                      .ok());
      return pixels;
    });
    for (int at = 0; at < side * side; ++at) {
      const int x = at % side;
      const int y = at / side;
      const auto place = oracle::turned_place(x, y, steps, {turn.pivot.x / 256.0, turn.pivot.y / 256.0},
                                              turn.position.x / 256.0, turn.position.y / 256.0);
      const auto pixel = static_cast<std::size_t>(at);
      if (shown.drawn(pixel) && place.inside(w, h)) worst = std::max(worst, place.distance(shown[pixel]));
    }
  }
  const double bound = TypeParam::bound.thousandths / 1000.0;
  EXPECT_LE(worst, bound) << random.seed_text();
  EXPECT_GE(worst, bound / 3);  // smaller pictures than those that the bound is for
}

TYPED_TEST(RotateRungs, ClippedIsTheWholeCut) {
  oracle::Random random(952);
  for (int i = 0; i < 40; ++i) {
    const int w = random.between(1, 120);
    const int h = random.between(1, 120);
    Values source(static_cast<std::size_t>(w * h));
    for (auto& value : source) value = static_cast<std::uint8_t>(random.between(0, 255));
    const ThreeShear turn{{random.between(80 * 256, 100 * 256), random.between(80 * 256, 100 * 256)},
                          {128 * (w - 1), 128 * (h - 1)},
                          Angle::from_steps(random.between(-32768, 32767))};
    const auto picture = Picture<Indexed8>::over(source, {w, h}).value();
    const auto drawn = [&](const Rect& clip) {
      Values pixels(side * side);
      EXPECT_TRUE(
          TypeParam{}(Surface<Indexed8>::over(pixels, {side, side}).value(), turn, picture, clip).ok());
      return pixels;
    };
    Values cut = drawn(everywhere);
    const Rect clip{random.between(-5, 90), random.between(-5, 90), random.between(0, 99),
                    random.between(0, 99)};
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x)
        if (x < clip.x || y < clip.y || x >= clip.x + clip.width || y >= clip.y + clip.height)
          cut[static_cast<std::size_t>(y * side + x)] = 0;
    ASSERT_EQ(drawn(clip), cut) << random.seed_text();
  }
}

TYPED_TEST(RotateRungs, BadArgumentsAreNamed) {
  constexpr int min = std::numeric_limits<int>::min();
  std::vector<std::uint8_t> source(16, 5);
  std::vector<std::uint8_t> target(64, 9);
  const auto picture = Picture<Indexed8>::over(source, {4, 4}).value();
  const auto surface = Surface<Indexed8>::over(target, {8, 8}).value();
  EXPECT_EQ(TypeParam{}(surface, {{min, 0}, {}, {}}, picture),
            (Status{Error::out_of_domain, Argument::position}));
  EXPECT_EQ(TypeParam{}(surface, {{}, {0, min}, {}}, picture),
            (Status{Error::out_of_domain, Argument::point}));
  EXPECT_EQ(TypeParam{}(surface, {}, picture, {min, 0, 1, 1}),
            (Status{Error::out_of_domain, Argument::rectangle}));
  EXPECT_EQ(TypeParam{}(surface, {}, Picture<Indexed8>(surface)),
            (Status{Error::mismatched, Argument::source}));
  EXPECT_EQ(target, std::vector<std::uint8_t>(64, 9));
}

}  // namespace
