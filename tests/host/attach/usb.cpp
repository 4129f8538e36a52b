// SPDX-License-Identifier: MIT
//
// Panels on USB with models of the devices behind a hidapi that isn't there.
#include <hal/hid/host/gaming_lcd.hpp>
#include <hal/hid/host/hidapi.hpp>
#include <hal/hid/host/mcp2221.hpp>
#include <hal/hid/host/replug_panel.hpp>
#include <hal/mock/strict_ssd1306.hpp>
#include <host/attach/attach.hpp>
#include <host/failure.hpp>
#include <tests/hal/hid/bridge.hpp>
#include <tests/hal/hid/keyboard.hpp>
#include <tests/hal/hid/wire.hpp>
#include <tests/host/attach/hidapi/fake_hidapi.hpp>
#include <tests/host/attach/test_card.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

namespace {

using fake_hidapi::bus;
using host::AttachOptions;
using testing::AllOf;
using testing::HasSubstr;
using tests::hid::Bytes;

constexpr std::uint32_t fast = 1'000'000;  // so many frames in 1000 s take no time

fake_hidapi::Device g13(const char* path, hal::hid::ReportPort& model, const wchar_t* serial = L"") {
  return {.path = path,
          .vendor = hal::hid::logitech,
          .product_number = 0xC21C,
          .serial = serial,
          .product = L"G13",
          .numbered = true,
          .model = &model};
}
fake_hidapi::Device mcp2221(const char* path, hal::hid::ReportPort& model) {
  return {.path = path,
          .vendor = hal::hid::microchip,
          .product_number = hal::hid::mcp2221_product,
          .product = L"MCP2221",
          .model = &model};
}
fake_hidapi::Device own(const char* path, hal::hid::ReportPort& model) {
  return {.path = path,
          .vendor = hal::hid::test_vendor,
          .product_number = hal::hid::test_product,
          .serial = L"S1",
          .product = L"Intaglio display",
          .usage_page = hal::hid::usage_page,
          .usage = hal::hid::usage,
          .model = &model};
}

class OnUsb : public testing::Test {
 protected:
  OnUsb() { fake_hidapi::reset(); }
  ~OnUsb() override { EXPECT_EQ(bus().open, 0) << "devices are still open"; }

  /// Whoever looks for devices the second time from now on finds this one.
  static void comes_back(
      const fake_hidapi::Device& device, const std::function<void()>& restart = [] {}) {
    bus().on_look = [=, looks = 0]() mutable {
      if (++looks != 2) return;
      restart();
      bus().devices.push_back(device);
    };
  }
  static std::string refusal(const char* panel) {
    try {
      static_cast<void>(host::attach({.panel = panel}));
    } catch (const host::Failure& failure) {
      return failure.what();
    }
    return "it was accepted";
  }
};

/// What a keyboard shows of the test card when nothing happens to it.
Bytes card_on_keyboard(std::uint32_t frames) {
  fake_hidapi::reset();
  tests::hid::Keyboard keyboard;
  bus().devices = {g13("/dev/hidraw0", keyboard)};
  const auto attached = host::attach({.panel = "hid:g13", .refresh_millihertz = fast});
  EXPECT_TRUE(host::run_test_card(attached->panel(), frames).ok());
  return keyboard.glass;
}

TEST_F(OnUsb, AKeyboardThatIsReplugged) {
  const Bytes card = card_on_keyboard(4);
  tests::hid::Keyboard keyboard;
  bus().devices = {g13("/dev/hidraw3", keyboard)};
  {
    const auto attached = host::attach({.panel = "hid:g13", .refresh_millihertz = fast});
    bus().writes_left = 2;
    comes_back(g13("/dev/hidraw7", keyboard), [&] { std::ranges::fill(keyboard.glass, std::uint8_t{0xAA}); });
    ASSERT_TRUE(host::run_test_card(attached->panel(), 4).ok()) << attached->fault();
    EXPECT_EQ(keyboard.glass, card);
    EXPECT_EQ(attached->notices(),
              "046d:c21c (G13) at /dev/hidraw3 was unplugged (writing)\n"
              "046d:c21c (G13) at /dev/hidraw7 is back\n");
    EXPECT_EQ(attached->notices(), "");
    EXPECT_EQ(attached->fault(), "");
    EXPECT_EQ(attached->counters(), "hid_reconnects 1\n");
  }
  EXPECT_EQ(std::ranges::count(keyboard.glass, 0), 991) << "left blank";
}

/// A keyboard's display on the desk's bus, with a clock that doesn't keep anyone waiting.
struct Desk {
  hal::sim::VirtualClock clock;
  hal::hid::HidApiPort port;
  hal::hid::GamingLcd driver{port};
  hal::hid::ReplugPanel panel{driver, port, clock, [] { return hal::Status{}; }, 5'000'000'000};

  Desk()
      : port(hal::hid::HidApi::over(hal::hid::HidApi::Way::hidraw),
             hal::hid::HidApi::over(hal::hid::HidApi::Way::hidraw).devices().at(0),
             hal::hid::Numbering::numbered) {}
  hal::Status draw() { return panel.write({0, 0, 160, 43}, Bytes(20 * 43), 20); }
};

TEST_F(OnUsb, ADeviceThatNeverComesBackIsNamed) {
  tests::hid::Keyboard keyboard;
  bus().devices = {g13("/dev/hidraw3", keyboard)};
  Desk desk;
  bus().unplug("/dev/hidraw3");
  EXPECT_EQ(desk.draw().error(), hal::Error::disconnected);
  EXPECT_EQ(desk.port.fault(), "046d:c21c (G13) at /dev/hidraw3 was unplugged and isn't back");
  EXPECT_GE(desk.clock.now(), hal::Nanoseconds{5'000'000'000});
}

TEST_F(OnUsb, AnotherDeviceOfTheSameKindIsNotTaken) {
  tests::hid::Keyboard keyboard;
  tests::hid::Keyboard other;
  bus().devices = {g13("/dev/hidraw3", keyboard, L"A")};
  Desk desk;
  bus().devices = {g13("/dev/hidraw4", other, L"B")};
  EXPECT_EQ(desk.draw().error(), hal::Error::disconnected);
  EXPECT_EQ(
      desk.port.fault(),
      "046d:c21c (G13) at /dev/hidraw3 was unplugged and isn't back; the one at /dev/hidraw4 has another "
      "serial number: B");
  EXPECT_EQ(other.reports, 0);
}

TEST_F(OnUsb, ADeviceThatMayNotBeOpenedWhenItIsBackIsSaid) {
  tests::hid::Keyboard keyboard;
  bus().devices = {g13("/dev/hidraw3", keyboard)};
  Desk desk;
  bus().devices = {g13("/dev/hidraw4", keyboard)};
  bus().devices[0].locked = true;
  EXPECT_EQ(desk.draw().error(), hal::Error::disconnected);
  EXPECT_THAT(desk.port.fault(),
              HasSubstr("is back at /dev/hidraw4, but can't be opened: permission denied"));
  bus().devices[0].locked = false;
  EXPECT_TRUE(desk.draw().ok());
}

/// Keys are pressed, and then the cable is pulled: reports that nobody has read still come.
class LastWords final : public hal::hid::ReportPort {
 public:
  int words = 0;
  bool deaf = false;

 private:
  hal::Status do_send(std::span<const std::uint8_t>) noexcept override {
    return deaf ? hal::Status{hal::Error::bus, hal::Part::bus} : hal::Status{};
  }
  hal::hid::Received do_receive(std::span<std::uint8_t> report, hal::Nanoseconds) noexcept override {
    if (words == 0) return {{deaf ? hal::Error::disconnected : hal::Error::timeout, hal::Part::panel}, 0};
    report[0] = static_cast<std::uint8_t>(words--);
    return {{}, 1};
  }
  hal::Status do_reopen() noexcept override { return {}; }
};

TEST_F(OnUsb, UnreadReportsDoNotHideThatADeviceIsGone) {
  LastWords model;
  bus().devices = {g13("/dev/hidraw3", model)};
  Desk desk;
  model.words = 3;
  EXPECT_TRUE(desk.port.look().ok());
  model.words = 3;
  EXPECT_TRUE(desk.port.look().ok());
  // What was said is still heard, in its order.
  Bytes report(8);
  for (const int word : {3, 2, 1, 3, 2, 1}) {
    ASSERT_TRUE(desk.port.receive(report, 0).status.ok());
    EXPECT_EQ(report[0], word);
  }
  model.words = 2;
  model.deaf = true;
  EXPECT_EQ(desk.port.send(report).error(), hal::Error::disconnected);
  EXPECT_THAT(desk.port.fault(), HasSubstr("was unplugged"));
}

TEST_F(OnUsb, NamesOfDevicesDoNothingToATerminal) {
  tests::hid::Keyboard keyboard;
  auto device = g13("/dev/hidraw3", keyboard);
  device.product =
      L"G\x1b[2J1\x9b"
      L"2J3\x7f\u00e9\n";
  auto without_file = device;
  without_file.path = "";
  bus().devices = {without_file, device};
  EXPECT_THAT(host::list_attached(), testing::Contains("--panel hid:g13: G[2J12J3é at /dev/hidraw3"));
}

TEST_F(OnUsb, ADisplayBehindABridgeThatIsRepluggedInMidTransfer) {
  constexpr std::uint32_t frames = 3;
  hal::sim::VirtualClock clock;
  auto glass = std::make_unique<hal::mock::StrictSsd1306>(128, 64);
  tests::hid::Bridge bridge(clock, glass->i2c(), 0x3C);
  bus().devices = {mcp2221("/dev/hidraw1", bridge)};
  const AttachOptions options{.panel = "hid:mcp2221/ssd1306@3c", .refresh_millihertz = fast};
  {
    const auto attached = host::attach(options);
    ASSERT_TRUE(host::run_test_card(attached->panel(), frames).ok());
  }
  const auto attached = host::attach(options);
  ASSERT_TRUE(host::run_test_card(attached->panel(), frames).ok());
  const hal::mock::Pattern undisturbed = glass->displayed();
  bus().writes_left = 100;
  comes_back(mcp2221("/dev/hidraw2", bridge), [&] {
    glass = std::make_unique<hal::mock::StrictSsd1306>(128, 64);
    bridge.restart(glass->i2c());
  });
  ASSERT_TRUE(host::run_test_card(attached->panel(), frames).ok()) << attached->fault();
  EXPECT_TRUE(glass->on());
  EXPECT_EQ(side_by_side(undisturbed, glass->displayed(), false), "");
  EXPECT_THAT(attached->notices(), AllOf(HasSubstr("04d8:00dd (MCP2221) at /dev/hidraw1 was unplugged"),
                                         HasSubstr("at /dev/hidraw2 is back")));
  EXPECT_EQ(attached->counters(), "hid_reconnects 1\n");
}

TEST_F(OnUsb, NothingBehindABridgeIsSaid) {
  hal::sim::VirtualClock clock;
  hal::mock::StrictSsd1306 glass(128, 64);
  tests::hid::Bridge bridge(clock, glass.i2c(), 0x3D);
  bus().devices = {mcp2221("/dev/hidraw1", bridge)};
  EXPECT_THAT(refusal("hid:mcp2221/ssd1306@3c"), HasSubstr("nothing answers at that address"));
  EXPECT_THAT(refusal("hid:g13"), HasSubstr("no device for --panel hid:g13 is plugged in"));
}

/// A display of the report protocol.
struct Display {
  explicit Display(int width) : glass(hal::sim::paletted(width, 24, 8), clock) {}
  hal::sim::VirtualClock clock;
  hal::sim::Panel glass;
  hal::hid::Device device{glass, nullptr, {}};
  tests::hid::Wire wire{clock, device};
};

TEST_F(OnUsb, ADisplayOfOurOwnThatIsReplugged) {
  Display display(32);
  bus().devices = {own("/dev/hidraw1", display.wire)};
  const auto attached = host::attach({.panel = "hid:intaglio"});
  bus().writes_left = 20;
  comes_back(own("/dev/hidraw2", display.wire), [&] { display.device.unplugged(); });
  ASSERT_TRUE(host::run_test_card(attached->panel(), 4).ok()) << attached->fault();
  EXPECT_EQ(attached->notices(),
            "1209:0002 (Intaglio display) at /dev/hidraw1 was unplugged (writing)\n"
            "1209:0002 (Intaglio display) at /dev/hidraw2 is back\n");
  EXPECT_THAT(attached->counters(), HasSubstr("hid_reconnects 1\n"));
}

TEST_F(OnUsb, ADisplayOfOurOwnThatComesBackAsAnotherIsSaid) {
  Display display(32);
  Display other(40);
  bus().devices = {own("/dev/hidraw1", display.wire)};
  const auto attached = host::attach({.panel = "hid:intaglio"});
  bus().writes_left = 20;
  comes_back(own("/dev/hidraw2", other.wire));
  EXPECT_FALSE(host::run_test_card(attached->panel(), 4).ok());
  EXPECT_EQ(attached->fault(),
            "1209:0002 (Intaglio display) at /dev/hidraw2 is back, but not as the display that it was");
}

}  // namespace
