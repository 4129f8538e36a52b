// SPDX-License-Identifier: MIT
//
// Which part of a segment is inside a closed box, from the definition: the ends of that part are among the
// ends of the segment and its crossings with the four lines of the box, each tried by itself in 128 bits.
#pragma once

#include <intaglio/linear/point.hpp>

#include <cstdint>
#include <vector>

namespace oracle {

struct Interval {
  bool visible = false;
  std::int64_t enter_n = 0, enter_d = 1;
  std::int64_t leave_n = 0, leave_d = 1;
};

/// The box is left <= x <= right, top <= y <= bottom.
inline Interval inside_part(intaglio::linear::SubPoint a, intaglio::linear::SubPoint b, std::int64_t left,
                            std::int64_t top, std::int64_t right, std::int64_t bottom) {
  __extension__ using Int = __int128;
  const std::int64_t dx = std::int64_t{b.x} - a.x;
  const std::int64_t dy = std::int64_t{b.y} - a.y;
  struct Candidate {
    std::int64_t n, d;
  };
  std::vector<Candidate> candidates{{0, 1}, {1, 1}};
  const auto add = [&](std::int64_t n, std::int64_t d) {
    if (d < 0) candidates.push_back({-n, -d});
    if (d > 0) candidates.push_back({n, d});
  };
  add(left - a.x, dx);
  add(right - a.x, dx);
  add(top - a.y, dy);
  add(bottom - a.y, dy);
  Interval part;
  for (const auto [n, d] : candidates) {
    if (n < 0 || n > d) continue;
    const Int x = Int{a.x} * d + Int{dx} * n;
    const Int y = Int{a.y} * d + Int{dy} * n;
    if (x < Int{left} * d || x > Int{right} * d || y < Int{top} * d || y > Int{bottom} * d) continue;
    if (!part.visible || Int{n} * part.enter_d < Int{part.enter_n} * d) {
      part.enter_n = n;
      part.enter_d = d;
    }
    if (!part.visible || Int{n} * part.leave_d > Int{part.leave_n} * d) {
      part.leave_n = n;
      part.leave_d = d;
    }
    part.visible = true;
  }
  return part;
}

}  // namespace oracle
