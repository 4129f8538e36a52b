// SPDX-License-Identifier: MIT
//
// Bus time: a write takes as long as its bytes take, and a pixel is in the panel's memory when its last bit
// is.
//
// Rule: a window begins with a gap and the bytes of its commands; pixel i of it (from 0) has arrived
//   gap + floor(1e9 * clocks * (commands + ceil((i + 1) * bits / 8)) / hertz)
// nanoseconds after the window began. A rectangle is one window, its pixels row after row; on panels whose
// memory is made of pages (y_alignment > 1) each page is one, its pixels column after column.
// Budget: a window of 2^28 pixels of 32 bits at 9 clocks a byte is 2^34 clocks; the time is reckoned in whole
// seconds and a rest, (hertz - 1) * 1e9 < 2^62.
#pragma once

#include <hal/sim/effects/effects.hpp>
#include <hal/sim/virtual_clock.hpp>

#include <algorithm>

namespace hal::sim {

class Bus {
 public:
  Bus(const BusTiming& timing, const Capabilities& panel)
      : timing_(timing),
        bits_(static_cast<std::uint64_t>(timing.bits_per_pixel > 0 ? timing.bits_per_pixel
                                                                   : panel.bits_per_pixel)),
        page_(panel.y_alignment) {}

  /// The time from the beginning of a window until so many of its bytes, those of commands included, are
  /// over.
  [[nodiscard]] Nanoseconds time_of(std::uint64_t bytes) const;
  /// Bytes that carry so many pixels.
  [[nodiscard]] std::uint64_t bytes_of(std::uint64_t pixels) const { return (pixels * bits_ + 7U) / 8U; }

  /// Sends a rectangle, calling `put(x, y)` (from the rectangle's corner) at the moment each pixel arrives,
  /// and returns the bytes sent. The clock moves.
  template <class Put>
  std::uint64_t send(const Rect& area, VirtualClock& clock, Put&& put) const;
  /// Sends a command with its parameters. The clock moves.
  std::uint64_t send_command(std::uint64_t bytes, VirtualClock& clock) const;

 private:
  BusTiming timing_;
  std::uint64_t bits_;
  int page_;
};

template <class Put>
std::uint64_t Bus::send(const Rect& area, VirtualClock& clock, Put&& put) const {
  note_call(Effect::bus);
  const auto commands = static_cast<std::uint64_t>(timing_.command_bytes);
  const int window = page_ > 1 ? page_ : area.height;
  std::uint64_t bytes = 0;
  for (int top = 0; top < area.height; top += window) {
    const Nanoseconds begin = static_cast<Clock&>(clock).now();
    const int rows = std::min(window, area.height - top);
    const int pixels = area.width * rows;
    for (int i = 0; i < pixels; ++i) {
      clock.wait_until(begin + time_of(commands + bytes_of(static_cast<std::uint64_t>(i) + 1U)));
      if (page_ > 1)
        put(i / rows, top + i % rows);
      else
        put(i % area.width, top + i / area.width);
    }
    bytes += commands + bytes_of(static_cast<std::uint64_t>(pixels));
  }
  return bytes;
}

}  // namespace hal::sim
