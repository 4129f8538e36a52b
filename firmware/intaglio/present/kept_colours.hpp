// SPDX-License-Identifier: MIT
//
// Colours of frames that weren't shown, for the next one that is.
//
// Rule: an entry has the colour that the latest frame which brought it gave it, shown or not. So a program
// that gives colours only when they change loses none with a dropped frame.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace intaglio::present {

class KeptColours {
 public:
  /// Adds the colours (3 bytes an entry from entry 0 on, at most 256 entries) of a frame that isn't shown.
  constexpr void keep(std::span<const std::uint8_t> palette) noexcept {
    const std::size_t bytes = std::min(palette.size(), bytes_.size());
    std::copy_n(palette.begin(), bytes, bytes_.begin());
    size_ = std::max(size_, bytes);
  }
  /// The colours to show a frame with that brings `palette`; valid until the next call.
  [[nodiscard]] constexpr std::span<const std::uint8_t> joined(
      std::span<const std::uint8_t> palette) noexcept {
    if (palette.size() >= size_) return palette;
    std::copy(palette.begin(), palette.end(), bytes_.begin());
    return std::span(bytes_).first(size_);
  }
  /// The colours have been shown.
  constexpr void forget() noexcept { size_ = 0; }

 private:
  std::array<std::uint8_t, 768> bytes_{};
  std::size_t size_ = 0;
};

}  // namespace intaglio::present
