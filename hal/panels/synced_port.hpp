// SPDX-License-Identifier: MIT
//
// A port to controllers that take parameters as commands (SSD1306, SSD0323).
//
// Rule: such a controller that was cut off inside a command takes the next bytes for its parameters. So
// before the first command, and before the first after a fault, as many no-operations go out as a command has
// parameters at most: the torn one swallows some, the others do nothing.
#pragma once

#include <hal/panels/command_port.hpp>

#include <array>

namespace hal::panels {

class SyncedPort {
 public:
  explicit SyncedPort(CommandPort& port) noexcept : port_(&port) {}

  /// As `CommandPort::command`.
  Status command(std::span<const std::uint8_t> bytes) noexcept {
    constexpr std::uint8_t nop = 0xE3;
    constexpr std::array<std::uint8_t, 8> longest{nop, nop, nop, nop, nop, nop, nop, nop};
    if (torn_)
      if (const Status s = port_->command(longest); !s.ok()) return s;
    const Status sent = port_->command(bytes);
    torn_ = !sent.ok();
    return sent;
  }
  /// As `CommandPort::data`.
  Status data(std::span<const std::uint8_t> bytes) noexcept { return port_->data(bytes); }
  [[nodiscard]] CommandPort& port() noexcept { return *port_; }

 private:
  CommandPort* port_;
  bool torn_ = true;
};

}  // namespace hal::panels
