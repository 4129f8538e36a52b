// SPDX-License-Identifier: MIT
//
// Inputs that broke other libraries' surfaces, blits and colour arithmetic. Expectations are computed bit by
// bit.
#include <intaglio/image/blit.hpp>
#include <intaglio/image/ramp.hpp>
#include <intaglio/image/rotozoom.hpp>
#include <intaglio/image/scale.hpp>
#include <intaglio/image/surface.hpp>
#include <intaglio/raster/round_rect.hpp>
#include <intaglio/raster/solid.hpp>
#include <intaglio/text/draw_text.hpp>
#include <tests/oracle/circle.hpp>
#include <tests/oracle/packed.hpp>
#include <tests/oracle/recording_sink.hpp>
#include <tests/text/test_font.hpp>

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

// LovyanGFX #454: a picture of 4 bits, turned or scaled, vanished where it began left of the screen.
TEST(HardImages, LovyanIssue454TurnedPicturesAtNegativeColumns) {
  oracle::Random random(454);
  Packed sprite(4, true, 8, 16);
  sprite.randomize(random);
  const auto source = over<Indexed4>(sprite, 16, 16);
  for (int degrees = 0; degrees < 360; degrees += 15) {
    // The same picture on a larger screen whose columns and rows begin further out.
    Packed large(4, true, 32, 64);
    Packed small(4, true, 16, 32);
    intaglio::image::Rotozoom placement{{256 * 35, 256 * 36},
                                        {128 * 15, 128 * 15},
                                        intaglio::number::Angle::from_degrees(degrees),
                                        intaglio::number::Fixed<16>::from_raw(98304)};
    ASSERT_TRUE(blit_rotozoom(over<Indexed4>(large, 64, 64), placement, source).ok());
    placement.position = {256 * 3, 256 * 4};
    ASSERT_TRUE(blit_rotozoom(over<Indexed4>(small, 32, 32), placement, source).ok());
    int shown = 0;
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < 32; ++x) {
        ASSERT_EQ(small.get(x, y), large.get(x + 32, y + 32)) << degrees << ": " << x << ' ' << y;
        shown += small.get(x, y) != 0 ? 1 : 0;
      }
    EXPECT_GT(shown, 100) << degrees;
  }
}

// Arduino_GFX PR #807: a cursor at (-3, -2) wrote before the first row.
TEST(HardImages, ArduinoGfxPull807TextAtNegativePlaces) {
  oracle::RecordingSink large({-40, -40, 120, 80});
  oracle::RecordingSink screen({0, 0, 40, 20});
  ASSERT_TRUE(intaglio::text::draw_text(large, test_font::font, {-3, -2}, "CAC\nAC?").ok());
  ASSERT_TRUE(intaglio::text::draw_text(screen, test_font::font, {-3, -2}, "CAC\nAC?").ok());
  EXPECT_EQ(screen.violation(), "");
  EXPECT_GT(large.touched(), screen.touched());
  EXPECT_GT(screen.touched(), 30);
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 40; ++x) ASSERT_EQ(screen.writes(x, y), large.writes(x, y)) << x << ' ' << y;
}

// Slint PR #4571: at 400.499999 and a scale of 1.5 the left and the right edge were rounded differently. The
// parts of a picture meet without gap or overlap wherever it lies, and are the whole one.
TEST(HardImages, SlintPull4571EdgesAtHalfPixelsAndScaleOneAndAHalf) {
  Packed memory(4, true, 20, 6);
  oracle::Random random(4571);
  memory.randomize(random);
  for (int y = 0; y < 6; ++y)
    for (int x = 0; x < 40; ++x) memory.set(x, y, memory.get(x, y) | 1U);
  const auto source = over<Indexed4>(memory, 40, 6);
  for (int place = 256 * 400; place <= 256 * 401; place += 8)
    for (const int seam : {1, 17, 20, 39}) {
      const intaglio::image::Rotozoom whole{
          {place, place - 256 * 395}, {}, {}, intaglio::number::Fixed<16>::from_raw(98304)};
      intaglio::image::Rotozoom right = whole;
      right.pivot.x = -256 * seam;
      const auto drawn = [](const auto& picture, const intaglio::image::Rotozoom& placement) {
        Packed screen(4, true, 240, 20);
        EXPECT_TRUE(blit_rotozoom(over<Indexed4>(screen, 480, 20), placement, picture).ok());
        return screen;
      };
      const Packed all = drawn(source, whole);
      const Packed first = drawn(source.sub({0, 0, seam, 6}), whole);
      const Packed second = drawn(source.sub({seam, 0, 40 - seam, 6}), right);
      int shown = 0;
      int wrong = 0;
      for (int y = 0; y < 20; ++y)
        for (int x = 390; x < 480; ++x) {
          shown += all.get(x, y) != 0 ? 1 : 0;
          wrong += first.get(x, y) != 0 && second.get(x, y) != 0 ? 1 : 0;
          wrong += (first.get(x, y) | second.get(x, y)) != all.get(x, y) ? 1 : 0;
        }
      ASSERT_GE(shown, 59 * 8) << place;
      ASSERT_LE(shown, 61 * 10) << place;
      ASSERT_EQ(wrong, 0) << place << ' ' << seam;
    }
}

// Slint #9136: a very large picture. The last of 2^21 columns shows the last of 2^20, and a picture too large
// for 16.16 is refused.
TEST(HardImages, SlintIssue9136VeryLargePictures) {
  constexpr int columns = 1 << 20;
  Packed memory(1, true, columns / 8, 1);
  memory.set(columns - 1, 0, 1);
  const auto source = over<intaglio::image::Indexed1>(memory, columns, 1);
  Packed screen(8, true, 9, 1);
  const auto target = over<Indexed8>(screen, 9, 1);
  ASSERT_TRUE(blit_scaled(target, {7 - 2 * columns, 0, 2 * columns, 1}, source).error() ==
              intaglio::Error::out_of_domain);
  ASSERT_TRUE(blit_scaled(target, {7 - columns, 0, columns, 1}, source).ok());
  EXPECT_EQ(screen.bytes(), (std::vector<std::uint8_t>{0, 0, 0, 0, 0, 0, 1, 0, 0}));
  EXPECT_EQ(blit_rotozoom(target, {}, source).error(), intaglio::Error::too_large);
}

// LVGL's radius mask on an object of 2560 x 2560: squares beyond 16 bits. As a mask of one bit it lets the
// same pixels of any picture through.
TEST(HardImages, LvglRadiusMaskOf2560Pixels) {
  constexpr int side = 2560;
  constexpr int radius = 1279;  // what half of the side leaves room for
  using intaglio::image::Indexed1;
  Packed memory(1, true, side / 8, side);
  const auto mask = over<Indexed1>(memory, side, side);
  const intaglio::raster::Solid ink(mask, 1);
  ASSERT_TRUE(fill_round_rect(ink, {0, 0, side, side}, intaglio::raster::CornerRadii::all(side)).ok());
  int wrong = 0;
  for (int y = 0; y < side; ++y) {
    const int dy = y < radius ? radius - y : y > radius + 1 ? y - radius - 1 : 0;
    const int reach = oracle::outline_reach(radius, dy);
    for (int x = 0; x < side; ++x) {
      const int dx = x < radius ? radius - x : x > radius + 1 ? x - radius - 1 : 0;
      wrong += (mask.get(x, y) != 0) == (dx <= reach) ? 0 : 1;
    }
  }
  EXPECT_EQ(wrong, 0);

  Packed full(1, true, side / 8, side);
  for (std::uint8_t& byte : full.bytes()) byte = 255;
  Packed screen(8, true, 320, 240);
  for (const int corner : {0, -375, -1000, -2300}) {
    for (std::uint8_t& byte : screen.bytes()) byte = 0;
    ASSERT_TRUE(blit(over<Indexed8>(screen, 320, 240), {corner, corner}, over<Indexed1>(full, side, side),
                     intaglio::image::Masked{mask})
                    .ok());
    for (int y = 0; y < 240; ++y)
      for (int x = 0; x < 320; ++x) {
        const bool on = x - corner < side && y - corner < side && mask.get(x - corner, y - corner) != 0;
        ASSERT_EQ(screen.get(x, y), on ? 1U : 0U) << corner << ": " << x << ' ' << y;
      }
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
