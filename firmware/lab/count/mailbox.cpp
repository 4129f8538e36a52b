// SPDX-License-Identifier: MIT
//
// Messages to the plugin in QEMU (host/lab/qemu_counter.cpp): it sees addresses, not values, so what is said
// is where a byte is stored. The plugin finds the symbol's address on its command line.
//   1 begins a count, 2 ends it, 3 ends the program, 256 + b says the byte b of a number, lowest first.
// What clears .bss stores words there, at multiples of four, before the first count.
#include <cstddef>
#include <cstdint>
#include <firmware/lab/count/probe.hpp>

extern "C" {
extern volatile std::uint8_t lab_mailbox[512];
constinit volatile std::uint8_t lab_mailbox[512] = {};
}

namespace lab::probe {

void begin() noexcept { lab_mailbox[1] = 0; }
void end() noexcept { lab_mailbox[2] = 0; }

void report(std::uint32_t value) noexcept {
  for (unsigned shift = 0; shift < 32; shift += 8) lab_mailbox[256U + (value >> shift & 255U)] = 0;
}

void finish() noexcept {
  lab_mailbox[3] = 0;
  for (;;) asm volatile("");
}

}  // namespace lab::probe
