// SPDX-License-Identifier: MIT
//
// Fields with smooth edges, and a floor seen in perspective.
#pragma once

#include <intaglio/image/blend_table.hpp>
#include <intaglio/raster/blend_coverage.hpp>
#include <intaglio/raster/coverage.hpp>
#include <intaglio/raster/dithered_coverage.hpp>
#include <intaglio/raster/perspective.hpp>
#include <intaglio/raster/pitteway.hpp>
#include <intaglio/raster/pixel.hpp>
#include <intaglio/raster/rectangle.hpp>
#include <intaglio/raster/smooth_line.hpp>

#include <firmware/apps/primitives/field.hpp>

namespace apps::primitives {

/// Enough for five vertices in any field.
using CoverageRow = std::array<raster::CoverageCell, raster::coverage_cells(5, longest_side)>;

/// All indices as a ramp.
template <image::PixelFormat F>
[[nodiscard]] raster::RampCoverage<F> ramp_of(const Field<F>& field) {
  const auto ramp = raster::RampCoverage<F>::over(field.target, 0, F::max_index + 1, field.area);
  field.keep(ramp.status());
  return ramp.ok() ? ramp.value() : raster::RampCoverage<F>();
}

template <image::PixelFormat F>
void draw_smooth_star(const Field<F>& field) {
  CoverageRow workspace;
  field.keep(
      fill_coverage(ramp_of(field), raster::FillRule::even_odd, field.template ring<5>(110, 144), workspace));
}

template <image::PixelFormat F>
void draw_smooth_lines(const Field<F>& field) {
  CoverageRow workspace;
  constexpr raster::Cap caps[] = {raster::Cap::butt, raster::Cap::square};
  for (int i = 0; i < 5; ++i)
    field.keep(draw_smooth_line(ramp_of(field), field.place(25, 72 * i), field.place(110, 72 * i + 2),
                                100 + 150 * i, caps[i % 2], workspace));
}

template <image::PixelFormat F>
void draw_pitteway_polygon(const Field<F>& field) {
  field.keep(fill_convex_pitteway(ramp_of(field), field.template ring<5>(105, 72)));
}

template <image::PixelFormat F>
void draw_dithered(const Field<F>& field) {
  CoverageRow workspace;
  const auto vertices = field.template ring<4>(60, 90);
  field.keep(fill_coverage(raster::DitheredCoverage(field.pen(15)), raster::FillRule::non_zero, vertices,
                           workspace));
  field.keep(fill_coverage(raster::DitheredCoverage(raster::Xor<F>(field.target, F::max_index, field.area),
                                                    raster::DitherPattern::reversed),
                           raster::FillRule::non_zero, field.template ring<3>(130, 120), workspace));
}

/// Over stripes, so that what is below counts.
template <image::PixelFormat F>
void draw_blended(const Field<F>& field, const image::BlendTable& table) {
  for (int i = 0; i < 8; ++i)
    field.keep(fill_rect(field.pen(static_cast<unsigned>(2 * i)),
                         {field.area.x + field.area.width * i / 8, field.area.y, field.area.width / 8 + 1,
                          field.area.height}));
  const auto blend = raster::BlendCoverage<F>::over(field.target, table, field.area);
  field.keep(blend.status());
  if (!blend.ok()) return;
  CoverageRow workspace;
  field.keep(
      fill_coverage(blend.value(), raster::FillRule::non_zero, field.template ring<5>(105, 144), workspace));
}

/// The tiles of a floor that goes away to the right, by three rungs.
template <image::PixelFormat F>
void draw_floor(const Field<F>& field) {
  const int steps = field.area.width < 2 ? 1 : field.area.width - 1;
  const auto far = static_cast<std::uint32_t>(500 + field.turn.steps() / 40);
  const auto run = raster::Perspective::by_depths(field.turn.steps(), 2'000'000, 100, far, steps);
  field.keep(run.status());
  if (!run.ok()) return;
  for (int band = 0; band < 3; ++band) {
    const int top = field.area.y + field.area.height * band / 3;
    int x = field.area.x;
    const auto take = [&](int value) {
      field.keep(draw_vertical(field.pen(static_cast<unsigned>(value >> 16) & 15U), {x++, top},
                               field.area.height / 3));
    };
    if (band == 0)
      raster::walk_perspective<raster::PerspectiveEveryPixel>(run.value(), 0, steps + 1, take);
    else if (band == 1)
      raster::walk_perspective<raster::PerspectiveEvery<16>>(run.value(), 0, steps + 1, take);
    else
      raster::walk_perspective<raster::PerspectiveAffine>(run.value(), 0, steps + 1, take);
  }
}

}  // namespace apps::primitives
