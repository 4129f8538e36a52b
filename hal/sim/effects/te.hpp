// SPDX-License-Identifier: MIT
//
// The tearing-effect line: where its edge is.
//
// Rule: the edge of the VBLANK after refresh k comes phase + J(k) after VBLANK begins, J(k) evenly spread
// over 0..jitter. Phase and jitter together are shorter than a refresh, so edges keep their order. A line
// that isn't connected has no edge; the program then counts by its own clock.
#pragma once

#include <hal/panels/frame_ticks.hpp>
#include <hal/sim/effects/effects.hpp>

namespace hal::sim {

class TeLine {
 public:
  /// `nominal_millihertz` is what the program believes the panel has.
  TeLine(const TeTiming& timing, Clock& clock, std::uint32_t nominal_millihertz);

  [[nodiscard]] bool connected() const { return timing_.connected; }
  /// From the beginning of the VBLANK after refresh `refresh` to the edge.
  [[nodiscard]] Nanoseconds delay(std::uint64_t refresh) const;
  /// The program's own rhythm, where the line isn't connected.
  [[nodiscard]] panels::FrameTicks& ticks() { return ticks_; }

 private:
  TeTiming timing_;
  panels::FrameTicks ticks_;
};

}  // namespace hal::sim
