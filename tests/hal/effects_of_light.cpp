// SPDX-License-Identifier: MIT
//
// What a panel does to light: depth, gamma, response, dead pixels, grid, and all of them together; and that
// what isn't declared isn't run.
#include <hal/sim/effects/depth.hpp>
#include <hal/sim/effects/draw.hpp>
#include <hal/sim/effects/gamma.hpp>
#include <hal/sim/effects/glass.hpp>
#include <hal/sim/effects/grid.hpp>
#include <hal/sim/effects/parse.hpp>
#include <hal/sim/effects/power.hpp>
#include <tests/oracle/crc32.hpp>
#include <tests/oracle/panel_effects.hpp>
#include <tests/oracle/random.hpp>
#include <tests/oracle/samples.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using hal::Nanoseconds;
using hal::sim::Effect;
using hal::sim::Effects;
using hal::sim::Glass;
using hal::sim::Panel;
using hal::sim::PanelSpec;
using hal::sim::VirtualClock;
using Bytes = std::vector<std::uint8_t>;

constexpr long double two32 = 4294967296.0L;

TEST(Power, LogarithmsAndPowersKeepTheirBounds) {
  oracle::Random random(51);
  long double log_off = 0;
  long double power_off = 0;
  long double whole_off = 0;
  for (int i = 0; i < oracle::samples(20'000, 5'000'000); ++i) {
    const auto x =
        static_cast<std::uint32_t>(random.bits() >> static_cast<unsigned>(random.between(32, 63))) | 1U;
    log_off = std::max(log_off, std::abs(static_cast<long double>(hal::sim::log2_of(x)) / two32 -
                                         std::log2(static_cast<long double>(x))));
    const std::uint64_t y = random.bits() >> static_cast<unsigned>(random.between(28, 63));
    const long double exact = std::exp2(-static_cast<long double>(y) / two32);
    const long double found = static_cast<long double>(hal::sim::two_to_minus(y)) / two32;
    // Small ones are rounded to 2^-32.
    power_off = std::max(power_off, (std::abs(found - exact) - 0.5L / two32) / exact);
    const auto d = static_cast<std::uint32_t>(random.between(1, 1 << 30));
    const auto n = static_cast<std::uint32_t>(random.between(0, static_cast<int>(d)));
    const int hundredths = random.between(1, 500);
    const long double whole = std::pow(static_cast<long double>(n) / d, hundredths / 100.0L);
    whole_off = std::max(
        whole_off, std::abs(static_cast<long double>(hal::sim::power(n, d, hundredths)) / two32 - whole));
  }
  EXPECT_LT(log_off, std::exp2(-29.0L));
  EXPECT_LT(power_off, std::exp2(-27.0L));
  EXPECT_LT(whole_off, std::exp2(-25.0L));
  EXPECT_EQ(hal::sim::log2_of(1), 0U);
  EXPECT_EQ(hal::sim::log2_of(1U << 31U), std::uint64_t{31} << 32U);
  EXPECT_EQ(hal::sim::two_to_minus(0), std::uint64_t{1} << 32U);
  EXPECT_EQ(hal::sim::two_to_minus(std::uint64_t{1} << 32U), std::uint64_t{1} << 31U);
  EXPECT_EQ(hal::sim::two_to_minus(~std::uint64_t{0}), 0U);
}

TEST(Light, CodesAreDecodedWithinTheBoundAndCodedBack) {
  for (int code = 0; code < 256; ++code) {
    const hal::sim::Light light = hal::sim::decode(static_cast<std::uint8_t>(code));
    const long double exact =
        oracle::srgb_decode(static_cast<long double>(code) / 255) * hal::sim::full_light;
    EXPECT_LE(std::abs(static_cast<long double>(light) - exact), 1.0L) << code;
    EXPECT_EQ(hal::sim::encode(light), code);
  }
  EXPECT_EQ(hal::sim::decode(255), hal::sim::full_light);
  EXPECT_EQ(hal::sim::encode(-1), 0);
  EXPECT_EQ(hal::sim::encode(hal::sim::full_light + 1000), 255);
}

TEST(Light, IsCodedAsTheNearestCode) {
  oracle::Random random(52);
  for (int i = 0; i < oracle::samples(20'000, 2'000'000); ++i) {
    const hal::sim::Light light = random.between(0, hal::sim::full_light) >> random.between(0, 12);
    const long double exact = oracle::code_of(static_cast<long double>(light) / hal::sim::full_light);
    // Half a code, and what a light of 2^-24 more or less makes: nowhere more than 12.92 * 255 codes of it.
    ASSERT_LE(std::abs(hal::sim::encode(light) - exact), 0.5L + 3295.0L / hal::sim::full_light) << light;
  }
}

TEST(DepthEffect, LevelsAreThoseOfTheBitsKept) {
  for (int bits = 1; bits <= 8; ++bits) {
    const int most = (1 << bits) - 1;
    for (int value = 0; value < 256; ++value) {
      const int shown = hal::sim::at_depth(static_cast<std::uint8_t>(value), bits);
      ASSERT_TRUE(oracle::nearest_quotient(oracle::Wide{255} * (value / (1 << (8 - bits))), most) == shown);
      ASSERT_EQ(hal::sim::at_depth(static_cast<std::uint8_t>(shown), bits), shown) << "twice is once";
    }
    EXPECT_EQ(hal::sim::at_depth(0, bits), 0);
    EXPECT_EQ(hal::sim::at_depth(255, bits), 255);
  }
}

TEST(GammaEffect, MakesTheLightOfTheFormula) {
  for (const int hundredths : {50, 100, 180, 220, 240, 500}) {
    for (int value = 0; value < 256; ++value) {
      const long double light = std::pow(static_cast<long double>(value) / 255, hundredths / 100.0L);
      const int shown = hal::sim::with_gamma(static_cast<std::uint8_t>(value), {hundredths});
      ASSERT_LE(std::abs(shown - oracle::code_of(light)), 0.501L) << value << ' ' << hundredths;
    }
    EXPECT_EQ(hal::sim::with_gamma(0, {hundredths}), 0);
    EXPECT_EQ(hal::sim::with_gamma(255, {hundredths}), 255);
  }
}

TEST(ResponseEffect, WhatIsLeftAfterAFrameIsThatOfTheFormula) {
  for (const Nanoseconds response :
       {1U, 1'000U, 1'000'000U, 8'000'000U, 16'666'667U, 100'000'000U, 500'000'000U})
    for (const Nanoseconds frame : {1'000'000U, 8'333'333U, 16'666'667U, 33'333'333U, 1'000'000'000U}) {
      const long double exact =
          oracle::left_after(static_cast<long double>(frame), static_cast<long double>(response));
      const auto found = static_cast<long double>(hal::sim::left_after(frame, response)) / 2147483648.0L;
      EXPECT_LE(std::abs(found - exact), std::exp2(-26.0L)) << frame << ' ' << response;
    }
  EXPECT_EQ(hal::sim::left_after(1, 0), 0);
}

/// A panel of one row of paletted pixels whose index i is grey i.
struct Greys {
  explicit Greys(const Effects& effects, int width = 1)
      : panel(hal::sim::paletted(width, 1, 8, 1), clock, effects), glass(panel, effects) {
    Bytes palette;
    for (int i = 0; i < 256; ++i) palette.insert(palette.end(), 3, static_cast<std::uint8_t>(i));
    panel.load_palette(palette).ignore();
    panel.wait_for_vblank().ignore();  // A dark refresh.
  }
  /// A refresh with these pixels, and the red that is seen after it.
  int show(std::uint8_t code) {
    panel.buffer(0)[0] = code;
    clock.advance(panel.frame_time());
    return glass.look().rgb[0];
  }
  VirtualClock clock;
  Panel panel;
  Glass glass;
};

TEST(ResponseEffect, EightMillisecondsGiveTheComputedGreyAfterOneFrame) {
  Effects effects;
  effects.response = hal::sim::ResponseTime{8'000'000, 8'000'000};
  Greys screen(effects);
  // 16.67 ms are 2.08 times 8 ms: 9^-2.08 = 1.03 % of the way is left, in linear light.
  EXPECT_EQ(screen.show(255), 254);
  EXPECT_EQ(screen.show(255), 255);
  EXPECT_EQ(screen.show(0), 26) << "the ghost of white: 1.03 % of full light";
  EXPECT_EQ(screen.show(0), 0);
}

TEST(ResponseEffect, AnySequenceFollowsTheExponential) {
  oracle::Random random(53);
  for (int round = 0; round < oracle::samples(60, 2000); ++round) {
    Effects effects;
    effects.response = hal::sim::ResponseTime{static_cast<Nanoseconds>(random.between(0, 120'000'000)),
                                              static_cast<Nanoseconds>(random.between(0, 120'000'000))};
    Greys screen(effects);
    const auto frame = static_cast<long double>(screen.panel.frame_time());
    const long double rising = oracle::left_after(frame, static_cast<long double>(effects.response->rise));
    const long double falling = oracle::left_after(frame, static_cast<long double>(effects.response->fall));
    std::vector<int> codes;
    for (int refresh = 0; refresh < 40; ++refresh) {
      codes.push_back(refresh > 0 && random.between(0, 2) > 0 ? codes.back() : random.between(0, 255));
      const int shown = screen.show(static_cast<std::uint8_t>(codes.back()));
      const long double exact = oracle::code_of(oracle::light_after(codes, rising, falling));
      ASSERT_LE(std::abs(shown - exact), 0.51L)
          << random.seed_text() << " round " << round << " refresh " << refresh;
    }
  }
}

TEST(DeadEffect, APixelShowsItsColourAndNoOtherChanges) {
  Effects effects;
  effects.dead = {{2, 0, {1, 2, 3}}};
  effects.response = hal::sim::ResponseTime{};
  Greys screen(effects, 4);
  for (int i = 0; i < 4; ++i) screen.panel.buffer(0)[static_cast<std::size_t>(i)] = 200;
  for (int i = 0; i < 9; ++i) screen.clock.advance(screen.panel.frame_time());
  EXPECT_EQ(screen.glass.look().rgb, (Bytes{200, 200, 200, 200, 200, 200, 1, 2, 3, 200, 200, 200}));
}

TEST(GridEffect, CellsAreLaidOutAsTheRuleSays) {
  oracle::Random random(54);
  for (int scale = 2; scale <= 32; ++scale) {
    for (const auto stripes : {hal::sim::Stripes::rgb, hal::sim::Stripes::bgr, hal::sim::Stripes::none}) {
      const int width = random.between(1, 5);
      const int height = random.between(1, 4);
      Bytes rgb(static_cast<std::size_t>(3 * width * height));
      for (std::uint8_t& byte : rgb) byte = static_cast<std::uint8_t>(random.between(1, 255));
      const Bytes large = hal::sim::enlarge({scale, stripes}, width, height, rgb);
      ASSERT_EQ(large.size(), rgb.size() * static_cast<std::size_t>(scale * scale));
      int wrong = 0;
      for (int y = 0; y < height * scale; ++y) {
        for (int x = 0; x < width * scale; ++x) {
          for (int component = 0; component < 3; ++component) {
            const int column = x % scale;
            bool lit = column < scale - 1 && y % scale < scale - 1;
            const int stripe = stripes == hal::sim::Stripes::bgr ? 2 - component : component;
            if (stripes != hal::sim::Stripes::none)
              lit = lit && scale >= 4 && column / ((scale - 1) / 3) == stripe;
            const int pixel = y / scale * width + x / scale;
            const int found = large[static_cast<std::size_t>(3 * (y * width * scale + x) + component)];
            if (found != (lit ? rgb[static_cast<std::size_t>(3 * pixel + component)] : 0)) ++wrong;
          }
        }
      }
      ASSERT_EQ(wrong, 0) << scale;
    }
  }
}

/// A panel of some colours, all effects of the glass on.
TEST(Glass, EffectsActInTheOrderStated) {
  const int width = 8;
  Effects effects;
  effects.depth = hal::sim::ColourDepth{{3, 4, 2}};
  effects.gamma = hal::sim::PanelGamma{300};
  effects.dead = {{5, 0, {7, 77, 177}}};
  effects.response = hal::sim::ResponseTime{20'000'000, 30'000'000};
  effects.grid = hal::sim::PixelGrid{5, hal::sim::Stripes::none};
  Greys screen(effects, width);
  for (int i = 0; i < width; ++i)
    screen.panel.buffer(0)[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(31 * i + 11);
  screen.clock.advance(screen.panel.frame_time());
  const auto view = screen.glass.look();
  ASSERT_EQ(view.width, 40);
  ASSERT_EQ(view.height, 5);
  const long double rising =
      oracle::left_after(static_cast<long double>(screen.panel.frame_time()), 20'000'000);
  for (int x = 0; x < width; ++x) {
    for (std::size_t component = 0; component < 3; ++component) {
      const int bits = effects.depth->bits[component];
      const int level = (31 * x + 11) >> (8 - bits);
      const auto sent = std::round(static_cast<long double>(level) * 255 / ((1 << bits) - 1));
      const auto lit = std::round(oracle::code_of(std::pow(sent / 255, 3.0L)));
      const long double seen = x == 5
                                   ? effects.dead[0].colour[component]
                                   : oracle::code_of(oracle::light_after({static_cast<int>(lit)}, rising, 0));
      EXPECT_LE(std::abs(view.rgb[static_cast<std::size_t>(15 * x) + component] - seen), 0.51L) << x;
      EXPECT_EQ(view.rgb[static_cast<std::size_t>(15 * x + 12) + component], 0) << "between two pixels";
    }
  }
}

TEST(Glass, TearingShowsWhatTheBeamFetched) {
  Effects effects;
  effects.tearing = true;
  for (const auto scan : {hal::ScanDirection::down, hal::ScanDirection::right}) {
    effects.scan = scan;
    VirtualClock clock;
    Panel panel(hal::sim::paletted(6, 6, 8, 1), clock, effects);
    Glass glass(panel, effects);
    ASSERT_TRUE(panel.load_palette(Bytes{0, 0, 0, 9, 9, 9}).ok());
    clock.wait_until(2U * panel.line_time() + 1U);
    std::ranges::fill(panel.buffer(0), std::uint8_t{1});
    ASSERT_TRUE(panel.wait_for_vblank().ok());
    const auto view = glass.look();
    for (int y = 0; y < 6; ++y)
      for (int x = 0; x < 6; ++x) {
        const int line = scan == hal::ScanDirection::down ? y : x;
        EXPECT_EQ(view.rgb[static_cast<std::size_t>(3 * (6 * y + x))], line < 3 ? 0 : 9) << x << ' ' << y;
      }
  }
}

// --- What isn't declared -------------------------------------------------------------------------------

/// All that an observer and a viewer are told of an ideal panel in some frames, as bytes.
class Log final : public hal::sim::Observer {
 public:
  Bytes bytes;
  void add(std::uint64_t value) {
    for (unsigned shift = 0; shift < 64; shift += 8)
      bytes.push_back(static_cast<std::uint8_t>(value >> shift));
  }
  void add(std::span<const std::uint8_t> part) { bytes.insert(bytes.end(), part.begin(), part.end()); }

 private:
  void on_line(const hal::sim::ScannedLine& line) override {
    add(line.refresh);
    add(static_cast<std::uint64_t>(line.y));
    add(line.time);
    add(line.pixels);
    add(line.palette);
  }
  void on_vblank(std::uint64_t refresh, Nanoseconds time) override {
    add(refresh);
    add(time);
  }
};

std::uint32_t digest_of_ideal(const char* name) {
  VirtualClock clock;
  Panel panel(*hal::sim::find_panel(name), clock);
  Log log;
  panel.attach(log);
  const hal::Capabilities& c = panel.capabilities();
  const int stride = c.width * c.bits_per_pixel / 8;
  Bytes memory(static_cast<std::size_t>(stride * c.height));
  for (std::size_t frame = 0; frame < 5; ++frame) {
    for (std::size_t i = 0; i < memory.size(); ++i)
      memory[i] = static_cast<std::uint8_t>(7U * i * frame + i / 100U);
    clock.advance(7'000'001U * frame);
    if (c.buffers > 0) {
      std::ranges::copy(memory, panel.buffer(static_cast<int>(frame % 2U)).begin());
      panel.show(static_cast<int>(frame % 2U), Bytes(6, static_cast<std::uint8_t>(50U * frame))).ignore();
    } else {
      panel.write({0, 0, c.width, c.height}, memory, stride).ignore();
    }
    panel.wait_for_vblank().ignore();
    log.add(panel.vblank_count());
    log.add(panel.displayed().rgb);
  }
  panel.detach(log);
  return oracle::crc32(log.bytes);
}

TEST(Effects, AnIdealPanelIsWhatItWasBeforeThereWereEffects) {
  // Counted with the simulator as it was then.
  EXPECT_EQ(digest_of_ideal("clcd"), 0xC4D57AE8U);
  EXPECT_EQ(digest_of_ideal("clcd1"), 0xE0CCFE3BU);
  EXPECT_EQ(digest_of_ideal("oled"), 0x7E1F7372U);
  EXPECT_EQ(digest_of_ideal("ssd1306"), 0xF8E424ABU);
  EXPECT_EQ(digest_of_ideal("97x33x8"), 0x3F1D91B3U);
}

/// The CRC of all that is seen of some frames, drawn and sent in ways that touch every effect.
std::uint32_t digest_of_run(const PanelSpec& spec, const Effects& effects) {
  VirtualClock clock;
  Panel panel(spec, clock, effects);
  Glass glass(panel, effects);
  const hal::Capabilities& c = panel.capabilities();
  Bytes seen;
  Bytes memory(static_cast<std::size_t>(c.width * c.height * c.bits_per_pixel / 8));
  for (std::uint32_t frame = 0; frame < 6; ++frame) {
    for (std::size_t i = 0; i < memory.size(); ++i) memory[i] = static_cast<std::uint8_t>(31U * i * frame);
    const Bytes palette(48, static_cast<std::uint8_t>(40U * frame));
    if (effects.draw) clock.advance(hal::sim::draw_time(*effects.draw, frame));
    if (c.buffers > 0) {
      std::ranges::copy(memory, panel.buffer(static_cast<int>(frame % 2U)).begin());
      EXPECT_TRUE(panel.show(static_cast<int>(frame % 2U), palette).ok());
    } else {
      EXPECT_TRUE(panel.write({0, 0, c.width, c.height}, memory, c.width * c.bits_per_pixel / 8).ok());
      panel.mark_frame();
    }
    EXPECT_TRUE(panel.wait_for_vblank().ok());
    const Bytes picture = glass.look().rgb;
    seen.insert(seen.end(), picture.begin(), picture.end());
  }
  return oracle::crc32(seen);
}

TEST(Effects, WhatIsntDeclaredIsntRunAndChangesNothing) {
  struct Case {
    Effect effect;
    const char* text;
    const char* panel;
  };
  const Case cases[]{{Effect::draw, "draw=3ms~1ms", "clcd4"},
                     {Effect::garbage, "garbage", "clcd4"},
                     {Effect::bus, "bus", "oled"},
                     {Effect::latch, "latch=palette", "clcd4"},
                     {Effect::te, "te=+1ms~1ms", "clcd4"},
                     {Effect::drift, "drift=900ppm", "clcd4"},
                     {Effect::scan, "scan=up,tearing", "oled"},
                     {Effect::tearing, "tearing", "oled"},
                     {Effect::depth, "depth=3", "clcd4"},
                     {Effect::gamma, "gamma=3.3", "oled"},
                     {Effect::response, "response=90ms", "oled"},
                     {Effect::dead, "dead=1:1:ff00ff", "oled"},
                     {Effect::grid, "grid=4", "clcd4"}};
  static_assert(std::size(cases) == hal::sim::effect_count);
  const std::uint32_t ideal_clcd = digest_of_run(*hal::sim::find_panel("clcd4"), {});
  const std::uint32_t ideal_oled = digest_of_run(*hal::sim::find_panel("oled"), {});
  const auto before = hal::sim::effect_calls;
  EXPECT_EQ(digest_of_run(*hal::sim::find_panel("clcd4"), {}), ideal_clcd);
  EXPECT_EQ(digest_of_run(*hal::sim::find_panel("oled"), {}), ideal_oled);
  EXPECT_EQ(hal::sim::effect_calls, before) << "an ideal panel runs no effect";
  for (const Case& c : cases) {
    const PanelSpec spec = *hal::sim::find_panel(c.panel);
    const auto parsed = hal::sim::parse_effects(c.text, spec);
    ASSERT_TRUE(std::holds_alternative<Effects>(parsed)) << c.text;
    hal::sim::effect_calls = {};
    digest_of_run(spec, std::get<Effects>(parsed));
    for (std::size_t i = 0; i < hal::sim::effect_count; ++i) {
      const bool declared = i == static_cast<std::size_t>(c.effect) ||
                            (c.effect == Effect::scan && i == static_cast<std::size_t>(Effect::tearing));
      EXPECT_EQ(hal::sim::effect_calls[i] > 0, declared) << c.text << ": " << hal::sim::effect_help()[i].name;
    }
  }
}

TEST(Effects, ARunRepeatsItself) {
  const PanelSpec spec = *hal::sim::find_panel("oled");
  const auto parsed = hal::sim::parse_effects(
      "draw=1ms~9ms,garbage=5,bus=1MHz+7us,te=60.2hz+300us~2ms,drift=300/"
      "2s,scan=left,tearing,depth=2,gamma=1.8,"
      "response=20ms/30ms,dead=0:0,dead=5:5:ffffff,grid=4:bgr",
      spec);
  ASSERT_TRUE(std::holds_alternative<Effects>(parsed)) << std::get<std::string>(parsed);
  const auto& effects = std::get<Effects>(parsed);
  EXPECT_EQ(digest_of_run(spec, effects), digest_of_run(spec, effects));
  EXPECT_NE(digest_of_run(spec, effects), digest_of_run(spec, {}));
}

// --- As a user names them ------------------------------------------------------------------------------

Effects effects_of(const char* text, const char* panel = "oled") {
  const auto parsed = hal::sim::parse_effects(text, *hal::sim::find_panel(panel));
  if (const auto* const wrong = std::get_if<std::string>(&parsed)) {
    ADD_FAILURE() << text << ": " << *wrong;
    return {};
  }
  return std::get<Effects>(parsed);
}

TEST(ParseEffects, ValuesAreReadExactly) {
  const Effects e = effects_of("response=8ms,te=60.2hz+200us,dead=12:7,bus=10MHz");
  EXPECT_EQ(e.response->rise, 8'000'000U);
  EXPECT_EQ(e.response->fall, 8'000'000U);
  EXPECT_EQ(e.te->millihertz, 60'200U);
  EXPECT_EQ(e.te->phase, 200'000U);
  EXPECT_EQ(e.te->jitter, 0U);
  ASSERT_EQ(e.dead.size(), 1U);
  EXPECT_EQ(e.dead[0].x, 12);
  EXPECT_EQ(e.dead[0].y, 7);
  EXPECT_EQ(e.bus->hertz, 10'000'000U);
  EXPECT_EQ(e.bus->command_bytes, 6) << "the panel's own";
  EXPECT_FALSE(e.tearing || e.depth || e.grid || e.drift || e.gamma || e.scan || e.latch || e.garbage ||
               e.draw);

  EXPECT_EQ(effects_of("bus=400kHz+1.5us").bus->gap, 1'500U);
  EXPECT_EQ(effects_of("bus=+0us").bus->gap, 0U);
  EXPECT_EQ(effects_of("bus").bus->hertz, 4'000'000U);
  EXPECT_EQ(effects_of("te=~0.25ms").te->jitter, 250'000U);
  EXPECT_EQ(effects_of("te=50HZ~1us").te->millihertz, 50'000U);
  EXPECT_FALSE(effects_of("te=off").te->connected);
  EXPECT_EQ(effects_of("response=1ms/2ms").response->fall, 2'000'000U);
  EXPECT_EQ(effects_of("response").response->rise, 10'000U);
  EXPECT_EQ(effects_of("drift=-300ppm/10s").drift->ppm, -300);
  EXPECT_EQ(effects_of("drift=300/10s").drift->period, 10'000'000'000U);
  EXPECT_EQ(effects_of("depth=565").depth->bits, (std::array{5, 6, 5}));
  EXPECT_EQ(effects_of("depth=6").depth->bits, (std::array{6, 6, 6}));
  EXPECT_EQ(effects_of("gamma=2.4").gamma->hundredths, 240);
  EXPECT_EQ(effects_of("grid=6:bgr").grid->stripes, hal::sim::Stripes::bgr);
  EXPECT_EQ(effects_of("grid").grid->scale, 6);
  EXPECT_EQ(effects_of("dead=1:2:0a0B0c").dead[0].colour, (std::array<std::uint8_t, 3>{10, 11, 12}));
  EXPECT_EQ(effects_of("scan=left").scan, hal::ScanDirection::left);
  EXPECT_EQ(effects_of("latch=none", "clcd").latch, hal::sim::PaletteLatch::both_at_once);
  EXPECT_EQ(effects_of("draw=9ms~3ms").draw->spread, 3'000'000U);
  EXPECT_EQ(effects_of("garbage=77").garbage->seed, 77U);
}

TEST(ParseEffects, WhatIsWrongIsSaid) {
  struct Case {
    const char* text;
    const char* says;
  };
  for (const Case& c :
       {Case{"ghosts", "no effect is named 'ghosts'"},
        {"bus,,te", "no effect is named ''"},
        {"bus,", "no effect is named ''"},
        {"bus=", "no value behind '='"},
        {"tearing=yes", "takes no value"},
        {"tearing,tearing", "named twice"},
        {"dead", "dead=X:Y"},
        {"dead=128:0", "x is 0 to 127"},
        {"dead=0:64", "y is 0 to 63"},
        {"dead=99999999999999999999:0", "x is 0 to 127"},
        {"dead=1", "dead=X:Y"},
        {"dead=1:2:red", "'1:2:red'"},
        {"dead=-1:2", "'-1:2'"},
        {"bus=10", "'10' is no value of bus[=RATE[+TIME]], RATE as in 10MHz, times as in 8ms"},
        {"bus=10MHz5", "'10MHz5' is no value"},
        {"bus=0.5Hz", "at least 1 Hz"},
        {"bus=2.5Hz", "whole hertz"},
        {"bus=9999999MHz", "out of range (at most 4000 MHz)"},
        {"bus=99999999999999999999999999MHz", "at most 4000 MHz"},
        {"bus=1MHz+1.5s", "at most 1 s"},
        {"te=2kHz", "at most 1 kHz"},
        {"te=0.001Hz", "1 Hz to 1 kHz"},
        {"te=60.2hz+20ms", "nine tenths"},
        {"te=+1parsec", "'+1parsec'"},
        {"te=offf", "'offf'"},
        {"response=600ms", "out of range (at most 500 ms)"},
        {"response=2147483648us", "at most 500 ms"},
        {"response=8ms/.5s1", "'8ms/.5s1'"},
        {"response=.ms", "'.ms'"},
        {"response=8ms/", "'8ms/'"},
        {"depth=9", "1 to 8"},
        {"depth=55", "1 to 8"},
        {"depth=505", "1 to 8"},
        {"depth=0565", "1 to 8"},
        {"depth=5x", "1 to 8"},
        {"gamma=0.1", "0.5 to 5"},
        {"gamma=5.01", "(0.5 to 5)"},
        {"gamma=9999999999999999999999", "(0.5 to 5)"},
        {"gamma=2.2222", "at most 2 decimals"},
        {"gamma=.", "'.'"},
        {"grid=3:rgb", "4 to 32"},
        {"grid=4:cmy", "'4:cmy'"},
        {"grid=33", "SCALE is 2 to 32"},
        {"scan=sideways", "'sideways'"},
        {"latch=none", "nothing to latch"},
        {"drift=1/1ns", "100 ms to 60 s"},
        {"drift=1/61s", "at most 60 s"},
        {"drift=-50001", "PPM is 0 to 50000"},
        {"drift=5/8", "PERIOD]], times as in 8ms"},
        {"garbage=18446744073709551616", "SEED is 0 to 18446744073709551615"},
        {"draw=10.5s", "at most 10 s"},
        {"draw=.", "'.'"}}) {
    const auto parsed = hal::sim::parse_effects(c.text, *hal::sim::find_panel("oled"));
    const auto* const wrong = std::get_if<std::string>(&parsed);
    ASSERT_NE(wrong, nullptr) << c.text;
    EXPECT_NE(wrong->find(c.says), std::string::npos) << c.text << ": " << *wrong;
  }
  const auto parsed = hal::sim::parse_effects("bus", *hal::sim::find_panel("clcd"));
  EXPECT_NE(std::get<std::string>(parsed).find("no bus"), std::string::npos);
}

}  // namespace
