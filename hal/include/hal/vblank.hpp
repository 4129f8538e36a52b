// SPDX-License-Identifier: MIT
//
// Where the rhythm of frames comes from: a tearing-effect line, an interrupt, a report of a USB device, or a
// clock where a panel tells nothing.
//
// Rule: a VBLANK is counted whether or not anyone waits for it, so a program that is late can tell by how
// many.
#pragma once

#include <hal/clock.hpp>
#include <hal/status.hpp>

#include <cstdint>

namespace hal {

class VblankSource {
 public:
  VblankSource(const VblankSource&) = delete;
  VblankSource& operator=(const VblankSource&) = delete;

  /// VBLANKs that have begun since the source was started; wraps.
  [[nodiscard]] std::uint32_t count() noexcept { return do_count(); }
  /// Returns when a VBLANK begins that hadn't begun at the call. Errors: timeout, bus, disconnected.
  Status wait() noexcept { return do_wait(); }
  /// When the VBLANK that was last counted began, on the clock of the source; 0 before the first.
  [[nodiscard]] Nanoseconds last() noexcept { return do_last(); }

 protected:
  constexpr VblankSource() noexcept = default;
  ~VblankSource() = default;

 private:
  [[nodiscard]] virtual std::uint32_t do_count() noexcept = 0;
  virtual Status do_wait() noexcept = 0;
  [[nodiscard]] virtual Nanoseconds do_last() noexcept = 0;
};

}  // namespace hal
