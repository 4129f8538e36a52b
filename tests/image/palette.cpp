// SPDX-License-Identifier: MIT
#include <intaglio/image/palette.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace {

using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::image::Palette;
using intaglio::image::Rgb;

template <class P>
class PaletteOf : public testing::Test {};
using Palettes = testing::Types<Palette<2>, Palette<3>, Palette<16>, Palette<255>, Palette<256>>;
TYPED_TEST_SUITE(PaletteOf, Palettes);

Rgb colour_of(int index) {
  return {static_cast<std::uint8_t>(index), static_cast<std::uint8_t>(index * 7),
          static_cast<std::uint8_t>(255 - index)};
}

TYPED_TEST(PaletteOf, StartsBlackAndHoldsWhatWasSet) {
  TypeParam palette;
  constexpr int size = TypeParam::size();
  for (int i = 0; i < size; ++i) EXPECT_EQ(palette.get(i), Rgb{});
  for (int i = 0; i < size; ++i) ASSERT_TRUE(palette.set(i, colour_of(i)).ok());
  ASSERT_EQ(palette.bytes().size(), static_cast<std::size_t>(size) * 3U);
  for (int i = 0; i < size; ++i) {
    EXPECT_EQ(palette.get(i), colour_of(i));
    const auto bytes = palette.bytes().subspan(static_cast<std::size_t>(i) * 3U, 3);
    EXPECT_EQ((Rgb{bytes[0], bytes[1], bytes[2]}), colour_of(i));
  }
}

TYPED_TEST(PaletteOf, IndicesOutsideAreNamedAndChangeNothing) {
  TypeParam palette;
  for (const int index :
       {-1, TypeParam::size(), std::numeric_limits<int>::max(), std::numeric_limits<int>::min()}) {
    EXPECT_EQ(palette.set(index, {1, 2, 3}), (Status{Error::out_of_range, Argument::index}));
    EXPECT_EQ(palette.set_from(index, {}), (Status{Error::out_of_range, Argument::index}));
    EXPECT_EQ(palette.get(index), Rgb{});
  }
  EXPECT_EQ(palette, TypeParam{});
}

TYPED_TEST(PaletteOf, RunsOfColoursFitOrAreRefusedWhole) {
  constexpr int size = TypeParam::size();
  TypeParam palette;
  std::vector<Rgb> colours(static_cast<std::size_t>(size));
  for (int i = 0; i < size; ++i) colours[static_cast<std::size_t>(i)] = colour_of(i);
  EXPECT_EQ(palette.set_from(1, colours),
            (Status{Error::too_large, Argument::palette, static_cast<std::uint32_t>(size - 1)}));
  EXPECT_EQ(palette, TypeParam{});
  ASSERT_TRUE(palette.set_from(0, colours).ok());
  for (int i = 0; i < size; ++i) EXPECT_EQ(palette.get(i), colour_of(i));
}

TEST(Palette, CanBeAConstantAndFillsUpWithBlack) {
  static constexpr Palette<4> palette({{1, 2, 3}, {4, 5, 6}});
  static_assert(palette.get(1) == Rgb{4, 5, 6});
  static_assert(palette.get(3) == Rgb{});
  EXPECT_EQ(palette.bytes().size(), 12U);
}

}  // namespace
