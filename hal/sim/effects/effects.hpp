// SPDX-License-Identifier: MIT
//
// What a real panel does to a picture, as parameters: each effect stands alone, and a scenario has those it
// declares. A panel's own values lie in its table (`PanelSpec::effects`).
//
// Rule: effects of time act in the order in which a frame meets them: drawing, bus, memory, palette latch,
// scan-out; then those of the glass in the order of light: depth, gamma, response, dead pixels, grid. Each
// takes what the one before left. An effect that isn't declared is no code that runs (`effect_calls`).
#pragma once

#include <hal/clock.hpp>
#include <hal/panel.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace hal::sim {

enum class Effect : std::uint8_t {
  draw,
  garbage,
  bus,
  latch,
  te,
  drift,
  scan,
  tearing,
  depth,
  gamma,
  response,
  dead,
  grid,
};
inline constexpr std::size_t effect_count = 13;

/// How often the code of each effect has run in this process: 0 for those that no scenario declared.
inline std::array<std::uint64_t, effect_count> effect_calls{};
inline void note_call(Effect effect) { ++effect_calls[static_cast<std::size_t>(effect)]; }

/// The time that the program takes to draw a frame: `least` and evenly spread up to `spread` more.
struct DrawTime {
  Nanoseconds least = 0;
  Nanoseconds spread = 0;
};

/// The bus of a write panel. Nothing else moves while bytes do.
struct BusTiming {
  std::uint32_t hertz = 10'000'000;  ///< Of its clock; at least 1.
  int clocks_per_byte = 8;           ///< 9 on I2C.
  int bits_per_pixel = 0;            ///< On the wire; 0: as the panel's format says.
  int command_bytes = 11;            ///< That set a window before its pixels are sent.
  Nanoseconds gap = 2'000;           ///< Chip select, data/command line and driver, a window.
};

/// The tearing-effect line, or the interrupt of VBLANK.
struct TeTiming {
  bool connected = true;         ///< False: the program counts frames by its own clock at the nominal rate.
  std::uint32_t millihertz = 0;  ///< The rate that the panel really has; 0: the nominal one.
  Nanoseconds phase = 0;         ///< From the beginning of VBLANK to the edge.
  Nanoseconds jitter = 0;        ///< Evenly spread up to that much later.
};

/// The refresh rate differs from the nominal one: by `ppm`, or going to and fro between -ppm and +ppm within
/// `period` (a triangle wave; 0: it stays).
struct RefreshDrift {
  int ppm = 200;
  Nanoseconds period = 0;
};

/// What memory and palette hold at power-on: noise.
struct PowerOnGarbage {
  std::uint64_t seed = 1;
};

/// Bits of red, green and blue that reach the glass, 1..8.
struct ColourDepth {
  std::array<int, 3> bits{5, 6, 5};
};

/// Light = (level / highest level) ^ (hundredths / 100), where the desk's screen has the sRGB curve.
struct PanelGamma {
  int hundredths = 220;  ///< 50..500
};

/// Times from 10 % to 90 % of the way, up and down. At most 500 ms each.
struct ResponseTime {
  Nanoseconds rise = 8'000'000;
  Nanoseconds fall = 8'000'000;
};

/// Light that one pixel shows whatever it is sent.
struct DeadPixel {
  int x = 0;
  int y = 0;
  std::array<std::uint8_t, 3> colour{};
};

/// How a pixel is made.
enum class Stripes : std::uint8_t { rgb, bgr, none };

/// The viewer's picture enlarged: `scale` screen pixels a side, the last of them dark.
struct PixelGrid {
  int scale = 4;  ///< 2..32, at least 4 with stripes.
  Stripes stripes = Stripes::rgb;
};

/// When colours take effect.
enum class PaletteLatch : std::uint8_t {
  at_vblank,     ///< With the buffer.
  at_once,       ///< Colours in the middle of a picture, the buffer at VBLANK: a look-up table not shadowed.
  both_at_once,  ///< Buffer, too: no latch at all.
};

/// The effects that a scenario declares, with their parameters.
struct Effects {
  std::optional<DrawTime> draw{};
  std::optional<PowerOnGarbage> garbage{};
  std::optional<BusTiming> bus{};
  std::optional<PaletteLatch> latch{};
  std::optional<TeTiming> te{};
  std::optional<RefreshDrift> drift{};
  std::optional<ScanDirection> scan{};
  bool tearing = false;
  std::optional<ColourDepth> depth{};
  std::optional<PanelGamma> gamma{};
  std::optional<ResponseTime> response{};
  std::vector<DeadPixel> dead{};
  std::optional<PixelGrid> grid{};
};

/// What the effects are on a certain panel where a scenario names them without a value. Those that aren't
/// here are the same on all panels.
struct EffectTable {
  BusTiming bus{};
  ColourDepth depth{};
  ResponseTime response{};
  PixelGrid grid{};
};

}  // namespace hal::sim
