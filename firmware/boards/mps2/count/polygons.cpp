// SPDX-License-Identifier: MIT
//
// Counted: triangles, polygons, their coverage, and polygons clipped and combined.
#include <intaglio/clip/boolean.hpp>
#include <intaglio/clip/convex.hpp>
#include <intaglio/clip/greiner_hormann.hpp>
#include <intaglio/raster/convex.hpp>
#include <intaglio/raster/coverage.hpp>
#include <intaglio/raster/disc.hpp>
#include <intaglio/raster/polygon.hpp>
#include <intaglio/raster/polygon_basic.hpp>
#include <intaglio/raster/polygon_clip.hpp>
#include <intaglio/raster/polygon_critical.hpp>
#include <intaglio/raster/triangle.hpp>
#include <intaglio/raster/triangle_box.hpp>

#include <firmware/boards/mps2/count/rig.hpp>

namespace boards::mps2 {

namespace {

namespace clip = intaglio::clip;
using raster::FillRule;
using Vertices = std::span<const SubPoint>;

// A star that crosses itself, about as large as the disc.
constexpr SubPoint star[] = {{40960, 17920}, {48499, 41041}, {28787, 26753}, {53133, 26753}, {33421, 41041}};

// Neither cross themselves.
constexpr auto wheel = gear<100>({160 * 256 + 50, 120 * 256 + 30}, 110 * 256, 60 * 256);
constexpr auto octagon = gear<8>({160 * 256 + 50, 120 * 256 + 30}, 50 * 256, 50 * 256);

// A coast of 1,400 vertices, as a map has it when zoomed in: a few of them in the window, the others
// thousands of pixels away on all sides.
constexpr auto coast = [] {
  std::array<SubPoint, 1400> vertices{};
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const int along =
        static_cast<int>(i % 350) * 64 * 256 - 175 * 64 * 256;  // a square ring, 22,400 pixels wide
    const int across = 160 * 256 + static_cast<int>(i * 37 % 61) * 256;
    constexpr int far = 175 * 64 * 256;
    vertices[i] = i < 350    ? SubPoint{along, across}
                  : i < 700  ? SubPoint{far + across, across + along + far}
                  : i < 1050 ? SubPoint{-along, 2 * far + across}
                             : SubPoint{-far - across, across - along + far};
  }
  return vertices;
}();

// The corners of the triangle with legs of 50 pixels.
constexpr Point corner{100, 100};
constexpr Point right{150, 100};
constexpr Point below{100, 150};

raster::PolygonEdge edges[128];
raster::PolygonCrossing crossings[128];
raster::PolygonChain chains[128];
raster::RowSpan window_spans[256];
clip::RingNode ring_nodes[128];
raster::CoverageCell cells[raster::coverage_cells(100, 320)];
clip::ClipStage stages[16];
clip::BooleanPiece pieces[256];
clip::BooleanVertex combined[64];
SubPoint clipped[256];

/// How often the edges of a polygon cross the rows of the screen.
std::uint32_t count_crossings(Vertices polygon) noexcept {
  std::uint32_t count = 0;
  for (int y = 0; y < 240; ++y) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const bool above = polygon[i].y <= y * 256;
      if (above != (polygon[(i + 1) % polygon.size()].y <= y * 256)) ++count;
    }
  }
  return count;
}

/// Pixels neither empty nor full, where the index is the level.
std::uint32_t count_boundary(const Pen& pen) noexcept {
  std::uint32_t count = 0;
  for (int y = 0; y < 240; ++y) {
    for (int x = 0; x < 320; ++x) {
      const unsigned level = pen.surface().get(x, y);
      count += level != 0 && level != raster::full_coverage ? 1U : 0U;
    }
  }
  return count;
}

void cover(const Pen& pen, Vertices polygon) {
  const auto sink = raster::RampCoverage<Format>::over(pen.surface(), 0, opaque(256));
  use(sink.ok() ? raster::fill_coverage(sink.value(), FillRule::non_zero, polygon, cells) : sink.status());
}

/// Takes spans and draws nothing: what is left is what finding them costs.
struct Nowhere {
  [[nodiscard]] Rect clip() const noexcept { return {0, 0, 320, 240}; }
  void span(int y, int x_begin, int x_end) const noexcept {
    asm volatile("" : : "r"(y), "r"(x_begin), "r"(x_end));
  }
};

// The pixels of the octagon.
raster::PolygonClip octagon_window(const Pen& pen) {
  constexpr int length = 8;
  const auto made = raster::PolygonClip::over(FillRule::non_zero, octagon, std::span<const int>(&length, 1),
                                              pen.clip(), edges, window_spans);
  use(made.status());
  return made.value();
}

constexpr Row rows[] = {
    {"triangle legs 50",
     [](const Pen& pen) { use(raster::fill_triangle(pen, opaque(corner), opaque(right), opaque(below))); }},
    {"triangle, thin",
     [](const Pen& pen) {
       use(raster::fill_triangle(pen, opaque(Point{0, 0}), opaque(Point{200, 10}), opaque(Point{100, 14})));
     }},
    {"triangle by box",
     [](const Pen& pen) {
       use(raster::fill_triangle_box(pen, opaque(linear::to_subpixel(corner)),
                                     opaque(linear::to_subpixel(right)), opaque(linear::to_subpixel(below))));
     }},
    {"triangle by blocks",
     [](const Pen& pen) {
       use(raster::fill_triangle_blocks(pen, opaque(linear::to_subpixel(corner)),
                                        opaque(linear::to_subpixel(right)),
                                        opaque(linear::to_subpixel(below))));
     }},
    {"polygon star", [](const Pen& pen) { use(raster::fill_polygon(pen, FillRule::even_odd, star, edges)); }},
    {"polygon of 100",
     [](const Pen& pen) { use(raster::fill_polygon(pen, FillRule::even_odd, wheel, edges)); },
     [](const Pen&) { return count_crossings(wheel); }},
    {"polygon of 100, no pixels",
     [](const Pen&) { use(raster::fill_polygon(Nowhere{}, FillRule::even_odd, wheel, edges)); },
     [](const Pen&) { return count_crossings(wheel); }},
    {"polygon of 1400",
     [](const Pen& pen) { use(raster::fill_polygon(pen, FillRule::non_zero, coast, edges)); }},
    {"polygon of 100, basic",
     [](const Pen& pen) {
       constexpr int length = 100;
       use(raster::fill_polygon_basic(pen, FillRule::even_odd, wheel, std::span<const int>(&length, 1),
                                      crossings));
     }},
    {"polygon of 100, critical",
     [](const Pen& pen) {
       constexpr int length = 100;
       use(raster::fill_polygon_critical(pen, FillRule::even_odd, wheel, std::span<const int>(&length, 1),
                                         chains));
     }},
    {"octagon, convex", [](const Pen& pen) { use(raster::fill_convex(pen, octagon)); }},
    {"octagon, coverage", [](const Pen& pen) { cover(pen, octagon); }, count_boundary},
    {"polygon of 100, coverage", [](const Pen& pen) { cover(pen, wheel); }, count_boundary},
    {"clip to octagon, made",
     [](const Pen& pen) { use(static_cast<std::uint32_t>(octagon_window(pen).spans().size())); }},
    {"clip to octagon, made, and a disc",
     [](const Pen& pen) {
       const raster::PolygonClip window = octagon_window(pen);
       use(raster::fill_disc(raster::PolygonClipped(pen, window), opaque(Point{170, 130}), opaque(50)));
     }},
    {"union of star and octagon, Greiner-Hormann",
     [](const Pen&) {
       constexpr int of_star = 5;
       constexpr int of_octagon = 8;
       int lengths[16];
       const auto result = clip::combine_greiner_hormann(
           clip::BooleanRule::join, {star, std::span<const int>(&of_star, 1)},
           {octagon, std::span<const int>(&of_octagon, 1)}, combined, lengths, ring_nodes);
       use(result.status());
     }},
    {"clip star to octagon",
     [](const Pen&) {
       const auto result = clip::clip_to_convex(star, octagon, clipped, stages);
       use(result.ok() ? static_cast<std::uint32_t>(result.value().size()) : 0U);
     }},
    {"union of star and octagon",
     [](const Pen&) {
       constexpr int of_star = 5;
       constexpr int of_octagon = 8;
       int lengths[16];
       const auto result =
           clip::combine(clip::BooleanRule::join, {star, std::span<const int>(&of_star, 1)},
                         {octagon, std::span<const int>(&of_octagon, 1)}, combined, lengths, pieces);
       use(result.ok() ? static_cast<std::uint32_t>(result.value().vertices) : 0U);
     }},
};

}  // namespace

constinit const std::span<const Row> polygon_rows = rows;

}  // namespace boards::mps2
