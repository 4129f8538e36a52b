// SPDX-License-Identifier: MIT
//
// What a call answers: success, or which argument was wrong, in which way, and (where it helps) how much
// would have been enough.
//
// Rule: no public call asserts, wraps or draws half. It returns a `Status` that must be looked at, or a
// `Result<T>` that holds either a value or a `Status`. Both are one machine word or a plain struct: no heap,
// no exceptions, and on Arm a `Status` travels in one register. The texts live in `status_text.hpp`, so an
// image that never prints them doesn't carry them.
#pragma once

#include <cstdint>
#include <utility>

namespace intaglio {

/// In which way an argument was wrong.
enum class Error : std::uint8_t {
  none,           ///< The call succeeded.
  out_of_domain,  ///< A coordinate or length beyond the stated domain (|c| <= 2^20 px, radius <= 2^20).
  out_of_range,   ///< An index, count or enumerator beyond what the object has.
  empty,          ///< A size of zero or less where something must be there.
  too_small,      ///< Memory, stride or table shorter than needed; `needed()` says how much.
  too_large,      ///< More than the object or the device can hold; `needed()` says the most that fits.
  misaligned,     ///< A position that the pixel format or the device can't address.
  malformed,      ///< Data that isn't what it says it is.
  mismatched,     ///< Two arguments that don't go together.
  unsupported,    ///< The object or device can't do this.
  busy,           ///< The object is still in use; try again after the next VBLANK.
  device,         ///< The device or its bus reported a failure.
};

/// Which argument was wrong.
enum class Argument : std::uint8_t {
  none,
  width,
  height,
  size,
  stride,
  buffer,
  point,
  rectangle,
  radius,
  vertices,
  contours,
  workspace,
  palette,
  index,
  colour,
  steps,
  table,
  source,
  position,
  glyph,
  font,
  text,
  angle,
  frame,
  panel,
  count,
  rule,
  limit,
  mask,
};

/// Success, or one error that names the argument. Four bytes, compares and copies as a word.
class [[nodiscard]] Status {
 public:
  /// Success.
  constexpr Status() noexcept = default;
  /// A failure. `needed` (0..2^22-1, saturated) is the amount that would have done, where that makes sense.
  constexpr Status(Error error, Argument argument, std::uint32_t needed = 0) noexcept
      : word_(static_cast<std::uint32_t>(error) | static_cast<std::uint32_t>(argument) << 4U |
              (needed < needed_limit ? needed : needed_limit - 1U) << 10U) {}

  [[nodiscard]] constexpr bool ok() const noexcept { return word_ == 0; }
  [[nodiscard]] constexpr Error error() const noexcept { return static_cast<Error>(word_ & 15U); }
  [[nodiscard]] constexpr Argument argument() const noexcept {
    return static_cast<Argument>(word_ >> 4U & 63U);
  }
  [[nodiscard]] constexpr std::uint32_t needed() const noexcept { return word_ >> 10U; }
  /// Says in the source that a status was looked at and doesn't matter here.
  constexpr void ignore() const noexcept {}

  friend constexpr bool operator==(Status, Status) noexcept = default;

 private:
  static constexpr std::uint32_t needed_limit = 1U << 22U;
  std::uint32_t word_ = 0;
};
static_assert(sizeof(Status) == 4);

/// A value, or the status that says why there is none. `T` must be default-constructible and cheap to move.
template <class T>
class [[nodiscard]] Result {
 public:
  constexpr Result(T value) noexcept : value_(std::move(value)) {}  // NOLINT(google-explicit-constructor)
  constexpr Result(Status failure) noexcept : status_(failure) {}   // NOLINT(google-explicit-constructor)

  [[nodiscard]] constexpr bool ok() const noexcept { return status_.ok(); }
  [[nodiscard]] constexpr Status status() const noexcept { return status_; }
  /// The value; a default-constructed one when there is none (an empty surface, say, that draws nothing).
  [[nodiscard]] constexpr T& value() & noexcept { return value_; }
  [[nodiscard]] constexpr const T& value() const& noexcept { return value_; }
  [[nodiscard]] constexpr T&& value() && noexcept { return std::move(value_); }

 private:
  T value_{};
  Status status_{};
};

}  // namespace intaglio
