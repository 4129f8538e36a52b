// SPDX-License-Identifier: MIT
//
// The rhythm of frames: one every `interval` VBLANKs, what becomes of those that come too late, and counts.
//
// Rule: frame n is due `interval` VBLANKs after frame n-1 was. It never appears earlier. One that comes later
// is shown late, and the rhythm begins anew with it; or it is dropped, and the rhythm goes on. No two in
// succession are dropped, so a program that is always late is still seen. The first frame has no deadline.
// From the first frame on display to the latest there are interval * (shown - 1) + repeated VBLANKs.
// VBLANK counts wrap; differences of them are taken modulo 2^32 and signed, so a frame may last 2^31-1
// VBLANKs.
#pragma once

#include <hal/panel.hpp>
#include <intaglio/status.hpp>

#include <cstdint>

namespace intaglio::present {

/// What becomes of a frame that comes too late.
enum class Late : std::uint8_t { show, drop };

/// What becomes of a frame that is followed by the next before its VBLANK.
enum class Order : std::uint8_t {
  every,   ///< It is shown; the next one waits.
  latest,  ///< It is dropped: the next one takes its place.
};

/// How frames follow each other.
struct Pace {
  /// A frame every so many VBLANKs.
  int interval = 1;
  Late late = Late::show;
  /// Of scan-out panels; `latest` wants three buffers to be of use, and an interval of 1.
  Order order = Order::every;

  // An interval is a pace; saying so at every screen would tell a reader nothing.
  // NOLINTNEXTLINE(google-explicit-constructor)
  constexpr Pace(int every = 1, Late late_frames = Late::show, Order which = Order::every) noexcept
      : interval(every), late(late_frames), order(which) {}
};

/// What became of frames. Each wraps at 2^32.
struct FrameCounts {
  /// Frames that were on display, or are sure to be.
  std::uint32_t shown = 0;
  /// Those of them that appeared after they were due.
  std::uint32_t late = 0;
  /// Frames that never were: too late, replaced by a later one, or lost to a failure of the device.
  std::uint32_t dropped = 0;
  /// VBLANKs at which a frame was due and didn't appear, so the one before was shown again.
  std::uint32_t repeated = 0;
  friend constexpr bool operator==(const FrameCounts&, const FrameCounts&) noexcept = default;
};

class Pacer {
 public:
  /// A pace that `check` accepts.
  explicit constexpr Pacer(const Pace& pace) noexcept
      : interval_(static_cast<std::uint32_t>(pace.interval)), late_(pace.late) {}

  /// Errors: count (out of range: an interval below 1; mismatched: `Order::latest` and an interval above 1).
  [[nodiscard]] static constexpr Status check(const Pace& pace) noexcept {
    if (pace.interval < 1) return {Error::out_of_range, Argument::count};
    if (pace.order == Order::latest && pace.interval != 1) return {Error::mismatched, Argument::count};
    return {};
  }

  /// Returns when at most `ahead` VBLANKs are left until the next frame is due. Errors: device.
  [[nodiscard]] Status wait(hal::Panel& panel, std::uint32_t ahead) const noexcept;
  /// The first VBLANK not before `vblank` at which the next frame may appear.
  [[nodiscard]] constexpr std::uint32_t not_before_due(std::uint32_t vblank) const noexcept {
    return started_ && after(due_, vblank) ? due_ : vblank;
  }

  /// True if the next frame, which can't appear before this VBLANK, isn't to be shown; counts it if so.
  [[nodiscard]] bool drop(std::uint32_t vblank) noexcept;
  /// Says that the next frame appeared (or is sure to appear) at this VBLANK.
  void appeared(std::uint32_t vblank) noexcept;
  /// Says that the next frame was to appear at this VBLANK, and the device failed.
  void lost(std::uint32_t vblank) noexcept;
  /// Says that a frame was replaced before it appeared.
  void replaced() noexcept { ++counts_.dropped; }

  [[nodiscard]] constexpr const FrameCounts& counts() const noexcept { return counts_; }
  /// Frames that were too late, shown or not.
  [[nodiscard]] constexpr std::uint32_t missed() const noexcept { return missed_; }

 private:
  /// True if VBLANK `a` comes after VBLANK `b`.
  [[nodiscard]] static constexpr bool after(std::uint32_t a, std::uint32_t b) noexcept {
    return a != b && a - b < 0x8000'0000U;
  }

  std::uint32_t interval_;
  std::uint32_t due_ = 0;  // The VBLANK at which the next frame is due, once `started_`.
  std::uint32_t missed_ = 0;
  FrameCounts counts_{};
  Late late_;
  bool started_ = false;
  bool dropped_last_ = false;
};

}  // namespace intaglio::present
