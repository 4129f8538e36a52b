// SPDX-License-Identifier: MIT
#include <intaglio/image/digest.hpp>
#include <tests/image/formats.hpp>
#include <tests/oracle/crc32.hpp>

namespace {

using intaglio::image::Crc32;
using intaglio::image::digest;
using intaglio::image::FrameDigest;
using intaglio::image::Picture;
using intaglio::image::Surface;
using intaglio::linear::Size;
using oracle::Packed;

TEST(Crc32, HasThePublishedCheckValue) {
  Crc32 crc;
  for (const char c : {'1', '2', '3', '4', '5', '6', '7', '8', '9'}) crc.add(static_cast<std::uint8_t>(c));
  EXPECT_EQ(crc.value(), 0xCBF43926U);
  EXPECT_EQ(oracle::crc32({'1', '2', '3', '4', '5', '6', '7', '8', '9'}), 0xCBF43926U);
  EXPECT_EQ(Crc32{}.value(), 0U);
}

TEST(Crc32, EqualsPolynomialDivisionForRandomBytes) {
  oracle::Random random(31);
  for (int length = 0; length < 300; ++length) {
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(length));
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.bits());
    Crc32 crc;
    crc.add(bytes);
    ASSERT_EQ(crc.value(), oracle::crc32(bytes)) << length;
  }
}

template <class F>
class Digest : public testing::Test {};
TYPED_TEST_SUITE(Digest, tests::AllFormats);

TYPED_TEST(Digest, CountsSizePaletteAndIndicesButNotTheStorage) {
  oracle::Random random(32);
  for (int width = 1; width < 18; ++width) {
    Packed memory = tests::packed_rows<TypeParam>(width, 5, width % 3);
    memory.randomize(random);
    const Surface<TypeParam> surface = tests::surface_over<TypeParam>(memory, width, 5);
    const std::vector<std::uint8_t> palette{1, 2, 3, 250, 251, 252};
    std::vector<std::uint8_t> indices;
    for (int y = 0; y < 5; ++y)
      for (int x = 0; x < width; ++x) indices.push_back(static_cast<std::uint8_t>(memory.get(x, y)));
    const std::uint32_t expected =
        oracle::frame_digest(static_cast<std::uint32_t>(width), 5, palette, indices);
    ASSERT_EQ(digest(surface, palette), expected);
    ASSERT_EQ(digest(Picture<TypeParam>(surface), palette), expected);

    FrameDigest in_bands(Size{width, 5}, palette);
    in_bands.add(surface.sub({0, 0, width, 2}));
    const auto last_rows = Surface<TypeParam>::over_band(
        std::span(memory.bytes()).subspan(static_cast<std::size_t>(memory.stride()) * 2U), {0, 2, width, 3},
        memory.stride());
    ASSERT_TRUE(last_rows.ok());
    in_bands.add(last_rows.value());
    ASSERT_EQ(in_bands.value(), expected);
  }
}

TEST(FrameDigest, OfOnePixelIsAKnownNumber) {
  // CRC-32 of 01 00 00 00  01 00 00 00  10 20 30  01, as zlib computes it.
  std::vector<std::uint8_t> memory{0x80};
  const auto surface = Surface<intaglio::image::Indexed1>::over(memory, {1, 1});
  const std::vector<std::uint8_t> palette{0x10, 0x20, 0x30};
  EXPECT_EQ(digest(surface.value(), palette), 0xECCF9D84U);
}

}  // namespace
