// SPDX-License-Identifier: MIT
//
// The device side by itself: what it answers to single reports.
#include <hal/hid/device/device.hpp>
#include <hal/sim/panel.hpp>

#include <gtest/gtest.h>

#include <vector>

namespace {

using namespace hal::hid;
using Bytes = std::vector<std::uint8_t>;

class HidDevice : public testing::Test {
 public:
  static constexpr std::uint32_t nonce = 0x1205;

  void give(ReportType type, std::span<const std::uint8_t> payload, std::uint16_t sequence = 0,
            std::uint8_t mark = nonce & 0xFF) {
    Bytes report(64);
    compose(report, {type, mark, sequence, payload});
    device.receive(report);
  }
  void hello(std::uint32_t with = nonce) {
    give(ReportType::hello, encode(Hello{with, false}));
    listen();
  }
  /// All that the device has to say.
  std::vector<Bytes> listen() {
    std::vector<Bytes> all;
    Bytes report(64);
    while (device.next(report) != 0 && all.size() < 10) all.push_back(report);
    return all;
  }
  /// The one STATUS that it has to say.
  DeviceState state() {
    const auto all = listen();
    EXPECT_EQ(all.size(), 1U);
    if (all.empty()) return {};
    const auto report = parse(all[0]);
    EXPECT_TRUE(report && report->type == ReportType::status);
    return decode_state(*report).value_or(DeviceState{});
  }

  hal::sim::VirtualClock clock;
  hal::sim::Panel glass{hal::sim::paletted(8, 4, 8), clock};
  Device device{glass, nullptr, {}};
  const Bytes nothing{};
  const Bytes skip{0xC0};
};

TEST_F(HidDevice, SaysNothingUnasked) {
  device.poll();
  EXPECT_TRUE(listen().empty());
  hello();
  device.poll();
  EXPECT_TRUE(listen().empty());
}

TEST_F(HidDevice, SaysNothingOfAnEarlierSession) {
  give(ReportType::hello, encode(Hello{nonce, true}));
  listen();
  clock.advance(20'000'000);
  device.poll();
  device.unplugged();
  clock.advance(20'000'000);
  device.poll();
  give(ReportType::hello, encode(Hello{nonce + 1, true}));
  const auto all = listen();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0][0], 0x81);
}

TEST_F(HidDevice, ComplainsOfReportsOfNoSession) {
  give(ReportType::pixels, skip, 0, 9);
  const auto all = listen();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0][1], 9) << "the mark it complains of";
  EXPECT_EQ(all[0][6], 2) << "no session";
  hello();
  give(ReportType::pixels, skip, 0, 9);
  EXPECT_EQ(listen().size(), 1U);
  EXPECT_EQ(device.counters().accepted, 0U);
}

TEST_F(HidDevice, KeepsItsSessionWhenGreetedAgain) {
  hello();
  for (std::uint16_t n = 0; n < 3; ++n) give(ReportType::pixels, nothing, n);
  give(ReportType::hello, encode(Hello{nonce, false}));
  const auto all = listen();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0][0], 0x81);
  EXPECT_EQ(all[0][2], 3) << "the number it expects";
  give(ReportType::pixels, nothing, 3);
  EXPECT_EQ(device.counters().accepted, 4U);
  hello(nonce + 1);
  give(ReportType::pixels, nothing, 0, (nonce & 0xFF) + 1);
  EXPECT_EQ(device.counters().accepted, 5U);
}

TEST_F(HidDevice, AnswersWhatArrivesTwiceAndTellsAGapOnce) {
  hello();
  give(ReportType::pixels, nothing, 0);
  EXPECT_TRUE(listen().empty()) << "one report is nothing to acknowledge";
  give(ReportType::pixels, nothing, 0);
  EXPECT_EQ(state().next, 1);
  give(ReportType::pixels, nothing, 5);
  EXPECT_TRUE(state().gap);
  give(ReportType::pixels, nothing, 6);
  EXPECT_TRUE(listen().empty());
  give(ReportType::pixels, nothing, 1);
  give(ReportType::pixels, nothing, 1);
  EXPECT_FALSE(state().gap);
  EXPECT_EQ(device.counters().repeated, 2U);
  EXPECT_EQ(device.counters().early, 2U);
}

TEST_F(HidDevice, AcknowledgesHalfOfWhatMayBeOnTheWay) {
  hello();
  for (std::uint16_t n = 0; n < 7; ++n) give(ReportType::pixels, nothing, n);
  EXPECT_TRUE(listen().empty());
  give(ReportType::pixels, nothing, 7);
  EXPECT_EQ(state().next, 8);
}

TEST_F(HidDevice, SaysWhatIsWrongWithAFrame) {
  const auto verdict_of = [this](ReportType type, const Bytes& payload) {
    hello(nonce);
    device.unplugged();
    hello(nonce);
    give(type, payload, 0);
    give(ReportType::commit, encode(Commit{3, 0}), 1);
    const DeviceState s = state();
    EXPECT_EQ(s.decided, 3);
    return s.verdict;
  };
  EXPECT_EQ(verdict_of(ReportType::rectangle, {0, 0, 0, 0, 8, 0, 4}), Verdict::malformed);
  EXPECT_EQ(verdict_of(ReportType::rectangle, {0, 0, 0, 0, 9, 0, 4, 0}), Verdict::outside);
  EXPECT_EQ(verdict_of(ReportType::rectangle, {8, 0, 0, 0, 1, 0, 1, 0}), Verdict::outside);
  EXPECT_EQ(verdict_of(ReportType::rectangle, {0, 0, 0, 0, 0, 0, 1, 0}), Verdict::outside);
  EXPECT_EQ(verdict_of(ReportType::rectangle, {0, 0, 0, 0, 8, 0, 4, 0, 0xFE, 33, 0, 1}), Verdict::outside);
  EXPECT_EQ(verdict_of(ReportType::rectangle, {0, 0, 0, 0, 8, 0, 4, 0, 0xFE, 32, 0, 1}), Verdict::mismatch);
  EXPECT_EQ(verdict_of(ReportType::rectangle, {0, 0, 0, 0, 8, 0, 4, 0, 0x03, 1}), Verdict::malformed);
  EXPECT_EQ(verdict_of(ReportType::pixels, {0xC0}), Verdict::outside) << "no rectangle";
  EXPECT_EQ(verdict_of(ReportType::palette, {0}), Verdict::malformed);
  EXPECT_EQ(verdict_of(ReportType::pixels, {}), Verdict::mismatch);
  EXPECT_EQ(device.counters().committed, 0U);
}

TEST_F(HidDevice, TakesNoPanelThatTheProtocolDoesNotHave) {
  hal::sim::Panel wide(hal::sim::paletted(4097, 1, 1), clock);
  EXPECT_EQ(Device(wide, nullptr, {}).status().part(), hal::Part::panel);
  hal::sim::Panel wider(hal::sim::paletted(65'536 + 8, 1, 1), clock);
  EXPECT_EQ(Device(wider, nullptr, {}).status().part(), hal::Part::panel) << "it would look 8 pixels wide";
  hal::sim::Panel single(hal::sim::paletted(8, 4, 8, 1), clock);
  Bytes memory(31);
  EXPECT_EQ(Device(single, nullptr, memory).status().part(), hal::Part::buffer);
  memory.resize(32);
  EXPECT_TRUE(Device(single, nullptr, memory).status().ok());
  EXPECT_EQ(Device(glass, nullptr, {}, {.report_bytes = 63}).status().error(), hal::Error::invalid);
  EXPECT_EQ(Device(glass, nullptr, {}, {.window = 17}).status().error(), hal::Error::invalid);
}

TEST_F(HidDevice, DescribesItselfInAFeature) {
  Bytes report(64);
  device.describe(report);
  const auto feature = parse(report);
  ASSERT_TRUE(feature);
  const auto info = decode_info(feature->payload);
  ASSERT_TRUE(info);
  EXPECT_EQ(info->capabilities.width, 8);
  EXPECT_EQ(info->capabilities.palette_entries, 256);
  EXPECT_EQ(info->nonce, 0U);
}

}  // namespace
