// SPDX-License-Identifier: MIT
//
// Values along runs seen in perspective, against rational arithmetic.
#include <intaglio/raster/perspective.hpp>
#include <tests/oracle/perspective.hpp>
#include <tests/oracle/random.hpp>
#include <tests/oracle/samples.hpp>

#include <climits>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

using namespace intaglio;
using raster::Perspective;

struct Ends {
  int from;
  int to;
  std::uint32_t from_depth;
  std::uint32_t to_depth;
  int steps;

  [[nodiscard]] Perspective made() const {
    const auto run = Perspective::by_depths(from, to, from_depth, to_depth, steps);
    EXPECT_TRUE(run.ok()) << text();
    return run.value();
  }
  [[nodiscard]] mpq_class exact(int k) const {
    return oracle::in_perspective(from, to, from_depth, to_depth, steps, k);
  }
  [[nodiscard]] std::string text() const {
    return std::to_string(from) + " at " + std::to_string(from_depth) + " to " + std::to_string(to) + " at " +
           std::to_string(to_depth) + " in " + std::to_string(steps);
  }
};

/// Runs of all sizes: short and long, flat and steep, to the edges of the domain.
Ends random_run(oracle::Random& random) {
  Ends run{};
  run.steps = 1 << random.between(0, 20);
  run.steps = random.between(1, run.steps);
  const std::uint32_t deepest = UINT32_MAX / static_cast<std::uint32_t>(run.steps);
  const auto depth = [&] {
    const auto any = static_cast<std::uint32_t>(random.bits() >> 32U) >> random.between(0, 31);
    return 1U + any % deepest;
  };
  const int reach = random.between(0, 3) == 0 ? raster::perspective_value_limit : 1 << random.between(0, 23);
  run.from = random.between(-reach, reach);
  run.to = random.between(-reach, reach);
  run.from_depth = depth();
  run.to_depth = random.between(0, 7) == 0 ? run.from_depth : depth();
  if (run.from_depth > deepest) run.from_depth = deepest;
  if (run.to_depth > deepest) run.to_depth = deepest;
  return run;
}

template <class Rung>
std::vector<int> values(const Perspective& run, int begin, int end) {
  std::vector<int> all;
  raster::walk_perspective<Rung>(run, begin, end, [&](int value) { all.push_back(value); });
  return all;
}

TEST(Perspective, EveryPixelIsTheExactValueRoundedDown) {
  oracle::Random random(1988);
  const int runs = oracle::samples(3000, 100000);
  for (int i = 0; i < runs; ++i) {
    const Ends run = random_run(random);
    const int k = i % 4 == 0 ? run.steps : random.between(0, run.steps);
    ASSERT_EQ(run.made().at(k), oracle::rounded_down(run.exact(k)))
        << run.text() << " step " << k << " " << random.seed_text();
  }
}

TEST(Perspective, EndsAreTheEndsWhateverTheDepths) {
  oracle::Random random(1989);
  for (int i = 0; i < 3000; ++i) {
    const Ends run = random_run(random);
    ASSERT_EQ(run.made().at(0), run.from) << run.text();
    ASSERT_EQ(run.made().at(run.steps), run.to) << run.text();
  }
}

TEST(Perspective, EqualDepthsAreNoPerspective) {
  const Ends run{-1000, 3001, 77, 77, 640};
  EXPECT_EQ(values<raster::PerspectiveAffine>(run.made(), 0, 641),
            values<raster::PerspectiveEveryPixel>(run.made(), 0, 641));
}

// The midpoint of a line from depth 1 to depth 3 is at depth 2, and on the screen 3/4 of the way: the
// cross-ratio's q is 3.
TEST(Perspective, TheProjectedMidpointSaysTheSameAsTheDepths) {
  const auto by_depths = Perspective::by_depths(0, 4096, 100, 300, 400);
  const auto by_midpoint = Perspective::by_midpoint(0, 4096, 300, 100, 400);
  ASSERT_TRUE(by_depths.ok() && by_midpoint.ok());
  EXPECT_EQ(by_midpoint.value().at(300), 2048);
  for (int k = 0; k <= 400; ++k) EXPECT_EQ(by_midpoint.value().at(k), by_depths.value().at(k));
}

// A camera at the origin looks along z; points of a slanted line are projected by x/z. What lies where the
// ray through a pixel meets the line is solved for directly, without depths or cross-ratios.
TEST(Perspective, AgreesWithRaysThroughThePixels) {
  constexpr int x0 = -300, z0 = 200, x1 = 900, z1 = 700, focal = 256, length = 1 << 16;
  const mpq_class left = mpq_class(x0 * focal) / z0;
  const mpq_class right = mpq_class(x1 * focal) / z1;
  constexpr int steps = 500;
  const auto run = Perspective::by_depths(0, length, z0, z1, steps);
  ASSERT_TRUE(run.ok());
  for (int k = 0; k <= steps; ++k) {
    const mpq_class x = left + (right - left) * k / steps;
    // x0 + t (x1-x0) = x/focal * (z0 + t (z1-z0))
    const mpq_class t = (x * z0 / focal - x0) / (mpq_class(x1 - x0) - x * (z1 - z0) / focal);
    ASSERT_EQ(run.value().at(k), oracle::rounded_down(t * length)) << k;
  }
}

template <class Rung>
class PerspectiveRung : public testing::Test {};
using Rungs =
    testing::Types<raster::PerspectiveEveryPixel, raster::PerspectiveEvery<8>, raster::PerspectiveEvery<16>,
                   raster::PerspectiveEvery<32>, raster::PerspectiveAffine>;
TYPED_TEST_SUITE(PerspectiveRung, Rungs);

TYPED_TEST(PerspectiveRung, StaysWithinItsBound) {
  oracle::Random random(7);
  const int runs = oracle::samples(300, 5000);
  for (int i = 0; i < runs; ++i) {
    Ends run = random_run(random);
    if (run.steps > 2000) run.steps = run.steps % 2000 + 1;
    const Perspective made = run.made();
    const int bound = TypeParam::bound(made);
    const std::vector<int> all = values<TypeParam>(made, 0, run.steps + 1);
    mpq_class worst = 0;
    for (int k = 0; k <= run.steps; ++k) {
      const mpq_class error = abs(run.exact(k) - all[static_cast<std::size_t>(k)]);
      if (error > worst) worst = error;
    }
    ASSERT_LE(worst, bound) << run.text() << " " << random.seed_text();
  }
}

TYPED_TEST(PerspectiveRung, ClippingChangesNoValue) {
  oracle::Random random(8);
  for (int i = 0; i < 300; ++i) {
    Ends run = random_run(random);
    if (run.steps > 500) run.steps = run.steps % 500 + 1;
    const Perspective made = run.made();
    const std::vector<int> all = values<TypeParam>(made, 0, run.steps + 1);
    const int begin = random.between(0, run.steps);
    const int end = i % 3 == 0 ? run.steps + 1 : random.between(begin, run.steps + 1);
    ASSERT_EQ(values<TypeParam>(made, begin, end), std::vector<int>(all.begin() + begin, all.begin() + end))
        << run.text() << " from " << begin << " to " << end;
  }
}

TYPED_TEST(PerspectiveRung, FarOutRunsAreWalkedWithoutOverflow) {
  const Ends run{-raster::perspective_value_limit, raster::perspective_value_limit, 1, 4095, 1 << 20};
  const Perspective made = run.made();
  const std::vector<int> tail = values<TypeParam>(made, (1 << 20) - 3, (1 << 20) + 1);
  ASSERT_EQ(tail.size(), 4U);
  EXPECT_EQ(tail.back(), raster::perspective_value_limit);
}

// The bound isn't idle: runs come within a tenth of it, roundings apart.
TEST(Perspective, TheBoundOfAStraightLineIsReached) {
  const Ends run{0, 1 << 20, 100, 900, 1000};
  const Perspective made = run.made();
  const std::vector<int> all = values<raster::PerspectiveAffine>(made, 0, 1001);
  mpq_class worst = 0;
  for (int k = 0; k <= 1000; ++k) {
    const mpq_class error = abs(run.exact(k) - all[static_cast<std::size_t>(k)]);
    if (error > worst) worst = error;
  }
  EXPECT_GT(worst * 10, 9 * raster::PerspectiveAffine::bound(made));
}

TEST(Perspective, BadRunsAreNamed) {
  const auto status = [](int from, int to, std::uint32_t from_depth, std::uint32_t to_depth, int steps) {
    return Perspective::by_depths(from, to, from_depth, to_depth, steps).status();
  };
  EXPECT_EQ(status(0, 1, 1, 1, 0), Status(Error::empty, Argument::steps));
  EXPECT_EQ(status(0, 1, 1, 1, INT_MIN), Status(Error::empty, Argument::steps));
  EXPECT_EQ(status(INT_MIN, 1, 1, 1, 4), Status(Error::out_of_domain, Argument::point));
  EXPECT_EQ(status(0, INT_MAX, 1, 1, 4), Status(Error::out_of_domain, Argument::point));
  EXPECT_EQ(status(0, 1, 0, 1, 4), Status(Error::out_of_range, Argument::position));
  EXPECT_EQ(status(0, 1, 1, 0, 4), Status(Error::out_of_range, Argument::position));
  EXPECT_EQ(status(0, 1, 1U << 30U, 1, 4), Status(Error::out_of_range, Argument::position));
  EXPECT_TRUE(status(0, 1, (1U << 30U) - 1, 1, 4).ok());
  EXPECT_TRUE(status(0, 1, 2, 2, INT_MAX).ok());
  EXPECT_EQ(Perspective::by_midpoint(0, 1, 0, 1, 4).status(),
            Status(Error::out_of_range, Argument::position));
}

}  // namespace
