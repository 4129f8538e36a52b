// SPDX-License-Identifier: MIT
#include <hal/baremetal/core.hpp>
#include <hal/baremetal/memory_guard.hpp>
#include <hal/baremetal/registers.hpp>

#include <bit>

namespace hal::baremetal {

namespace {

// From the unit's type register on.
enum Offset : std::uintptr_t { type = 0x00, control = 0x04, number = 0x08, base = 0x0C, attributes = 0x10 };

// The core's fault registers lie so far before the unit's.
constexpr std::uintptr_t fault_status = 0xE000'ED90 - 0xE000'ED28;
constexpr std::uintptr_t fault_address = 0xE000'ED90 - 0xE000'ED34;

}  // namespace

bool MemoryGuard::start() const noexcept {
  constexpr std::uint32_t on_with_default_map = 1U | 1U << 2U;
  const bool has_regions = (read_register(registers_ + type) >> 8U & 0xFFU) != 0;
  if (!has_regions || bytes_ < 32 || !std::has_single_bit(bytes_) || begin_ % bytes_ != 0) return false;
  write_register(registers_ + number, 0);
  write_register(registers_ + base, static_cast<std::uint32_t>(begin_));
  open();
  write_register(registers_ + control, on_with_default_map);
  synchronise();
  return true;
}

void MemoryGuard::set(bool read_only) const noexcept {
  constexpr std::uint32_t enable = 1;
  constexpr std::uint32_t on_chip_ram = 1U << 17U | 1U << 18U;  // cacheable, shareable
  constexpr std::uint32_t never_executed = 1U << 28U;
  const std::uint32_t access = (read_only ? 6U : 3U) << 24U;
  const auto size = static_cast<std::uint32_t>(std::countr_zero(bytes_)) - 1U;
  write_register(registers_ + number, 0);
  write_register(registers_ + attributes, enable | size << 1U | on_chip_ram | access | never_executed);
  synchronise();
}

bool MemoryGuard::caught() const noexcept {
  constexpr std::uint32_t data_access_at_known_address = 1U << 1U | 1U << 7U;
  const std::uint32_t status = read_register(registers_ - fault_status);
  const std::uint32_t address = read_register(registers_ - fault_address);
  return (status & data_access_at_known_address) == data_access_at_known_address && address >= begin_ &&
         address - begin_ < bytes_;
}

}  // namespace hal::baremetal
