// SPDX-License-Identifier: MIT
//
// What every blit must do, wherever it shows what it reads: the same pixels under any clip and in any band,
// from the source's own pixels alone; and refuse what it can't show, with nothing drawn.
#include <tests/image/every_blit.hpp>
#include <tests/image/pictures.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace {

using namespace intaglio;
using image::ColourKey;
using image::Everything;
using image::KeyedRemap;
using image::Picture;
using image::Remap;
using image::Surface;
using linear::Point;
using linear::Rect;
using linear::Size;
using linear::SubPoint;
using oracle::Packed;

constexpr int limit = 1 << 20;
constexpr int width = 29;
constexpr int height = 13;
constexpr int columns = 11;
constexpr int rows = 9;

template <class F>
class EveryBlit : public testing::Test {};
TYPED_TEST_SUITE(EveryBlit, tests::AllFormats);

TYPED_TEST(EveryBlit, BandsOfTheTargetAndOfTheSourceGiveTheWholePicture) {
  using F = TypeParam;
  oracle::Random random(91);
  Packed from = tests::packed_rows<F>(columns, rows);
  for (int i = 0; i < 12; ++i) {
    from.randomize(random);
    const Picture<F> source = tests::surface_over<F>(from, columns, rows);
    const auto band_of_source = Picture<F>::over_band(from.bytes(), {-3, 40, columns, rows});
    ASSERT_TRUE(band_of_source.ok());
    tests::with_each_blit(random, {width, height}, {columns, rows}, [&](const auto draw) {
      Packed whole = tests::packed_rows<F>(width, height);
      ASSERT_TRUE(draw(tests::surface_over<F>(whole, width, height), source).ok());
      tests::expect_bands_give<F>(whole, width, height,
                                  [&](const Surface<F>& band) { return draw(band, band_of_source.value()); });
    });
  }
}

TYPED_TEST(EveryBlit, NoClipChangesAPixelNorDoesWhatLiesAroundTheSource) {
  using F = TypeParam;
  oracle::Random random(92);
  int shown = 0;
  for (int i = 0; i < 60; ++i)
    tests::with_each_blit(random, {width, height}, {columns, rows}, [&](const auto draw) {
      const Rect part{random.between(0, 4), random.between(0, 4), columns, rows};
      Packed from = tests::packed_rows<F>(columns + 5, rows + 5);
      Packed around = from;
      from.randomize(random);
      around.randomize(random);
      for (int y = part.y; y < part.bottom(); ++y)
        for (int x = part.x; x < part.right(); ++x) around.set(x, y, from.get(x, y));
      const auto source_in = [&](Packed& memory) {
        return Picture<F>(tests::surface_over<F>(memory, columns + 5, rows + 5).sub(part));
      };
      Packed before = tests::packed_rows<F>(width, height);
      before.randomize(random);
      Packed whole = before;
      ASSERT_TRUE(draw(tests::surface_over<F>(whole, width, height), source_in(from)).ok());
      const Rect clip = tests::random_part(random, width, height);
      Packed clipped = before;
      ASSERT_TRUE(
          draw(tests::surface_over<F>(clipped, width, height), source_in(around), Everything{}, clip).ok());
      Packed expected = before;
      for (int y = clip.y; y < clip.bottom(); ++y)
        for (int x = clip.x; x < clip.right(); ++x) expected.set(x, y, whole.get(x, y));
      ASSERT_EQ(clipped.bytes(), expected.bytes()) << tests::text(clip) << ", " << random.seed_text();
      shown += expected.bytes() != before.bytes() ? 1 : 0;
    });
  EXPECT_GT(shown, 60) << "most of the cases show nothing";
}

/// Two pictures, and whether one of them is still as it was.
class BlitArguments : public testing::Test {
 protected:
  using Indexed2 = image::Indexed2;

  BlitArguments() {
    oracle::Random random(93);
    to_.randomize(random);
    from_.randomize(random);
    before_ = to_.bytes();
  }
  ~BlitArguments() override { EXPECT_EQ(to_.bytes(), before_) << "drawn all the same"; }

  Surface<Indexed2> target() { return tests::surface_over<Indexed2>(to_, width, height); }
  Surface<Indexed2> source() { return tests::surface_over<Indexed2>(from_, columns, rows); }

  static constexpr int int_min = std::numeric_limits<int>::min();
  static constexpr int int_max = std::numeric_limits<int>::max();

 private:
  Packed to_ = tests::packed_rows<Indexed2>(width, height);
  Packed from_ = tests::packed_rows<Indexed2>(columns, rows);
  std::vector<std::uint8_t> before_;
};

TEST_F(BlitArguments, BadClipsAndRulesAreNamedAndEmptyViewsDrawNothing) {
  using image::Indexed8;
  oracle::Random random(94);
  Packed deep = tests::packed_rows<Indexed8>(columns, rows);
  std::array<std::uint8_t, 256> table{};
  const auto first = [&](std::size_t entries) { return std::span<const std::uint8_t>(table).first(entries); };
  tests::with_each_blit(random, {width, height}, {columns, rows}, [&](const auto draw) {
    for (const Rect& clip : {Rect{limit + 1, 0, 1, 1}, Rect{0, 0, int_max, 1}, Rect{0, 0, 1, int_min}})
      EXPECT_EQ(draw(target(), source(), Everything{}, clip),
                (Status{Error::out_of_domain, Argument::rectangle}));
    EXPECT_EQ(draw(target(), source(), ColourKey{4}), (Status{Error::out_of_range, Argument::colour, 3}));
    EXPECT_EQ(draw(target(), source(), KeyedRemap{4, table}),
              (Status{Error::out_of_range, Argument::colour, 3}));
    EXPECT_EQ(draw(target(), source(), Remap{first(3)}), (Status{Error::too_small, Argument::table, 4}));
    EXPECT_EQ(draw(target(), source(), KeyedRemap{1, first(3)}),
              (Status{Error::too_small, Argument::table, 4}));
    EXPECT_EQ(draw(target(), tests::surface_over<Indexed8>(deep, columns, rows), Remap{first(255)}),
              (Status{Error::too_small, Argument::table, 256}));
    table[3] = 4;
    EXPECT_EQ(draw(target(), source(), Remap{table}), (Status{Error::out_of_range, Argument::table, 3}));
    table[3] = 0;
    EXPECT_TRUE(draw(target(), Picture<Indexed2>{}).ok());
    EXPECT_TRUE(draw(Surface<Indexed2>{}, source()).ok());
    EXPECT_TRUE(draw(target(), source(), Everything{}, Rect{3, 3, 0, 5}).ok());
  });
}

TEST_F(BlitArguments, PlacesOutsideTheDomainAreNamed) {
  const Status position{Error::out_of_domain, Argument::position};
  for (const Point p : {Point{limit + 1, 0}, Point{0, -limit - 1}, Point{int_min, int_max}}) {
    EXPECT_EQ(image::blit(target(), p, source()), position);
    EXPECT_EQ(image::blit_scaled(target(), {p.x, p.y, 9, 9}, source()), position);
  }
  for (const Size size : {Size{2 * limit + 1, 1}, Size{1, int_max}, Size{int_min, 1}})
    EXPECT_EQ(image::blit_scaled(target(), {0, 0, size.width, size.height}, source()),
              (Status{Error::out_of_domain, Argument::size}));
  for (const Rect& none : {Rect{0, 0, 0, 9}, Rect{0, 0, 9, -1}, Rect{width, 0, 9, 9}, Rect{0, -9, 9, 9}})
    EXPECT_TRUE(image::blit_scaled(target(), none, source()).ok());
}

TEST_F(BlitArguments, OfTurnedPicturesAreNamed) {
  Packed wide = tests::packed_rows<Indexed2>((1 << 16) + 1, 1);
  const auto turned = [&](SubPoint position, SubPoint pivot, const Picture<Indexed2>& picture,
                          Status expected) {
    EXPECT_EQ(image::blit_rotozoom(target(), {position, pivot}, picture), expected);
    EXPECT_EQ(image::blit_three_shear(target(), {position, pivot}, picture), expected);
  };
  constexpr int far = 256 * limit;
  for (const SubPoint place : {SubPoint{far + 1, 0}, SubPoint{0, -far - 1}, SubPoint{int_min, int_max}}) {
    turned(place, {}, source(), {Error::out_of_domain, Argument::position});
    turned({}, place, source(), {Error::out_of_domain, Argument::point});
  }
  turned({}, {}, tests::surface_over<Indexed2>(wide, (1 << 16) + 1, 1),
         {Error::too_large, Argument::source, 1U << 16U});
  turned({}, {}, target(), {Error::mismatched, Argument::source});
  for (const int scale : {0, -65536, (1 << 8) - 1, (1 << 24) + 1, int_min, int_max})
    EXPECT_EQ(image::blit_rotozoom(target(), {.scale = number::Fixed<16>::from_raw(scale)}, source()),
              (Status{Error::out_of_range, Argument::size}));
}

TEST(TurnedBlit, TakesASourceInTheFrameThatTheClipKeepsApart) {
  Packed memory = tests::packed_rows<image::Indexed2>(width, height);
  const auto frame = tests::surface_over<image::Indexed2>(memory, width, height);
  const Rect below{0, 3, width, height};
  EXPECT_TRUE(image::blit_rotozoom(frame, {}, frame.sub({0, 0, width, 3}), Everything{}, below).ok());
  EXPECT_TRUE(image::blit_three_shear(frame, {}, frame.sub({0, 0, width, 3}), Everything{}, below).ok());
}

}  // namespace
