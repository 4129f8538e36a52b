// SPDX-License-Identifier: MIT
//
// The visible part of a line between two pixels, exactly.
//
// Rule (DESIGN.md, "Line"): of each column (row, if the line is steep) the nearest pixel, ties towards the
// larger coordinate, whichever way the line was given. Walked to the right, with the major axis the longer
// one (x if they are equal), step k = 0..M along it lies
//     j(k) = floor((2*m*k + M - s) / (2*M))
// steps along the minor axis, where M and m are the magnitudes of the differences. s is 0 if the minor
// coordinate increases, so that ties go on; it is 1 if it decreases (a line that is not steep and goes up),
// so that they stay. A steep line's minor coordinate is x, which never decreases. j never decreases, so the
// steps whose pixels lie in a rectangle are one interval, found by inverting the formula: the first k with
// j(k) >= J is ceil((2*M*J - M + s) / (2*m)). Rounded end points are never drawn again as a line: clipping
// changes no pixel. Work: at most three divisions, none when the line lies inside.
//
// Bit budget: differences within 2^21, so 2*m*M + M is below 2^44.
// Textbook: section 2.3, Bresenham's line. Its `line3` starts the error at -floor(dx/2), which is wrong for
// odd dx; here everything is doubled and the error starts at -(M + s). Worst known input: (-2^20,
// -2^20)-(2^20, 2^20-1) against a one-pixel clip: three 64-bit divisions.
#pragma once

#include <intaglio/linear/rect.hpp>
#include <intaglio/status.hpp>

#include <cstdint>

namespace intaglio::clip {

/// A digital line as a walk to the right, or straight up or down: start there, take `count` pixels. After
/// each pixel add `minor_step` to `error`; step along the major axis; if `error` isn't negative, step along
/// the minor axis too and take `major_step` from it.
struct LinePath {
  linear::Point start;
  int count;  ///< Pixels; 0: the line misses the window, and nothing else here counts.
  int error;  ///< -major_step .. -1
  int minor_step;
  int major_step;
  bool steep;  ///< The major axis is y.
  bool up;     ///< Steps along y go up.
};

/// The part of the line from `a` to `b`, both drawn, that lies in `window` (which is in the domain).
/// Errors: out_of_domain point; the path is empty then.
Status line_path(linear::Point a, linear::Point b, const linear::Rect& window, LinePath& path) noexcept;

/// The same for ends in 1/256 pixel: from the column (row, if steep) nearest to one end to that nearest to
/// the other, ties to the larger, both included, the nearest pixel of each to the line through the ends. The
/// ends' own columns may stick out by half a pixel, over which the line goes on straight. On whole pixels the
/// same path.
Status line_path(linear::SubPoint a, linear::SubPoint b, const linear::Rect& window, LinePath& path) noexcept;

}  // namespace intaglio::clip
