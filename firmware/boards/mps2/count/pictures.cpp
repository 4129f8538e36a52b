// SPDX-License-Identifier: MIT
//
// Counted: pictures copied, stretched, turned and dithered; flood fill.
#include <intaglio/image/blit.hpp>
#include <intaglio/image/dither.hpp>
#include <intaglio/image/rotate_rungs.hpp>
#include <intaglio/image/rotozoom.hpp>
#include <intaglio/image/scale.hpp>
#include <intaglio/image/scale_rungs.hpp>
#include <intaglio/image/three_shear.hpp>
#include <intaglio/raster/flood.hpp>

#include <firmware/boards/mps2/count/rig.hpp>

namespace boards::mps2 {

namespace {

// A picture to copy: 64x64 pixels of index 1 and 2 by turns.
constexpr auto checkered = [] {
  std::array<std::uint8_t, 64 * 64> indices{};
  for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = i % 2 == 0 ? 1 : 2;
  return indices;
}();
constexpr auto checkers = image::Picture<Format>::over(checkered, {64, 64}).value();

// A mask: a disc that fills it nearly.
constexpr auto disc_bits = [] {
  std::array<std::uint8_t, 64 * 8> bits{};
  for (int y = -63; y <= 63; y += 2)
    for (int x = -63; x <= 63; x += 2)
      if (x * x + y * y < 60 * 60)
        bits[static_cast<std::size_t>((y + 63) * 4 + (x + 63) / 16)] |=
            static_cast<std::uint8_t>(128 >> (x + 63) / 2 % 8);
  return bits;
}();
constexpr auto disc = image::Picture<image::Indexed1>::over(disc_bits, {64, 64}).value();

// A table for 8 bits a pixel.
constexpr auto complements = [] {
  std::array<std::uint8_t, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) table[i] = static_cast<std::uint8_t>(255 - i);
  return table;
}();

raster::FloodSpan flood_spans[64];

std::int16_t owed[66];  // by error diffusion, a row of 64

template <class Rung>
void stretch(const Pen& pen, const Rect& to) {
  use(Rung{}(pen.surface(), to, checkers));
}
template <class Rung>
void dither(const Pen& pen) {
  use(image::blit_dithered<Rung>(pen.surface(), opaque(Point{101, 77}), checkers, opaque(200), owed));
}

constexpr Row rows[] = {
    {"blit 64x64",
     [](const Pen& pen) {
       use(image::blit(pen.surface(), opaque(Point{101, 77}), checkers));
     }},
    {"blit 64x64 keyed",
     [](const Pen& pen) {
       use(image::blit(pen.surface(), opaque(Point{101, 77}), checkers, image::ColourKey{2}));
     }},
    {"blit 64x64 to 100x60",
     [](const Pen& pen) {
       use(image::blit_scaled(pen.surface(), opaque(Rect{101, 77, 100, 60}), checkers));
     }},
    {"blit 64x64 to 100x60, bilinear in 1/16",
     [](const Pen& pen) {
       stretch<image::ScaleBilinear4>(pen, opaque(Rect{101, 77, 100, 60}));
     }},
    {"blit 64x64 to 100x60, bilinear in 1/256",
     [](const Pen& pen) {
       stretch<image::ScaleBilinear8>(pen, opaque(Rect{101, 77, 100, 60}));
     }},
    {"blit 64x64 to 100x60, boxes",
     [](const Pen& pen) {
       stretch<image::ScaleBox>(pen, opaque(Rect{101, 77, 100, 60}));
     }},
    {"blit 64x64 to 25x15, boxes",
     [](const Pen& pen) {
       stretch<image::ScaleBox>(pen, opaque(Rect{101, 77, 25, 15}));
     }},
    {"blit 64x64 turned by 30",
     [](const Pen& pen) {
       image::Rotozoom placement;
       placement.position = opaque(SubPoint{160 * 256, 120 * 256});
       placement.pivot = {128 * 63, 128 * 63};
       placement.angle = number::Angle::from_steps(opaque(number::Angle::turn / 12));
       use(image::blit_rotozoom(pen.surface(), placement, checkers));
     }},
    {"blit 64x64 turned by 30, bilinear",
     [](const Pen& pen) {
       image::ThreeShear placement;
       placement.position = opaque(SubPoint{160 * 256, 120 * 256});
       placement.pivot = {128 * 63, 128 * 63};
       placement.angle = number::Angle::from_steps(opaque(number::Angle::turn / 12));
       use(image::RotateBilinear{}(pen.surface(), placement, checkers));
     }},
    {"blit 64x64 turned by 30, three shears",
     [](const Pen& pen) {
       image::ThreeShear placement;
       placement.position = opaque(SubPoint{160 * 256, 120 * 256});
       placement.pivot = {128 * 63, 128 * 63};
       placement.angle = number::Angle::from_steps(opaque(number::Angle::turn / 12));
       use(image::blit_three_shear(pen.surface(), placement, checkers));
     }},
    {"blit 64x64 through a mask",
     [](const Pen& pen) {
       use(image::blit(pen.surface(), opaque(Point{101, 77}), checkers, image::Masked{checkers}));
     }},
    {"blit 64x64 through a mask of bits",
     [](const Pen& pen) {
       use(image::blit(pen.surface(), opaque(Point{101, 77}), checkers, image::Masked{disc}));
     }},
    {"blit 64x64 through a table",
     [](const Pen& pen) {
       use(image::blit(pen.surface(), opaque(Point{101, 77}), checkers, image::Remap{complements}));
     }},
    {"blit 64x64 to 200 levels", [](const Pen& pen) { dither<image::DitherNone>(pen); }},
    {"blit 64x64 dithered, Bayer 8x8", [](const Pen& pen) { dither<image::DitherOrdered8>(pen); }},
    {"blit 64x64 dithered, three taps", [](const Pen& pen) { dither<image::DitherThreeTap>(pen); }},
    {"blit 64x64 dithered, Floyd-Steinberg", [](const Pen& pen) { dither<image::DitherFourTap>(pen); }},
    {"blit 64x64 dithered, serpentine", [](const Pen& pen) { dither<image::DitherSerpentine>(pen); }},
    {"flood 100x60",
     [](const Pen& pen) {
       const Pen bounded(pen.surface(), 1, opaque(Rect{101, 77, 100, 60}));
       use(raster::flood_fill(bounded, raster::Connectivity::four, opaque(Point{150, 100}), flood_spans));
     }},
};

}  // namespace

constinit const std::span<const Row> picture_rows = rows;

}  // namespace boards::mps2
