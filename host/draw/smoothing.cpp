// SPDX-License-Identifier: MIT
#include <host/draw/outline.hpp>
#include <host/draw/smoothing.hpp>
#include <host/failure.hpp>
#include <intaglio/number/division.hpp>
#include <intaglio/raster/adaptive.hpp>
#include <intaglio/raster/enlargement.hpp>
#include <intaglio/raster/inside.hpp>
#include <intaglio/raster/oval.hpp>
#include <intaglio/raster/pitteway.hpp>
#include <intaglio/raster/polyline.hpp>
#include <intaglio/raster/round_rect.hpp>
#include <intaglio/raster/smooth_line.hpp>
#include <intaglio/raster/stochastic.hpp>
#include <intaglio/raster/thick_line.hpp>
#include <intaglio/raster/triangle.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace host::draw {
namespace {

namespace raster = intaglio::raster;
using intaglio::Status;
using linear::Point;
using linear::Rect;
using linear::SubPoint;
using raster::Enlargement;

/// All ways by name.
std::vector<Smoothing> ways() {
  using Way = Smoothing::Way;
  std::vector<Smoothing> all{{Way::area, "area"}, {Way::pitteway, "pitteway"}};
  for (const auto& rung : raster::supersampling_rungs) {
    const auto& grid = rung.grid;
    const bool box = grid.filter == raster::SampleFilter::box;
    all.push_back(
        {Way::samples,
         box ? fmt::format("box{}", grid.scale) : fmt::format("bartlett{}x{}", grid.scale, grid.width),
         grid});
  }
  for (int scale = 2; scale <= Enlargement::limit; ++scale) {
    const raster::Supersampling grid{scale, scale, raster::SampleFilter::box};
    all.push_back({Way::adaptive, fmt::format("adaptive{}", scale), grid});
    all.push_back({Way::stochastic, fmt::format("stochastic{}", scale), grid});
  }
  all.push_back({Way::masks, "abuffer4x4", {}, raster::MaskGrid::four_by_four});
  all.push_back({Way::masks, "abuffer4x8", {}, raster::MaskGrid::four_by_eight});
  return all;
}

constexpr auto short_names = std::to_array<std::pair<std::string_view, std::string_view>>({
    {"box", "box4"},
    {"bartlett3", "bartlett3x3"},
    {"bartlett5", "bartlett3x5"},
    {"bartlett7", "bartlett3x7"},
    {"adaptive", "adaptive4"},
    {"stochastic", "stochastic4"},
    {"abuffer", "abuffer4x4"},
});

std::vector<SubPoint> enlarged(std::vector<SubPoint> places, const Enlargement& by) {
  for (SubPoint& place : places) place = by.place(place);
  return places;
}

/// Draws a primitive enlarged by the same factor along both axes.
struct EnlargedDrawer {
  raster::SampleSink& sink;
  const Enlargement& by;
  std::string_view name;

  Status operator()(const Line& l) const {
    return raster::draw_thick_line(sink, by.place(l.from), by.place(l.to), by.width(linear::subpixel_one));
  }
  Status operator()(const ThickLine& l) const {
    return raster::draw_thick_line(sink, by.place(l.from), by.place(l.to), by.width(l.width), l.cap);
  }
  Status operator()(const Polyline& p) const {
    raster::Stroke stroke = p.stroke;
    stroke.width = by.width(stroke.width);
    const std::vector<SubPoint> points = enlarged(p.points, by);
    const auto needed = raster::polyline_workspace(points, stroke, sink.clip());
    if (!needed.ok()) return needed.status();
    std::vector<raster::StrokeEdge> workspace(needed.value());
    return raster::draw_polyline(sink, points, stroke, workspace);
  }
  Status operator()(const Circle& c) const {
    const Status status = raster::detail::check_ellipse(c.centre, c.radius, c.radius);
    return status.ok() ? round(square_around(c.centre, c.radius), c.filled ? -1 : c.radius - 1, c.centre)
                       : status;
  }
  Status operator()(const DiametricCircle& c) const {
    const Status status = raster::detail::check_diameter(c.top_left, c.diameter);
    if (!status.ok() || c.diameter == 0) return status;
    const Rect outer{c.top_left.x, c.top_left.y, c.diameter, c.diameter};
    const Rect inner{outer.x + 1, outer.y + 1, c.diameter - 2, c.diameter - 2};
    return between(outer, c.filled ? Rect{} : inner);
  }
  Status operator()(const Ring& r) const {
    const Status status = raster::detail::check_ellipse(r.centre, r.inner_radius, r.outer_radius);
    if (!status.ok()) return status;
    if (r.inner_radius > r.outer_radius) return {intaglio::Error::mismatched, intaglio::Argument::radius};
    return round(square_around(r.centre, r.outer_radius), r.inner_radius, r.centre);
  }
  Status operator()(const Ellipse& e) const {
    const Status status = raster::detail::check_ellipse(e.centre, e.x_radius, e.y_radius);
    if (!status.ok()) return status;
    const auto box = [&](int less) {
      return Rect{e.centre.x - e.x_radius + less, e.centre.y - e.y_radius + less, 2 * (e.x_radius - less) + 1,
                  2 * (e.y_radius - less) + 1};
    };
    return between(box(0), e.filled ? Rect{} : box(1));
  }
  Status operator()(const Arc& a) const { return outlined(a); }
  Status operator()(const EllipseArc& a) const { return outlined(a); }
  Status operator()(const RoundRectangle& r) const {
    const Status status = raster::detail::check_round_rect(r.area, r.radii);
    if (!status.ok() || r.area.empty()) return status;
    const raster::CornerRadii radii = raster::detail::fitting(r.area, r.radii);
    const auto shape = [&](int less) {
      const auto corner = [&](int pixels) { return pixels <= less ? 0 : radius(pixels - less); };
      const Rect area =
          by.area({r.area.x + less, r.area.y + less, r.area.width - 2 * less, r.area.height - 2 * less});
      return raster::detail::RoundRectShape(area, {corner(radii.top_left), corner(radii.top_right),
                                                   corner(radii.bottom_right), corner(radii.bottom_left)});
    };
    if (!linear::in_domain(by.area(r.area)))
      return {intaglio::Error::out_of_domain, intaglio::Argument::rectangle};
    if (r.filled || std::min(r.area.width, r.area.height) < 3)
      raster::detail::fill_rows(sink, shape(0));
    else
      raster::detail::fill_rows_around(sink, shape(0), shape(1));
    return {};
  }
  Status operator()(const Triangle& t) const {
    return raster::fill_triangle(sink, by.place(t.a), by.place(t.b), by.place(t.c));
  }
  Status operator()(const Polygon& p) const {
    const std::vector<SubPoint> vertices = enlarged(p.vertices, by);
    std::vector<raster::PolygonEdge> workspace(vertices.size());
    return raster::fill_polygon(sink, p.rule, vertices, p.contour_lengths, workspace);
  }
  Status operator()(const Combination& c) const {
    return fill_combination(sink, Combination{c.rule, enlarged(c.a, by), enlarged(c.b, by)});
  }
  template <class Other>
  Status operator()(const Other& /*other*/) const {
    fail();
  }

 private:
  [[noreturn]] void fail() const { throw Failure(fmt::format("aa {} doesn't draw this", name)); }
  [[nodiscard]] Status outlined(const Primitive& primitive) const {
    Status status;
    const auto polygon = outline_of(primitive, status);
    if (!status.ok()) return status;
    return (*this)(*polygon);
  }
  static Rect square_around(Point centre, int pixels) {
    return {centre.x - pixels, centre.y - pixels, 2 * pixels + 1, 2 * pixels + 1};
  }
  /// The disc in a square without the one of a radius around the middle; none if the radius is negative.
  [[nodiscard]] Status round(const Rect& outer, int inner_radius, Point centre) const {
    return between(outer, inner_radius < 0 ? Rect{} : square_around(centre, inner_radius));
  }
  /// The oval in a box without that in another around the same middle, if that isn't empty.
  [[nodiscard]] Status between(const Rect& outer, const Rect& inner) const {
    const Rect large = by.area(outer);
    if (!linear::in_domain(large)) return {intaglio::Error::out_of_domain, intaglio::Argument::radius};
    const raster::detail::Oval all({large.x, large.y}, large.width, large.height);
    if (inner.empty()) {
      raster::detail::fill_rows(sink, all);
      return {};
    }
    const Rect small = by.area(inner);
    raster::detail::fill_rows_around(sink, all,
                                     raster::detail::Oval({small.x, small.y}, small.width, small.height));
    return {};
  }
  /// The radius of a corner that is 2 * pixels + 1 wide, enlarged.
  [[nodiscard]] int radius(int pixels) const { return (by.across() * (2 * pixels + 1) - 1) / 2; }
};

Status draw_samples(const AnyCoverage& sink, const Smoothing& smoothing, const Primitive& primitive) {
  const Enlargement by(smoothing.grid.scale);
  constexpr int most_cells = 1 << 20;
  const Rect clip = sink.clip();
  const int rows = std::clamp(most_cells / std::max(clip.width, 1), 1, std::max(clip.height, 1));
  std::vector<raster::SampleCell> workspace(static_cast<std::size_t>(clip.width) *
                                            static_cast<std::size_t>(rows));
  return raster::supersample(sink, smoothing.grid, workspace, [&](raster::SampleSink& samples) {
    return std::visit(EnlargedDrawer{samples, by, smoothing.name}, primitive);
  });
}

/// Asks if places are inside a polygon, which may have very many vertices: on each row of pixels it looks
/// only at what of the polygon reaches that row. Of vertices that follow each other above it, or below it,
/// the first and the last stand for all.
class RowQuestions {
 public:
  /// Places are enlarged ones; a row is `row_height` high, in 1/256 enlarged pixel.
  RowQuestions(const Polygon& polygon, std::vector<SubPoint> vertices, int row_height)
      : polygon_(&polygon), all_(std::move(vertices)), row_height_(row_height) {}

  [[nodiscard]] intaglio::Result<bool> ask(SubPoint place) {
    if (place.y < top_ || place.y > top_ + row_height_ || lengths_.empty()) look_at(place.y);
    return raster::inside_polygon(polygon_->rule, vertices_, lengths_, place);
  }

 private:
  void look_at(int y) {
    top_ = intaglio::number::floor_div(y + linear::subpixel_one / 2, row_height_) * row_height_ -
           linear::subpixel_one / 2;
    vertices_.clear();
    lengths_.clear();
    const auto side = [&](const SubPoint& v) { return v.y < top_ ? -1 : v.y > top_ + row_height_ ? 1 : 0; };
    auto contour = all_.begin();
    for (const int length : polygon_->contour_lengths) {
      const std::size_t before = vertices_.size();
      for (int i = 0; i < length; ++i) {
        const int here = side(contour[i]);
        const int last = side(contour[i > 0 ? i - 1 : length - 1]);
        const int next = side(contour[i + 1 < length ? i + 1 : 0]);
        // Three make a contour, wherever they are.
        if (here == 0 || here != last || here != next || i < 3) vertices_.push_back(contour[i]);
      }
      lengths_.push_back(static_cast<int>(vertices_.size() - before));
      contour += length;
    }
  }

  const Polygon* polygon_;
  std::vector<SubPoint> all_;
  int row_height_;
  int top_ = 0;
  std::vector<SubPoint> vertices_;
  std::vector<int> lengths_;
};

Status draw_polygon(const AnyCoverage& sink, const Smoothing& smoothing, const Polygon& p) {
  using Way = Smoothing::Way;
  switch (smoothing.way) {
    case Way::area: {
      std::vector<raster::CoverageCell> workspace(
          raster::coverage_cells(p.vertices.size(), sink.clip().width));
      return raster::fill_coverage(sink, p.rule, p.vertices, p.contour_lengths, workspace);
    }
    case Way::pitteway:
      if (p.contour_lengths.size() != 1) throw Failure("aa pitteway draws convex polygons only");
      return raster::fill_convex_pitteway(sink, p.vertices);
    case Way::masks: {
      const Enlargement by(4, static_cast<int>(smoothing.masks));
      const std::vector<SubPoint> vertices = enlarged(p.vertices, by);
      std::vector<raster::PolygonEdge> edges(vertices.size());
      std::vector<raster::MaskCell> workspace(static_cast<std::size_t>(sink.clip().width));
      return raster::cover_by_masks(raster::OneLayer<const AnyCoverage&>(sink), smoothing.masks, 1, workspace,
                                    [&](int /*layer*/, raster::MaskSink& parts) {
                                      return raster::fill_polygon(parts, p.rule, vertices, p.contour_lengths,
                                                                  edges);
                                    });
    }
    default: {
      const int scale = smoothing.grid.scale;
      std::vector<SubPoint> vertices = enlarged(p.vertices, Enlargement(scale));
      const Status status = raster::inside_polygon(p.rule, vertices, p.contour_lengths, {}).status();
      if (!status.ok()) return status;
      RowQuestions questions(p, std::move(vertices), scale * linear::subpixel_one);
      const auto inside = [&](SubPoint place) { return questions.ask(place).value(); };
      return smoothing.way == Way::adaptive
                 ? raster::cover_adaptively(sink, sink.clip(), scale, inside)
                 : raster::cover_stochastically(sink, sink.clip(), scale, 0, inside);
    }
  }
}

}  // namespace

Smoothing parse_smoothing(std::string_view name) {
  const std::vector<Smoothing> all = ways();
  for (const auto& [alias, meaning] : short_names)
    if (name == alias) name = meaning;
  for (const Smoothing& way : all)
    if (way.name == name) return way;
  std::string names;
  for (const Smoothing& way : all) names += " " + way.name;
  throw Failure(fmt::format("no method '{}'; there are off{}", name, names));
}

bool has_edges(const Primitive& primitive) {
  return !std::holds_alternative<Pixel>(primitive) && !std::holds_alternative<Rectangle>(primitive) &&
         !std::holds_alternative<Coverage>(primitive) && !std::holds_alternative<FloodFill>(primitive) &&
         !std::holds_alternative<Text>(primitive) && !std::holds_alternative<Sprite>(primitive);
}

Status draw_smooth(const AnyCoverage& sink, const Smoothing& smoothing, const Primitive& primitive) {
  if (smoothing.way == Smoothing::Way::samples) return draw_samples(sink, smoothing, primitive);
  Status status;
  const auto polygon = outline_of(primitive, status);
  if (!status.ok()) return status;
  if (!polygon) throw Failure(fmt::format("aa {} doesn't draw this; box4 may", smoothing.name));
  return draw_polygon(sink, smoothing, *polygon);
}

}  // namespace host::draw
