// SPDX-License-Identifier: MIT
//
// What a hardware call answers: success, or what failed and on account of which argument or part.
#pragma once

#include <cstdint>

namespace hal {

enum class Error : std::uint8_t {
  none,
  invalid,       ///< An argument the device can't take; `part()` names it.
  misaligned,    ///< A rectangle that doesn't meet the alignment the panel states.
  unsupported,   ///< The device has no such feature.
  busy,          ///< The last request hasn't taken effect yet.
  timeout,       ///< The device didn't answer in time.
  bus,           ///< The transfer failed (no acknowledgement, line fault).
  disconnected,  ///< The device is gone: unplugged, or taken away by the system.
};

/// The argument or the part of the hardware an error is about.
enum class Part : std::uint8_t { none, rectangle, pixels, stride, palette, buffer, command, bus, pin, panel };

/// Success, or an error and the part it is about. Two bytes.
class [[nodiscard]] Status {
 public:
  constexpr Status() noexcept = default;
  constexpr Status(Error error, Part part) noexcept : error_(error), part_(part) {}
  [[nodiscard]] constexpr bool ok() const noexcept { return error_ == Error::none; }
  [[nodiscard]] constexpr Error error() const noexcept { return error_; }
  [[nodiscard]] constexpr Part part() const noexcept { return part_; }
  /// Says in the source that a status was looked at and doesn't matter here.
  constexpr void ignore() const noexcept {}
  friend constexpr bool operator==(Status, Status) noexcept = default;

 private:
  Error error_ = Error::none;
  Part part_ = Part::none;
};

}  // namespace hal
