// SPDX-License-Identifier: MIT
//
// Oracle: dithered pictures straight from the rules, on whole arrays.
#pragma once

#include <cstddef>
#include <vector>

namespace oracle {

/// A picture of so many columns: values, or levels.
struct DitherPicture {
  int width;
  std::vector<int> pixels;
  [[nodiscard]] int height() const { return static_cast<int>(pixels.size()) / width; }
  [[nodiscard]] std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
};

/// The number in Bayer's matrix of side 1, 2, 4, 8 ... by its recursion.
inline int bayer(int x, int y, int side) {
  if (side == 1) return 0;
  const int half = side / 2;
  constexpr int quarters[2][2] = {{0, 2}, {3, 1}};
  return 4 * bayer(x % half, y % half, half) + quarters[y / half % 2][x / half % 2];
}

/// Ordered dithering, with the picture's corner at a multiple of the matrix.
inline DitherPicture ordered(const DitherPicture& values, int levels, int side) {
  DitherPicture out = values;
  const int places = side * side;
  for (int y = 0; y < values.height(); ++y)
    for (int x = 0; x < values.width; ++x) {
      const int wanted = values.pixels[values.at(x, y)] * (levels - 1);
      out.pixels[values.at(x, y)] =
          (2 * places * wanted + 255 * (2 * bayer(x % side, y % side, side) + 1)) / (510 * places);
    }
  return out;
}

/// Error diffusion with these sixteenths to the right, below left, below, and below right.
inline DitherPicture diffused(const DitherPicture& values, int levels, const int (&shares)[4],
                              bool serpentine) {
  DitherPicture out = values;
  std::vector<int> owed(values.pixels.size());
  for (int y = 0; y < values.height(); ++y) {
    const int ahead = serpentine && y % 2 == 1 ? -1 : 1;
    int rest = 0;
    for (int i = 0; i < values.width; ++i) {
      const int x = ahead > 0 ? i : values.width - 1 - i;
      const int sum = owed[values.at(x, y)] + rest;
      const int whole = (sum + 16 * 1000) / 16 - 1000;
      rest = sum - 16 * whole;
      const int wanted = values.pixels[values.at(x, y)] * (levels - 1) + whole;
      int level = 0;
      while (2 * (wanted - 255 * level) > 255) ++level;
      out.pixels[values.at(x, y)] = level;
      const auto give = [&](int to_x, int to_y, int share) {
        if (to_x >= 0 && to_x < values.width && to_y < values.height())
          owed[values.at(to_x, to_y)] += share * (wanted - 255 * level);
      };
      give(x + ahead, y, shares[0]);
      give(x - ahead, y + 1, shares[1]);
      give(x, y + 1, shares[2]);
      give(x + ahead, y + 1, shares[3]);
    }
  }
  return out;
}

/// The most by which the mean of 8x8 pixels, at multiples of 8, is off, in levels.
inline double worst_mean(const DitherPicture& values, const DitherPicture& levels, int steps) {
  int worst = 0;
  for (int top = 0; top + 8 <= values.height(); top += 8)
    for (int left = 0; left + 8 <= values.width; left += 8) {
      int sum = 0;
      for (int i = 0; i < 64; ++i) {
        const std::size_t at = values.at(left + i % 8, top + i / 8);
        sum += 255 * levels.pixels[at] - steps * values.pixels[at];
      }
      sum = sum < 0 ? -sum : sum;
      worst = sum > worst ? sum : worst;
    }
  return worst / (255.0 * 64);
}

}  // namespace oracle
