// SPDX-License-Identifier: MIT
//
// Oracle: CIE 1976 L*a*b* of sRGB colours under D65, in real numbers.
#pragma once

#include <tests/oracle/srgb.hpp>

#include <array>
#include <cmath>
#include <cstddef>

namespace oracle {

/// Lightness and two coordinates of tint.
using Lab = std::array<double, 3>;

/// X, Y and Z of a colour, white's Y being 1.
inline std::array<double, 3> xyz(int r, int g, int b) {
  static const auto lights = [] {
    std::array<double, 256> light{};
    for (std::size_t code = 0; code < 256; ++code)
      light[code] = static_cast<double>(srgb_decode(static_cast<long double>(code) / 255));
    return light;
  }();
  const double red = lights.at(static_cast<std::size_t>(r));
  const double green = lights.at(static_cast<std::size_t>(g));
  const double blue = lights.at(static_cast<std::size_t>(b));
  return {0.4124564 * red + 0.3575761 * green + 0.1804375 * blue,
          0.2126729 * red + 0.7151522 * green + 0.0721750 * blue,
          0.0193339 * red + 0.1191920 * green + 0.9503041 * blue};
}

/// The f of L*a*b*.
inline double lab_f(double part) {
  return part > 216.0 / 24389 ? std::cbrt(part) : (24389.0 / 27 * part + 16) / 116;
}

inline Lab lab(int r, int g, int b) {
  static const auto white = xyz(255, 255, 255);
  const auto colour = xyz(r, g, b);
  const double x = lab_f(colour[0] / white[0]);
  const double y = lab_f(colour[1] / white[1]);
  const double z = lab_f(colour[2] / white[2]);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

/// CIE 1976 L*u*v*.
inline Lab luv(int r, int g, int b) {
  static const auto white = xyz(255, 255, 255);
  const auto colour = xyz(r, g, b);
  const double lightness = 116 * lab_f(colour[1] / white[1]) - 16;
  if (r == 0 && g == 0 && b == 0) return {0, 0, 0};
  const auto sum = [](const std::array<double, 3>& c) { return c[0] + 15 * c[1] + 3 * c[2]; };
  return {lightness, 13 * lightness * (4 * colour[0] / sum(colour) - 4 * white[0] / sum(white)),
          13 * lightness * (9 * colour[1] / sum(colour) - 9 * white[1] / sum(white))};
}

/// CIE76, squared.
inline double squared_distance(const Lab& a, const Lab& b) {
  const double x = a[0] - b[0];
  const double y = a[1] - b[1];
  const double z = a[2] - b[2];
  return x * x + y * y + z * z;
}

}  // namespace oracle
