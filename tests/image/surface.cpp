// SPDX-License-Identifier: MIT
#include <intaglio/image/surface.hpp>
#include <tests/image/formats.hpp>

#include <limits>

namespace {

using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::image::Picture;
using intaglio::image::Surface;
using intaglio::linear::Rect;
using intaglio::linear::Size;
using oracle::Packed;
using tests::packed_rows;
using tests::surface_over;

constexpr int int_min = std::numeric_limits<int>::min();
constexpr int int_max = std::numeric_limits<int>::max();
constexpr int limit = 1 << 20;

template <class F>
class SurfaceOf : public testing::Test {};
TYPED_TEST_SUITE(SurfaceOf, tests::AllFormats);

TYPED_TEST(SurfaceOf, PixelsLieWhereTheFormatSaysForEveryWidthAndStride) {
  oracle::Random random(11);
  for (int width = 1; width <= 19; ++width)
    for (const int extra : {0, 1, 5}) {
      Packed memory = packed_rows<TypeParam>(width, 3, extra);
      memory.randomize(random);
      const Surface<TypeParam> surface = surface_over<TypeParam>(memory, width, 3);
      const Picture<TypeParam> picture = surface;
      for (int y = 0; y < 3; ++y)
        for (int x = 0; x < width; ++x) {
          ASSERT_EQ(surface.get(x, y), memory.get(x, y)) << width << ' ' << x << ' ' << y;
          ASSERT_EQ(picture.get(x, y), memory.get(x, y));
          Packed expected = memory;
          const auto index = static_cast<unsigned>(random.bits()) & TypeParam::max_index;
          expected.set(x, y, index);
          surface.set(x, y, index);
          ASSERT_EQ(memory.bytes(), expected.bytes()) << width << ' ' << x << ' ' << y << ' ' << index;
        }
    }
}

TYPED_TEST(SurfaceOf, OnlyTheLowBitsOfAnIndexAreWritten) {
  Packed memory = packed_rows<TypeParam>(9, 1);
  const Surface<TypeParam> surface = surface_over<TypeParam>(memory, 9, 1);
  surface.set(4, 0, TypeParam::max_index + 1U);
  EXPECT_EQ(memory.bytes(), packed_rows<TypeParam>(9, 1).bytes());
}

TYPED_TEST(SurfaceOf, BandsKeepTheFramesCoordinates) {
  oracle::Random random(12);
  for (const int x : {0, 1, 3, 8, -1, -13, limit - 40, -limit})
    for (const int y : {0, 5, -7, limit - 40, -limit}) {
      Packed memory = packed_rows<TypeParam>(11, 4, 2);
      memory.randomize(random);
      const auto band = Surface<TypeParam>::over_band(memory.bytes(), {x, y, 11, 4}, memory.stride());
      ASSERT_TRUE(band.ok());
      ASSERT_EQ(band.value().bounds(), (Rect{x, y, 11, 4}));
      for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 11; ++column)
          ASSERT_EQ(band.value().get(x + column, y + row), memory.get(column, row)) << x << ' ' << y;
    }
}

TYPED_TEST(SurfaceOf, EverySubSurfaceIsAPartOfItsParentAndSoAreItsOwnParts) {
  oracle::Random random(13);
  Packed memory = packed_rows<TypeParam>(19, 4, 1);
  memory.randomize(random);
  const Surface<TypeParam> surface = surface_over<TypeParam>(memory, 19, 4);
  for (int x = 0; x < 19; ++x)
    for (int width = 1; x + width <= 19; ++width) {
      const auto part = surface.sub({x, 1, width, 3});
      ASSERT_EQ(part.bounds(), (Rect{0, 0, width, 3}));
      for (int column = 0; column < width; ++column)
        ASSERT_EQ(part.get(column, 2), memory.get(x + column, 3)) << x << ' ' << width;
      for (int inner = 0; inner < width; ++inner) {
        const auto part_of_part = part.sub({inner, 1, width, 9});
        ASSERT_EQ(part_of_part.bounds(), (Rect{0, 0, width - inner, 2}));
        ASSERT_EQ(part_of_part.get(0, 0), memory.get(x + inner, 2)) << x << ' ' << width << ' ' << inner;
      }
    }
}

TYPED_TEST(SurfaceOf, PartsOfBandsUseTheBandsCoordinates) {
  oracle::Random random(14);
  for (const int x0 : {-5, 0, 3}) {
    Packed memory = packed_rows<TypeParam>(17, 3);
    memory.randomize(random);
    const auto band = Surface<TypeParam>::over_band(memory.bytes(), {x0, 100, 17, 3});
    ASSERT_TRUE(band.ok());
    for (int x = 0; x < 17; ++x) {
      const auto part = band.value().sub({x0 + x, 101, 4, 1});
      ASSERT_EQ(part.get(0, 0), memory.get(x, 1));
    }
  }
}

TYPED_TEST(SurfaceOf, SubSurfacesAreCutToTheBoundsAndEmptyOutsideThem) {
  Packed memory = packed_rows<TypeParam>(10, 4);
  const Surface<TypeParam> surface = surface_over<TypeParam>(memory, 10, 4);
  EXPECT_EQ(surface.sub({-3, -1, 5, 100}).bounds(), (Rect{0, 0, 2, 4}));
  EXPECT_EQ(surface.sub({8, 3, 5, 5}).bounds(), (Rect{0, 0, 2, 1}));
  for (const Rect& outside : {Rect{10, 0, 5, 5}, Rect{0, 4, 5, 5}, Rect{-5, 0, 5, 5}, Rect{0, -5, 5, 5},
                              Rect{2, 2, 0, 1}, Rect{2, 2, 1, -1}, Rect{int_min, int_min, int_max, int_max},
                              Rect{int_max, 0, int_max, 1}, Rect{0, 0, int_min, int_min}})
    EXPECT_TRUE(surface.sub(outside).empty());
  EXPECT_TRUE(Surface<TypeParam>{}.sub({0, 0, 1, 1}).empty());
}

TYPED_TEST(SurfaceOf, BadSizesAreNamed) {
  std::vector<std::uint8_t> memory(64);
  for (const Size size : {Size{0, 1}, Size{1, 0}, Size{-1, 1}, Size{1, -1}, Size{int_min, int_min}})
    EXPECT_EQ(Surface<TypeParam>::over(memory, size).status(), (Status{Error::empty, Argument::size}));
  for (const Size size : {Size{limit + 1, 1}, Size{1, limit + 1}, Size{int_max, int_max}})
    EXPECT_EQ(Surface<TypeParam>::over(memory, size).status(),
              (Status{Error::too_large, Argument::size, limit}));
}

TYPED_TEST(SurfaceOf, BadStridesAreNamedWithTheLeastThatWouldDo) {
  std::vector<std::uint8_t> memory(64);
  const int least = (13 * TypeParam::bits + 7) / 8;
  for (const int stride : {least - 1, 1, -1, -least, int_min}) {
    if (stride == least || stride == 0) continue;
    EXPECT_EQ(Surface<TypeParam>::over(memory, {13, 2}, stride).status(),
              (Status{Error::too_small, Argument::stride, static_cast<std::uint32_t>(least)}))
        << stride;
  }
  EXPECT_EQ(Surface<TypeParam>::over(memory, {13, 2}, int_max).status(),
            (Status{Error::too_large, Argument::stride}));
  EXPECT_EQ(Surface<TypeParam>::over_band(memory, {0, limit - 2, 13, 2}, 1024).status(),
            (Status{Error::too_large, Argument::stride}));
}

TYPED_TEST(SurfaceOf, ShortBuffersAreNamedWithTheLengthThatWouldDo) {
  // The last row needs only its own bytes, not a whole stride.
  const int least = (13 * TypeParam::bits + 7) / 8;
  const auto needed = static_cast<std::uint32_t>(2 * (least + 3) + least);
  std::vector<std::uint8_t> memory(needed);
  EXPECT_TRUE(Surface<TypeParam>::over(memory, {13, 3}, least + 3).ok());
  EXPECT_TRUE(Picture<TypeParam>::over(memory, {13, 3}, least + 3).ok());
  const Status expected{Error::too_small, Argument::buffer, needed};
  EXPECT_EQ(Surface<TypeParam>::over(std::span(memory).first(needed - 1), {13, 3}, least + 3).status(),
            expected);
  EXPECT_EQ(Surface<TypeParam>::over({}, {13, 3}, least + 3).status(), expected);
  EXPECT_TRUE(Surface<TypeParam>::over({}, {13, 3}).value().empty());
}

TYPED_TEST(SurfaceOf, BandsOutsideTheDomainAreNamed) {
  std::vector<std::uint8_t> memory(1024);
  const Status expected{Error::out_of_domain, Argument::rectangle};
  for (const Rect& band : {Rect{limit + 1, 0, 4, 4}, Rect{0, -limit - 1, 4, 4}, Rect{limit - 3, 0, 4, 4},
                           Rect{0, limit - 3, 4, 4}, Rect{int_max, int_max, 4, 4}, Rect{int_min, 0, 4, 4}})
    EXPECT_EQ(Surface<TypeParam>::over_band(memory, band).status(), expected) << band.x << ' ' << band.y;
  EXPECT_TRUE(Surface<TypeParam>::over_band(memory, {limit - 4, limit - 4, 4, 4}).ok());
}

}  // namespace
