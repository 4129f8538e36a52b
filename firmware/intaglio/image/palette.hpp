// SPDX-License-Identifier: MIT
//
// Palettes: what colour an index means.
//
// Rule: a palette is N entries of three bytes, red, green, blue, in the order a panel takes them, so
// `bytes()` goes to a device, a digest or a file as it stands. Entries that were never set are black.
#pragma once

#include <intaglio/status.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace intaglio::image {

/// A colour: red, green, blue, 0 .. 255 each, in the sRGB encoding.
struct Rgb {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;
  friend constexpr bool operator==(Rgb, Rgb) noexcept = default;
};

/// N colours, 2 .. 256.
template <int N>
class Palette {
  static_assert(N >= 2 && N <= 256);

 public:
  /// All black.
  constexpr Palette() noexcept = default;
  /// These colours, one an index; for tables known at compile time.
  constexpr explicit Palette(const Rgb (&colours)[static_cast<std::size_t>(N)]) noexcept {
    for (int index = 0; index < N; ++index) store(index, colours[index]);
  }

  /// Entries.
  [[nodiscard]] static constexpr int size() noexcept { return N; }
  /// True if the index has an entry.
  [[nodiscard]] static constexpr bool has(int index) noexcept { return index >= 0 && index < N; }

  /// Changes one entry. Errors: index (outside 0 .. N-1).
  constexpr Status set(int index, Rgb colour) noexcept {
    if (!has(index)) return {Error::out_of_range, Argument::index};
    store(index, colour);
    return {};
  }
  /// Changes the entries from `first` on. Errors: index (`first` is outside), palette (more colours than
  /// there are entries from there on: `needed()` is how many fit). Nothing is changed on error.
  constexpr Status set_from(int first, std::span<const Rgb> colours) noexcept {
    if (!has(first)) return {Error::out_of_range, Argument::index};
    const auto room = static_cast<std::uint32_t>(N - first);
    if (colours.size() > room) return {Error::too_large, Argument::palette, room};
    for (const Rgb& colour : colours) store(first++, colour);
    return {};
  }
  /// The colour of an index; black outside 0 .. N-1.
  [[nodiscard]] constexpr Rgb get(int index) const noexcept {
    if (!has(index)) return {};
    const std::size_t at = offset(index);
    return {bytes_[at], bytes_[at + 1], bytes_[at + 2]};
  }

  /// 3 * N bytes: RGBRGB...
  [[nodiscard]] constexpr std::span<const std::uint8_t> bytes() const noexcept { return bytes_; }

  friend constexpr bool operator==(const Palette&, const Palette&) noexcept = default;

 private:
  [[nodiscard]] static constexpr std::size_t offset(int index) noexcept {
    return static_cast<std::size_t>(index) * 3U;
  }
  constexpr void store(int index, Rgb colour) noexcept {
    const std::size_t at = offset(index);
    bytes_[at] = colour.r;
    bytes_[at + 1] = colour.g;
    bytes_[at + 2] = colour.b;
  }

  std::array<std::uint8_t, std::size_t{N} * 3U> bytes_{};
};

}  // namespace intaglio::image
