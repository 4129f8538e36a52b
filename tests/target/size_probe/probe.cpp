// SPDX-License-Identifier: MIT
//
// One call of each public 2D primitive on 8-bit pixels, for weighing: tests/target/size links each of these
// functions alone and all of them together, and everything they don't reach is thrown out by the linker.
#include <intaglio/clip/boolean.hpp>
#include <intaglio/clip/convex.hpp>
#include <intaglio/clip/line_window.hpp>
#include <intaglio/image/blit.hpp>
#include <intaglio/image/clear.hpp>
#include <intaglio/image/dither.hpp>
#include <intaglio/image/rotate_rungs.hpp>
#include <intaglio/image/rotozoom.hpp>
#include <intaglio/image/scale.hpp>
#include <intaglio/image/scale_rungs.hpp>
#include <intaglio/image/three_shear.hpp>
#include <intaglio/raster/arc.hpp>
#include <intaglio/raster/chord.hpp>
#include <intaglio/raster/circle.hpp>
#include <intaglio/raster/convex.hpp>
#include <intaglio/raster/coverage.hpp>
#include <intaglio/raster/dash.hpp>
#include <intaglio/raster/disc.hpp>
#include <intaglio/raster/ellipse.hpp>
#include <intaglio/raster/flood.hpp>
#include <intaglio/raster/line.hpp>
#include <intaglio/raster/pixel.hpp>
#include <intaglio/raster/polygon.hpp>
#include <intaglio/raster/polygon_basic.hpp>
#include <intaglio/raster/polygon_critical.hpp>
#include <intaglio/raster/polyline.hpp>
#include <intaglio/raster/rectangle.hpp>
#include <intaglio/raster/ring.hpp>
#include <intaglio/raster/ring_arc.hpp>
#include <intaglio/raster/round_rect.hpp>
#include <intaglio/raster/solid.hpp>
#include <intaglio/raster/thick_line.hpp>
#include <intaglio/raster/triangle.hpp>
#include <intaglio/raster/triangle_box.hpp>
#include <intaglio/text/draw_aligned_text.hpp>
#include <intaglio/text/draw_text.hpp>

using namespace intaglio;

using Format = image::Indexed8;
using Pen = raster::Solid<Format>;
using Points = std::span<const linear::SubPoint>;
using Edges = std::span<raster::PolygonEdge>;
using Lengths = std::span<const int>;
using Line = linear::SubPoint[2];
using Triangle = linear::SubPoint[3];

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
Status draw_aligned_text(const Pen& pen, const text::Font& font, const linear::Rect& box,
                         text::Alignment across, text::Baseline down, std::string_view s) {
  return text::draw_aligned_text(pen, font, box, across, down, s);
}
Status clear(const image::Surface<Format>& surface, unsigned index) { return image::clear(surface, index); }
Status blit(const image::Surface<Format>& target, linear::Point p, const image::Picture<Format>& source) {
  return image::blit(target, p, source);
}
Status blit_keyed(const image::Surface<Format>& target, linear::Point p,
                  const image::Picture<Format>& source) {
  return image::blit(target, p, source, image::ColourKey{0});
}

Status draw_fine_line(const Pen& pen, const Line& p) { return raster::draw_line(pen, p[0], p[1]); }
Status draw_dashed_line(const Pen& pen, linear::Point a, linear::Point b, int on, int off) {
  return raster::draw_dashed_line(pen, a, b, on, off);
}
Status draw_thick_line(const Pen& pen, linear::Point a, linear::Point b, int width) {
  return raster::draw_thick_line(pen, a, b, width);
}
Status draw_polyline(const Pen& pen, Points points, const raster::Stroke& stroke,
                     std::span<raster::StrokeEdge> workspace) {
  return raster::draw_polyline(pen, points, stroke, workspace);
}
Status draw_circle_in(const Pen& pen, linear::Point p, int d) { return raster::draw_circle_in(pen, p, d); }
Status fill_disc_in(const Pen& pen, linear::Point p, int d) { return raster::fill_disc_in(pen, p, d); }
Status draw_ellipse(const Pen& pen, linear::Point c, int a, int b) {
  return raster::draw_ellipse(pen, c, a, b);
}
Status fill_ellipse(const Pen& pen, linear::Point c, int a, int b) {
  return raster::fill_ellipse(pen, c, a, b);
}
Status fill_ring(const Pen& pen, linear::Point c, int inner, int outer) {
  return raster::fill_ring(pen, c, inner, outer);
}
Status fill_ring_arc(const Pen& pen, linear::Point c, int inner, int outer, number::Angle start, int sweep) {
  return raster::fill_ring_arc(pen, c, inner, outer, start, sweep);
}
Status draw_arc(const Pen& pen, linear::Point c, int r, number::Angle start, int sweep) {
  return raster::draw_arc(pen, c, r, start, sweep);
}
Status fill_pie(const Pen& pen, linear::Point c, int r, number::Angle start, int sweep) {
  return raster::fill_pie(pen, c, r, start, sweep);
}
Status fill_chord(const Pen& pen, linear::Point c, int r, number::Angle start, int sweep) {
  return raster::fill_chord(pen, c, r, start, sweep);
}
Status draw_round_rect(const Pen& pen, const linear::Rect& r, const raster::CornerRadii& radii) {
  return raster::draw_round_rect(pen, r, radii);
}
Status fill_round_rect(const Pen& pen, const linear::Rect& r, const raster::CornerRadii& radii) {
  return raster::fill_round_rect(pen, r, radii);
}
Status flood_fill(const Pen& pen, raster::Connectivity connectivity, linear::Point seed,
                  std::span<raster::FloodSpan> workspace) {
  return raster::flood_fill(pen, connectivity, seed, workspace);
}
Status fill_triangle_box(const Pen& pen, const Triangle& p) {
  return raster::fill_triangle_box(pen, p[0], p[1], p[2]);
}
Status fill_triangle_blocks(const Pen& pen, const Triangle& p) {
  return raster::fill_triangle_blocks(pen, p[0], p[1], p[2]);
}
Status fill_polygon_basic(const Pen& pen, raster::FillRule rule, Points points, Lengths contours,
                          std::span<raster::PolygonCrossing> workspace) {
  return raster::fill_polygon_basic(pen, rule, points, contours, workspace);
}
Status fill_polygon_critical(const Pen& pen, raster::FillRule rule, Points points, Lengths contours,
                             std::span<raster::PolygonChain> workspace) {
  return raster::fill_polygon_critical(pen, rule, points, contours, workspace);
}
Status fill_convex(const Pen& pen, Points points) { return raster::fill_convex(pen, points); }
Status fill_coverage(const raster::RampCoverage<Format>& sink, raster::FillRule rule, Points points,
                     Lengths contours, std::span<raster::CoverageCell> workspace) {
  return raster::fill_coverage(sink, rule, points, contours, workspace);
}
Status clip_to_convex(Points polygon, Points clipper, std::span<linear::SubPoint> out,
                      std::span<clip::ClipStage> workspace) {
  return clip::clip_to_convex(polygon, clipper, out, workspace).status();
}
Status combine(clip::BooleanRule rule, const clip::BooleanOperand& a, const clip::BooleanOperand& b,
               std::span<clip::BooleanVertex> vertices, std::span<int> contours,
               std::span<clip::BooleanPiece> workspace) {
  return clip::combine(rule, a, b, vertices, contours, workspace).status();
}
Status cohen_sutherland(const Line& p, const linear::SubRect& window) {
  return clip::cohen_sutherland(p[0], p[1], window).status();
}
Status skala(const Line& p, const linear::SubRect& window) {
  return clip::skala(p[0], p[1], window).status();
}
Status liang_barsky(const Line& p, const linear::SubRect& window) {
  return clip::liang_barsky(p[0], p[1], window).status();
}
Status blit_scaled(const image::Surface<Format>& target, const linear::Rect& r,
                   const image::Picture<Format>& source) {
  return image::blit_scaled(target, r, source);
}
Status blit_rotozoom(const image::Surface<Format>& target, const image::Rotozoom& placement,
                     const image::Picture<Format>& source) {
  return image::blit_rotozoom(target, placement, source);
}
Status blit_three_shear(const image::Surface<Format>& target, const image::ThreeShear& placement,
                        const image::Picture<Format>& source) {
  return image::blit_three_shear(target, placement, source);
}
Status blit_turned_bilinear(const image::Surface<Format>& target, const image::ThreeShear& placement,
                            const image::Picture<Format>& source) {
  return image::RotateBilinear{}(target, placement, source);
}
Status blit_scaled_bilinear(const image::Surface<Format>& target, const linear::Rect& r,
                            const image::Picture<Format>& source) {
  return image::ScaleBilinear8{}(target, r, source);
}
Status blit_scaled_box(const image::Surface<Format>& target, const linear::Rect& r,
                       const image::Picture<Format>& source) {
  return image::ScaleBox{}(target, r, source);
}
Status blit_dithered(const image::Surface<Format>& target, linear::Point p,
                     const image::Picture<Format>& source, int levels) {
  return image::blit_dithered<image::DitherOrdered8>(target, p, source, levels);
}
Status blit_diffused(const image::Surface<Format>& target, linear::Point p,
                     const image::Picture<Format>& source, int levels, std::span<std::int16_t> memory) {
  return image::blit_dithered<image::DitherFourTap>(target, p, source, levels, memory);
}

// Where a probe that weighs nothing begins.
void nothing() {}
}
