// SPDX-License-Identifier: MIT
#include <host/draw/outline.hpp>
#include <intaglio/raster/oval.hpp>
#include <intaglio/raster/round_rect.hpp>
#include <intaglio/raster/smooth_line.hpp>
#include <intaglio/raster/thick_line.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace host::draw {
namespace {

namespace raster = intaglio::raster;
using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using linear::Point;
using linear::Rect;
using linear::SubPoint;

constexpr double turn = 2 * std::numbers::pi;

/// In pixels.
struct Place {
  double x;
  double y;
};

SubPoint rounded(Place p) {
  // Saturated outside the domain, where the library refuses it.
  const auto part = [](double c) {
    constexpr double far = linear::coordinate_limit + 1.0;
    return static_cast<int>(std::lround(std::clamp(c, -far, far) * linear::subpixel_one));
  };
  return {part(p.x), part(p.y)};
}

/// A curve around a place; angles as seen from there, from three o'clock on, clockwise on screen.
struct Curve {
  Place middle;
  double x_radius;
  double y_radius;

  /// Appends the way from an angle on, both ends included.
  void append(std::vector<SubPoint>& out, double start, double sweep) const {
    // The parameter of the place seen at an angle.
    const auto parameter = [&](double angle) {
      const double turns = std::round(angle / turn) * turn;
      return turns + std::atan2(x_radius * std::sin(angle - turns), y_radius * std::cos(angle - turns));
    };
    const double from = parameter(start);
    const double to = parameter(start + sweep);
    // The side of an n-gon is r * (1 - cos(pi / n)) inside.
    const double largest = std::max({x_radius, y_radius, 1.0});
    const double step = 2 * std::acos(1 - 1 / (512 * largest));
    const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(to - from) / step)));
    for (int i = 0; i <= steps; ++i) {
      const double t = from + (to - from) * i / steps;
      out.push_back(rounded({middle.x + x_radius * std::cos(t), middle.y + y_radius * std::sin(t)}));
    }
  }
};

/// A polygon that grows contour by contour.
class Outline {
 public:
  std::vector<SubPoint>& vertices() { return polygon_.vertices; }
  void end_contour() {
    int before = 0;
    for (const int length : polygon_.contour_lengths) before += length;
    polygon_.contour_lengths.push_back(static_cast<int>(polygon_.vertices.size()) - before);
  }
  void add(const Curve& curve) {
    if (curve.x_radius <= 0 || curve.y_radius <= 0) return;
    curve.append(vertices(), 0, turn);
    end_contour();
  }
  Polygon done() { return std::move(polygon_); }

 private:
  Polygon polygon_{raster::FillRule::even_odd, {}, {}, {}};
};

struct AsPolygon {
  Status& status;
  using Result = std::optional<Polygon>;

  Result operator()(const Line& l) const {
    return quadrilateral(l.from, l.to, linear::subpixel_one, raster::Cap::butt);
  }
  Result operator()(const ThickLine& l) const {
    if (l.cap != raster::Cap::round) return quadrilateral(l.from, l.to, l.width, l.cap);
    std::array<SubPoint, raster::smooth_line_vertices> outline{};
    const auto count = raster::detail::round_line_outline(l.from, l.to, l.width, outline);
    status = count.status();
    if (!count.ok()) return Polygon{};
    const int vertices = static_cast<int>(count.value());
    return Polygon{raster::FillRule::non_zero, {outline.begin(), outline.begin() + vertices}, {vertices}, {}};
  }
  Result operator()(const Triangle& t) const {
    return Polygon{raster::FillRule::non_zero, {t.a, t.b, t.c}, {3}, {}};
  }
  Result operator()(const Polygon& p) const { return p; }
  Result operator()(const Circle& c) const {
    status = raster::detail::check_ellipse(c.centre, c.radius, c.radius);
    return between(around(c.centre, c.radius, c.radius), c.filled ? 0 : 1);
  }
  Result operator()(const DiametricCircle& c) const {
    status = raster::detail::check_diameter(c.top_left, c.diameter);
    const double radius = c.diameter / 2.0;
    return between({{c.top_left.x - 0.5 + radius, c.top_left.y - 0.5 + radius}, radius, radius},
                   c.filled ? 0 : 1);
  }
  Result operator()(const Ellipse& e) const {
    status = raster::detail::check_ellipse(e.centre, e.x_radius, e.y_radius);
    return between(around(e.centre, e.x_radius, e.y_radius), e.filled ? 0 : 1);
  }
  Result operator()(const Ring& r) const {
    status = raster::detail::check_ellipse(r.centre, r.inner_radius, r.outer_radius);
    if (status.ok() && r.inner_radius > r.outer_radius) status = {Error::mismatched, Argument::radius};
    Outline outline;
    if (status.ok()) {
      outline.add(around(r.centre, r.outer_radius, r.outer_radius));
      outline.add(around(r.centre, r.inner_radius, r.inner_radius));
    }
    return outline.done();
  }
  Result operator()(const Arc& a) const {
    return swept(a.centre, a.radius, a.radius, a.start.steps(), a.sweep, a.shape);
  }
  Result operator()(const EllipseArc& a) const {
    return swept(a.centre, a.x_radius, a.y_radius, a.start.steps(), a.sweep, a.shape);
  }
  Result operator()(const RoundRectangle& r) const {
    status = raster::detail::check_round_rect(r.area, r.radii);
    Outline outline;
    if (!status.ok() || r.area.empty()) return outline.done();
    const raster::CornerRadii radii = raster::detail::fitting(r.area, r.radii);
    add_round_rect(outline, r.area, radii, 0);
    if (!r.filled && std::min(r.area.width, r.area.height) > 2) add_round_rect(outline, r.area, radii, 1);
    return outline.done();
  }
  template <class Other>
  Result operator()(const Other& /*other*/) const {
    return std::nullopt;
  }

 private:
  [[nodiscard]] Polygon quadrilateral(SubPoint from, SubPoint to, int width, raster::Cap cap) const {
    std::array<SubPoint, 4> corners{};
    status = raster::detail::thick_line_corners(from, to, width, cap, corners);
    return {raster::FillRule::non_zero, {corners.begin(), corners.end()}, {4}, {}};
  }
  static Curve around(Point centre, int x_radius, int y_radius) {
    return {{static_cast<double>(centre.x), static_cast<double>(centre.y)}, x_radius + 0.5, y_radius + 0.5};
  }
  /// What is inside a curve, or an outline of so many pixels along it.
  [[nodiscard]] Polygon between(const Curve& outer, int wide) const {
    Outline outline;
    if (!status.ok()) return outline.done();
    outline.add(outer);
    if (wide > 0) outline.add({outer.middle, outer.x_radius - wide, outer.y_radius - wide});
    return outline.done();
  }
  [[nodiscard]] Polygon swept(Point centre, int x_radius, int y_radius, int start, int sweep,
                              SweptShape shape) const {
    status = raster::detail::check_ellipse(centre, x_radius, y_radius);
    const Curve outer = around(centre, x_radius, y_radius);
    constexpr int full = 65536;
    if (sweep >= full || sweep <= -full) return between(outer, shape == SweptShape::arc ? 1 : 0);
    Outline outline;
    if (!status.ok() || sweep == 0) return outline.done();
    const double from = turn * start / full;
    const double along = turn * sweep / full;
    outer.append(outline.vertices(), from, along);
    if (shape == SweptShape::pie) {
      outline.vertices().push_back(rounded(outer.middle));
    } else if (shape == SweptShape::arc) {
      const Curve inner{outer.middle, outer.x_radius - 1, outer.y_radius - 1};
      if (inner.x_radius > 0 && inner.y_radius > 0)
        inner.append(outline.vertices(), from + along, -along);
      else
        outline.vertices().push_back(rounded(outer.middle));
    }
    outline.end_contour();
    return outline.done();
  }
  static void add_round_rect(Outline& outline, const Rect& r, const raster::CornerRadii& radii, int less) {
    const double left = r.x - 0.5 + less;
    const double top = r.y - 0.5 + less;
    const double right = r.right() - 0.5 - less;
    const double bottom = r.bottom() - 0.5 - less;
    const auto corner = [&](int pixels, double x, double y, int x_side, int y_side, double start) {
      const double radius = pixels > less ? pixels + 0.5 - less : 0;
      const Curve curve{{x + x_side * radius, y + y_side * radius}, radius, radius};
      if (radius > 0)
        curve.append(outline.vertices(), start, turn / 4);
      else
        outline.vertices().push_back(rounded({x, y}));
    };
    corner(radii.top_left, left, top, 1, 1, turn / 2);
    corner(radii.top_right, right, top, -1, 1, turn * 3 / 4);
    corner(radii.bottom_right, right, bottom, -1, -1, 0);
    corner(radii.bottom_left, left, bottom, 1, -1, turn / 4);
    outline.end_contour();
  }
};

}  // namespace

std::optional<Polygon> outline_of(const Primitive& primitive, Status& status) {
  status = {};
  return std::visit(AsPolygon{status}, primitive);
}

}  // namespace host::draw
