// SPDX-License-Identifier: MIT
#include <intaglio/image/blit.hpp>
#include <tests/image/formats.hpp>
#include <tests/image/pictures.hpp>
#include <tests/image/rules.hpp>

#include <optional>
#include <tuple>

namespace {

using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::image::blit;
using intaglio::image::Indexed4;
using intaglio::image::Indexed4Lsb;
using intaglio::image::Indexed8;
using intaglio::image::Picture;
using intaglio::image::Surface;
using intaglio::linear::Point;
using intaglio::linear::Rect;
using oracle::Packed;
using tests::IndexMap;
using tests::Layout;

constexpr int width = 27;
constexpr int height = 6;

/// What is copied onto what, in coordinates of the two memories.
struct Job {
  Rect source;     // The part of the source memory that is the source.
  Rect target;     // The part of the target memory that is the target.
  Point position;  // In the target's coordinates.
  Rect clip;       // In the target's coordinates.
};

Job random_job(oracle::Random& random) {
  Job job{tests::random_part(random, width, height),
          tests::random_part(random, width, height),
          {random.between(-9, 9), random.between(-4, 4)},
          {-100, -100, 200, 200}};
  if (random.between(0, 2) == 0)
    job.clip = {random.between(-5, 20), random.between(-3, 5), random.between(-1, 20), random.between(-1, 6)};
  return job;
}

/// Paints the expected picture: the source is read first, then every pixel that is inside everything is
/// written. Answers how many are.
int expect_blit(Packed& target, const Packed& source, const Job& job, const IndexMap& map) {
  std::vector<unsigned> read;
  for (int y = 0; y < job.source.height; ++y)
    for (int x = 0; x < job.source.width; ++x) read.push_back(source.get(job.source.x + x, job.source.y + y));
  std::size_t next = 0;
  int shown = 0;
  for (int y = 0; y < job.source.height; ++y)
    for (int x = 0; x < job.source.width; ++x) {
      const std::optional<unsigned> index = map(read[next++]);
      const int column = job.position.x + x;
      const int row = job.position.y + y;
      const bool on_target = tests::inside({0, 0, job.target.width, job.target.height}, column, row);
      if (!index || !on_target || !tests::inside(job.clip, column, row)) continue;
      target.set(job.target.x + column, job.target.y + row, *index);
      ++shown;
    }
  return shown;
}

std::string text(const Job& job) {
  return "source " + tests::text(job.source) + " target " + tests::text(job.target) + " at " +
         std::to_string(job.position.x) + ',' + std::to_string(job.position.y) + " clip " +
         tests::text(job.clip);
}

/// Draws a job from one memory to another, or within one.
using Draw = std::function<Status(Packed& to, Packed& from, const Job& job)>;

/// One random job by one rule between two memories, and within one if the formats are the same.
void check(oracle::Random& random, Layout target, Layout source, const IndexMap& map, const Draw& draw) {
  const Job job = random_job(random);
  const Packed target_memory = tests::packed_rows(target, width, height, random.between(0, 3));
  const Packed source_memory = tests::packed_rows(source, width, height, random.between(0, 3));
  tests::check_drawing(
      random, target_memory, source_memory, text(job),
      [&](Packed& expected, const Packed& from) { return expect_blit(expected, from, job, map); },
      [&](Packed& memory, Packed& from) { return draw(memory, from, job); });
  if (target == source)
    tests::check_drawing(
        random, target_memory, Packed(8, true, 0, 0), "overlap, " + text(job),
        [&](Packed& expected, const Packed&) { return expect_blit(expected, expected, job, map); },
        [&](Packed& memory, Packed&) { return draw(memory, memory, job); });
}

template <class F>
class Blit : public testing::Test {};
TYPED_TEST_SUITE(Blit, tests::AllFormats);

TYPED_TEST(Blit, FromEveryFormatByEveryRuleEqualsReadingFirstAndWritingThen) {
  oracle::Random random(4001);
  tests::for_all_sources<TypeParam>(tests::AllFormats{}, [&]<class F, class G>() {
    const int jobs = std::is_same_v<F, G> ? 3000 : 400;
    for (int i = 0; i < jobs && !testing::Test::HasFailure(); ++i)
      tests::try_all_rules<F, G>(random, [&](const auto& rule, const IndexMap& map) {
        check(random, tests::layout_of<F>, tests::layout_of<G>, map,
              [&rule](Packed& to, Packed& from, const Job& job) {
                return blit(tests::surface_over<F>(to, width, height).sub(job.target), job.position,
                            Picture<G>(tests::surface_over<G>(from, width, height).sub(job.source)), rule,
                            job.clip);
              });
      });
  });
}

TYPED_TEST(Blit, AFrameScrollsOverItselfInEveryDirection) {
  oracle::Random random(41);
  for (int dy = -7; dy <= 7; ++dy)
    for (int dx = -28; dx <= 28; ++dx) {
      Packed memory = tests::packed_rows<TypeParam>(width, height, 1);
      memory.randomize(random);
      Packed expected = memory;
      const Rect all{0, 0, width, height};
      expect_blit(expected, expected, {all, all, {dx, dy}, all},
                  [](unsigned i) { return std::optional<unsigned>(i); });
      const auto frame = tests::surface_over<TypeParam>(memory, width, height);
      ASSERT_TRUE(blit(frame, {dx, dy}, frame).ok());
      ASSERT_EQ(memory.bytes(), expected.bytes()) << dx << ' ' << dy;
    }
}

TYPED_TEST(Blit, ABandAsSourceLandsWithItsCorner) {
  oracle::Random random(43);
  Packed from = tests::packed_rows<TypeParam>(9, 3);
  from.randomize(random);
  const auto band = Picture<TypeParam>::over_band(from.bytes(), {-4, 77, 9, 3});
  ASSERT_TRUE(band.ok());
  Packed to = tests::packed_rows<TypeParam>(width, height);
  Packed expected = to;
  expect_blit(expected, from, {{0, 0, 9, 3}, {0, 0, width, height}, {5, 2}, {0, 0, width, height}},
              [](unsigned i) { return std::optional<unsigned>(i); });
  ASSERT_TRUE(blit(tests::surface_over<TypeParam>(to, width, height), {5, 2}, band.value()).ok());
  EXPECT_EQ(to.bytes(), expected.bytes());
}

TEST(BlitVisible, PositionsOutsideTheTargetDrawNothing) {
  constexpr int limit = 1 << 20;
  oracle::Random random(45);
  Packed to = tests::packed_rows<Indexed8>(width, height);
  to.randomize(random);
  Packed from = tests::packed_rows<Indexed8>(width, height);
  const Packed before = to;
  const auto target = tests::surface_over<Indexed8>(to, width, height);
  const auto source = tests::surface_over<Indexed8>(from, width, height);
  for (const Point position : {Point{width, 0}, Point{-width, 0}, Point{0, height}, Point{0, -height},
                               Point{limit, limit}, Point{-limit, -limit}})
    EXPECT_TRUE(blit(target, position, source).ok());
  EXPECT_EQ(to.bytes(), before.bytes());
}

TEST(BlitOverlap, ViewsOfAnotherStrideOrFormatInTheSameMemoryAreRefused) {
  oracle::Random random(46);
  Packed memory = tests::packed_rows<Indexed8>(width, height);
  memory.randomize(random);
  const Packed before = memory;
  const auto view = [&]<class F>(F, int columns, int rows, int stride) {
    const auto result = Surface<F>::over(memory.bytes(), {columns, rows}, stride);
    EXPECT_TRUE(result.ok());
    return result.value();
  };
  const auto frame = view(Indexed8{}, width, height, 0);
  const Status refused{Error::mismatched, Argument::source};
  EXPECT_EQ(blit(frame, {0, 1}, view(Indexed8{}, width, height - 1, width + 1)), refused);
  EXPECT_EQ(blit(frame, {0, 1}, view(Indexed4{}, width, height, 0)), refused);
  EXPECT_EQ(blit(view(Indexed4Lsb{}, width, 2, 0), {0, 0}, view(Indexed4{}, width, 2, 0)), refused);
  EXPECT_EQ(memory.bytes(), before.bytes());
  // A single row has no stride, and rows that don't meet don't overlap.
  EXPECT_TRUE(blit(frame, {2, 0}, view(Indexed8{}, width, 1, width + 1)).ok());
  EXPECT_TRUE(blit(frame.sub({0, 4, width, 2}), {0, 0}, view(Indexed8{}, 20, 2, 20)).ok());
}

}  // namespace
