// SPDX-License-Identifier: MIT
//
// A card of every primitive of the library, each in a field of its own and turning a little every frame. Most
// figures are cut by their field's edges, and some are far larger than any screen: equal digests on two
// machines say something of each.
//
// A new primitive gets a function in one of the headers beside this one, and an entry in `fields`.
#pragma once

#include <intaglio/image/blend_table.hpp>
#include <intaglio/image/palette.hpp>
#include <intaglio/present/screen_info.hpp>
#include <intaglio/raster/rectangle.hpp>

#include <array>
#include <cstdint>
#include <firmware/apps/primitives/curves.hpp>
#include <firmware/apps/primitives/field.hpp>
#include <firmware/apps/primitives/layers.hpp>
#include <firmware/apps/primitives/lines.hpp>
#include <firmware/apps/primitives/pictures.hpp>
#include <firmware/apps/primitives/polygons.hpp>
#include <firmware/apps/primitives/smooth.hpp>
#include <span>

namespace apps::primitives {

/// Looks best from 320x240 pixels up; draws on any size.
template <image::PixelFormat F>
class Primitives {
 public:
  explicit Primitives(const intaglio::present::ScreenInfo& screen)
      : size_(screen.size), paletted_(screen.palette_entries != 0) {
    for (unsigned i = 0; i < indices; ++i) {
      const unsigned step = i * 255U / (indices - 1U);
      colours_
          .set(static_cast<int>(i),
               {static_cast<std::uint8_t>(step), static_cast<std::uint8_t>(step * step / 255U),
                static_cast<std::uint8_t>(i == indices - 1U ? 255U : step * 5U)})
          .ignore();
    }
    image::make_blend_table(blended_, colours_.bytes(), static_cast<int>(indices) - 1, blend_steps).ignore();
  }

  /// The state of that frame.
  void update(std::uint32_t frame) { turn_ = Angle::from_steps(static_cast<int>(frame * 547U % 65536U)); }
  std::span<const std::uint8_t> palette() const {
    return paletted_ ? colours_.bytes() : std::span<const std::uint8_t>{};
  }

  Status draw(image::Surface<F> target) const {
    FirstFault faults;
    faults.keep(fill_rect(raster::Solid<F>(target, 0), {0, 0, size_.width, size_.height}));
    constexpr int count = static_cast<int>(fields.size()) + 1;
    const int columns = columns_for(count);
    const int rows = (count + columns - 1) / columns;
    for (int i = 0; i < count; ++i) {
      const int left = size_.width * (i % columns) / columns;
      const int right = size_.width * (i % columns + 1) / columns;
      const int top = size_.height * (i / columns) / rows;
      const int bottom = size_.height * (i / columns + 1) / rows;
      // A free column and row between fields, where there is room.
      const Rect area{left, top, shortened(right - left), shortened(bottom - top)};
      const Field<F> field{target, area, turn_ + Angle::from_degrees(7 * i), &faults};
      if (i + 1 < count)
        fields[static_cast<std::size_t>(i)](field);
      else
        blend(field);
    }
    return faults.status();
  }

 private:
  using Draw = void (*)(const Field<F>&);
  static constexpr unsigned indices = F::max_index + 1U;
  static constexpr int blend_steps = 4;
  static constexpr std::array<Draw, 39> fields{draw_points<F>,
                                               draw_rectangles<F>,
                                               draw_long_lines<F>,
                                               draw_sub_pixel_lines<F>,
                                               draw_line_rungs<F>,
                                               draw_dashes<F>,
                                               draw_thick_lines<F>,
                                               draw_polylines<F>,
                                               draw_clipped_lines<F>,
                                               draw_circles<F>,
                                               draw_discs<F>,
                                               draw_rings<F>,
                                               draw_arcs<F>,
                                               draw_pies<F>,
                                               draw_chords<F>,
                                               draw_ellipses<F>,
                                               draw_circles_by_diameter<F>,
                                               draw_round_rectangles<F>,
                                               draw_parts_of_ellipses<F>,
                                               draw_triangles<F>,
                                               draw_polygons<F>,
                                               draw_convex_polygons<F>,
                                               draw_combination<F>,
                                               draw_walked_combination<F>,
                                               draw_clipped<F>,
                                               draw_floods<F>,
                                               draw_smooth_star<F>,
                                               draw_smooth_lines<F>,
                                               draw_pitteway_polygon<F>,
                                               draw_dithered<F>,
                                               draw_supersampled<F>,
                                               draw_sampled<F>,
                                               draw_visible_areas<F>,
                                               draw_mask_layers<F>,
                                               draw_floor<F>,
                                               draw_sprites<F>,
                                               draw_scaled<F>,
                                               draw_turned<F>,
                                               draw_sheared<F>};

  /// As many columns as make the fields about square.
  [[nodiscard]] int columns_for(int count) const {
    int columns = 1;
    while (columns < count &&
           std::int64_t{size_.height} * columns * columns < std::int64_t{size_.width} * count)
      ++columns;
    return columns;
  }
  [[nodiscard]] static int shortened(int side) {
    const int inner = side > 8 ? side - 1 : side;
    return inner < longest_side ? inner : longest_side;
  }
  void blend(const Field<F>& field) const {
    const auto table = image::BlendTable::over(blended_, static_cast<int>(indices),
                                               static_cast<int>(indices) - 1, blend_steps);
    field.keep(table.status());
    if (table.ok()) draw_blended(field, table.value());
  }

  linear::Size size_;
  bool paletted_;
  Angle turn_{};
  image::Palette<static_cast<int>(indices)> colours_;
  std::array<std::uint8_t, image::BlendTable::bytes(static_cast<int>(indices), blend_steps)> blended_{};
};

}  // namespace apps::primitives
