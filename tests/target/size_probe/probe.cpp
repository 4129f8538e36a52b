// SPDX-License-Identifier: MIT
//
// One call of each public 2D primitive on 8-bit pixels, for weighing: tests/target/size links each of these
// functions alone and all of them together, and everything they don't reach is thrown out by the linker.
#include <intaglio/image/blit.hpp>
#include <intaglio/image/clear.hpp>
#include <intaglio/raster/circle.hpp>
#include <intaglio/raster/disc.hpp>
#include <intaglio/raster/line.hpp>
#include <intaglio/raster/pixel.hpp>
#include <intaglio/raster/polygon.hpp>
#include <intaglio/raster/rectangle.hpp>
#include <intaglio/raster/solid.hpp>
#include <intaglio/raster/triangle.hpp>
#include <intaglio/text/draw_text.hpp>

using namespace intaglio;

using Format = image::Indexed8;
using Pen = raster::Solid<Format>;
using Points = std::span<const linear::SubPoint>;
using Edges = std::span<raster::PolygonEdge>;

extern "C" {

Status draw_pixel(const Pen& pen, linear::Point p) { return raster::draw_pixel(pen, p); }
Status draw_horizontal(const Pen& pen, linear::Point p, int n) { return raster::draw_horizontal(pen, p, n); }
Status draw_vertical(const Pen& pen, linear::Point p, int n) { return raster::draw_vertical(pen, p, n); }
Status fill_rect(const Pen& pen, const linear::Rect& r) { return raster::fill_rect(pen, r); }
Status draw_rect(const Pen& pen, const linear::Rect& r) { return raster::draw_rect(pen, r); }
Status draw_line(const Pen& pen, linear::Point a, linear::Point b) { return raster::draw_line(pen, a, b); }
Status draw_circle(const Pen& pen, linear::Point c, int r) { return raster::draw_circle(pen, c, r); }
Status fill_disc(const Pen& pen, linear::Point c, int r) { return raster::fill_disc(pen, c, r); }
Status fill_triangle(const Pen& pen, const linear::SubPoint (&p)[3]) {
  return raster::fill_triangle(pen, p[0], p[1], p[2]);
}
Status fill_polygon(const Pen& pen, raster::FillRule rule, Points points, std::span<const int> contours,
                    Edges workspace) {
  return raster::fill_polygon(pen, rule, points, contours, workspace);
}
Status draw_text(const Pen& pen, const text::Font& font, linear::Point p, std::string_view s) {
  return text::draw_text(pen, font, p, s);
}
Status clear(const image::Surface<Format>& surface, unsigned index) { return image::clear(surface, index); }
Status blit(const image::Surface<Format>& target, linear::Point p, const image::Picture<Format>& source) {
  return image::blit(target, p, source);
}
Status blit_keyed(const image::Surface<Format>& target, linear::Point p,
                  const image::Picture<Format>& source) {
  return image::blit(target, p, source, image::ColourKey{0});
}

// Where a probe that weighs nothing begins.
void nothing() {}
}
