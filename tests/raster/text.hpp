// SPDX-License-Identifier: MIT
//
// Places and windows as text, for messages.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>

#include <string>

namespace tests {

inline std::string text(intaglio::linear::Point p) {
  return "(" + std::to_string(p.x) + "," + std::to_string(p.y) + ")";
}

/// In 1/256 pixel, as the numbers are.
inline std::string text(intaglio::linear::SubPoint p) {
  return "(" + std::to_string(p.x) + "," + std::to_string(p.y) + ")/256";
}

inline std::string text(const intaglio::linear::Rect& r) {
  return std::to_string(r.x) + "," + std::to_string(r.y) + " " + std::to_string(r.width) + "x" +
         std::to_string(r.height);
}

}  // namespace tests
