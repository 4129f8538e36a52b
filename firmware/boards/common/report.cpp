// SPDX-License-Identifier: MIT
#include <hal/baremetal/core.hpp>

#include <firmware/boards/common/report.hpp>

namespace boards {

void report_frame(hal::baremetal::TextOutput& serial, std::uint32_t frame, std::uint32_t digest) noexcept {
  serial.text("frame ");
  serial.decimal(frame);
  serial.text(" crc32 ");
  serial.hex(digest);
  serial.text("\n");
}

void report_work(hal::baremetal::TextOutput& serial, std::span<const std::uint32_t> times) noexcept {
  serial.text("work");
  for (const std::uint32_t time : times) {
    serial.text(" ");
    serial.decimal(time);
  }
  serial.text("\n");
}

void report_end(hal::baremetal::TextOutput& serial, std::span<const std::uint16_t> vblanks,
                std::uint32_t missed) noexcept {
  std::uint32_t all = 0;
  serial.text("vblanks");
  for (const std::uint16_t count : vblanks) {
    serial.text(" ");
    serial.decimal(count);
    all += count;
  }
  serial.text("\ndone: ");
  serial.decimal(static_cast<std::uint32_t>(vblanks.size()));
  serial.text(" frames, ");
  serial.decimal(all);
  serial.text(" vblanks, ");
  serial.decimal(missed);
  serial.text(" missed\n");
}

void report_failure(hal::baremetal::TextOutput& serial, intaglio::Status status) noexcept {
  serial.text("failed: error ");
  serial.decimal(static_cast<std::uint32_t>(status.error()));
  serial.text(" argument ");
  serial.decimal(static_cast<std::uint32_t>(status.argument()));
  serial.text("\n");
  for (;;) hal::baremetal::wait_for_interrupt();
}

}  // namespace boards
