// SPDX-License-Identifier: MIT
//
// What drawing costs: each primitive through its public, clipped call, counted in instructions.
//
// Rule: a row is one call on a 320x240 surface of 8 bits a pixel, or of a function that draws nothing. Its
// arguments are opaque to the compiler, its status is used, and the sink exists before (it is the caller's
// pen). Counted is all from the call to the return, less what an empty row costs. Pixels are counted
// afterwards in the buffer, not taken on trust.
// Output, one line a row: `row NAME;PIXELS;INSTRUCTIONS`. tests/target/speed reads it.
#include <intaglio/image/blit.hpp>
#include <intaglio/image/digest.hpp>
#include <intaglio/number/root.hpp>
#include <intaglio/number/sine.hpp>
#include <intaglio/raster/circle.hpp>
#include <intaglio/raster/disc.hpp>
#include <intaglio/raster/line.hpp>
#include <intaglio/raster/pixel.hpp>
#include <intaglio/raster/polygon.hpp>
#include <intaglio/raster/rectangle.hpp>
#include <intaglio/raster/solid.hpp>
#include <intaglio/raster/triangle.hpp>
#include <intaglio/text/draw_text.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <firmware/boards/common/semihosting.hpp>
#include <firmware/boards/mps2/count/instructions.hpp>
#include <intaglio_fonts/fixed_6x13.hpp>

namespace {

using namespace intaglio;
using linear::Point;
using linear::Rect;
using Format = image::Indexed8;
using Pen = raster::Solid<Format>;

constexpr linear::Size screen{320, 240};
alignas(4) constinit std::uint8_t pixels[static_cast<std::size_t>(screen.width) * screen.height];

// A value that the compiler knows nothing about.
int opaque(int value) noexcept {
  asm volatile("" : "+r"(value));
  return value;
}

void use(Status status) noexcept { asm volatile("" : : "r"(status)); }
void use(std::uint32_t value) noexcept { asm volatile("" : : "r"(value)); }

// A picture to copy: 64x64 pixels of index 1 and 2 by turns.
constexpr auto checkered = [] {
  std::array<std::uint8_t, 64 * 64> indices{};
  for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = i % 2 == 0 ? 1 : 2;
  return indices;
}();
constexpr auto checkers = image::Picture<Format>::over(checkered, {64, 64}).value();

// A star that crosses itself, about as large as the disc.
constexpr linear::SubPoint star[] = {
    {40960, 17920}, {48499, 41041}, {28787, 26753}, {53133, 26753}, {33421, 41041}};

// A coast of 1,400 vertices, as a map has it when zoomed in: a few of them in the window, the others
// thousands of pixels away on all sides.
constexpr auto coast = [] {
  std::array<linear::SubPoint, 1400> vertices{};
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const int along =
        static_cast<int>(i % 350) * 64 * 256 - 175 * 64 * 256;  // a square ring, 22,400 pixels wide
    const int across = 160 * 256 + static_cast<int>(i * 37 % 61) * 256;
    constexpr int far = 175 * 64 * 256;
    vertices[i] = i < 350    ? linear::SubPoint{along, across}
                  : i < 700  ? linear::SubPoint{far + across, across + along + far}
                  : i < 1050 ? linear::SubPoint{-along, 2 * far + across}
                             : linear::SubPoint{-far - across, across - along + far};
  }
  return vertices;
}();

raster::PolygonEdge edges[64];

struct Row {
  const char* name;
  void (*draw)(const Pen& pen);
};

// A primitive is counted by a line here, and its limit stands in tests/target/speed.
constexpr Row rows[] = {
    {"pixel",
     [](const Pen& pen) {
       use(raster::draw_pixel(pen, {opaque(100), opaque(77)}));
     }},
    {"span 64",
     [](const Pen& pen) {
       use(raster::draw_horizontal(pen, {opaque(100), opaque(77)}, opaque(64)));
     }},
    {"span 320",
     [](const Pen& pen) {
       use(raster::draw_horizontal(pen, {opaque(0), opaque(77)}, opaque(320)));
     }},
    {"span 64 odd",
     [](const Pen& pen) {
       use(raster::draw_horizontal(pen, {opaque(101), opaque(77)}, opaque(64)));
     }},
    {"column 64",
     [](const Pen& pen) {
       use(raster::draw_vertical(pen, {opaque(100), opaque(77)}, opaque(64)));
     }},
    {"clear 320x240",
     [](const Pen& pen) {
       use(raster::fill_rect(pen, {opaque(0), opaque(0), opaque(320), opaque(240)}));
     }},
    {"fill_rect 100x60",
     [](const Pen& pen) {
       use(raster::fill_rect(pen, {opaque(101), opaque(77), opaque(100), opaque(60)}));
     }},
    {"draw_rect 100x60",
     [](const Pen& pen) {
       use(raster::draw_rect(pen, {opaque(101), opaque(77), opaque(100), opaque(60)}));
     }},
    {"line (0,0)-(319,100)",
     [](const Pen& pen) {
       use(raster::draw_line(pen, {opaque(0), opaque(0)}, {opaque(319), opaque(100)}));
     }},
    {"line (10,10)-(60,200)",
     [](const Pen& pen) {
       use(raster::draw_line(pen, {opaque(10), opaque(10)}, {opaque(60), opaque(200)}));
     }},
    {"circle r=50",
     [](const Pen& pen) {
       use(raster::draw_circle(pen, {opaque(160), opaque(120)}, opaque(50)));
     }},
    {"disc r=50",
     [](const Pen& pen) {
       use(raster::fill_disc(pen, {opaque(160), opaque(120)}, opaque(50)));
     }},
    {"triangle legs 50",
     [](const Pen& pen) {
       const Point a{opaque(100), opaque(100)};
       const Point b{opaque(150), opaque(100)};
       const Point c{opaque(100), opaque(150)};
       use(raster::fill_triangle(pen, a, b, c));
     }},
    {"polygon star",
     [](const Pen& pen) { use(raster::fill_polygon(pen, raster::FillRule::even_odd, star, edges)); }},
    {"polygon of 1400",
     [](const Pen& pen) { use(raster::fill_polygon(pen, raster::FillRule::non_zero, coast, edges)); }},
    {"text 10 of 6x13",
     [](const Pen& pen) {
       use(text::draw_text(pen, fonts::fixed_6x13, {opaque(101), opaque(77)}, "Intaglio2D"));
     }},
    {"line clipped",
     [](const Pen& pen) {
       use(raster::draw_line(pen, {opaque(-30000), opaque(-20000)}, {opaque(30500), opaque(20300)}));
     }},
    {"blit 64x64",
     [](const Pen& pen) {
       use(image::blit(pen.surface(), {opaque(101), opaque(77)}, checkers));
     }},
    {"blit 64x64 keyed",
     [](const Pen& pen) {
       use(image::blit(pen.surface(), {opaque(101), opaque(77)}, checkers, image::ColourKey{2}));
     }},
    {"digest 320x240",
     [](const Pen& pen) {
       image::FrameDigest digest(screen, {});
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

int main() {
  namespace semihosting = boards::semihosting;
  const auto surface = image::Surface<Format>::over(pixels, screen);
  if (!surface.ok()) semihosting::exit(1);
  Pen pen(surface.value(), 1);
  asm volatile("" : : "r"(&pen) : "memory");
  const boards::mps2::InstructionCounter counter;
  void (*volatile nothing)(const Pen&) = [](const Pen&) {};
  auto* const empty = nothing;
  const std::uint32_t overhead = counter.measure([&] { empty(pen); });
  for (const Row& row : rows) {
    for (std::uint8_t& pixel : pixels) pixel = 0;
    auto* const draw = row.draw;
    const std::uint32_t instructions = counter.measure([&] { draw(pen); }) - overhead;
    std::uint32_t drawn = 0;
    for (const std::uint8_t pixel : pixels) drawn += pixel != 0 ? 1 : 0;
    semihosting::write("row ");
    semihosting::write(row.name);
    semihosting::write(";");
    semihosting::write(drawn);
    semihosting::write(";");
    semihosting::write(instructions);
    semihosting::write("\n");
  }
  semihosting::exit(0);
}
