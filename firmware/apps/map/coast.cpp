// SPDX-License-Identifier: MIT
#include <firmware/apps/map/coast.hpp>

namespace apps::map {
namespace {

using intaglio::linear::Rect;
using intaglio::linear::SubPoint;

constexpr std::size_t at(int i) noexcept { return static_cast<std::size_t>(i); }

// The longitude nearest to `before` that is `x` modulo a world.
constexpr int unrolled(int x, int before) noexcept {
  while (x - before > world_width / 2) x -= world_width;
  while (before - x > world_width / 2) x += world_width;
  return x;
}

// Moves vertices together, those left out that are nearer than `shortest` along both axes to the last one
// kept; how many remain.
std::size_t thinned(std::span<SubPoint> places, int shortest) noexcept {
  const auto is_near = [shortest](int a, int b) { return (a < b ? b - a : a - b) < shortest; };
  std::size_t kept = 1;
  for (const SubPoint& place : places.subspan(1)) {
    const SubPoint& last = places[kept - 1];
    if (!is_near(place.x, last.x) || !is_near(place.y, last.y)) places[kept++] = place;
  }
  return kept;
}

// What the table doesn't say about a piece: how far its longitudes reach when they go on across the date
// line.
struct Reach {
  int start = 0;  // longitude of the first vertex, chosen so that `west` lies on the map
  int west = 0;
  int east = 0;
  bool polar = false;
};

constexpr Reach reach_of(const land::Polygon& piece) noexcept {
  const int first = land::vertices[piece.first_vertex].x;
  Reach reach{first, first, first, false};
  int x = first;
  const int border = land::contour_lengths[piece.first_contour];
  for (int i = 1; i < border; ++i) {
    x = unrolled(land::vertices[piece.first_vertex + i].x, x);
    if (x < reach.west) reach.west = x;
    if (x > reach.east) reach.east = x;
  }
  reach.polar = unrolled(first, x) != first;
  if (reach.polar) reach.east = first + world_width;
  const int shift = reach.west < -world_width / 2 ? world_width : 0;
  return {reach.start + shift, reach.west + shift, reach.east + shift, reach.polar};
}

constexpr std::array<Reach, at(piece_count)> reaches = [] {
  std::array<Reach, at(piece_count)> all{};
  for (int i = 0; i < piece_count; ++i) all[at(i)] = reach_of(land::polygons[i]);
  return all;
}();

}  // namespace

Copies copies_in_sight(const Projection& projection, int panel_width) noexcept {
  constexpr int reach =
      world_width / 2 + 20 * units_per_degree;  // a piece goes that far beyond the date line
  Copies copies;
  while (copies.first > -2 && to_pixel(projection.column((copies.first - 1) * world_width + reach)) >= 0)
    --copies.first;
  while (copies.last < 2 &&
         to_pixel(projection.column((copies.last + 1) * world_width - reach)) < panel_width)
    ++copies.last;
  return copies;
}

bool Coast::find(int index, int copy, const Projection& projection, const Rect& window,
                 int shortest) noexcept {
  const land::Polygon& piece = land::polygons[at(index)];
  const Reach& reach = reaches[at(index)];
  const int shift = copy * world_width;
  const int south = reach.polar ? 90 * units_per_degree : piece.max_y;
  // Two pixels more on each side, for what is drawn along the shore.
  if (to_pixel(projection.row(south)) < window.y - 2 ||
      to_pixel(projection.row(piece.min_y)) > window.bottom() + 2 ||
      to_pixel(projection.column(reach.east + shift)) < window.x - 2 ||
      to_pixel(projection.column(reach.west + shift)) > window.right() + 2)
    return false;
  count_ = 0;
  contours_ = 0;
  const land::Vertex* vertex = land::vertices + piece.first_vertex;
  int x = reach.start;
  for (int contour = 0; contour < piece.contour_count; ++contour) {
    const int length = land::contour_lengths[piece.first_contour + contour];
    const std::size_t first = count_;
    for (int i = 0; i < length; ++i, ++vertex) {
      x = unrolled(vertex->x, x);
      places_[count_++] = projection.place(x + shift, vertex->y);
    }
    if (shortest > 0) count_ = first + thinned(std::span(places_).subspan(first, at(length)), shortest);
    lengths_[contours_++] = static_cast<int>(count_ - first);
  }
  shore_end_ = count_;
  if (reach.polar) {
    const int y = land::vertices[piece.first_vertex].y;
    places_[count_++] = projection.place(reach.start + world_width + shift, y);
    shore_end_ = count_;
    places_[count_++] = projection.place(reach.start + world_width + shift, south);
    places_[count_++] = projection.place(reach.start + shift, south);
    lengths_[0] += 3;
  }
  return true;
}

}  // namespace apps::map
