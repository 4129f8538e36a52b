// SPDX-License-Identifier: MIT
//
// What a test image says on the serial line: a digest a frame, then how it ended.
#pragma once

#include <hal/baremetal/text_output.hpp>
#include <intaglio/status.hpp>

#include <cstdint>
#include <span>

namespace boards {

/// `frame 12 crc32 89abcdef`, as the simulator's --digest prints it.
void report_frame(hal::baremetal::TextOutput& serial, std::uint32_t frame, std::uint32_t digest) noexcept;
/// `work 1234 1250 ...`, the time that each frame took.
void report_work(hal::baremetal::TextOutput& serial, std::span<const std::uint32_t> times) noexcept;
/// `vblanks 1 1 2 ...`, how many VBLANKs each frame took, then the last line of a run that went well:
/// `done: 120 frames, 121 vblanks, 0 missed`.
void report_end(hal::baremetal::TextOutput& serial, std::span<const std::uint16_t> vblanks,
                std::uint32_t missed) noexcept;
/// `failed: error 3 argument 5`, the numbers of the status: the last line of a run that went wrong. A status
/// that is success means the hardware didn't come up.
[[noreturn]] void report_failure(hal::baremetal::TextOutput& serial, intaglio::Status status) noexcept;

}  // namespace boards
