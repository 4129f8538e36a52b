// SPDX-License-Identifier: MIT
#include <hal/baremetal/core.hpp>
#include <hal/baremetal/registers.hpp>
#include <hal/baremetal/systick.hpp>

namespace hal::baremetal {

namespace {
enum Offset : std::uintptr_t { control = 0x00, reload = 0x04, current = 0x08 };
}  // namespace

void SysTick::start() noexcept {
  constexpr std::uint32_t run_on_core_clock_with_interrupt = 7;
  write_register(registers_ + reload, cycles_ - 1);
  write_register(registers_ + current, 0);
  write_register(registers_ + control, run_on_core_clock_with_interrupt);
}

void SysTick::on_interrupt() noexcept {
  const std::uint32_t low = ticks_low_ + 1;
  ticks_low_ = low;
  if (low == 0) ticks_high_ = ticks_high_ + 1;
}

std::uint32_t SysTick::cycles() const noexcept {
  for (;;) {
    const std::uint32_t ticks = ticks_low_;
    const std::uint32_t left = read_register(registers_ + current);
    // At 0 a tick is due, and whether it has been counted isn't known.
    if (left != 0 && ticks_low_ == ticks) return ticks * cycles_ + (cycles_ - left);
  }
}

Nanoseconds SysTick::do_now() noexcept {
  for (;;) {
    const std::uint32_t high = ticks_high_;
    const std::uint32_t low = ticks_low_;
    if (ticks_high_ == high && ticks_low_ == low) return (std::uint64_t{high} << 32U | low) * tick_length_;
  }
}

void SysTick::do_wait_until(Nanoseconds time) noexcept {
  sleep_until([&] { return do_now() >= time; });
}

}  // namespace hal::baremetal
