// SPDX-License-Identifier: MIT
//
// Inputs that broke other libraries' surfaces, blits and colour arithmetic. Expectations are computed bit by
// bit.
#include <intaglio/image/blit.hpp>
#include <intaglio/image/ramp.hpp>
#include <intaglio/image/surface.hpp>
#include <tests/oracle/packed.hpp>

#include <gtest/gtest.h>

namespace {

using intaglio::image::blit;
using intaglio::image::ColourKey;
using intaglio::image::Indexed4;
using intaglio::image::Indexed4Lsb;
using intaglio::image::Indexed8;
using intaglio::image::mix;
using intaglio::image::PixelFormat;
using intaglio::image::Rgb;
using intaglio::image::Surface;
using oracle::Packed;

template <PixelFormat F>
Surface<F> over(Packed& memory, int width, int height) {
  const auto surface = Surface<F>::over(memory.bytes(), {width, height}, memory.stride());
  EXPECT_TRUE(surface.ok());
  return surface.value();
}

// Pimoroni PR #516: on a panel 135 pixels wide the nibble was chosen from x alone, as if rows were joined.
template <PixelFormat F>
void expect_every_nibble_at_135x240(bool high_nibble_first) {
  Packed memory(4, high_nibble_first, 68, 240);
  Packed expected = memory;
  const Surface<F> surface = over<F>(memory, 135, 240);
  for (int y = 0; y < 240; ++y)
    for (int x = 0; x < 135; ++x) {
      const auto index = static_cast<unsigned>(x * 7 + y * 3) & 15U;
      surface.set(x, y, index);
      expected.set(x, y, index);
    }
  EXPECT_EQ(memory.bytes(), expected.bytes());
}
TEST(HardImages, PimoroniPull516NibblesOfAnOddWidth) {
  expect_every_nibble_at_135x240<Indexed4>(true);
  expect_every_nibble_at_135x240<Indexed4Lsb>(false);
}

// LovyanGFX #454, Arduino_GFX PR #807: sprites pushed at negative columns vanished or wrote before the row.
TEST(HardImages, LovyanIssue454SpritesAtNegativeColumns) {
  for (int x = -16; x <= 0; ++x) {
    oracle::Random random(static_cast<std::uint32_t>(100 + x));
    Packed sprite(4, true, 8, 9);
    sprite.randomize(random);
    Packed screen(4, true, 16, 12);
    Packed expected = screen;
    for (int row = 2; row < 9; ++row)
      for (int column = -x; column < 16; ++column) expected.set(x + column, row - 2, sprite.get(column, row));
    ASSERT_TRUE(blit(over<Indexed4>(screen, 32, 12), {x, -2}, over<Indexed4>(sprite, 16, 9)).ok());
    ASSERT_EQ(screen.bytes(), expected.bytes()) << x;
  }
}

// Adafruit #325: y * width beyond 32767 in 16 bits. The last pixel of a large picture is where it should be.
TEST(HardImages, AdafruitIssue325IndicesBeyond16Bits) {
  Packed from(8, true, 300, 300);
  from.set(299, 299, 77);
  Packed to(8, true, 300, 300);
  ASSERT_TRUE(blit(over<Indexed8>(to, 300, 300), {0, 0}, over<Indexed8>(from, 300, 300), ColourKey{0}).ok());
  EXPECT_EQ(to.bytes(), from.bytes());
}

// PicoGraphics RGB::blend, SDL #15882 and others: rounding down each time darkens; a colour mixed with itself
// must stay itself, and full parts must be the full colour.
TEST(HardImages, BlendsDoNotDarken) {
  for (int level = 0; level < 256; ++level) {
    const auto code = static_cast<std::uint8_t>(level);
    const Rgb grey{code, code, code};
    for (int part = 0; part <= 255; ++part)
      ASSERT_EQ(mix(grey, grey, part, 255), grey) << level << ' ' << part;
    ASSERT_EQ(mix({}, grey, 255, 255), grey) << level;
    ASSERT_EQ(mix(grey, {}, 0, 255), grey) << level;
  }
}

}  // namespace
