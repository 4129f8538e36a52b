// SPDX-License-Identifier: MIT
//
// Whoever watches a simulated panel: recorders, detectors, effects. A panel that no one watches scans nothing
// out and costs nothing.
#pragma once

#include <hal/clock.hpp>

#include <cstdint>
#include <span>

namespace hal::sim {

/// One line as the beam fetched it.
struct ScannedLine {
  std::uint64_t refresh = 0;  ///< Refreshes before this one.
  int y = 0;
  Nanoseconds time = 0;
  std::span<const std::uint8_t> pixels;   ///< Packed as the panel's format says.
  std::span<const std::uint8_t> palette;  ///< Red, green, blue, three bytes an entry.
};

/// A picture that the program asked to be shown.
struct PresentedFrame {
  std::uint32_t number = 0;              ///< Requests of `show` so far; 0: what was there at the start.
  std::span<const std::uint8_t> pixels;  ///< Rows `stride` bytes apart.
  int stride = 0;
  std::span<const std::uint8_t> palette;  ///< As it will be when the frame is on display.
};

class Observer {
 public:
  virtual ~Observer() = default;
  /// A line was fetched.
  virtual void on_line(const ScannedLine&) {}
  /// The VBLANK after refresh `refresh` has begun; the palette and buffer asked for are in effect.
  virtual void on_vblank(std::uint64_t /*refresh*/, Nanoseconds /*time*/) {}
  /// `show` or `load_palette` was called, or the observer was attached.
  virtual void on_presented(const PresentedFrame&) {}
};

}  // namespace hal::sim
