// SPDX-License-Identifier: MIT
#include <hal/panels/command_port.hpp>

#include <array>

namespace hal::panels {

Status SpiPort::do_command(std::span<const std::uint8_t> bytes) noexcept {
  if (const Status s = data_command_->set(false); !s.ok()) return s;
  return bus_->write(bytes);
}

Status SpiPort::do_data(std::span<const std::uint8_t> bytes) noexcept {
  if (const Status s = data_command_->set(true); !s.ok()) return s;
  return bus_->write(bytes);
}

Status I2cPort::do_command(std::span<const std::uint8_t> bytes) noexcept {
  constexpr std::array<std::uint8_t, 1> more_commands{0x00};
  constexpr std::array<std::uint8_t, 1> one_command{0x80};
  if (framing_ == I2cFraming::stream) return bus_->write(address_, more_commands, bytes);
  for (std::size_t i = 0; i < bytes.size(); ++i)
    if (const Status s = bus_->write(address_, one_command, bytes.subspan(i, 1)); !s.ok()) return s;
  return {};
}

Status I2cPort::do_data(std::span<const std::uint8_t> bytes) noexcept {
  constexpr std::array<std::uint8_t, 1> memory{0x40};
  return bus_->write(address_, memory, bytes);
}

}  // namespace hal::panels
