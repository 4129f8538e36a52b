// SPDX-License-Identifier: MIT
#include <hal/panels/command_port.hpp>

#include <array>

namespace hal::panels {

Status CommandPort::command(std::uint8_t code, std::span<const std::uint8_t> parameters) noexcept {
  if (const Status s = do_command({&code, 1}); !s.ok()) return s;
  return parameters.empty() ? Status{} : do_data(parameters);
}

Status CommandPort::sequence(std::span<const std::uint8_t> commands) noexcept {
  while (commands.size() >= 2) {
    const std::size_t parameters = commands[1];
    if (parameters > commands.size() - 2) return {Error::invalid, Part::command};
    if (const Status s = command(commands[0], commands.subspan(2, parameters)); !s.ok()) return s;
    commands = commands.subspan(2 + parameters);
  }
  return commands.empty() ? Status{} : Status(Error::invalid, Part::command);
}

Status SpiPort::send(Line line, std::span<const std::uint8_t> bytes) noexcept {
  if (line != line_) {
    // Where a fault leaves the line no one knows.
    line_ = Line::unknown;
    if (const Status s = data_command_->set(line == Line::data); !s.ok()) return s;
    line_ = line;
  }
  return bus_->write(bytes);
}

Status SpiPort::do_command(std::span<const std::uint8_t> bytes) noexcept {
  return send(Line::command, bytes);
}

Status SpiPort::do_data(std::span<const std::uint8_t> bytes) noexcept { return send(Line::data, bytes); }

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
