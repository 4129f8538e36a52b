// SPDX-License-Identifier: MIT
//
// Keys, as a panel or a board has them: a set of pressed keys that the program polls once a frame.
#pragma once

#include <cstdint>

namespace hal {

enum class Key : std::uint8_t { up, down, left, right, select, back };

/// The keys held down at one moment.
class Keys {
 public:
  constexpr Keys() noexcept = default;
  [[nodiscard]] constexpr bool held(Key key) const noexcept {
    return (bits_ >> static_cast<unsigned>(key) & 1U) != 0;
  }
  constexpr void press(Key key) noexcept {
    bits_ = static_cast<std::uint8_t>(bits_ | 1U << static_cast<unsigned>(key));
  }
  friend constexpr bool operator==(Keys, Keys) noexcept = default;

 private:
  std::uint8_t bits_ = 0;
};

class Input {
 public:
  Input(const Input&) = delete;
  Input& operator=(const Input&) = delete;

  [[nodiscard]] Keys poll() noexcept { return do_poll(); }

 protected:
  constexpr Input() noexcept = default;
  ~Input() = default;

 private:
  virtual Keys do_poll() noexcept = 0;
};

}  // namespace hal
