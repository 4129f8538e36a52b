// SPDX-License-Identifier: MIT
//
// Counted: antialiasing by each method, of one triangle, one line and one disc; values seen in perspective.
#include <intaglio/raster/adaptive.hpp>
#include <intaglio/raster/blend_coverage.hpp>
#include <intaglio/raster/disc.hpp>
#include <intaglio/raster/dithered_coverage.hpp>
#include <intaglio/raster/enlargement.hpp>
#include <intaglio/raster/inside.hpp>
#include <intaglio/raster/layer_sink.hpp>
#include <intaglio/raster/mask_buffer.hpp>
#include <intaglio/raster/perspective.hpp>
#include <intaglio/raster/pitteway.hpp>
#include <intaglio/raster/smooth_line.hpp>
#include <intaglio/raster/stochastic.hpp>
#include <intaglio/raster/supersample.hpp>
#include <intaglio/raster/triangle.hpp>

#include <firmware/boards/mps2/count/rig.hpp>

namespace boards::mps2 {

namespace {

using raster::CoverageCell;
using Ramp = raster::RampCoverage<Format>;

constexpr std::array<SubPoint, 3> triangle{
    {{100 * 256 + 40, 100 * 256}, {150 * 256, 100 * 256 + 90}, {100 * 256, 150 * 256 + 70}}};

CoverageCell cells[raster::coverage_cells(4, 320)];
raster::SampleCell samples[320 * 4];
raster::MaskCell masks[320];
std::uint8_t blended[256 * 14];  // a colour over 256 others in 16 steps; what it holds costs nothing

Ramp ramp(const Pen& pen, const Rect& clip) {
  return Ramp::over(pen.surface(), 0, opaque(256), opaque(clip)).value();
}
// The triangle's box: methods that sample look at all of the clip.
Ramp box_ramp(const Pen& pen) { return ramp(pen, {99, 99, 53, 53}); }

// The triangle, four times as large.
constexpr std::array<SubPoint, 3> enlarged = [] {
  std::array<SubPoint, 3> result{};
  for (std::size_t i = 0; i < 3; ++i) result[i] = raster::Enlargement(4).place(triangle[i]);
  return result;
}();
bool in_enlarged(SubPoint p) { return raster::inside_convex(enlarged, p).value(); }

constexpr raster::Supersampling box4{4, 4, raster::SampleFilter::box};
constexpr raster::Supersampling bartlett3{3, 3, raster::SampleFilter::bartlett};

Status sample_triangle(const Pen& pen, const raster::Supersampling& grid) {
  const raster::Enlargement by(grid.scale);
  return raster::supersample(box_ramp(pen), grid, samples, [&](raster::SampleSink& sink) {
    return raster::fill_triangle(sink, by.place(triangle[0]), by.place(triangle[1]), by.place(triangle[2]));
  });
}

template <class Rung>
void walk(const Pen& pen) {
  const auto run = raster::Perspective::by_depths(opaque(0), opaque(64 * 256), 100, 400, 319);
  std::uint8_t* pixel = pen.surface().byte_at(0, 77);
  raster::walk_perspective<Rung>(run.value(), 0, 320,
                                 [&](int value) { *pixel++ = static_cast<std::uint8_t>(value >> 8 | 1); });
}

constexpr Row rows[] = {
    {"smooth line of 200",
     [](const Pen& pen) {
       use(raster::draw_smooth_line(ramp(pen, {0, 0, 320, 240}), opaque(SubPoint{10 * 256, 10 * 256}),
                                    opaque(SubPoint{210 * 256, 60 * 256}), opaque(256), raster::Cap::butt,
                                    cells));
     }},
    {"smooth triangle by area",
     [](const Pen& pen) {
       use(raster::fill_coverage(box_ramp(pen), raster::FillRule::non_zero, triangle, cells));
     }},
    {"smooth triangle, Pitteway",
     [](const Pen& pen) { use(raster::fill_convex_pitteway(box_ramp(pen), triangle)); }},
    {"smooth triangle, box 4x4", [](const Pen& pen) { use(sample_triangle(pen, box4)); }},
    {"smooth triangle, Bartlett 3x3", [](const Pen& pen) { use(sample_triangle(pen, bartlett3)); }},
    {"smooth triangle, masks 4x8",
     [](const Pen& pen) {
       const raster::Enlargement by(4, 8);
       use(raster::cover_by_masks(raster::OneLayer(box_ramp(pen)), raster::MaskGrid::four_by_eight, 1, masks,
                                  [&](int, raster::MaskSink& sink) {
                                    return raster::fill_triangle(sink, by.place(triangle[0]),
                                                                 by.place(triangle[1]),
                                                                 by.place(triangle[2]));
                                  }));
     }},
    {"smooth triangle, adaptive 4x4",
     [](const Pen& pen) {
       use(raster::cover_adaptively(box_ramp(pen), opaque(Rect{99, 99, 53, 53}), 4, in_enlarged));
     }},
    {"smooth triangle, stochastic 4x4",
     [](const Pen& pen) {
       use(raster::cover_stochastically(box_ramp(pen), opaque(Rect{99, 99, 53, 53}), 4, 1, in_enlarged));
     }},
    {"blended span of 64",
     [](const Pen& pen) {
       const auto table = image::BlendTable::over(blended, 256, 1, 16);
       const auto sink = raster::BlendCoverage<Format>::over(pen.surface(), table.value());
       sink.value().span(opaque(77), opaque(100), opaque(164), opaque(100));
     }},
    {"dithered span of 64",
     [](const Pen& pen) {
       raster::DitheredCoverage<const Pen&>(pen).span(opaque(77), opaque(100), opaque(164), opaque(100));
     }},
    {"perspective 320, every pixel", walk<raster::PerspectiveEveryPixel>},
    {"perspective 320, every 8th", walk<raster::PerspectiveEvery<8>>},
    {"perspective 320, every 16th", walk<raster::PerspectiveEvery<16>>},
    {"perspective 320, every 32nd", walk<raster::PerspectiveEvery<32>>},
    {"perspective 320, affine", walk<raster::PerspectiveAffine>},
};

}  // namespace

constinit const std::span<const Row> smooth_rows = rows;

}  // namespace boards::mps2
