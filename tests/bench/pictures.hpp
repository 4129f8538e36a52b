// SPDX-License-Identifier: MIT
//
// The pictures that every library draws in the comparison, and which pixels each of their shapes has.
//
// Rule: a picture is a hundred shapes of one kind with a fixed seed, wholly inside 320x240 pixels. A pixel is
// its integer centre. Which pixels belong to a shape is answered pixel by pixel by the oracles of
// tests/oracle, or here by the shape's own inequality in 64-bit integers; nothing is taken from the library.
#pragma once

#include <intaglio/linear/point.hpp>

#include <string>
#include <variant>
#include <vector>

namespace bench {

inline constexpr int width = 320;
inline constexpr int height = 240;

struct Line {
  intaglio::linear::Point a, b;
};
/// Its sides lie half of `across` pixels to either hand; its ends are cut straight.
struct ThickLine {
  intaglio::linear::Point a, b;
  int across;
};
struct Circle {
  intaglio::linear::Point centre;
  int radius;
  bool filled;
};
struct Ellipse {
  intaglio::linear::Point centre;
  int x_radius, y_radius;
  bool filled;
};
/// Vertices in 1/256 pixel.
struct Polygon {
  std::vector<intaglio::linear::SubPoint> vertices;
  bool even_odd;
};
using Shape = std::variant<Line, ThickLine, Circle, Ellipse, Polygon>;

struct Picture {
  std::string name;
  std::vector<Shape> shapes;
};

/// All of them.
std::vector<Picture> pictures();

/// True if the shape has the pixel.
bool has_pixel(const Shape& shape, int x, int y);

}  // namespace bench
