// SPDX-License-Identifier: MIT
//
// What drawing costs: each primitive through its public, clipped call, counted in instructions.
//
// Rule: a row is one call on a 320x240 surface of 8 bits a pixel, or of a function that draws nothing. Its
// arguments are opaque to the compiler, its status is used, and the sink exists before (it is the caller's
// pen). Counted is all from the call to the return, less what an empty row costs. Pixels are counted
// afterwards in the buffer, not taken on trust.
// Output, one line a row: `row NAME;PIXELS;INSTRUCTIONS;UNITS`, and one a pair:
// `pair NAME;FILLING;FAR` in instructions, which tests/target/bounded_work reads.
#include <cstddef>
#include <cstdint>
#include <firmware/boards/common/semihosting.hpp>
#include <firmware/boards/mps2/count/instructions.hpp>
#include <firmware/boards/mps2/count/rig.hpp>

namespace {

using namespace boards::mps2;
namespace semihosting = boards::semihosting;

constexpr linear::Size screen{320, 240};
alignas(4) constinit std::uint8_t pixels[static_cast<std::size_t>(screen.width) * screen.height];

class Bench {
 public:
  explicit Bench(const Pen& pen) noexcept : pen_(pen) {
    void (*volatile nothing)(const Pen&) = [](const Pen&) {};
    overhead_ = measured(nothing);
  }

  /// Instructions of one call on an empty screen.
  [[nodiscard]] std::uint32_t count(void (*draw)(const Pen&)) const noexcept {
    for (std::uint8_t& pixel : pixels) pixel = 0;
    return measured(draw) - overhead_;
  }

 private:
  /// Never inlined, so that all calls, the empty one too, are made in the same way.
  [[nodiscard, gnu::noinline]] std::uint32_t measured(void (*draw)(const Pen&)) const noexcept {
    return counter_.measure([&] { draw(pen_); });
  }

  const Pen& pen_;
  InstructionCounter counter_;
  std::uint32_t overhead_ = 0;
};

/// Writes a number and what follows it.
void write(std::uint32_t number, const char* then) noexcept {
  semihosting::write(number);
  semihosting::write(then);
}

}  // namespace

int main() {
  const auto surface = image::Surface<Format>::over(pixels, screen);
  if (!surface.ok()) semihosting::exit(1);
  Pen pen(surface.value(), 1);
  asm volatile("" : : "r"(&pen) : "memory");
  const Bench bench(pen);
  for (const auto& rows :
       {basic_rows, line_rows, curve_rows, polygon_rows, smooth_rows, picture_rows, composed_rows}) {
    for (const Row& row : rows) {
      const std::uint32_t instructions = bench.count(row.draw);
      std::uint32_t drawn = 0;
      for (const std::uint8_t pixel : pixels) drawn += pixel != 0 ? 1 : 0;
      semihosting::write("row ");
      semihosting::write(row.name);
      semihosting::write(";");
      write(drawn, ";");
      write(instructions, ";");
      write(row.units == nullptr ? 0 : row.units(pen), "\n");
    }
  }
  for (const Pair& pair : pairs) {
    semihosting::write("pair ");
    semihosting::write(pair.name);
    semihosting::write(";");
    write(bench.count(pair.filling), ";");
    write(bench.count(pair.far), "\n");
  }
  semihosting::exit(0);
}
