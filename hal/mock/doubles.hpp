// SPDX-License-Identifier: MIT
//
// GoogleMock doubles of every interface of the border to hardware.
//
// Rule: a double answers success and zeros until a test expects something else. The panel's argument checks
// are those of `hal::Panel`, so `do_write` and the others are called with good arguments only.
#pragma once

#include <hal/bus.hpp>
#include <hal/clock.hpp>
#include <hal/input.hpp>
#include <hal/panel.hpp>
#include <hal/pin.hpp>

#include <gmock/gmock.h>

namespace hal::mock {

// An expectation that a test set up wrongly throws, and that may well end a test program.
// NOLINTBEGIN(bugprone-exception-escape)

class MockPanel : public Panel {
 public:
  explicit MockPanel(const Capabilities& capabilities) : capabilities_(capabilities) {
    ON_CALL(*this, do_capabilities()).WillByDefault(testing::ReturnRef(capabilities_));
  }
  virtual ~MockPanel() = default;

  MOCK_METHOD(const Capabilities&, do_capabilities, (), (const, noexcept, override));
  MOCK_METHOD(std::span<std::uint8_t>, do_buffer, (int index), (noexcept, override));
  MOCK_METHOD(int, do_buffer_stride, (), (const, noexcept, override));
  MOCK_METHOD(Status, do_show, (int index, std::span<const std::uint8_t> palette), (noexcept, override));
  MOCK_METHOD(bool, do_show_pending, (), (noexcept, override));
  MOCK_METHOD(Status, do_write, (const Rect& area, std::span<const std::uint8_t> pixels, int stride),
              (noexcept, override));
  MOCK_METHOD(Status, do_load_palette, (std::span<const std::uint8_t> palette), (noexcept, override));
  MOCK_METHOD(std::uint32_t, do_vblank_count, (), (noexcept, override));
  MOCK_METHOD(Status, do_wait_for_vblank, (), (noexcept, override));
  MOCK_METHOD(void, do_refused, (Status status), (noexcept, override));

 private:
  Capabilities capabilities_;
};

class MockOutputPin : public OutputPin {
 public:
  virtual ~MockOutputPin() = default;
  MOCK_METHOD(Status, do_set, (bool high), (noexcept, override));
};

class MockSpiBus : public SpiBus {
 public:
  virtual ~MockSpiBus() = default;
  MOCK_METHOD(Status, do_write, (std::span<const std::uint8_t> bytes), (noexcept, override));
};

class MockI2cBus : public I2cBus {
 public:
  virtual ~MockI2cBus() = default;
  MOCK_METHOD(Status, do_write,
              (std::uint8_t address, std::span<const std::uint8_t> prefix,
               std::span<const std::uint8_t> bytes),
              (noexcept, override));
};

class MockClock : public Clock {
 public:
  virtual ~MockClock() = default;
  MOCK_METHOD(Nanoseconds, do_now, (), (noexcept, override));
  MOCK_METHOD(void, do_wait_until, (Nanoseconds time), (noexcept, override));
};

class MockInput : public Input {
 public:
  virtual ~MockInput() = default;
  MOCK_METHOD(Keys, do_poll, (), (noexcept, override));
};

// NOLINTEND(bugprone-exception-escape)

}  // namespace hal::mock
