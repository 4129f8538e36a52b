// SPDX-License-Identifier: MIT
#include <hal/mock/doubles.hpp>

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <vector>

namespace {

using hal::Capabilities;
using hal::Error;
using hal::Part;
using hal::Rect;
using hal::Status;
using hal::mock::MockPanel;
using testing::_;
using testing::NiceMock;
using testing::Return;
using testing::StrictMock;

constexpr Capabilities write_panel{.width = 20,
                                   .height = 10,
                                   .bits_per_pixel = 4,
                                   .palette_entries = 16,
                                   .x_alignment = 4,
                                   .y_alignment = 3};
constexpr Capabilities scan_out{.width = 20, .height = 10, .palette_entries = 16, .buffers = 2};

/// A panel whose driver must not be reached.
class RefusingPanel : public testing::Test {
 protected:
  static void expect_refused(MockPanel& panel, Error error, Part part) {
    EXPECT_CALL(panel, do_write(_, _, _)).Times(0);
    EXPECT_CALL(panel, do_show(_, _)).Times(0);
    EXPECT_CALL(panel, do_load_palette(_)).Times(0);
    EXPECT_CALL(panel, do_refused(Status(error, part)));
  }
  static void refuses_write(const Rect& area, Error error, Part part, std::size_t bytes = 1000,
                            int stride = 10) {
    NiceMock<MockPanel> panel(write_panel);
    expect_refused(panel, error, part);
    const std::vector<std::uint8_t> pixels(bytes);
    EXPECT_EQ(panel.write(area, pixels, stride), Status(error, part));
  }
};

TEST_F(RefusingPanel, WriteOutsideThePanel) {
  constexpr int most = std::numeric_limits<int>::max();
  constexpr int least = std::numeric_limits<int>::min();
  for (const Rect& r :
       {Rect{-4, 0, 4, 3}, Rect{0, -3, 4, 3}, Rect{20, 0, 4, 3}, Rect{0, 10, 4, 3}, Rect{16, 0, 8, 3},
        Rect{0, 9, 4, 3}, Rect{0, 0, 0, 3}, Rect{0, 0, 4, -3}, Rect{most, 0, most, 3}, Rect{4, 0, most, 3},
        Rect{0, 3, 4, most}, Rect{least, least, 4, 3}, Rect{0, 0, least, 3}})
    refuses_write(r, Error::invalid, Part::rectangle);
}

TEST_F(RefusingPanel, MisalignedWrite) {
  for (const Rect& r : {Rect{1, 0, 4, 3}, Rect{0, 1, 4, 3}, Rect{0, 0, 5, 3}, Rect{0, 0, 4, 4}})
    refuses_write(r, Error::misaligned, Part::rectangle);
}

TEST_F(RefusingPanel, TooFewPixelsOrTooShortAStride) {
  refuses_write({0, 0, 8, 3}, Error::invalid, Part::stride, 1000, 3);
  refuses_write({0, 0, 8, 3}, Error::invalid, Part::pixels, 23, 10);
  refuses_write({0, 0, 8, 3}, Error::invalid, Part::pixels, 0, std::numeric_limits<int>::max());
}

TEST_F(RefusingPanel, ScanOutCallsOnAWritePanelAndTheOtherWayRound) {
  NiceMock<MockPanel> writes(write_panel);
  expect_refused(writes, Error::unsupported, Part::buffer);
  EXPECT_EQ(writes.show(0, {}), Status(Error::unsupported, Part::buffer));
  EXPECT_TRUE(writes.buffer(0).empty());
  NiceMock<MockPanel> scans(scan_out);
  expect_refused(scans, Error::unsupported, Part::buffer);
  const std::vector<std::uint8_t> pixels(1000);
  EXPECT_EQ(scans.write({0, 0, 20, 10}, pixels, 20), Status(Error::unsupported, Part::buffer));
}

TEST_F(RefusingPanel, BufferThatDoesntExist) {
  for (const int index : {-1, 2, std::numeric_limits<int>::max()}) {
    NiceMock<MockPanel> panel(scan_out);
    expect_refused(panel, Error::invalid, Part::buffer);
    EXPECT_EQ(panel.show(index, {}), Status(Error::invalid, Part::buffer));
    EXPECT_CALL(panel, do_buffer(_)).Times(0);
    EXPECT_TRUE(panel.buffer(index).empty());
  }
}

TEST_F(RefusingPanel, PaletteTooLongOrOfPartEntries) {
  for (const std::size_t bytes : {1U, 2U, 47U, 49U, 51U}) {
    const std::vector<std::uint8_t> palette(bytes);
    NiceMock<MockPanel> panel(scan_out);
    expect_refused(panel, Error::invalid, Part::palette);
    EXPECT_EQ(panel.show(0, palette), Status(Error::invalid, Part::palette));
    NiceMock<MockPanel> loads(scan_out);
    expect_refused(loads, Error::invalid, Part::palette);
    EXPECT_EQ(loads.load_palette(palette), Status(Error::invalid, Part::palette));
  }
}

TEST(Panel, GoodArgumentsReachTheDriver) {
  NiceMock<MockPanel> panel(write_panel);
  EXPECT_CALL(panel, do_refused(_)).Times(0);
  const std::vector<std::uint8_t> pixels(24);
  EXPECT_CALL(panel, do_write(Rect{0, 0, 8, 3}, _, 10)).WillOnce(Return(Status(Error::bus, Part::bus)));
  EXPECT_EQ(panel.write({0, 0, 8, 3}, pixels, 10), Status(Error::bus, Part::bus));
  // The far edges needn't be aligned.
  EXPECT_CALL(panel, do_write(Rect{16, 9, 4, 1}, _, 2));
  EXPECT_TRUE(panel.write({16, 9, 4, 1}, pixels, 2).ok());
}

TEST(I2cBus, AddressHasSevenBits) {
  StrictMock<hal::mock::MockI2cBus> bus;
  EXPECT_EQ(bus.write(0x80, {}, {}), Status(Error::invalid, Part::bus));
}

TEST(SpiBus, NothingToSendIsNoTransfer) {
  StrictMock<hal::mock::MockSpiBus> bus;
  EXPECT_TRUE(bus.write({}).ok());
}

TEST(Doubles, AnswerNothingUntilToldOtherwise) {
  NiceMock<hal::mock::MockClock> clock;
  EXPECT_EQ(clock.now(), 0U);
  NiceMock<hal::mock::MockInput> input;
  EXPECT_FALSE(input.poll().held(hal::Key::select));
  NiceMock<hal::mock::MockOutputPin> pin;
  EXPECT_CALL(pin, do_set(true)).WillOnce(Return(Status(Error::bus, Part::pin)));
  EXPECT_FALSE(pin.set(true).ok());
}

}  // namespace
