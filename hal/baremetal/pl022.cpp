// SPDX-License-Identifier: MIT
#include <hal/baremetal/pl022.hpp>
#include <hal/baremetal/registers.hpp>

namespace hal::baremetal {

namespace {

enum Offset : std::uintptr_t {
  control_0 = 0x00,
  control_1 = 0x04,
  data = 0x08,
  status = 0x0C,
  prescale = 0x10
};

constexpr std::uint32_t transmit_not_full = 1U << 1U;
constexpr std::uint32_t receive_not_empty = 1U << 2U;
constexpr std::uint32_t busy = 1U << 4U;

}  // namespace

void Pl022::start() noexcept {
  constexpr std::uint32_t eight_bits = 7;
  constexpr std::uint32_t mode_3 = 3U << 6U;
  constexpr std::uint32_t port_enable = 1U << 1U;
  write_register(registers_ + control_1, 0);
  write_register(registers_ + prescale, 2);
  write_register(registers_ + control_0, eight_bits | mode_3);
  write_register(registers_ + control_1, port_enable);
}

// What comes in is nobody's; unread, it would fill the receive FIFO and raise overrun.
void Pl022::drain() noexcept {
  while ((read_register(registers_ + status) & receive_not_empty) != 0)
    static_cast<void>(read_register(registers_ + data));
}

Status Pl022::do_write(std::span<const std::uint8_t> bytes) noexcept {
  for (const std::uint8_t byte : bytes) {
    while ((read_register(registers_ + status) & transmit_not_full) == 0) {
    }
    write_register(registers_ + data, byte);
    drain();
  }
  // The caller may change the data/command line as soon as this returns, so the last bit must be out.
  while ((read_register(registers_ + status) & busy) != 0) {
  }
  drain();
  return {};
}

}  // namespace hal::baremetal
