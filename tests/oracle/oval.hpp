// SPDX-License-Identifier: MIT
//
// Filled ovals by definition, in 128-bit integers, pixel by pixel.
#pragma once

#include <cstdlib>

namespace oracle {

__extension__ using Wide = __int128;

/// True if the oval of a + 1 by b + 1 pixels has the pixel that is x and y half pixels from its middle. In
/// the flat part of the curve the pixel nearest to it in its column is the outermost, elsewhere the one
/// nearest to it in its row; halfway, the outer one of two.
inline bool in_oval(int a, int b, int x, int y) {
  const Wide column = std::abs(x);
  const Wide row = std::abs(y);
  const Wide aa = Wide{a} * a;
  const Wide bb = Wide{b} * b;
  if (column > a || row > b) return false;
  // The oval's inequality x^2/a^2 + y^2/b^2 <= 1 for the point half a pixel closer to an axis.
  const auto inside = [&](Wide px, Wide py) { return bb * px * px + aa * py * py <= aa * bb; };
  const bool flat = bb * column <= aa * row;
  if (flat) return row == 0 || inside(column, row - 1);
  return inside(column - 1, row);
}

/// How far in half pixels the oval reaches on row y; -1 if it has no pixel there. Looked for from outside.
inline int oval_reach(int a, int b, int y) {
  for (int x = a; x >= 0; x -= 2)
    if (in_oval(a, b, x, y)) return x;
  return -1;
}

/// True if the outline has the pixel: it belongs to the oval and one of its four neighbours doesn't.
inline bool on_oval(int a, int b, int x, int y) {
  return in_oval(a, b, x, y) && !(in_oval(a, b, x - 2, y) && in_oval(a, b, x + 2, y) &&
                                  in_oval(a, b, x, y - 2) && in_oval(a, b, x, y + 2));
}

}  // namespace oracle
