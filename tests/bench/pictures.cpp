// SPDX-License-Identifier: MIT
#include <tests/bench/pictures.hpp>
#include <tests/oracle/circle.hpp>
#include <tests/oracle/line.hpp>
#include <tests/oracle/oval.hpp>
#include <tests/oracle/polygon.hpp>
#include <tests/oracle/random.hpp>

#include <functional>
#include <utility>

namespace bench {
namespace {

using intaglio::linear::Point;
using intaglio::linear::SubPoint;

constexpr int shapes_in_picture = 100;

Picture picture(std::string name, std::uint32_t seed, const std::function<Shape(oracle::Random&)>& shape) {
  Picture made{std::move(name), {}};
  oracle::Random random(seed);
  for (int i = 0; i < shapes_in_picture; ++i) made.shapes.push_back(shape(random));
  return made;
}

Point anywhere(oracle::Random& random, int margin) {
  const int x = random.between(margin, width - 1 - margin);
  return {x, random.between(margin, height - 1 - margin)};
}

Polygon polygon(oracle::Random& random, int vertices, bool even_odd, bool whole_pixels) {
  Polygon made{{}, even_odd};
  const Point centre = anywhere(random, 50);
  for (int i = 0; i < vertices; ++i) {
    const int reach = 45 * 256;
    SubPoint p{centre.x * 256 + random.between(-reach, reach),
               centre.y * 256 + random.between(-reach, reach)};
    if (whole_pixels) p = {p.x / 256 * 256, p.y / 256 * 256};
    made.vertices.push_back(p);
  }
  return made;
}

struct HasPixel {
  int x, y;

  bool operator()(const Line& l) const { return oracle::on_line(l.a.x, l.a.y, l.b.x, l.b.y, x, y); }
  bool operator()(const ThickLine& l) const {
    const long dx = l.b.x - l.a.x;
    const long dy = l.b.y - l.a.y;
    const long along = dx * (x - l.a.x) + dy * (y - l.a.y);
    const long across = dx * (y - l.a.y) - dy * (x - l.a.x);
    const long squared = dx * dx + dy * dy;
    const long inside = squared * l.across * l.across - 4 * across * across;
    // A centre on a side or an end belongs to what lies to the right of it: seen from a little further right,
    // `along` is larger for a line that goes right, `across` for one that goes up. Neither level nor upright.
    const bool after_start = along > 0 || (along == 0 && dx > 0);
    const bool before_end = along < squared || (along == squared && dx < 0);
    return after_start && before_end && (inside > 0 || (inside == 0 && (across > 0) == (dy > 0)));
  }
  bool operator()(const Circle& c) const {
    return c.filled ? std::abs(x - c.centre.x) <= oracle::outline_reach(c.radius, y - c.centre.y)
                    : oracle::on_circle(c.radius, x - c.centre.x, y - c.centre.y);
  }
  bool operator()(const Ellipse& e) const {
    const int dx = 2 * (x - e.centre.x);
    const int dy = 2 * (y - e.centre.y);
    return e.filled ? oracle::in_oval(2 * e.x_radius, 2 * e.y_radius, dx, dy)
                    : oracle::on_oval(2 * e.x_radius, 2 * e.y_radius, dx, dy);
  }
  bool operator()(const Polygon& p) const { return oracle::in_polygon({p.vertices}, p.even_odd, x, y); }
};

}  // namespace

std::vector<Picture> pictures() {
  using oracle::Random;
  return {
      picture("lines", 1,
              [](Random& r) {
                return Line{anywhere(r, 0), anywhere(r, 0)};
              }),
      picture("thick lines, 5 wide", 2,
              [](Random& r) {
                Point a = anywhere(r, 8);
                Point b = anywhere(r, 8);
                if (a.x == b.x) b.x = a.x < width / 2 ? a.x + 7 : a.x - 7;
                if (a.y == b.y) b.y = a.y < height / 2 ? a.y + 7 : a.y - 7;
                return ThickLine{a, b, 5};
              }),
      picture("circles", 3,
              [](Random& r) {
                return Circle{anywhere(r, 52), r.between(5, 50), false};
              }),
      picture("discs", 4,
              [](Random& r) {
                return Circle{anywhere(r, 52), r.between(5, 50), true};
              }),
      picture("ellipses", 5,
              [](Random& r) {
                return Ellipse{anywhere(r, 52), r.between(5, 50), r.between(5, 50), false};
              }),
      picture("filled ellipses", 6,
              [](Random& r) {
                return Ellipse{anywhere(r, 52), r.between(5, 50), r.between(5, 50), true};
              }),
      picture("triangles", 7, [](Random& r) { return polygon(r, 3, true, true); }),
      picture("triangles, sub-pixel", 8, [](Random& r) { return polygon(r, 3, true, false); }),
      picture("polygons of 12, even-odd", 9, [](Random& r) { return polygon(r, 12, true, true); }),
      picture("polygons of 12, non-zero", 10, [](Random& r) { return polygon(r, 12, false, true); }),
  };
}

bool has_pixel(const Shape& shape, int x, int y) { return std::visit(HasPixel{x, y}, shape); }

}  // namespace bench
