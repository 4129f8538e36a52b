// SPDX-License-Identifier: MIT
//
// The rhythm of frames: one every `interval` VBLANKs, and a count of those that came too late.
//
// Rule: frame n is due `interval` VBLANKs after frame n-1 appeared. It never appears earlier; if it appears
// later, it has missed its deadline, by however many VBLANKs. The first frame has no deadline.
// VBLANK counts wrap; differences of them are taken modulo 2^32, so a frame may last 2^32-1 VBLANKs.
#pragma once

#include <hal/panel.hpp>
#include <intaglio/status.hpp>

#include <cstdint>

namespace intaglio::present {

class Pacer {
 public:
  /// `interval` >= 1; see `check`.
  explicit constexpr Pacer(int interval) noexcept : interval_(static_cast<std::uint32_t>(interval)) {}

  /// Errors: count (out of range), if `interval` is below 1.
  [[nodiscard]] static constexpr Status check(int interval) noexcept {
    return interval < 1 ? Status{Error::out_of_range, Argument::count} : Status{};
  }

  /// Returns when at most `ahead` VBLANKs are left until the next frame is due. Errors: device.
  [[nodiscard]] Status wait(hal::Panel& panel, std::uint32_t ahead) noexcept;
  /// Says that the next frame appeared (or is sure to appear) at this VBLANK.
  void appeared(std::uint32_t vblank) noexcept;

  /// Frames that appeared later than they were due.
  [[nodiscard]] constexpr std::uint32_t missed() const noexcept { return missed_; }

 private:
  std::uint32_t interval_;
  std::uint32_t last_ = 0;
  std::uint32_t missed_ = 0;
  bool started_ = false;
};

}  // namespace intaglio::present
