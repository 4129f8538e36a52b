// SPDX-License-Identifier: MIT
//
// What a count program tells whoever counts: where a count begins and ends, and numbers.
//
// Rule: two programs link the same counts. On an emulated core (mailbox.cpp) a message is a byte stored at a
// place of the mailbox, which the plugin in QEMU sees; on the desk (callgrind.cpp) a request to Valgrind.
#pragma once

#include <cstdint>

namespace lab::probe {

/// What executes from here ...
void begin() noexcept;
/// ... to here is one count.
void end() noexcept;
/// A number that belongs to the last count.
void report(std::uint32_t value) noexcept;
/// All is counted: ends the program.
[[noreturn]] void finish() noexcept;

}  // namespace lab::probe
