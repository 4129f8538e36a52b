// SPDX-License-Identifier: MIT
//
// Masks, in every kind of blit: a target pixel shows what it shows without the mask if the mask is set where
// it comes from, and else stays as it is. Which pixel it comes from is learnt from a source whose pixels all
// have their own index.
#include <tests/image/every_blit.hpp>
#include <tests/image/pictures.hpp>

namespace {

using namespace intaglio;
using image::blit;
using image::blit_rotozoom;
using image::blit_scaled;
using image::blit_three_shear;
using image::ColourKey;
using image::Indexed1;
using image::Indexed1Lsb;
using image::Indexed2;
using image::Indexed4;
using image::Indexed8;
using image::Masked;
using image::Picture;
using image::Surface;
using oracle::Packed;

constexpr int width = 31;
constexpr int height = 23;
constexpr int columns = 17;
constexpr int rows = 15;

template <class M>
void expect_masks_hide(std::uint32_t seed) {
  oracle::Random random(seed);
  Packed named = tests::packed_rows<Indexed8>(columns, rows);
  for (int i = 0; i < columns * rows; ++i) named.set(i % columns, i / columns, static_cast<unsigned>(i) + 1);
  const Picture<Indexed8> names = tests::surface_over<Indexed8>(named, columns, rows);
  Packed from = tests::packed_rows<Indexed8>(columns, rows);
  Packed mask = tests::packed_rows<M>(columns + 3, rows + 2, 1);
  Packed from_map = tests::packed_rows<Indexed8>(width, height);
  Packed to = from_map;
  for (int i = 0; i < 200; ++i) {
    from.randomize(random);
    mask.randomize(random);
    // Half of them with bytes that hide or show all their pixels.
    for (std::uint8_t& byte : mask.bytes())
      if (i % 2 == 0 && byte < 200) byte = byte < 100 ? 0 : 255;
    const Picture<Indexed8> source = tests::surface_over<Indexed8>(from, columns, rows);
    // A part of a larger picture, so that its corner isn't that of a byte.
    const Picture<M> cut = tests::surface_over<M>(mask, columns + 3, rows + 2).sub({3, 2, columns, rows});
    const auto key = static_cast<unsigned>(random.between(0, 255));
    tests::with_each_blit(random, {width, height}, {columns, rows}, [&](auto draw) {
      from_map = tests::packed_rows<Indexed8>(width, height);
      to.randomize(random);
      Packed expected = to;
      ASSERT_TRUE(
          draw(tests::surface_over<Indexed8>(from_map, width, height), names, image::Everything{}).ok());
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
          const int name = static_cast<int>(from_map.get(x, y)) - 1;
          if (name < 0 || mask.get(name % columns + 3, name / columns + 2) == 0) continue;
          const unsigned index = from.get(name % columns, name / columns);
          if (index != key) expected.set(x, y, index);
        }
      const Surface<Indexed8> target = tests::surface_over<Indexed8>(to, width, height);
      ASSERT_TRUE(draw(target, source, Masked{cut, ColourKey{key}}).ok());
      ASSERT_EQ(to.bytes(), expected.bytes()) << random.seed_text();
    });
  }
}

TEST(Mask, HidesWhatItHidesInEveryBlit) {
  expect_masks_hide<Indexed1>(81);
  expect_masks_hide<Indexed1Lsb>(82);
  expect_masks_hide<Indexed4>(83);
}

TEST(Mask, MustBeAsLargeAsTheSourceAndApartFromTheTarget) {
  oracle::Random random(84);
  Packed from = tests::packed_rows<Indexed8>(columns, rows);
  Packed mask = tests::packed_rows<Indexed1>(columns, rows);
  Packed to = tests::packed_rows<Indexed8>(width, height);
  to.randomize(random);
  const Packed before = to;
  const auto source = tests::surface_over<Indexed8>(from, columns, rows);
  const auto whole = tests::surface_over<Indexed1>(mask, columns, rows);
  const auto target = tests::surface_over<Indexed8>(to, width, height);
  const auto within = Picture<Indexed1>::over(to.bytes(), {columns, rows});
  ASSERT_TRUE(within.ok());
  const Status wrong{Error::mismatched, Argument::mask};
  for (int i = 0; i < 50; ++i) {
    const int less = random.between(1, 4);
    tests::with_each_blit(random, {width, height}, {columns, rows}, [&](auto draw) {
      EXPECT_EQ(draw(target, source, Masked{whole.sub({0, 0, columns - less, rows})}), wrong);
      EXPECT_EQ(draw(target, source, Masked{whole.sub({0, 0, columns, rows - less})}), wrong);
      EXPECT_EQ(draw(target, source.sub({1, 1, columns, rows}), Masked{whole}), wrong);
    });
  }
  const Masked overlapping{within.value()};
  EXPECT_EQ(blit(target, {0, 0}, source, overlapping), wrong);
  EXPECT_EQ(blit_scaled(target, {0, 0, 5, 5}, source, overlapping), wrong);
  EXPECT_EQ(blit_rotozoom(target, {}, source, overlapping), wrong);
  EXPECT_EQ(blit_three_shear(target, {}, source, overlapping), wrong);
  EXPECT_EQ(to.bytes(), before.bytes());
}

}  // namespace
