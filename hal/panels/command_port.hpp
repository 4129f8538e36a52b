// SPDX-License-Identifier: MIT
//
// How bytes reach a display controller: as commands or as data.
//
// Rule: a controller takes the same bytes over SPI, where a line says which they are, and over I2C, where a
// control byte in front of them does. A driver knows only this port. Parameters of a command travel as
// commands on a SSD1306 or SSD0323, and as data on a SSD1322 and on everything that speaks MIPI DCS (ST7789,
// ILI9341), so a driver says which.
#pragma once

#include <hal/bus.hpp>
#include <hal/pin.hpp>

#include <cstdint>
#include <span>

namespace hal::panels {

class CommandPort {
 public:
  CommandPort(const CommandPort&) = delete;
  CommandPort& operator=(const CommandPort&) = delete;

  /// Sends whole commands with their parameters, all of them as commands. Errors: bus, pin.
  Status command(std::span<const std::uint8_t> bytes) noexcept { return do_command(bytes); }
  /// Sends one command whose parameters travel as data. Errors: bus, pin.
  Status command(std::uint8_t code, std::span<const std::uint8_t> parameters) noexcept;
  /// Sends commands whose parameters travel as data: code, number of parameters, parameters; code …
  Status sequence(std::span<const std::uint8_t> commands) noexcept;
  /// Sends what goes to the display memory. Errors: bus, pin.
  Status data(std::span<const std::uint8_t> bytes) noexcept { return do_data(bytes); }

 protected:
  constexpr CommandPort() noexcept = default;
  ~CommandPort() = default;

 private:
  virtual Status do_command(std::span<const std::uint8_t> bytes) noexcept = 0;
  virtual Status do_data(std::span<const std::uint8_t> bytes) noexcept = 0;
};

/// SPI with a data/command line: low for commands, high for data. The line belongs to the port: it is driven
/// only when it has to change.
class SpiPort final : public CommandPort {
 public:
  SpiPort(SpiBus& bus, OutputPin& data_command) noexcept : bus_(&bus), data_command_(&data_command) {}

 private:
  Status do_command(std::span<const std::uint8_t> bytes) noexcept override;
  Status do_data(std::span<const std::uint8_t> bytes) noexcept override;

  enum class Line : std::uint8_t { unknown, command, data };
  Status send(Line line, std::span<const std::uint8_t> bytes) noexcept;

  SpiBus* bus_;
  OutputPin* data_command_;
  Line line_ = Line::unknown;
};

/// How commands travel over I2C.
enum class I2cFraming : std::uint8_t {
  stream,  ///< Control byte 0x00, then any number of command bytes.
  single,  ///< One command byte a transaction behind control byte 0x80: an SSD0303, and QEMU's model of it.
};

/// I2C with a control byte.
class I2cPort final : public CommandPort {
 public:
  /// `address` has 7 bits, usually 0x3C or 0x3D.
  I2cPort(I2cBus& bus, std::uint8_t address, I2cFraming framing = I2cFraming::stream) noexcept
      : bus_(&bus), address_(address), framing_(framing) {}

 private:
  Status do_command(std::span<const std::uint8_t> bytes) noexcept override;
  Status do_data(std::span<const std::uint8_t> bytes) noexcept override;

  I2cBus* bus_;
  std::uint8_t address_;
  I2cFraming framing_;
};

}  // namespace hal::panels
