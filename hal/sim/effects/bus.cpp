// SPDX-License-Identifier: MIT
#include <hal/sim/effects/bus.hpp>

namespace hal::sim {

Nanoseconds Bus::time_of(std::uint64_t bytes) const {
  constexpr std::uint64_t second = 1'000'000'000;
  const std::uint64_t clocks = bytes * static_cast<std::uint64_t>(timing_.clocks_per_byte);
  const std::uint64_t rate = timing_.hertz;
  return timing_.gap + clocks / rate * second + clocks % rate * second / rate;
}

std::uint64_t Bus::send_command(std::uint64_t bytes, VirtualClock& clock) const {
  note_call(Effect::bus);
  clock.advance(time_of(bytes));
  return bytes;
}

}  // namespace hal::sim
