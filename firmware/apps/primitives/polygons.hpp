// SPDX-License-Identifier: MIT
//
// Fields with triangles, polygons, clips and floods.
#pragma once

#include <intaglio/clip/boolean.hpp>
#include <intaglio/clip/clip_stack.hpp>
#include <intaglio/clip/convex.hpp>
#include <intaglio/clip/greiner_hormann.hpp>
#include <intaglio/image/blit.hpp>
#include <intaglio/image/clear.hpp>
#include <intaglio/raster/circle.hpp>
#include <intaglio/raster/convex.hpp>
#include <intaglio/raster/flood.hpp>
#include <intaglio/raster/line.hpp>
#include <intaglio/raster/polygon.hpp>
#include <intaglio/raster/polygon_basic.hpp>
#include <intaglio/raster/polygon_clip.hpp>
#include <intaglio/raster/polygon_critical.hpp>
#include <intaglio/raster/rectangle.hpp>
#include <intaglio/raster/triangle.hpp>
#include <intaglio/raster/triangle_box.hpp>

#include <firmware/apps/primitives/field.hpp>
#include <span>

namespace apps::primitives {

/// A fan of six triangles by three methods.
template <image::PixelFormat F>
void draw_triangles(const Field<F>& field) {
  const SubPoint hub = field.place(20, 0);
  const auto ring = field.template ring<6>(130, 60);
  for (std::size_t i = 0; i < 6; ++i) {
    const SubPoint next = ring[(i + 1) % 6];
    const auto pen = field.pen(static_cast<unsigned>(3 + 2 * i));
    field.keep(i % 3 == 0   ? fill_triangle(pen, hub, ring[i], next)
               : i % 3 == 1 ? fill_triangle_box(pen, hub, ring[i], next)
                            : fill_triangle_blocks(pen, hub, ring[i], next));
  }
  field.keep(fill_triangle(field.pen(1), field.middle(), {1'000'000, -900'000}, {1'000'000, -1'000'000}));
}

/// A star with a hole by three methods, one within another.
template <image::PixelFormat F>
void draw_polygons(const Field<F>& field) {
  constexpr int contours[] = {5, 3};
  for (int i = 0; i < 3; ++i) {
    std::array<SubPoint, 8> vertices;
    for (std::size_t k = 0; k < 5; ++k)
      vertices[k] = field.place(110 - 35 * i, 144 * static_cast<int>(k) + 20 * i);
    for (std::size_t k = 0; k < 3; ++k) vertices[5 + k] = field.place(60 - 25 * i, 120 * static_cast<int>(k));
    const auto pen = field.pen(static_cast<unsigned>(4 + 5 * i));
    if (i == 0) {
      std::array<raster::PolygonEdge, 8> workspace;
      field.keep(fill_polygon(pen, raster::FillRule::even_odd, vertices, contours, workspace));
    } else if (i == 1) {
      std::array<raster::PolygonCrossing, 8> workspace;
      field.keep(fill_polygon_basic(pen, raster::FillRule::non_zero, vertices, contours, workspace));
    } else {
      std::array<raster::PolygonChain, 8> workspace;
      field.keep(fill_polygon_critical(pen, raster::FillRule::even_odd, vertices, contours, workspace));
    }
  }
}

template <image::PixelFormat F>
void draw_convex_polygons(const Field<F>& field) {
  field.keep(fill_convex(field.pen(7), field.template ring<7>(100, 51)));
  // A triangle cut to a square.
  const auto triangle = field.template ring<3>(180, 120);
  const auto square = field.template ring<4>(70, 90, 30);
  std::array<SubPoint, 12> out;
  std::array<intaglio::clip::ClipStage, 4> stages;
  const auto part = intaglio::clip::clip_to_convex(triangle, square, out, stages);
  field.keep(part.status());
  if (part.ok()) field.keep(fill_convex(field.pen(14), part.value()));
}

/// A star and a square combined by one of four rules after the other; `combine(rule, a, b, vertices,
/// lengths)`.
template <image::PixelFormat F, class Combine>
void draw_combined(const Field<F>& field, Combine combine) {
  // Their own coordinates, the field's corner being (0, 0): operands have a domain of their own.
  const SubPoint corner{field.area.x * linear::subpixel_one, field.area.y * linear::subpixel_one};
  auto star = field.template ring<5>(95, 144);
  auto square = field.template ring<4>(60, 90);
  for (SubPoint& p : star) p = {p.x - corner.x, p.y - corner.y};
  for (SubPoint& p : square) p = {p.x - corner.x, p.y - corner.y};
  constexpr int five[] = {5};
  constexpr int four[] = {4};
  std::array<intaglio::clip::BooleanVertex, 40> vertices;
  std::array<int, 12> lengths;
  const auto rule = static_cast<intaglio::clip::BooleanRule>(field.turn.steps() / (Angle::turn / 4) % 4);
  const auto result = combine(rule, intaglio::clip::BooleanOperand{star, five},
                              intaglio::clip::BooleanOperand{square, four}, vertices, lengths);
  field.keep(result.status());
  if (!result.ok()) return;
  std::array<SubPoint, 40> places;
  for (std::size_t i = 0; i < result.value().vertices; ++i) {
    const SubPoint p = nearest(vertices[i]);
    places[i] = {p.x + corner.x, p.y + corner.y};
  }
  std::array<raster::PolygonEdge, 40> workspace;
  field.keep(fill_polygon(field.pen(11), raster::FillRule::even_odd,
                          std::span(places).first(result.value().vertices),
                          std::span<const int>(lengths).first(result.value().contours), workspace));
}

template <image::PixelFormat F>
void draw_combination(const Field<F>& field) {
  draw_combined(field, [](auto rule, const auto& a, const auto& b, auto& vertices, auto& lengths) {
    std::array<intaglio::clip::BooleanPiece, 64> pieces;
    return intaglio::clip::combine(rule, a, b, vertices, lengths, pieces);
  });
}

/// The same by a walk along both; the two touch nowhere but where they cross.
template <image::PixelFormat F>
void draw_walked_combination(const Field<F>& field) {
  draw_combined(field, [](auto rule, const auto& a, const auto& b, auto& vertices, auto& lengths) {
    std::array<intaglio::clip::RingNode, 64> nodes;
    auto result = intaglio::clip::combine_greiner_hormann(rule, a, b, vertices, lengths, nodes);
    if (result.status().error() == intaglio::Error::unsupported) result = intaglio::clip::BooleanResult{};
    return result;
  });
}

/// Circles and lines through a hexagon in a window.
template <image::PixelFormat F>
void draw_clipped(const Field<F>& field) {
  intaglio::clip::ClipStack<2> clips(field.area);
  field.keep(clips.push({field.area.x, field.area.y, field.area.width, field.area.height - 1}));
  raster::Solid<F> pen(field.target, field.shade(13), clips.top());
  const auto hexagon = field.template ring<6>(110, 60);
  constexpr int six[] = {6};
  std::array<raster::PolygonEdge, 6> edges;
  std::array<raster::RowSpan, longest_side> spans;
  const auto clip =
      raster::PolygonClip::over(raster::FillRule::non_zero, hexagon, six, clips.top(), edges, spans);
  field.keep(clip.status());
  if (!clip.ok()) return;
  const raster::PolygonClipped clipped(pen, clip.value());
  for (int r = field.unit() * 3 / 2; r > 0; r -= 4) field.keep(draw_circle(clipped, field.middle(), r));
  field.keep(draw_line(clipped, field.place(150, 10), field.place(150, 190)));
}

/// Floods see what was drawn before, all of it: so they have a picture of their own.
template <image::PixelFormat F>
void draw_floods(const Field<F>& field) {
  constexpr int side = 24;
  std::array<std::uint8_t, static_cast<std::size_t>(F::row_bytes(side)) * side> memory{};
  const auto picture = image::Surface<F>::over(memory, {side, side});
  field.keep(picture.status());
  if (!picture.ok()) return;
  const image::Surface<F>& own = picture.value();
  const raster::Solid<F> border(own, field.shade(15));
  field.keep(draw_circle(border, {11, 11}, 10));
  const SubPoint tip = around({11, 11}, 9 * linear::subpixel_one, field.turn);
  field.keep(draw_line(border, {11, 11}, {tip.x / 256, tip.y / 256}));
  std::array<raster::FloodSpan, 48> workspace;
  field.keep(boundary_fill(raster::Solid<F>(own, field.shade(6)), field.shade(15), raster::Connectivity::four,
                           {11 - (tip.y / 256 - 11) / 3, 11 + (tip.x / 256 - 11) / 3}, workspace));
  field.keep(
      flood_fill(raster::Solid<F>(own, field.shade(9)), raster::Connectivity::eight, {0, 0}, workspace));
  field.keep(blit(field.target, {field.middle().x - side / 2, field.middle().y - side / 2},
                  image::Picture<F>(own), image::Everything{}, field.area));
}

}  // namespace apps::primitives
