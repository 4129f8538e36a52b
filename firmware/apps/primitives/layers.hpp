// SPDX-License-Identifier: MIT
//
// Fields with supersampled figures, and with polygons one behind the other.
#pragma once

#include <intaglio/raster/adaptive.hpp>
#include <intaglio/raster/enlargement.hpp>
#include <intaglio/raster/inside.hpp>
#include <intaglio/raster/mask_buffer.hpp>
#include <intaglio/raster/polygon.hpp>
#include <intaglio/raster/stochastic.hpp>
#include <intaglio/raster/supersample.hpp>
#include <intaglio/raster/triangle.hpp>
#include <intaglio/raster/visible_area.hpp>

#include <firmware/apps/primitives/field.hpp>
#include <firmware/apps/primitives/smooth.hpp>

namespace apps::primitives {

/// A star through a window of samples that overlaps its neighbours'.
template <image::PixelFormat F>
void draw_supersampled(const Field<F>& field) {
  std::array<raster::SampleCell, longest_side> workspace;
  constexpr raster::Supersampling grid{.scale = 3, .width = 5, .filter = raster::SampleFilter::bartlett};
  const raster::Enlargement enlarge(grid.scale);
  auto star = field.template ring<5>(105, 144);
  for (SubPoint& p : star) p = enlarge.place(p);
  std::array<raster::PolygonEdge, 5> edges;
  field.keep(supersample(ramp_of(field), grid, workspace, [&](auto& samples) {
    return fill_polygon(samples, raster::FillRule::non_zero, star, edges);
  }));
}

/// A triangle sampled where its edges are, and another at random places.
template <image::PixelFormat F>
void draw_sampled(const Field<F>& field) {
  constexpr int scale = 4;
  for (int i = 0; i < 2; ++i) {
    auto triangle = field.template ring<3>(80 - 30 * i, 120, 60 * i);
    for (SubPoint& p : triangle) p = raster::Enlargement(scale).place(p);
    const auto inside = [&](SubPoint p) {
      const auto answer = raster::inside_convex(triangle, p);
      return answer.ok() && answer.value();
    };
    field.keep(i == 0 ? cover_adaptively(ramp_of(field), field.area, scale, inside)
                      : cover_stochastically(ramp_of(field), field.area, scale, 2021, inside));
  }
}

/// Draws the pixels of which a layer is at least half.
template <image::PixelFormat F>
struct LayerInks {
  const Field<F>& field;

  [[nodiscard]] Rect clip() const { return field.pen(0).clip(); }
  void span(int layer, int y, int x_begin, int x_end, int coverage) const {
    if (coverage >= 128) field.pen(static_cast<unsigned>(15 - 4 * layer)).span(y, x_begin, x_end);
  }
};

/// Three triangles, front first, once by their exact areas and once by masks.
template <image::PixelFormat F>
void draw_layers(const Field<F>& field, bool exact) {
  std::array<std::array<SubPoint, 3>, 3> triangles;
  for (std::size_t i = 0; i < 3; ++i)
    triangles[i] = field.template ring<3>(60 + 30 * static_cast<int>(i), 120, 40 * static_cast<int>(i));
  if (exact) {
    constexpr int three[] = {3};
    std::array<raster::DepthPolygon, 3> polygons;
    for (std::size_t i = 0; i < 3; ++i) polygons[i] = {raster::FillRule::non_zero, triangles[i], three};
    std::array<raster::VisibleEntry, 12> workspace;
    field.keep(cover_front_to_back(LayerInks<F>{field}, polygons, workspace));
    return;
  }
  const raster::Enlargement enlarge(4, 8);
  std::array<raster::MaskCell, longest_side> workspace;
  field.keep(cover_by_masks(
      LayerInks<F>{field}, raster::MaskGrid::four_by_eight, 3, workspace, [&](int layer, auto& parts) {
        const auto& t = triangles[static_cast<std::size_t>(layer)];
        return fill_triangle(parts, enlarge.place(t[0]), enlarge.place(t[1]), enlarge.place(t[2]));
      }));
}

template <image::PixelFormat F>
void draw_visible_areas(const Field<F>& field) {
  draw_layers(field, true);
}
template <image::PixelFormat F>
void draw_mask_layers(const Field<F>& field) {
  draw_layers(field, false);
}

}  // namespace apps::primitives
