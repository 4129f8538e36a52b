// SPDX-License-Identifier: MIT
#include <intaglio/image/fill.hpp>
#include <intaglio/image/surface.hpp>
#include <intaglio/raster/circle.hpp>
#include <intaglio/raster/coverage.hpp>
#include <intaglio/raster/disc.hpp>
#include <intaglio/raster/ellipse.hpp>
#include <intaglio/raster/line.hpp>
#include <intaglio/raster/polygon.hpp>
#include <intaglio/raster/solid.hpp>
#include <intaglio/raster/thick_line.hpp>
#include <intaglio/raster/triangle.hpp>
#include <tests/bench/painter.hpp>

#include <algorithm>
#include <array>
#include <cstdint>

namespace bench {
namespace {

using namespace intaglio;
using Format = image::Indexed8;

class Canvas : public Painter {
 public:
  void clear() override { bytes_.fill(0); }
  [[nodiscard]] int level(int x, int y) const override {
    return bytes_[static_cast<std::size_t>(y * width + x)];
  }

 protected:
  [[nodiscard]] image::Surface<Format> surface() {
    return image::Surface<Format>::over(bytes_, {width, height}).value();
  }

 private:
  alignas(8) std::array<std::uint8_t, std::size_t{width} * height> bytes_{};
};

class Intaglio final : public Canvas {
 public:
  bool draw(const Shape& shape) override {
    return std::visit([&](const auto& s) { return draw_one(s).ok(); }, shape);
  }

 private:
  Status draw_one(const Line& l) { return raster::draw_line(pen_, l.a, l.b); }
  Status draw_one(const ThickLine& l) { return raster::draw_thick_line(pen_, l.a, l.b, l.across); }
  Status draw_one(const Circle& c) {
    return c.filled ? raster::fill_disc(pen_, c.centre, c.radius)
                    : raster::draw_circle(pen_, c.centre, c.radius);
  }
  Status draw_one(const Ellipse& e) {
    return e.filled ? raster::fill_ellipse(pen_, e.centre, e.x_radius, e.y_radius)
                    : raster::draw_ellipse(pen_, e.centre, e.x_radius, e.y_radius);
  }
  Status draw_one(const Polygon& p) {
    if (p.vertices.size() == 3)
      return raster::fill_triangle(pen_, p.vertices[0], p.vertices[1], p.vertices[2]);
    return raster::fill_polygon(pen_, p.even_odd ? raster::FillRule::even_odd : raster::FillRule::non_zero,
                                p.vertices, edges_);
  }

  raster::Solid<Format> pen_{surface(), 255};
  std::array<raster::PolygonEdge, 64> edges_;
};

class IntaglioSmooth final : public Canvas {
 public:
  bool draw(const Shape& shape) override {
    const auto* const p = std::get_if<Polygon>(&shape);
    return p != nullptr &&
           raster::fill_coverage(pen_, p->even_odd ? raster::FillRule::even_odd : raster::FillRule::non_zero,
                                 p->vertices, cells_)
               .ok();
  }

 private:
  raster::RampCoverage<Format> pen_ = raster::RampCoverage<Format>::over(surface(), 0, 256).value();
  std::array<raster::CoverageCell, raster::coverage_cells(12, width)> cells_;
};

}  // namespace

std::unique_ptr<Painter> make_intaglio() { return std::make_unique<Intaglio>(); }
std::unique_ptr<Painter> make_intaglio_smooth() { return std::make_unique<IntaglioSmooth>(); }

}  // namespace bench
