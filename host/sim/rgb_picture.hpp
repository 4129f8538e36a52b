// SPDX-License-Identifier: MIT
//
// A picture in colours, as viewers and files take it: 3 bytes a pixel, red, green, blue, rows close together.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace host {

struct RgbPicture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> bytes;

  RgbPicture() = default;
  /// A black picture. Both sides >= 0.
  RgbPicture(int columns, int rows) : width(columns), height(rows), bytes(offset(0, rows)) {}

  /// The three bytes of a pixel. (x, y) must be inside.
  [[nodiscard]] std::span<std::uint8_t, 3> at(int x, int y) {
    return std::span<std::uint8_t, 3>{bytes.data() + offset(x, y), 3};
  }
  [[nodiscard]] std::span<const std::uint8_t, 3> at(int x, int y) const {
    return std::span<const std::uint8_t, 3>{bytes.data() + offset(x, y), 3};
  }

  friend bool operator==(const RgbPicture&, const RgbPicture&) = default;

 private:
  [[nodiscard]] std::size_t offset(int x, int y) const {
    return 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
  }
};

}  // namespace host
