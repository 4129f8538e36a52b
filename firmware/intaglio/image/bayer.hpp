// SPDX-License-Identifier: MIT
//
// Bayer's matrices for ordered dithering, of 2x2, 4x4 and 8x8 places.
//
// Rule: the place (x, y) of the matrix of 2^b x 2^b has a number of 0 .. 4^b - 1, whose binary digits are,
// from the highest down, the lowest bits of x^y and of y in turn: places of successive numbers lie as far
// apart as can be. Error: none. Textbook: section 1.4, on displays of few levels.
#pragma once

namespace intaglio::image {

/// The number of a place in the matrix of 2^bits rows and columns, which repeats over the plane.
[[nodiscard]] constexpr unsigned bayer_number(unsigned x, unsigned y, unsigned bits) noexcept {
  unsigned number = 0;
  for (unsigned bit = 0; bit < bits; ++bit)
    number = number << 2U | ((x ^ y) >> bit & 1U) << 1U | (y >> bit & 1U);
  return number;
}

}  // namespace intaglio::image
