// SPDX-License-Identifier: MIT
//
// Placements of turned pictures, as their oracles take them: with sine and cosine of the library, which have
// tests and an error bound of their own.
#pragma once

#include <intaglio/image/rotozoom.hpp>
#include <intaglio/image/three_shear.hpp>
#include <intaglio/number/sine.hpp>
#include <tests/oracle/rotozoom.hpp>
#include <tests/oracle/three_shear.hpp>

namespace tests {

inline oracle::Rotozoom oracle_of(const intaglio::image::Rotozoom& p) {
  return {p.position.x,
          p.position.y,
          p.pivot.x,
          p.pivot.y,
          intaglio::number::cosine(p.angle).raw(),
          intaglio::number::sine(p.angle).raw(),
          p.scale.raw()};
}

/// The rest is the angle's distance from the nearest quarter turn; half-way it is an eighth back.
inline oracle::ThreeShear oracle_of(const intaglio::image::ThreeShear& p, intaglio::linear::Size source) {
  int quarters = 0;
  int rest = p.angle.steps();
  while (rest >= 8192) {
    rest -= 16384;
    ++quarters;
  }
  const auto angle = intaglio::number::Angle::from_steps(rest);
  return {source.width,
          source.height,
          p.position.x,
          p.position.y,
          p.pivot.x,
          p.pivot.y,
          quarters,
          intaglio::number::sine(angle).raw(),
          intaglio::number::cosine(angle).raw()};
}

}  // namespace tests
