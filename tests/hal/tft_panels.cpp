// SPDX-License-Identifier: MIT
//
// TFT controllers (ST7789, ILI9341) against models that know only the data sheets.
#include <hal/mock/strict_dcs.hpp>
#include <hal/panels/ili9341.hpp>
#include <hal/panels/st7789.hpp>
#include <hal/sim/catalog.hpp>
#include <hal/sim/virtual_clock.hpp>
#include <tests/hal/turned_glass.hpp>
#include <tests/oracle/samples.hpp>

#include <array>

namespace {

using glass::Rotation;
using hal::mock::DcsGlass;
using hal::mock::Pattern;
using hal::mock::StrictDcs;
using hal::mock::StrictIli9341;
using hal::mock::StrictSt7789;
using hal::panels::DcsOptions;
using hal::panels::Ili9341;
using hal::panels::SpiPort;
using hal::panels::St7789;
using hal::panels::TearingEffect;
using hal::sim::VirtualClock;

constexpr hal::Nanoseconds millisecond = 1'000'000;

/// 256 colours of which none equals another as RGB565.
std::vector<std::uint8_t> colours() {
  std::vector<std::uint8_t> all;
  for (int i = 0; i < 256; ++i) {
    const std::array<int, 3> colour{i * 7 % 256, i * 11 % 256, i};
    for (const int channel : colour) all.push_back(static_cast<std::uint8_t>(channel));
  }
  return all;
}

/// The level of a channel that is nearest to it, found by trying all.
int nearest(int channel, int levels) {
  int best = 0;
  for (int level = 1; level < levels; ++level) {
    const int here = std::abs(level * 255 - channel * (levels - 1));
    const int there = std::abs(best * 255 - channel * (levels - 1));
    if (here < there) best = level;
  }
  return best;
}

/// What RGB565 a viewer sees for an index.
std::function<int(int, int, int)> seen_through(const std::vector<std::uint8_t>& palette) {
  std::vector<int> words;
  for (std::size_t i = 0; i < palette.size(); i += 3)
    words.push_back(nearest(palette[i], 32) * 2048 + nearest(palette[i + 1], 64) * 32 +
                    nearest(palette[i + 2], 32));
  return [words](int index, int, int) { return words[static_cast<std::size_t>(index)]; };
}

template <class Driver, class Model>
void shows_every_pixel(const DcsOptions& module, const DcsGlass& mounted, unsigned seed, int rounds) {
  const std::vector<std::uint8_t> palette = colours();
  for (const Rotation rotation : glass::rotations) {
    VirtualClock clock;
    Model model(clock, mounted);
    SpiPort port(model.spi(), model.data_command());
    DcsOptions options = module;
    options.rotation = rotation;
    Driver panel(port, clock, nullptr, options);
    EXPECT_NE(model.memory(), Pattern::blank(mounted.width, mounted.height)) << "noise at power-on";
    ASSERT_TRUE(panel.start().ok());
    EXPECT_TRUE(model.on());
    const auto entries = std::size_t{3} << static_cast<unsigned>(options.bits_per_pixel);
    ASSERT_TRUE(panel.load_palette(std::span(palette).first(entries)).ok());
    glass::random_writes_show(panel, model, rotation, seed, rounds, seen_through(palette));
    EXPECT_TRUE(glass::beam_runs_as_told(panel.capabilities(), model, rotation));
  }
}

TEST(St7789, EveryPixelArrivesInAllRotations) {
  shows_every_pixel<St7789, StrictSt7789>(hal::panels::st7789_240x320, {.inverted = true}, 50'001,
                                          oracle::samples(5, 60));
}

TEST(Ili9341, EveryPixelArrivesInAllRotations) {
  shows_every_pixel<Ili9341, StrictIli9341>(hal::panels::ili9341_240x320, {.mirrored = true, .bgr = true},
                                            50'002, oracle::samples(5, 60));
}

TEST(St7789, AGlassSmallerThanTheMemoryIsHitInAllRotations) {
  shows_every_pixel<St7789, StrictSt7789>(hal::panels::st7789_240x240, {.height = 240, .inverted = true},
                                          50'003, oracle::samples(4, 40));
  shows_every_pixel<St7789, StrictSt7789>(
      hal::panels::st7789_135x240,
      {.width = 135, .height = 240, .column_offset = 52, .row_offset = 40, .inverted = true}, 50'004,
      oracle::samples(9, 60));
  DcsOptions corner{.width = 17, .height = 31, .column_offset = 223, .row_offset = 289, .mirrored = true};
  const DcsGlass mounted{
      .width = 17, .height = 31, .column_offset = 223, .row_offset = 289, .mirrored = true};
  shows_every_pixel<St7789, StrictSt7789>(corner, mounted, 50'005, oracle::samples(100, 1000));
}

TEST(St7789, IndicesOfAllWidthsInBothBitOrders) {
  for (const int bits : {1, 2, 4, 8})
    for (const hal::BitOrder order : {hal::BitOrder::msb_first, hal::BitOrder::lsb_first}) {
      SCOPED_TRACE(bits);
      const DcsOptions options{.width = 45,
                               .height = 38,
                               .column_offset = 3,
                               .row_offset = 5,
                               .bits_per_pixel = bits,
                               .bit_order = order};
      const DcsGlass mounted{.width = 45, .height = 38, .column_offset = 3, .row_offset = 5};
      shows_every_pixel<St7789, StrictSt7789>(options, mounted, 50'006, oracle::samples(20, 400));
    }
}

TEST(St7789, TheBeamCanRunUpTheGlass) {
  for (const Rotation rotation : glass::rotations) {
    VirtualClock clock;
    StrictSt7789 model(clock);
    SpiPort port(model.spi(), model.data_command());
    St7789 panel(port, clock, nullptr, {.rotation = rotation, .invert = true, .scan_up = true});
    ASSERT_TRUE(panel.start().ok());
    EXPECT_EQ(model.beam_row(0), 319);
    EXPECT_TRUE(glass::beam_runs_as_told(panel.capabilities(), model, rotation));
  }
}

/// A small glass with everything it needs.
struct Bench {
  explicit Bench(DcsOptions wanted = {}) : options(wanted) {
    options.width = options.height = 24;
    options.invert = true;
  }
  DcsOptions options;
  VirtualClock clock;
  StrictSt7789 model{clock, {.width = 24, .height = 24, .inverted = true}};
  SpiPort port{model.spi(), model.data_command()};
};

TEST(DcsPanel, TearingEffectIsSwitchedOnWithItsParameter) {
  const auto tearing = [](DcsOptions options) {
    Bench bench(options);
    St7789 panel(bench.port, bench.clock, nullptr, bench.options);
    EXPECT_TRUE(panel.start().ok());
    return std::pair(bench.model.tearing(), bench.model.tearing_line());
  };
  EXPECT_EQ(tearing({}), std::pair(StrictDcs::Tearing::off, 0));
  EXPECT_EQ(tearing({.te = TearingEffect::vblank}), std::pair(StrictDcs::Tearing::vblank, 0));
  EXPECT_EQ(tearing({.te = TearingEffect::vblank_and_hblank}),
            std::pair(StrictDcs::Tearing::vblank_and_hblank, 0));
  EXPECT_EQ(tearing({.te = TearingEffect::vblank, .te_line = 300}),
            std::pair(StrictDcs::Tearing::vblank, 300));
}

TEST(DcsPanel, SleepWaitsForWhatIsLeftOfItsPausesAndNoLonger) {
  Bench bench;
  hal::Clock& clock = bench.clock;
  St7789 panel(bench.port, bench.clock, nullptr, bench.options);
  ASSERT_TRUE(panel.start().ok());
  EXPECT_EQ(clock.now(), 130 * millisecond) << "5 before the reset, 120 behind it, 5 behind waking";
  ASSERT_TRUE(panel.sleep(false).ok());
  EXPECT_EQ(clock.now(), 130 * millisecond) << "it is awake";
  ASSERT_TRUE(panel.sleep(true).ok());
  EXPECT_EQ(clock.now(), 245 * millisecond) << "120 since it woke";
  EXPECT_TRUE(bench.model.asleep());
  ASSERT_TRUE(panel.sleep(false).ok());
  EXPECT_EQ(clock.now(), 365 * millisecond);
  bench.clock.advance(1000 * millisecond);
  ASSERT_TRUE(panel.sleep(true).ok());
  EXPECT_EQ(clock.now(), 1365 * millisecond) << "all pauses are over";
}

TEST(DcsPanel, StartingAgainWaitsUntilTheControllerIsAwake) {
  Bench bench;
  hal::Clock& clock = bench.clock;
  St7789 panel(bench.port, bench.clock, nullptr, bench.options);
  ASSERT_TRUE(panel.start().ok());
  ASSERT_EQ(clock.now(), 130 * millisecond);
  ASSERT_TRUE(panel.start().ok());
  EXPECT_EQ(clock.now(), (245 + 120 + 5) * millisecond) << "120 since it woke, then as the first time";
  ASSERT_TRUE(panel.stop().ok());
  EXPECT_EQ(clock.now(), (365 + 120) * millisecond);
  ASSERT_TRUE(panel.start().ok());
  EXPECT_EQ(clock.now(), (485 + 5 + 120 + 5) * millisecond) << "asleep it can be reset at once";
}

TEST(DcsPanel, StopPutsAControllerToSleepOfWhichAFaultLeftNothingKnown) {
  Bench bench;
  St7789 panel(bench.port, bench.clock, nullptr, bench.options);
  ASSERT_TRUE(panel.start().ok());
  bench.model.fail_after(0);
  EXPECT_EQ(panel.start().error(), hal::Error::bus) << "awake as before";
  bench.model.fail_after(1 << 30);
  ASSERT_TRUE(panel.stop().ok());
  EXPECT_TRUE(bench.model.asleep());
  // A program that begins knows nothing of what the one before left.
  ASSERT_TRUE(panel.start().ok());
  St7789 next(bench.port, bench.clock, nullptr, bench.options);
  bench.clock.advance(200 * millisecond);
  ASSERT_TRUE(next.stop().ok());
  EXPECT_TRUE(bench.model.asleep());
}

TEST(DcsPanel, SleepKeepsThePictureAndStopBlanksIt) {
  Bench bench;
  St7789 panel(bench.port, bench.clock, nullptr, bench.options);
  ASSERT_TRUE(panel.start().ok());
  const std::array<std::uint8_t, 6> palette{0, 0, 0, 255, 255, 255};
  ASSERT_TRUE(panel.load_palette(palette).ok());
  const std::vector<std::uint8_t> white(24 * 24, 1);
  ASSERT_TRUE(panel.write({0, 0, 24, 24}, white, 24).ok());
  const Pattern shown = bench.model.displayed();
  EXPECT_EQ(shown.at(23, 23), 0xFFFF);
  ASSERT_TRUE(panel.sleep(true).ok());
  EXPECT_EQ(bench.model.displayed(), Pattern::blank(24, 24));
  ASSERT_TRUE(panel.write({0, 0, 1, 1}, white, 24).ok()) << "the memory is awake";
  ASSERT_TRUE(panel.sleep(false).ok());
  EXPECT_EQ(bench.model.displayed(), shown);
  ASSERT_TRUE(panel.stop().ok());
  EXPECT_FALSE(bench.model.on());
  EXPECT_TRUE(bench.model.asleep());
  ASSERT_TRUE(panel.start().ok());
  EXPECT_EQ(bench.model.displayed(), Pattern::blank(24, 24));
  EXPECT_TRUE(bench.model.on());
}

TEST(DcsPanel, StopTriesBothStepsAndAnswersTheFirstError) {
  struct FailsOnce final : hal::SpiBus {
    explicit FailsOnce(hal::SpiBus& bus) : whole(&bus) {}
    hal::SpiBus* whole;
    int good = -1;
    hal::Status do_write(std::span<const std::uint8_t> bytes) noexcept override {
      return good-- == 0 ? hal::Status(hal::Error::timeout, hal::Part::bus) : whole->write(bytes);
    }
  };
  for (const int step : {0, 1}) {
    Bench bench;
    FailsOnce wire(bench.model.spi());
    SpiPort port(wire, bench.model.data_command());
    St7789 panel(port, bench.clock, nullptr, bench.options);
    ASSERT_TRUE(panel.start().ok());
    wire.good = step;
    EXPECT_EQ(panel.stop(), hal::Status(hal::Error::timeout, hal::Part::bus));
    EXPECT_EQ(bench.model.asleep(), step == 0);
    EXPECT_FALSE(bench.model.on()) << "blank, or at least asleep";
    ASSERT_TRUE(panel.stop().ok());
    ASSERT_TRUE(panel.sleep(false).ok());
    EXPECT_FALSE(bench.model.on()) << "awake, but blank";
  }
}

TEST(DcsPanel, ColoursAreThoseLoadedWhenPixelsWereWritten) {
  Bench bench;
  St7789 panel(bench.port, bench.clock, nullptr, bench.options);
  EXPECT_TRUE(panel.capabilities().palette_on_write);
  ASSERT_TRUE(panel.start().ok());
  const std::array<std::uint8_t, 3> red{255, 0, 0};
  const std::array<std::uint8_t, 3> blue{0, 0, 255};
  const std::array<std::uint8_t, 1> pixel{0};
  ASSERT_TRUE(panel.load_palette(red).ok());
  ASSERT_TRUE(panel.write({3, 4, 1, 1}, pixel, 1).ok());
  ASSERT_TRUE(panel.load_palette(blue).ok());
  EXPECT_EQ(bench.model.displayed().at(3, 4), 0xF800);
  ASSERT_TRUE(panel.write({3, 4, 1, 1}, pixel, 1).ok());
  EXPECT_EQ(bench.model.displayed().at(3, 4), 0x001F);
}

TEST(DcsPanel, ALargerWorkspaceSavesTransfers) {
  const auto transfers = [](std::span<std::uint8_t> workspace) {
    VirtualClock clock;
    StrictSt7789 model(clock);
    SpiPort port(model.spi(), model.data_command());
    St7789 panel(port, clock, nullptr, {.invert = true, .workspace = workspace});
    EXPECT_TRUE(panel.start().ok());
    const int before = model.transfers();
    const std::vector<std::uint8_t> pixels(std::size_t{240} * 320, 3);
    EXPECT_TRUE(panel.write({0, 0, 240, 320}, pixels, 240).ok());
    model.expect_idle();
    return model.transfers() - before;
  };
  std::array<std::uint8_t, 4097> workspace{};
  constexpr int window = 5 + 5;  // Commands and parameters, and the line for each but the first command.
  EXPECT_EQ(transfers({}), window + 600);
  EXPECT_EQ(transfers(workspace), window + 38);
}

TEST(DcsPanel, ATearingEffectLineGivesTheRhythm) {
  struct Line final : hal::VblankSource {
    std::uint32_t pulses = 41;
    std::uint32_t do_count() noexcept override { return pulses; }
    hal::Status do_wait() noexcept override {
      ++pulses;
      return pulses == 43 ? hal::Status(hal::Error::timeout, hal::Part::pin) : hal::Status();
    }
    hal::Nanoseconds do_last() noexcept override { return 0; }
  } line;
  Bench bench;
  St7789 panel(bench.port, bench.clock, &line, bench.options);
  EXPECT_TRUE(panel.capabilities().vblank_signal);
  EXPECT_EQ(panel.vblank_count(), 41U);
  EXPECT_TRUE(panel.wait_for_vblank().ok());
  EXPECT_EQ(panel.vblank_count(), 42U);
  EXPECT_EQ(panel.wait_for_vblank(), hal::Status(hal::Error::timeout, hal::Part::pin));
  const St7789 without(bench.port, bench.clock, nullptr, bench.options);
  EXPECT_FALSE(without.capabilities().vblank_signal);
}

TEST(DcsPanel, OptionsThatCannotBeAreRefusedAndNothingIsSent) {
  const std::array<DcsOptions, 16> all{{{.width = 0},
                                        {.width = 241},
                                        {.height = 321},
                                        {.height = -1},
                                        {.column_offset = 1},
                                        {.row_offset = -1},
                                        {.width = 100, .column_offset = INT32_MAX},
                                        {.te_line = 320},
                                        {.te_line = -1},
                                        {.te = TearingEffect::vblank_and_hblank, .te_line = 1},
                                        {.te = static_cast<TearingEffect>(3)},
                                        {.rotation = static_cast<Rotation>(4)},
                                        {.bits_per_pixel = 0},
                                        {.bits_per_pixel = 3},
                                        {.bits_per_pixel = 16},
                                        {.refresh_millihertz = 0}}};
  for (const DcsOptions& options : all) {
    VirtualClock clock;
    StrictSt7789 model(clock);
    SpiPort port(model.spi(), model.data_command());
    St7789 panel(port, clock, nullptr, options);
    EXPECT_EQ(panel.start(), hal::Status(hal::Error::invalid, hal::Part::panel));
    EXPECT_EQ(model.transfers(), 0);
  }
}

TEST(DcsPanel, OptionsAtTheirLimitsAreTaken) {
  shows_every_pixel<St7789, StrictSt7789>({.width = 1, .height = 1, .column_offset = 239, .row_offset = 319},
                                          {.width = 1, .height = 1, .column_offset = 239, .row_offset = 319},
                                          50'007, 4);
  Bench bench({.te = TearingEffect::vblank, .te_line = 319});
  St7789 panel(bench.port, bench.clock, nullptr, bench.options);
  ASSERT_TRUE(panel.start().ok());
  EXPECT_EQ(bench.model.tearing_line(), 319);
}

TEST(DcsPanel, BadRectanglesSendNothing) {
  Bench bench({.bits_per_pixel = 4});
  St7789 panel(bench.port, bench.clock, nullptr, bench.options);
  ASSERT_TRUE(panel.start().ok());
  const int before = bench.model.transfers();
  const std::array<std::uint8_t, 64> pixels{};
  EXPECT_EQ(panel.write({1, 0, 2, 2}, pixels, 1).error(), hal::Error::misaligned);
  EXPECT_EQ(panel.write({0, 0, 26, 2}, pixels, 13).error(), hal::Error::invalid);
  EXPECT_EQ(panel.write({0, 0, 24, 24}, pixels, 12).error(), hal::Error::invalid);
  EXPECT_EQ(panel.write({0, 0, 4, 4}, pixels, 1).error(), hal::Error::invalid);
  EXPECT_EQ(panel.write({INT32_MAX, INT32_MIN, 1, 1}, pixels, 1).error(), hal::Error::invalid);
  const std::array<std::uint8_t, 51> many{};
  EXPECT_EQ(panel.load_palette(many).error(), hal::Error::invalid) << "17 colours of 16";
  EXPECT_EQ(bench.model.transfers(), before);
}

TEST(DcsPanel, FaultsAreReportedAndLeaveNoTrace) {
  const std::vector<std::uint8_t> palette = colours();
  glass::faults_leave_no_trace([&](const auto& use) {
    Bench bench({.rotation = Rotation::by_90, .te = TearingEffect::vblank, .te_line = 2});
    St7789 panel(bench.port, bench.clock, nullptr, bench.options);
    EXPECT_TRUE(panel.load_palette(palette).ok());
    use(panel, bench.model, Rotation::by_90, seen_through(palette));
  });
}

TEST(DcsPanel, ContrastIsTheBackLight) {
  Bench bench({.contrast = 77});
  St7789 panel(bench.port, bench.clock, nullptr, bench.options);
  ASSERT_TRUE(panel.start().ok());
  EXPECT_EQ(bench.model.brightness(), 77);
  ASSERT_TRUE(panel.set_contrast(12).ok());
  EXPECT_EQ(bench.model.brightness(), 12);
}

}  // namespace
