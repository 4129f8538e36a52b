// SPDX-License-Identifier: MIT
//
// What can be turned to make a frame cheaper or more accurate: a type with these members.
//
// Rule: a knob is a constant of the program's type, so a setting that isn't used costs neither code nor time.
// `intaglio-lab budget` says what each of them costs and how far it is from the most accurate picture.
#pragma once

#include <intaglio/number/sine.hpp>
#include <intaglio/number/sine_rungs.hpp>

#include <cstdint>
#include <firmware/apps/theme.hpp>

namespace apps::gauges {

/// How the edges of needles and ticks are drawn.
enum class Edges : std::uint8_t {
  hard,     ///< A pixel is covered or it isn't.
  box_2x2,  ///< By 2x2 samples a pixel.
  box_4x4,  ///< By 4x4 samples.
  area,     ///< By the exact area.
};

/// The knobs of the program as it is.
struct DefaultKnobs {
  /// What places everything that turns.
  using Sine = intaglio::number::SineTable256Linear;
  /// How colours fade and glow.
  using Mixing = MixLight;
  /// Wedges that a bezel's metal is made of, a power of two of at most 1024.
  static constexpr int wedges = 64;
  /// Discs that a dial's face is shaded with, 1 .. ink::face_steps.
  static constexpr int face_steps = 12;
  /// Edges of needles and ticks. Smooth ones need 8 bits a pixel and 256 entries; elsewhere they are hard.
  static constexpr Edges edges = Edges::hard;
  /// Palette entries between the face and each of the colours that have smooth edges: 0, or up to 15.
  static constexpr int edge_steps = 0;
};

/// The most accurate setting of each.
struct FinestKnobs : DefaultKnobs {
  using Sine = intaglio::number::SineCordic;
  static constexpr int wedges = 128;
  static constexpr Edges edges = Edges::area;
  static constexpr int edge_steps = 15;
};

}  // namespace apps::gauges
