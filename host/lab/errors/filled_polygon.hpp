// SPDX-License-Identifier: MIT
//
// Pixels that a polygon fill gets wrong, against winding numbers in 128 bits.
#pragma once

#include <host/lab/errors/report.hpp>
#include <tests/oracle/polygon.hpp>

namespace host::lab {

/// How many pixels of the canvas are wrong when a rung of a family fills a polygon, by even-odd.
template <class Family, class R>
[[nodiscard]] long double wrong_pixels(const typename Family::Input& polygon) {
  ::lab::clear_canvas();
  const auto picture = ::lab::canvas();
  const auto bounds = picture.bounds();
  if (Family::template run<R>(polygon) != 1) return bounds.width * bounds.height;
  const auto vertices = polygon.vertices();
  const oracle::Contours contours{{vertices.begin(), vertices.end()}};
  int wrong = 0;
  for (int y = 0; y < bounds.height; ++y) {
    const auto turns = oracle::winding_row(contours, 0, bounds.width, y);
    for (int x = 0; x < bounds.width; ++x) {
      const bool inside = turns[static_cast<std::size_t>(x)] % 2 != 0;
      if (inside != (picture.get(x, y) != 0)) ++wrong;
    }
  }
  return wrong;
}

}  // namespace host::lab
