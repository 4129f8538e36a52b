// SPDX-License-Identifier: MIT
//
// The pixels of a line by its definition: for every step of the major axis the nearest pixel centre, ties
// towards the larger coordinate, found by searching and comparing distances in 128 bits. No running error, no
// inverse, nothing of the library.
#pragma once

namespace oracle {

using Wide = __int128;

/// The minor coordinate at `major` of the line through (major0, minor0), (major1, minor1), major0 < major1:
/// the integer v for which |v - exact| is smallest, of two the larger.
inline long nearest_minor(long major0, long minor0, long major1, long minor1, long major) {
  const Wide d = major1 - major0;
  // exact = e / d; v is right iff v - 1/2 <= e/d < v + 1/2, that is 2*v*d - d <= 2*e < 2*v*d + d.
  const Wide e = Wide{minor0} * d + Wide{minor1 - minor0} * (major - major0);
  long low = (minor0 < minor1 ? minor0 : minor1) - 1;
  long high = (minor0 < minor1 ? minor1 : minor0) + 1;
  while (low < high) {
    const long middle = low + (high - low) / 2;
    if (2 * e < 2 * Wide{middle} * d + d)
      high = middle;
    else
      low = middle + 1;
  }
  return low;
}

/// True if (x, y) is a pixel of the line from (x0, y0) to (x1, y1).
inline bool on_line(long x0, long y0, long x1, long y1, long x, long y) {
  const long dx = x1 > x0 ? x1 - x0 : x0 - x1;
  const long dy = y1 > y0 ? y1 - y0 : y0 - y1;
  if (dx == 0 && dy == 0) return x == x0 && y == y0;
  if (dx >= dy) {
    if (x < (x0 < x1 ? x0 : x1) || x > (x0 < x1 ? x1 : x0)) return false;
    return x0 < x1 ? y == nearest_minor(x0, y0, x1, y1, x) : y == nearest_minor(x1, y1, x0, y0, x);
  }
  return on_line(y0, x0, y1, x1, y, x);
}

/// True if pixel (x, y) is on the line whose ends are given in 1/256 pixel: (x, y) isn't outside the columns
/// (rows, if steep) nearest to the ends, and 256*y is the multiple of 256 nearest to the line at 256*x; of
/// two as near, here too, the larger counts.
inline bool on_sub_line(long x0, long y0, long x1, long y1, long x, long y) {
  const long dx = x1 > x0 ? x1 - x0 : x0 - x1;
  const long dy = y1 > y0 ? y1 - y0 : y0 - y1;
  const auto near = [](Wide exact_numerator, Wide d, long pixel) {
    const Wide twice_off = 2 * (exact_numerator - Wide{256} * pixel * d);
    return -256 * d <= twice_off && twice_off < 256 * d;
  };
  if (dx == 0 && dy == 0) return near(x0, 1, x) && near(y0, 1, y);
  if (dx < dy) return on_sub_line(y0, x0, y1, x1, y, x);
  if (x0 > x1) return on_sub_line(x1, y1, x0, y0, x, y);
  const bool not_before = near(x0, 1, x) || 256 * x > x0;
  const bool not_after = near(x1, 1, x) || 256 * x < x1;
  return not_before && not_after && near(Wide{y0} * dx + Wide{y1 - y0} * (256 * x - x0), dx, y);
}

/// True if pixel (x, y) of the line from (x0, y0) to (x1, y1) belongs to a dash: `on` pixels and then `off`
/// not, counted from (x0, y0).
inline bool on_dash(long x0, long y0, long x1, long y1, long on, long off, long x, long y) {
  if (!on_line(x0, y0, x1, y1, x, y)) return false;
  const long across = x > x0 ? x - x0 : x0 - x;
  const long down = y > y0 ? y - y0 : y0 - y;
  return (across > down ? across : down) % (on + off) < on;
}

}  // namespace oracle
