// SPDX-License-Identifier: MIT
//
// I2C behind an MCP2221 or MCP2221A, a bridge from USB HID to I2C: reports of 64 bytes, each answered by one.
//
// Rule: a transfer goes out in pieces of 60 bytes, each with the length of the whole; the bridge refuses a
// piece while its engine is still at the last one, and then the piece is sent again. After the last piece the
// state of the engine is asked for until it has come to rest; what the other end didn't acknowledge is told
// there, and the transfer is cancelled so that the bus is free for the next.
#pragma once

#include <hal/bus.hpp>
#include <hal/clock.hpp>
#include <hal/hid/host/patience.hpp>
#include <hal/hid/host/report_port.hpp>

#include <array>
#include <cstdint>

namespace hal::hid {

inline constexpr std::uint16_t microchip = 0x04D8;
inline constexpr std::uint16_t mcp2221_product = 0x00DD;

class Mcp2221I2c final : public I2cBus {
 public:
  Mcp2221I2c(ReportPort& port, Clock& clock) : port_(&port), clock_(&clock) {}

  /// Frees the bus of what was left on it and sets its speed, 46'511 to 400'000 Hz. Errors: invalid bus
  /// (speed), timeout (no answer), bus, disconnected.
  Status start(std::uint32_t hertz = 400'000) noexcept;

 private:
  static constexpr std::size_t report_bytes = 64;
  using Report = std::array<std::uint8_t, report_bytes>;

  Status do_write(std::uint8_t address, std::span<const std::uint8_t> prefix,
                  std::span<const std::uint8_t> bytes) noexcept override;
  Status send_piece(const Report& piece, Patience& patience) noexcept;
  Status settle(Patience& patience) noexcept;
  Status cancel(const Status& why) noexcept;
  Status ask(const Report& command, Report& answer) noexcept;

  ReportPort* port_;
  Clock* clock_;
};

}  // namespace hal::hid
