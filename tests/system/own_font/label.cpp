// SPDX-License-Identifier: MIT
#include <intaglio/raster/solid.hpp>
#include <intaglio/text/draw_text.hpp>

#include <cstdint>
#include <intaglio_fonts/fixed_5x8.hpp>
#include <intaglio_fonts/mono_9.hpp>

using namespace intaglio;

static_assert(fonts::mono_9.tables().glyphs.size() == 97);  // 95 of ASCII, e acute, the replacement box
static_assert(fonts::mono_9.tables().glyphs[1].advance == fonts::mono_9.tables().glyphs[95].advance);

Status draw_label(image::Surface<image::Indexed1> surface, bool small) {
  return text::draw_text(raster::Solid(surface, 1), small ? fonts::fixed_5x8 : fonts::mono_9, {0, 0},
                         "label");
}
