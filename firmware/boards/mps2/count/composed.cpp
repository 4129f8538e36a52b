// SPDX-License-Identifier: MIT
//
// Counted: what is made of other primitives. Here, because a second use in a file changes how compilers
// inline those, and so what they cost.
#include <intaglio/raster/ring_arc.hpp>
#include <intaglio/text/draw_aligned_text.hpp>

#include <firmware/boards/mps2/count/rig.hpp>
#include <intaglio_fonts/fixed_6x13.hpp>

namespace boards::mps2 {

namespace {

namespace text = intaglio::text;

constexpr Point middle{160, 120};
constexpr number::Angle start = number::Angle::from_degrees(30);
constexpr int sweep = number::Angle::turn / 3;

constexpr Row rows[] = {
    {"ring r=40..50, a third",
     [](const Pen& pen) {
       use(raster::fill_ring_arc(pen, opaque(middle), opaque(40), opaque(50), start, opaque(sweep)));
     }},
    {"text 10 of 6x13, centred",
     [](const Pen& pen) {
       use(text::draw_aligned_text(pen, intaglio::fonts::fixed_6x13, opaque(Rect{101, 77, 100, 60}),
                                   text::Alignment::centre, text::Baseline::middle, "Intaglio2D"));
     }},
};

}  // namespace

constinit const std::span<const Row> composed_rows = rows;

}  // namespace boards::mps2
