// SPDX-License-Identifier: MIT
#include <intaglio/image/rotozoom.hpp>
#include <tests/image/formats.hpp>
#include <tests/image/pictures.hpp>
#include <tests/image/placements.hpp>
#include <tests/image/rules.hpp>
#include <tests/oracle/sine.hpp>

#include <optional>

namespace {

using intaglio::Status;
using intaglio::image::blit;
using intaglio::image::blit_rotozoom;
using intaglio::image::Everything;
using intaglio::image::Indexed1;
using intaglio::image::Indexed2;
using intaglio::image::Indexed8;
using intaglio::image::KeyedRemap;
using intaglio::image::Picture;
using intaglio::image::Rotozoom;
using intaglio::linear::Point;
using intaglio::linear::Rect;
using intaglio::number::Angle;
using intaglio::number::Fixed;
using oracle::Packed;
using oracle::Wide;
using tests::IndexMap;
using tests::Layout;

constexpr int sub_limit = 1 << 28;
constexpr int width = 29;
constexpr int height = 13;
constexpr int least_scale = 1 << 8;
constexpr int largest_scale = 1 << 24;

std::string text(const Rotozoom& p) {
  return "position " + std::to_string(p.position.x) + ',' + std::to_string(p.position.y) + " pivot " +
         std::to_string(p.pivot.x) + ',' + std::to_string(p.pivot.y) + " angle " +
         std::to_string(p.angle.steps()) + " scale " + std::to_string(p.scale.raw());
}

/// Every pixel of a `width` x `height` target asked by itself; the number of pixels shown.
int expect_rotozoom(Packed& target, const Packed& source, const Rect& part, const Rotozoom& placement,
                    const Rect& clip, const IndexMap& map) {
  const oracle::Rotozoom rule = tests::oracle_of(placement);
  int shown = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Wide column = rule.column(x, y);
      const Wide row = rule.row(x, y);
      if (column < 0 || column >= part.width || row < 0 || row >= part.height || !tests::inside(clip, x, y))
        continue;
      ++shown;
      const std::optional<unsigned> index =
          map(source.get(part.x + static_cast<int>(column), part.y + static_cast<int>(row)));
      if (index) target.set(x, y, *index);
    }
  return shown;
}

/// Half of them about the middles with ordinary scales, the others anything up to the domain's edge.
Rotozoom random_placement(oracle::Random& random, const Rect& part) {
  Rotozoom p;
  p.position = {random.between(-2000, 256 * width), random.between(-2000, 256 * height)};
  p.pivot = {random.between(-300, 256 * part.width), random.between(-300, 256 * part.height)};
  p.angle =
      Angle::from_steps(random.between(0, 3) == 0 ? 16384 * random.between(0, 3) : random.between(0, 65535));
  p.scale = Fixed<16>::from_raw(random.between(1 << 14, 1 << 18));
  switch (random.between(0, 5)) {
    case 0:
      p.scale = Fixed<16>::from_raw(random.between(least_scale, largest_scale));
      break;
    case 1:
      p.scale = Fixed<16>::from_raw(random.between(0, 1) == 0 ? least_scale : largest_scale);
      break;
    case 2:
      p.position = {random.between(-sub_limit, sub_limit), random.between(-sub_limit, sub_limit)};
      p.pivot = {random.between(-sub_limit, sub_limit), random.between(-sub_limit, sub_limit)};
      break;
    default:
      break;
  }
  return p;
}

constexpr int most = 17;

/// What is shown of the source, how, and what of that is drawn.
struct Job {
  Rect part;
  Rotozoom placement;
  Rect clip;
};
using Draw = std::function<Status(Packed& to, Packed& from, const Job& job)>;

/// The number of pixels shown.
int check(oracle::Random& random, Layout target, Layout source, const IndexMap& map, const Draw& draw) {
  const Rect part = tests::random_part(random, most, most);
  const Job job{part, random_placement(random, part), tests::random_clip(random)};
  const Packed target_memory = tests::packed_rows(target, width, height, random.between(0, 3));
  const Packed source_memory = tests::packed_rows(source, most, most, random.between(0, 3));
  return tests::check_drawing(
      random, target_memory, source_memory, text(job.placement),
      [&](Packed& expected, const Packed& from) {
        return expect_rotozoom(expected, from, job.part, job.placement, job.clip, map);
      },
      [&](Packed& to, Packed& from) { return draw(to, from, job); });
}

template <class F>
class RotozoomFormats : public testing::Test {};
TYPED_TEST_SUITE(RotozoomFormats, tests::AllFormats);

TYPED_TEST(RotozoomFormats, FromEveryFormatEqualsThePredicatePixelByPixel) {
  oracle::Random random(6001);
  tests::for_all_sources<TypeParam>(tests::AllFormats{}, [&]<class F, class G>() {
    int shown = 0;
    for (int i = 0; i < 150 && !testing::Test::HasFailure(); ++i)
      tests::try_all_rules<F, G>(random, [&]<class Rule>(const Rule& rule, const IndexMap& map) {
        // The other two rules are halves of these.
        if constexpr (std::is_same_v<Rule, KeyedRemap> || std::is_same_v<Rule, Everything>)
          shown +=
              check(random, tests::layout_of<F>, tests::layout_of<G>, map,
                    [&rule](Packed& to, Packed& from, const Job& job) {
                      return blit_rotozoom(tests::surface_over<F>(to, width, height), job.placement,
                                           Picture<G>(tests::surface_over<G>(from, most, most).sub(job.part)),
                                           rule, job.clip);
                    });
      });
    EXPECT_GT(shown, 1500) << "most of the cases show nothing";
  });
}

TEST(Rotozoom, EveryAngleAboutTheMiddleEqualsThePredicate) {
  oracle::Random random(61);
  Packed from = tests::packed_rows<Indexed8>(12, 7);
  from.randomize(random);
  const auto source = tests::surface_over<Indexed8>(from, 12, 7);
  int wrong = 0;
  for (int steps = 0; steps < 65536; steps += 13) {
    const Rotozoom placement{{128 * (width - 1), 128 * (height - 1)},
                             {128 * 11, 128 * 6},
                             Angle::from_steps(steps),
                             Fixed<16>::from_raw(60000 + steps)};
    Packed to = tests::packed_rows<Indexed8>(width, height);
    Packed expected = to;
    expect_rotozoom(expected, from, {0, 0, 12, 7}, placement, {0, 0, width, height},
                    [](unsigned index) { return std::optional<unsigned>(index); });
    ASSERT_TRUE(blit_rotozoom(tests::surface_over<Indexed8>(to, width, height), placement, source).ok());
    wrong += static_cast<int>(to.bytes() != expected.bytes());
  }
  EXPECT_EQ(wrong, 0);
}

TEST(Rotozoom, UnturnedAndUnscaledIsAPlainBlit) {
  oracle::Random random(62);
  Packed from = tests::packed_rows<Indexed2>(13, 7);
  from.randomize(random);
  const Picture<Indexed2> source = tests::surface_over<Indexed2>(from, 13, 7);
  for (const Point at : {Point{0, 0}, Point{-5, 3}, Point{20, -2}}) {
    Packed turned = tests::packed_rows<Indexed2>(width, height);
    Packed copied = turned;
    ASSERT_TRUE(blit_rotozoom(tests::surface_over<Indexed2>(turned, width, height),
                              {.position = {256 * at.x, 256 * at.y}}, source)
                    .ok());
    ASSERT_TRUE(blit(tests::surface_over<Indexed2>(copied, width, height), at, source).ok());
    EXPECT_EQ(turned.bytes(), copied.bytes()) << at.x << ' ' << at.y;
  }
}

TEST(Rotozoom, AQuarterTurnIsTheTransposedPictureClockwise) {
  oracle::Random random(63);
  Packed from = tests::packed_rows<Indexed8>(9, 4);
  from.randomize(random);
  Packed to = tests::packed_rows<Indexed8>(width, height);
  Packed expected = to;
  // The corner pixel stays; columns go down, rows to the left.
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 9; ++x) expected.set(10 - y, 2 + x, from.get(x, y));
  ASSERT_TRUE(blit_rotozoom(tests::surface_over<Indexed8>(to, width, height),
                            {.position = {2560, 512}, .angle = intaglio::number::quarter_turn},
                            tests::surface_over<Indexed8>(from, 9, 4))
                  .ok());
  EXPECT_EQ(to.bytes(), expected.bytes());
}

TEST(Rotozoom, ASourceOfTheLongestSideIsReadToItsLastColumn) {
  constexpr int side = 1 << 16;
  oracle::Random random(65);
  Packed from = tests::packed_rows<Indexed1>(side, 1);
  from.randomize(random);
  const auto source = tests::surface_over<Indexed1>(from, side, 1);
  for (const int raw : {least_scale, 65536, 32768, 300, 70001})
    for (const int degrees : {0, 180, 90, 1}) {
      const Rotozoom placement{{256 * (width - 1), 0},
                               {256 * (side - 1), 0},
                               Angle::from_degrees(degrees),
                               Fixed<16>::from_raw(raw)};
      Packed to = tests::packed_rows<Indexed1>(width, height);
      Packed expected = to;
      EXPECT_GT(expect_rotozoom(expected, from, {0, 0, side, 1}, placement, {0, 0, width, height},
                                [](unsigned index) { return std::optional<unsigned>(index); }),
                0);
      ASSERT_TRUE(blit_rotozoom(tests::surface_over<Indexed1>(to, width, height), placement, source).ok());
      EXPECT_EQ(to.bytes(), expected.bytes()) << text(placement);
    }
}

TEST(RotozoomBound, PlacesOnTheSourceAreWithinTheStatedErrorOfTheTrueOnes) {
  // In 2^-16 pixel: what U or V of the rule may be off by, from the head of rotozoom.hpp, a tenth of a
  // percent of a unit being left for the oracle's own sine.
  oracle::Random random(66);
  int wrong = 0;
  for (int i = 0; i < 200000; ++i) {
    const Angle angle = Angle::from_steps(random.between(0, 65535));
    const int scale = random.between(0, 1) == 0 ? random.between(least_scale, 1 << 17)
                                                : random.between(least_scale, largest_scale);
    const oracle::Rotozoom rule = tests::oracle_of(Rotozoom{{}, {}, angle, Fixed<16>::from_raw(scale)});
    // |U - true| <= 1/2 + 2.002 * 65536 / scale; both sides times scale * 1000, the sine in 2^62.
    const Wide used = rule.step(rule.sine) * scale;                  // 2^-32
    const Wide truth = Wide{oracle::sine_q62(angle.steps())} >> 30;  // 2^-32
    const Wide off = used > truth ? used - truth : truth - used;
    wrong += static_cast<int>(1000 * off > Wide{500} * scale + Wide{2002} * 65536);
  }
  EXPECT_EQ(wrong, 0);
}

}  // namespace
