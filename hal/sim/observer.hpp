// SPDX-License-Identifier: MIT
//
// Whoever watches a simulated panel: recorders, detectors, effects. A panel that no one watches scans nothing
// out and costs nothing.
#pragma once

#include <hal/clock.hpp>
#include <hal/panel.hpp>

#include <cstdint>
#include <span>

namespace hal::sim {

/// One line as the beam fetched it.
struct ScannedLine {
  std::uint64_t refresh = 0;  ///< Refreshes before this one.
  int line = 0;               ///< Lines of this refresh before this one.
  int y = 0;                  ///< The row; the column on panels scanned by columns.
  Nanoseconds time = 0;
  /// Packed as the panel's format says; red, green, blue where colours are applied as pixels are written.
  std::span<const std::uint8_t> pixels;
  std::span<const std::uint8_t> palette;  ///< Red, green, blue, three bytes an entry; empty for such pixels.
};

/// A picture that the program asked to be shown.
struct PresentedFrame {
  std::uint32_t number = 0;              ///< Requests of `show` so far; 0: what was there at the start.
  std::span<const std::uint8_t> pixels;  ///< Rows `stride` bytes apart, as those of a line.
  int stride = 0;
  std::span<const std::uint8_t> palette;  ///< As it will be when the frame is on display.
};

/// A rectangle or a palette that went over the bus; with an ideal bus in no time.
struct Transfer {
  Nanoseconds begin = 0;
  Nanoseconds end = 0;
  std::uint64_t bytes = 0;   ///< With commands; 0 where the scenario has no bus.
  Rect area{};               ///< Empty: colours.
  std::uint32_t vblank = 0;  ///< VBLANKs that the program knew of when it began.
};

class Observer {
 public:
  virtual ~Observer() = default;
  /// A line was fetched.
  virtual void on_line(const ScannedLine&) {}
  /// The VBLANK after refresh `refresh` has begun; the palette and buffer asked for are in effect.
  virtual void on_vblank(std::uint64_t /*refresh*/, Nanoseconds /*time*/) {}
  /// The edge that tells the program of the VBLANK after refresh `refresh` comes at `time`; told when VBLANK
  /// begins, only by panels that have the effect.
  virtual void on_te(std::uint64_t /*refresh*/, Nanoseconds /*time*/) {}
  /// Frame `frame` is on display from now on.
  virtual void on_swap(std::uint32_t /*frame*/, Nanoseconds /*time*/) {}
  /// Frame `frame` was asked for, but never shown: another was asked for before its VBLANK.
  virtual void on_dropped(std::uint32_t /*frame*/, Nanoseconds /*time*/) {}
  virtual void on_transfer(const Transfer&) {}
  /// `show`, `load_palette` or `mark_frame` was called, or the observer was attached.
  virtual void on_presented(const PresentedFrame&) {}
};

}  // namespace hal::sim
