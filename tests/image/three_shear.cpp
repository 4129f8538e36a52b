// SPDX-License-Identifier: MIT
#include <intaglio/image/three_shear.hpp>
#include <tests/image/pictures.hpp>
#include <tests/image/placements.hpp>
#include <tests/image/rules.hpp>
#include <tests/oracle/samples.hpp>
#include <tests/oracle/sine.hpp>

#include <optional>

namespace {

using intaglio::image::blit_three_shear;
using intaglio::image::Everything;
using intaglio::image::Indexed1;
using intaglio::image::Indexed2;
using intaglio::image::Indexed8;
using intaglio::image::Picture;
using intaglio::image::ThreeShear;
using intaglio::linear::Point;
using intaglio::linear::Rect;
using intaglio::linear::Size;
using intaglio::linear::SubPoint;
using intaglio::number::Angle;
using oracle::Packed;
using oracle::Wide;
using tests::IndexMap;

constexpr int sub_limit = 1 << 28;
constexpr int width = 29;
constexpr int height = 13;

/// What is shown by the rule `Everything`.
unsigned as_it_is(unsigned index) { return index; }

std::string text(const ThreeShear& p) {
  return "position " + std::to_string(p.position.x) + ',' + std::to_string(p.position.y) + " pivot " +
         std::to_string(p.pivot.x) + ',' + std::to_string(p.pivot.y) + " angle " +
         std::to_string(p.angle.steps());
}

/// Every pixel of the source brought to where it lands; how many land on the `width` x `height` target.
int expect_three_shear(Packed& target, const Packed& source, const Rect& part, const ThreeShear& placement,
                       const Rect& clip, const IndexMap& map) {
  const oracle::ThreeShear rule = tests::oracle_of(placement, {part.width, part.height});
  int shown = 0;
  for (int row = 0; row < part.height; ++row)
    for (int column = 0; column < part.width; ++column) {
      const auto place = rule.land(column, row);
      if (place.x < 0 || place.x >= width || place.y < 0 || place.y >= height) continue;
      const int x = static_cast<int>(place.x);
      const int y = static_cast<int>(place.y);
      if (!tests::inside(clip, x, y)) continue;
      ++shown;
      const std::optional<unsigned> index = map(source.get(part.x + column, part.y + row));
      if (index) target.set(x, y, *index);
    }
  return shown;
}

/// Most of them near the middles; an eighth of a turn and its neighbours are as likely as all other angles.
ThreeShear random_placement(oracle::Random& random, const Rect& part) {
  ThreeShear p;
  p.position = {random.between(0, 256 * width), random.between(0, 256 * height)};
  p.pivot = {random.between(-300, 256 * part.width), random.between(-300, 256 * part.height)};
  p.angle = Angle::from_steps(random.between(0, 1) == 0 ? 8192 * random.between(0, 7) + random.between(-1, 1)
                                                        : random.between(0, 65535));
  if (random.between(0, 2) == 0) p.position.x = 128 * random.between(0, 2 * width);
  if (random.between(0, 9) == 0) {
    // Two places so far away that they are next to each other again, if the angle is small.
    p.position = {random.between(-sub_limit, sub_limit), random.between(-sub_limit, sub_limit)};
    p.pivot = {p.position.x + random.between(-2000, 2000), p.position.y + random.between(-2000, 2000)};
    p.pivot = {std::clamp(p.pivot.x, -sub_limit, sub_limit), std::clamp(p.pivot.y, -sub_limit, sub_limit)};
    if (random.between(0, 1) == 0) p.angle = Angle::from_steps(0);
  }
  return p;
}

template <class F, class G, class Rule>
int check(oracle::Random& random, const Rule& rule, const IndexMap& map) {
  constexpr int most = 17;
  const Rect part = tests::random_part(random, most, most);
  const ThreeShear placement = random_placement(random, part);
  const Rect clip = tests::random_clip(random);
  const Packed target_memory = tests::packed_rows<F>(width, height, random.between(0, 3));
  const Packed source_memory = tests::packed_rows<G>(most, most, random.between(0, 3));
  return tests::check_drawing(
      random, target_memory, source_memory, text(placement) + ", source " + tests::text(part),
      [&](Packed& expected, const Packed& from) {
        return expect_three_shear(expected, from, part, placement, clip, map);
      },
      [&](Packed& to, Packed& from) {
        return blit_three_shear(tests::surface_over<F>(to, width, height), placement,
                                Picture<G>(tests::surface_over<G>(from, most, most).sub(part)), rule, clip);
      });
}

template <class F, class G>
void check_pair(std::uint32_t seed, int jobs) {
  oracle::Random random(seed);
  int shown = 0;
  for (int i = 0; i < jobs && !testing::Test::HasFailure(); ++i)
    tests::try_all_rules<F, G>(
        random, [&](const auto& rule, const IndexMap& map) { shown += check<F, G>(random, rule, map); });
  EXPECT_GT(shown, 10 * jobs) << "most of the cases show nothing";
}

TEST(ThreeShear, BetweenFormatsByEveryRuleEqualsEveryPixelFollowedForwards) {
  check_pair<Indexed8, Indexed8>(7001, oracle::samples(1000, 100000));
  check_pair<Indexed1, Indexed8>(7002, 200);
  check_pair<Indexed8, Indexed1>(7003, 200);
  check_pair<intaglio::image::Indexed4Lsb, Indexed2>(7004, 200);
}

// Each of 247 pixels has an index of its own, and lies on a target with room for all of them.
TEST(ThreeShear, IsAPermutationAtEveryAngle) {
  constexpr int side = 40;
  Packed from = tests::packed_rows<Indexed8>(19, 13);
  for (int i = 0; i < 19 * 13; ++i) from.set(i % 19, i / 19, static_cast<unsigned>(i) + 1);
  const Picture<Indexed8> source = tests::surface_over<Indexed8>(from, 19, 13);
  int wrong = 0;
  for (int steps = 0; steps < 65536; steps += oracle::samples(7, 1)) {
    Packed to = tests::packed_rows<Indexed8>(side, side);
    const ThreeShear placement{{128 * side, 128 * side}, {128 * 18, 128 * 12}, Angle::from_steps(steps)};
    ASSERT_TRUE(blit_three_shear(tests::surface_over<Indexed8>(to, side, side), placement, source).ok());
    std::array<int, 256> times{};
    for (const std::uint8_t index : to.bytes()) ++times[index];
    wrong +=
        static_cast<int>(std::any_of(times.begin() + 1, times.begin() + 248, [](int n) { return n != 1; }));
  }
  EXPECT_EQ(wrong, 0);
}

TEST(ThreeShear, QuarterTurnsRenumberThePixels) {
  oracle::Random random(72);
  Packed from = tests::packed_rows<Indexed8>(9, 4);
  from.randomize(random);
  const Picture<Indexed8> source = tests::surface_over<Indexed8>(from, 9, 4);
  for (int quarters = 0; quarters < 4; ++quarters) {
    Packed to = tests::packed_rows<Indexed8>(width, height);
    Packed expected = to;
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 9; ++x) {
        // Columns go right, down, left, up; the corner pixel stays.
        constexpr std::array<Point, 4> ways{Point{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
        const Point way = ways[static_cast<std::size_t>(quarters)];
        const int column = 14 + way.x * x - way.y * y;
        const int row = 6 + way.y * x + way.x * y;
        if (row >= 0 && row < height) expected.set(column, row, from.get(x, y));
      }
    const ThreeShear placement{{256 * 14, 256 * 6}, {0, 0}, intaglio::number::quarter_turn * quarters};
    ASSERT_TRUE(blit_three_shear(tests::surface_over<Indexed8>(to, width, height), placement, source).ok());
    EXPECT_EQ(to.bytes(), expected.bytes()) << quarters;
  }
}

TEST(ThreeShear, ASourceOfTheLongestSideIsReadToItsLastColumn) {
  constexpr int side = 1 << 16;
  oracle::Random random(74);
  Packed from = tests::packed_rows<Indexed1>(side, 1);
  Packed tall = tests::packed_rows<Indexed1>(1, side);
  from.randomize(random);
  tall.randomize(random);
  for (const int steps : {0, 1, -1, 77, 5000, 8191, 8192, -8192, -8193, 16384, 32768, 40000, 49151})
    for (const bool upright : {false, true}) {
      const SubPoint end{upright ? 0 : 256 * (side - 1), upright ? 256 * (side - 1) : 0};
      const ThreeShear placement{{256 * (width - 1), 256 * 5}, end, Angle::from_steps(steps)};
      Packed to = tests::packed_rows<Indexed1>(width, height);
      Packed expected = to;
      const Size size = upright ? Size{1, side} : Size{side, 1};
      Packed& memory = upright ? tall : from;
      EXPECT_GT(expect_three_shear(expected, memory, {0, 0, size.width, size.height}, placement,
                                   {0, 0, width, height}, as_it_is),
                0);
      ASSERT_TRUE(blit_three_shear(tests::surface_over<Indexed1>(to, width, height), placement,
                                   tests::surface_over<Indexed1>(memory, size.width, size.height))
                      .ok());
      EXPECT_EQ(to.bytes(), expected.bytes()) << text(placement);
    }
}

// In 2^-15 pixel, a thousandth being left for the oracle's own sine: what the head of three_shear.hpp states.
TEST(ThreeShearBound, PixelsLandWithinTheStatedErrorOfTheTrueTurn) {
  oracle::Random random(75);
  int wrong = 0;
  for (int i = 0; i < 200000; ++i) {
    const int reach = i % 2 == 0 ? 40 : 20000;
    const int steps = random.between(-8192, 8191);
    const oracle::ThreeShear rule = tests::oracle_of(ThreeShear{{}, {}, Angle::from_steps(steps)}, {1, 1});
    const Wide column = random.between(-reach, reach);
    const Wide row = random.between(-reach, reach);
    const auto place = rule.land(column, row);
    const int turn = steps < 0 ? steps + 65536 : steps;
    const Wide sine = Wide{oracle::sine_q62(turn)};
    const Wide cosine = Wide{oracle::sine_q62((turn + 16384) % 65536)};
    const auto off = [](Wide landed, Wide truth_q62) {
      const Wide difference = landed * 32768 - (truth_q62 >> 47);
      return difference < 0 ? -difference : difference;
    };
    const Wide x_off = off(place.x, column * cosine - row * sine);
    const Wide y_off = off(place.y, column * sine + row * cosine);
    const Wide distance = (column < 0 ? -column : column) + (row < 0 ? -row : row);
    wrong += static_cast<int>(1000 * x_off > Wide{1360} * 32768 + 2400 * distance ||
                              1000 * y_off > Wide{860} * 32768 + 2400 * distance);
  }
  EXPECT_EQ(wrong, 0);
}

}  // namespace
