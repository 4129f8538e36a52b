// SPDX-License-Identifier: MIT
//
// Strokes by definition: the list of their pieces, and for each pixel centre whether any of them holds it.
// All in 128-bit integers; half-widths by halving, tips of miters by Cramer's rule.
#pragma once

#include <intaglio/raster/stroke.hpp>
#include <tests/oracle/integer.hpp>
#include <tests/oracle/polygon.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace oracle {

class StrokeArea {
 public:
  using SubPoint = intaglio::linear::SubPoint;
  using Stroke = intaglio::raster::Stroke;
  using Cap = intaglio::raster::Cap;
  using Join = intaglio::raster::Join;

  StrokeArea(Contour points, const Stroke& stroke) : stroke_(stroke) {
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (stroke.closed)
      while (points.size() > 1 && points.back() == points.front()) points.pop_back();
    const std::size_t count = points.size();
    if (count == 0) return;
    if (count == 1) {
      cap(points[0], {1, 0}, true);
      cap(points[0], {-1, 0}, true);
      return;
    }
    for (std::size_t i = 0; i + 1 < count + (stroke.closed ? 1 : 0); ++i) {
      const SubPoint a = points[i];
      const SubPoint b = points[(i + 1) % count];
      segment(a, b, !stroke.closed && i == 0, !stroke.closed && i + 2 == count);
      if (stroke.closed || i + 2 < count) join(a, b, points[(i + 2) % count]);
    }
    if (!stroke.closed) {
      cap(points[0], {1, 0}, false);
      cap(points[count - 1], {1, 0}, false);
    }
  }

  /// True if the centre of pixel (x, y) belongs to the stroke.
  [[nodiscard]] bool holds(int x, int y) const {
    if (stroke_.width == 0) return false;
    for (const Contour& piece : pieces_)
      if (in_polygon({piece}, false, x, y)) return true;
    for (const SubPoint centre : discs_) {
      const Wide dx = Wide{x} * 256 - centre.x;
      const Wide dy = Wide{y} * 256 - centre.y;
      const Wide room = Wide{stroke_.width} * stroke_.width - 4 * (dx * dx + dy * dy);
      if (room > 0 || (room == 0 && dx < 0)) return true;
    }
    return false;
  }
  /// How many joins are miters.
  [[nodiscard]] int miters() const { return miters_; }

 private:
  static Wide cross(SubPoint a, SubPoint b) { return Wide{a.x} * b.y - Wide{a.y} * b.x; }
  static Wide dot(SubPoint a, SubPoint b) { return Wide{a.x} * b.x + Wide{a.y} * b.y; }
  static SubPoint minus(SubPoint a, SubPoint b) { return {a.x - b.x, a.y - b.y}; }

  // The integer nearest to d * w / (2 * sqrt(l2)), ties away from zero: of v, (2v - 1)^2 * l2 <= (d*w)^2.
  [[nodiscard]] int part(int d, Wide l2) const {
    const Wide product = Wide{d < 0 ? -d : d} * stroke_.width;
    int low = 0;
    int high = stroke_.width;
    while (low < high) {
      const int v = low + (high - low + 1) / 2;
      if (Wide{2 * v - 1} * (2 * v - 1) * l2 <= product * product)
        low = v;
      else
        high = v - 1;
    }
    return d < 0 ? -low : low;
  }
  // Half the width to the left of the way.
  [[nodiscard]] SubPoint left(SubPoint way) const {
    const Wide l2 = dot(way, way);
    return {part(way.y, l2), -part(way.x, l2)};
  }

  void segment(SubPoint a, SubPoint b, bool begins, bool ends) {
    const SubPoint side = left(minus(b, a));
    if (stroke_.cap == Cap::square) {
      if (begins) a = {a.x + side.y, a.y - side.x};
      if (ends) b = {b.x - side.y, b.y + side.x};
    }
    pieces_.push_back({{a.x + side.x, a.y + side.y},
                       {b.x + side.x, b.y + side.y},
                       {b.x - side.x, b.y - side.y},
                       {a.x - side.x, a.y - side.y}});
  }

  void cap(SubPoint end, SubPoint way, bool alone) {
    if (stroke_.cap == Cap::round) discs_.push_back(end);
    if (stroke_.cap == Cap::square && alone) {
      const SubPoint side = left(way);
      pieces_.push_back({{end.x + side.x, end.y + side.y},
                         {end.x + side.x - side.y, end.y + side.y + side.x},
                         {end.x - side.x - side.y, end.y - side.y + side.x},
                         {end.x - side.x, end.y - side.y}});
    }
  }

  void join(SubPoint before, SubPoint v, SubPoint after) {
    const SubPoint in = minus(v, before);
    const SubPoint out = minus(after, v);
    const Wide turn = cross(in, out);
    if (turn == 0 && dot(in, out) > 0) return;
    if (stroke_.join == Join::round) {
      discs_.push_back(v);
      return;
    }
    if (turn == 0) return;
    SubPoint a = left(in);
    SubPoint b = left(out);
    if (turn < 0) a = {-a.x, -a.y}, b = {-b.x, -b.y};
    const auto at = [&](SubPoint d) { return SubPoint{v.x + d.x, v.y + d.y}; };
    // The point p with in x p = in x a and out x p = out x b, times `turn`.
    const Wide along = cross(in, a);
    const Wide across = cross(out, b);
    const Wide px = along * out.x - across * in.x;
    const Wide py = along * out.y - across * in.y;
    // `far` how far it is beyond an end along a way, times `turn`.
    const auto far = [&](SubPoint end, SubPoint way) {
      return ((px - turn * end.x) * way.x + (py - turn * end.y) * way.y) * (turn < 0 ? -1 : 1);
    };
    if (stroke_.join == Join::miter && far(a, in) >= 0 && far(b, out) <= 0) {
      const Wide x = nearest_quotient(px, turn);
      const Wide y = nearest_quotient(py, turn);
      constexpr Wide most = Wide{1} << 40U;
      const Wide reach = Wide{stroke_.miter_limit} * stroke_.width;
      if (x < most && -x < most && y < most && -y < most && 512 * 512 * (x * x + y * y) <= reach * reach) {
        const SubPoint tip{static_cast<int>(x), static_cast<int>(y)};
        pieces_.push_back({v, at(a), at(tip)});
        pieces_.push_back({v, at(tip), at(b)});
        ++miters_;
        return;
      }
    }
    pieces_.push_back({v, at(a), at(b)});
  }

  Stroke stroke_;
  Contours pieces_;
  std::vector<SubPoint> discs_;
  int miters_ = 0;
};

}  // namespace oracle
