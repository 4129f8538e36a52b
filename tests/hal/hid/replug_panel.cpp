// SPDX-License-Identifier: MIT
//
// Displays that are unplugged at any time and plugged in again, without memory of what they showed.
#include <hal/hid/host/gaming_lcd.hpp>
#include <hal/hid/host/mcp2221.hpp>
#include <hal/hid/host/replug_panel.hpp>
#include <hal/mock/strict_ssd1306.hpp>
#include <hal/panels/command_port.hpp>
#include <hal/panels/ssd1306.hpp>
#include <tests/hal/hid/bridge.hpp>
#include <tests/hal/hid/keyboard.hpp>

#include <gtest/gtest.h>

#include <memory>
#include <random>

namespace {

using hal::Error;
using hal::Nanoseconds;
using hal::Status;
using hal::hid::ReplugPanel;
using tests::hid::Bytes;
using tests::hid::Cable;

constexpr Nanoseconds patience = 5'000'000'000;

int bit(const Bytes& picture, int stride, int x, int y) {
  return picture[static_cast<std::size_t>(y * stride + x / 8)] >> (7 - x % 8) & 1;
}

/// A keyboard's display.
struct LcdRig {
  static constexpr int width = 160;
  static constexpr int height = 43;
  static constexpr int reports_step = 1;
  hal::sim::VirtualClock clock;
  tests::hid::Keyboard device;
  hal::hid::GamingLcd driver{device, &clock};
  ReplugPanel panel{driver, device, clock, [this] { return driver.start(); }, patience};
  Cable& cable = device.cable;

  LcdRig() {
    cable.on_return = [this] { std::ranges::fill(device.glass, std::uint8_t{0xAA}); };
    EXPECT_TRUE(driver.start().ok());
  }
  [[nodiscard]] bool on() const { return true; }
  /// A function that tells pixels of what is shown now.
  [[nodiscard]] auto shown() const {
    return [this](int x, int y) { return device.pixel(x, y); };
  }
};

/// A display on I2C behind a bridge.
struct BridgeRig {
  static constexpr int width = 128;
  static constexpr int height = 64;
  static constexpr int reports_step = 37;
  hal::sim::VirtualClock clock;
  std::unique_ptr<hal::mock::StrictSsd1306> glass = std::make_unique<hal::mock::StrictSsd1306>(width, height);
  tests::hid::Bridge device{clock, glass->i2c(), 0x3C};
  hal::hid::Mcp2221I2c bus{device, clock};
  hal::panels::I2cPort port{bus, 0x3C};
  hal::panels::Ssd1306 driver{port, hal::panels::ssd1306_128x64, &clock};
  ReplugPanel panel{driver, device, clock, [this] { return start(); }, patience};
  Cable& cable = device.cable;

  BridgeRig() {
    cable.on_return = [this] {
      glass = std::make_unique<hal::mock::StrictSsd1306>(width, height);
      device.restart(glass->i2c());
    };
    EXPECT_TRUE(start().ok());
  }
  Status start() {
    const Status s = bus.start();
    return s.ok() ? driver.start() : s;
  }
  [[nodiscard]] bool on() const { return glass->on(); }
  [[nodiscard]] auto shown() const {
    return [picture = glass->displayed()](int x, int y) { return picture.at(x, y); };
  }
};

/// What a program draws: whole frames, and parts of frames where the panel takes them.
template <class Rig>
class Sketch {
 public:
  static constexpr int stride = Rig::width / 8;
  explicit Sketch(std::uint32_t seed)
      : random_(seed), picture_(static_cast<std::size_t>(stride * Rig::height)) {}

  Status draw(Rig& rig) {
    const hal::Capabilities& c = rig.panel.capabilities();
    const bool parts = c.x_alignment == 8 && drawn_++ % 2 == 1;
    const hal::Rect area = parts ? hal::Rect{16, 8, 40, 24} : hal::Rect{0, 0, Rig::width, Rig::height};
    for (int y = area.y; y < area.y + area.height; ++y)
      for (int x = area.x / 8; x < (area.x + area.width) / 8; ++x)
        picture_[static_cast<std::size_t>(y * stride + x)] = static_cast<std::uint8_t>(random_());
    const auto first = static_cast<std::size_t>(area.y * stride + area.x / 8);
    return rig.panel.write(area, std::span(picture_).subspan(first), stride);
  }
  [[nodiscard]] int wrong(const Rig& rig) const {
    const auto shown = rig.shown();
    int wrong = 0;
    for (int y = 0; y < Rig::height; ++y)
      for (int x = 0; x < Rig::width; ++x) wrong += shown(x, y) != bit(picture_, stride, x, y);
    return wrong;
  }

 private:
  std::mt19937 random_;
  Bytes picture_;
  int drawn_ = 0;
};

template <class Rig>
class Replug : public testing::Test {};
using Rigs = testing::Types<LcdRig, BridgeRig>;
TYPED_TEST_SUITE(Replug, Rigs);

TYPED_TEST(Replug, GoesOnWhereverTheCableIsPulled) {
  constexpr int step = TypeParam::reports_step;
  int pulled = 0;
  for (int at = 0; at < 8 * step; at += step) {
    TypeParam rig;
    Sketch<TypeParam> sketch(5);
    rig.cable.reports_left = at;
    for (int n = 0; n < 3; ++n) ASSERT_TRUE(sketch.draw(rig).ok()) << at;
    EXPECT_EQ(sketch.wrong(rig), 0) << at;
    EXPECT_TRUE(rig.on());
    EXPECT_EQ(rig.panel.reconnects(), static_cast<std::uint64_t>(rig.cable.pulls));
    pulled += rig.cable.pulls;
  }
  EXPECT_GE(pulled, 3);
}

TYPED_TEST(Replug, GoesOnWhenThePlugShakes) {
  TypeParam rig;
  Sketch<TypeParam> sketch(6);
  ASSERT_TRUE(sketch.draw(rig).ok());
  rig.cable.pull();
  // Pulled again while the picture is sent again.
  rig.cable.on_return = [&rig, again = rig.cable.on_return] {
    again();
    rig.cable.reports_left =
        rig.cable.pulls < 4 ? TypeParam::reports_step * (rig.cable.pulls - 1) / 2 : Cable::never;
    rig.cable.looks_left = 1;
  };
  ASSERT_TRUE(sketch.draw(rig).ok());
  EXPECT_EQ(rig.cable.pulls, 4);
  EXPECT_EQ(rig.panel.reconnects(), 1U);
  EXPECT_EQ(sketch.wrong(rig), 0);
}

TYPED_TEST(Replug, ShowsThePictureAgainWhileNothingIsSent) {
  TypeParam rig;
  Sketch<TypeParam> sketch(7);
  ASSERT_TRUE(sketch.draw(rig).ok());
  rig.cable.pull();
  ASSERT_TRUE(rig.panel.wait_for_vblank().ok());
  EXPECT_EQ(sketch.wrong(rig), 0);
  EXPECT_EQ(rig.panel.reconnects(), 1U);
}

TYPED_TEST(Replug, EndsWhenPatienceRunsOut) {
  TypeParam rig;
  Sketch<TypeParam> sketch(8);
  ASSERT_TRUE(sketch.draw(rig).ok());
  rig.cable.looks_left = Cable::never;
  rig.cable.pull();
  const Nanoseconds before = rig.clock.now();
  EXPECT_EQ(sketch.draw(rig).error(), Error::disconnected);
  EXPECT_GE(rig.clock.now() - before, patience);
  EXPECT_LT(rig.clock.now() - before, patience + 200'000'000);
  // It may still come back later.
  rig.cable.looks_left = 0;
  ASSERT_TRUE(sketch.draw(rig).ok());
  EXPECT_EQ(sketch.wrong(rig), 0);
}

TYPED_TEST(Replug, DoesNotLookForItWithoutPatience) {
  TypeParam rig;
  ReplugPanel hasty(
      rig.driver, rig.device, rig.clock, [] { return Status{}; }, 0);
  rig.cable.pull();
  const Nanoseconds before = rig.clock.now();
  EXPECT_EQ(hasty.wait_for_vblank().error(), Error::disconnected);
  EXPECT_LT(rig.clock.now() - before, Nanoseconds{100'000'000});
}

TYPED_TEST(Replug, EndsAtOnceWithADisplayThatIsAnother) {
  TypeParam rig;
  ReplugPanel strict(
      rig.driver, rig.device, rig.clock,
      [] {
        return Status{Error::unsupported, hal::Part::panel};
      },
      patience);
  rig.cable.looks_left = 0;
  rig.cable.pull();
  const Nanoseconds before = rig.clock.now();
  EXPECT_EQ(strict.wait_for_vblank().error(), Error::unsupported);
  EXPECT_LT(rig.clock.now() - before, Nanoseconds{100'000'000});
}

TEST(ReplugPanel, WaitsForADisplayThatIsSlowerThanItsBridge) {
  BridgeRig rig;
  Sketch<BridgeRig> sketch(9);
  ASSERT_TRUE(sketch.draw(rig).ok());
  rig.device.address = 0x3D;
  rig.cable.pull();
  // It answers from the fourth look on.
  ReplugPanel panel(
      rig.driver, rig.device, rig.clock,
      [&rig, looks = 0]() mutable {
        if (++looks == 4) rig.device.address = 0x3C;
        return rig.start();
      },
      patience);
  ASSERT_TRUE(panel.wait_for_vblank().ok());
  EXPECT_TRUE(rig.on());
}

TEST(ReplugPanel, SaysThatNothingAnswersBehindTheBridge) {
  BridgeRig rig;
  rig.device.address = 0x3D;
  rig.cable.pull();
  EXPECT_EQ(rig.panel.wait_for_vblank().error(), Error::bus);
}

/// A panel with colours of which a byte holds two pixels.
class Paletted final : public hal::panels::WritePanel {
 public:
  Paletted() : WritePanel({.width = 6, .height = 2, .bits_per_pixel = 4, .palette_entries = 16}, nullptr) {}
  Bytes colours;
  Bytes memory;
  bool gone = false;

 private:
  Status do_write(const hal::Rect&, std::span<const std::uint8_t> pixels, int) noexcept override {
    if (gone) return {Error::disconnected, hal::Part::panel};
    memory.assign(pixels.begin(), pixels.end());
    return {};
  }
  Status do_load_palette(std::span<const std::uint8_t> palette) noexcept override {
    if (gone) return {Error::disconnected, hal::Part::panel};
    colours.assign(palette.begin(), palette.end());
    return {};
  }
};

TEST(ReplugPanel, LoadsColoursAgainAndKeepsToWholeBytes) {
  hal::sim::VirtualClock clock;
  tests::hid::Keyboard port;
  Paletted inner;
  ReplugPanel panel(
      inner, port, clock,
      [&inner] {
        inner.gone = false;
        inner.colours.clear();
        return Status{};
      },
      patience);
  EXPECT_EQ(panel.capabilities().x_alignment, 2);
  const Bytes colours{1, 2, 3, 4, 5, 6};
  ASSERT_TRUE(panel.load_palette(colours).ok());
  ASSERT_TRUE(panel.write({2, 1, 2, 1}, Bytes{0xAB}, 1).ok());
  EXPECT_EQ(panel.write({1, 1, 2, 1}, Bytes{0xAB}, 1).error(), Error::misaligned);
  inner.gone = true;
  ASSERT_TRUE(panel.write({0, 0, 2, 1}, Bytes{0xCD}, 1).ok());
  EXPECT_EQ(inner.colours, colours);
  EXPECT_EQ(inner.memory, (Bytes{0xCD, 0, 0, 0, 0xAB, 0}));
}

}  // namespace
