// SPDX-License-Identifier: MIT
#include <intaglio/image/scale.hpp>
#include <tests/image/formats.hpp>
#include <tests/image/pictures.hpp>
#include <tests/image/rules.hpp>
#include <tests/oracle/scale.hpp>

#include <optional>

namespace {

using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::image::blit;
using intaglio::image::blit_scaled;
using intaglio::image::Everything;
using intaglio::image::Indexed4;
using intaglio::image::Indexed8;
using intaglio::image::Picture;
using intaglio::linear::Point;
using intaglio::linear::Rect;
using intaglio::linear::Size;
using oracle::Packed;
using tests::IndexMap;
using tests::Layout;

constexpr int limit = 1 << 20;
constexpr int width = 29;
constexpr int height = 11;

/// Every pixel of a `width` x `height` target asked by itself; the number of pixels shown.
int expect_scaled(Packed& target, const Packed& source, const Rect& part, const Rect& destination,
                  const Rect& clip, const IndexMap& map) {
  int shown = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      if (!tests::inside(destination, x, y) || !tests::inside(clip, x, y)) continue;
      ++shown;
      const int column = oracle::scaled_source(x - destination.x, part.width, destination.width);
      const int row = oracle::scaled_source(y - destination.y, part.height, destination.height);
      const std::optional<unsigned> index = map(source.get(part.x + column, part.y + row));
      if (index) target.set(x, y, *index);
    }
  return shown;
}

/// A start and a length that matter to a target of `extent` pixels: small, or up to the domain's edge.
std::pair<int, int> random_extent(oracle::Random& random, int extent) {
  switch (random.between(0, 3)) {
    case 0:
      return {random.between(-limit, extent), random.between(1, 2 * limit)};
    case 1:
      return {random.between(-4 * extent, extent), random.between(1, 8 * extent)};
    default:
      return {random.between(-extent, extent), random.between(-1, 2 * extent)};
  }
}

constexpr int most = 19;

/// What is shown of the source, where, and what of that is drawn.
struct Job {
  Rect part;
  Rect destination;
  Rect clip;
};
using Draw = std::function<Status(Packed& to, Packed& from, const Job& job)>;

void check(oracle::Random& random, Layout target, Layout source, const IndexMap& map, const Draw& draw) {
  const Rect part = tests::random_part(random, most, most);
  const auto [left, columns] = random_extent(random, width);
  const auto [top, rows] = random_extent(random, height);
  const Job job{part, {left, top, columns, rows}, tests::random_clip(random)};
  const Packed target_memory = tests::packed_rows(target, width, height, random.between(0, 3));
  const Packed source_memory = tests::packed_rows(source, most, most, random.between(0, 3));
  tests::check_drawing(
      random, target_memory, source_memory,
      "source " + tests::text(job.part) + " to " + tests::text(job.destination) + " clip " +
          tests::text(job.clip),
      [&](Packed& expected, const Packed& from) {
        return expect_scaled(expected, from, job.part, job.destination, job.clip, map);
      },
      [&](Packed& to, Packed& from) { return draw(to, from, job); });
}

template <class F>
class Scale : public testing::Test {};
TYPED_TEST_SUITE(Scale, tests::AllFormats);

TYPED_TEST(Scale, FromEveryFormatByEveryRuleEqualsThePredicatePixelByPixel) {
  oracle::Random random(5001);
  tests::for_all_sources<TypeParam>(tests::AllFormats{}, [&]<class F, class G>() {
    for (int i = 0; i < 400 && !testing::Test::HasFailure(); ++i)
      tests::try_all_rules<F, G>(random, [&](const auto& rule, const IndexMap& map) {
        check(random, tests::layout_of<F>, tests::layout_of<G>, map,
              [&rule](Packed& to, Packed& from, const Job& job) {
                return blit_scaled(tests::surface_over<F>(to, width, height), job.destination,
                                   Picture<G>(tests::surface_over<G>(from, most, most).sub(job.part)), rule,
                                   job.clip);
              });
      });
  });
}

TYPED_TEST(Scale, ToItsOwnSizeIsAPlainBlit) {
  oracle::Random random(51);
  Packed from = tests::packed_rows<TypeParam>(13, 7);
  from.randomize(random);
  const Picture<TypeParam> source = tests::surface_over<TypeParam>(from, 13, 7);
  for (const Point at : {Point{0, 0}, Point{-5, 3}, Point{20, -2}}) {
    Packed scaled = tests::packed_rows<TypeParam>(width, height);
    Packed copied = scaled;
    ASSERT_TRUE(
        blit_scaled(tests::surface_over<TypeParam>(scaled, width, height), {at.x, at.y, 13, 7}, source).ok());
    ASSERT_TRUE(blit(tests::surface_over<TypeParam>(copied, width, height), at, source).ok());
    EXPECT_EQ(scaled.bytes(), copied.bytes()) << at.x << ' ' << at.y;
  }
}

TEST(ScaleStep, EqualsThePredicateAtEveryPixelOfOddAndHugeLengths) {
  // A drift of one part in 2^21 would show at the end of the longest ones.
  for (const Size pair : {Size{1, 2 * limit}, Size{limit, 2 * limit}, Size{limit, 1}, Size{limit, limit - 1},
                          Size{limit - 1, 2 * limit - 1}, Size{limit - 1, 3}, Size{7, 2 * limit - 3},
                          Size{699051, 1048573}, Size{3, 2}, Size{1, 1}}) {
    auto step = intaglio::image::detail::ScaleStep::at(0, pair.width, pair.height);
    int wrong = 0;
    for (int offset = 0; offset < pair.height; ++offset, step.advance()) {
      const int expected = oracle::scaled_source(offset, pair.width, pair.height);
      wrong += static_cast<int>(step.index() != expected || expected < 0 || expected >= pair.width);
    }
    EXPECT_EQ(wrong, 0) << pair.width << " to " << pair.height;
  }
}

TEST(ScaleStep, EveryPairOfSmallLengthsBegunAnywhereEqualsThePredicate) {
  int wrong = 0;
  for (int from = 1; from <= 40; ++from)
    for (int to = 1; to <= 40; ++to)
      for (int first = 0; first < to; ++first) {
        auto step = intaglio::image::detail::ScaleStep::at(first, from, to);
        for (int offset = first; offset < to; ++offset, step.advance())
          wrong += static_cast<int>(step.index() != oracle::scaled_source(offset, from, to));
      }
  EXPECT_EQ(wrong, 0);
}

TEST(ScaleVisible, APictureOfTheDomainsSizeShowsItsVisiblePartOnly) {
  oracle::Random random(53);
  Packed from = tests::packed_rows<Indexed8>(5, 3);
  from.randomize(random);
  const auto source = tests::surface_over<Indexed8>(from, 5, 3);
  for (const Rect& destination :
       {Rect{-limit, -limit, 2 * limit, 2 * limit}, Rect{-limit, -limit, limit + 9, limit + 4},
        Rect{width - 1, height - 1, 2 * limit, 2 * limit}, Rect{-limit, 0, limit + 1, 1}}) {
    Packed to = tests::packed_rows<Indexed8>(width, height);
    Packed expected = to;
    expect_scaled(expected, from, {0, 0, 5, 3}, destination, {0, 0, width, height},
                  [](unsigned index) { return std::optional<unsigned>(index); });
    ASSERT_TRUE(blit_scaled(tests::surface_over<Indexed8>(to, width, height), destination, source).ok());
    EXPECT_EQ(to.bytes(), expected.bytes()) << tests::text(destination);
  }
}

TEST(ScaleOverlap, SourceAndVisibleTargetMustNotMeetInMemory) {
  oracle::Random random(55);
  Packed memory = tests::packed_rows<Indexed8>(width, height);
  memory.randomize(random);
  const Packed before = memory;
  const auto frame = tests::surface_over<Indexed8>(memory, width, height);
  const Status refused{Error::mismatched, Argument::source};
  EXPECT_EQ(blit_scaled(frame, {0, 0, 2 * width, 2 * height}, frame), refused);
  EXPECT_EQ(blit_scaled(frame, {width - 1, 0, 4, 1}, frame.sub({0, 0, width, 1})), refused);
  const auto packed = Picture<Indexed4>::over(memory.bytes(), {4, 4});
  ASSERT_TRUE(packed.ok());
  EXPECT_EQ(blit_scaled(frame, {0, 0, 8, 8}, packed.value()), refused);
  EXPECT_EQ(memory.bytes(), before.bytes());
  // Rows below the source's are free, and a clip may keep the drawing to them.
  EXPECT_TRUE(blit_scaled(frame, {0, 3, width, 5}, frame.sub({0, 0, width, 3})).ok());
  EXPECT_TRUE(
      blit_scaled(frame, {0, 0, width, height}, frame.sub({0, 0, width, 3}), Everything{}, {0, 3, 99, 99})
          .ok());
}

}  // namespace
