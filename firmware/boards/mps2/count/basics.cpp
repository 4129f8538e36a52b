// SPDX-License-Identifier: MIT
//
// Counted: pixels, runs, rectangles, text, and the arithmetic under it all.
#include <intaglio/image/digest.hpp>
#include <intaglio/number/root.hpp>
#include <intaglio/raster/pixel.hpp>
#include <intaglio/raster/rectangle.hpp>
#include <intaglio/text/draw_text.hpp>

#include <firmware/boards/mps2/count/rig.hpp>
#include <intaglio_fonts/fixed_6x13.hpp>

namespace boards::mps2 {

namespace {

constexpr Row rows[] = {
    {"pixel",
     [](const Pen& pen) {
       use(raster::draw_pixel(pen, opaque(Point{100, 77})));
     }},
    {"span 64",
     [](const Pen& pen) {
       use(raster::draw_horizontal(pen, opaque(Point{100, 77}), opaque(64)));
     }},
    {"span 320",
     [](const Pen& pen) {
       use(raster::draw_horizontal(pen, opaque(Point{0, 77}), opaque(320)));
     }},
    {"span 64 odd",
     [](const Pen& pen) {
       use(raster::draw_horizontal(pen, opaque(Point{101, 77}), opaque(64)));
     }},
    {"column 64",
     [](const Pen& pen) {
       use(raster::draw_vertical(pen, opaque(Point{100, 77}), opaque(64)));
     }},
    {"clear 320x240",
     [](const Pen& pen) {
       use(raster::fill_rect(pen, opaque(Rect{0, 0, 320, 240})));
     }},
    {"fill_rect 100x60",
     [](const Pen& pen) {
       use(raster::fill_rect(pen, opaque(Rect{101, 77, 100, 60})));
     }},
    {"draw_rect 100x60",
     [](const Pen& pen) {
       use(raster::draw_rect(pen, opaque(Rect{101, 77, 100, 60})));
     }},
    {"text 10 of 6x13",
     [](const Pen& pen) {
       use(intaglio::text::draw_text(pen, intaglio::fonts::fixed_6x13, opaque(Point{101, 77}), "Intaglio2D"));
     }},
    {"digest 320x240",
     [](const Pen& pen) {
       image::FrameDigest digest(pen.surface().size(), {});
       digest.add(image::Picture<Format>(pen.surface()));
       use(digest.value());
     }},
    {"sine",
     [](const Pen&) {
       const auto angle = number::Angle::from_steps(opaque(12345));
       use(static_cast<std::uint32_t>(number::sine(angle).raw()));
     }},
    {"isqrt 32", [](const Pen&) { use(number::isqrt(static_cast<std::uint32_t>(opaque(1234567890)))); }},
    {"isqrt 64",
     [](const Pen&) {
       use(number::isqrt(static_cast<std::uint64_t>(opaque(1234567890)) << 32U | 987654321U));
     }},
};

}  // namespace

constinit const std::span<const Row> basic_rows = rows;

}  // namespace boards::mps2
