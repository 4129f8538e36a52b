// SPDX-License-Identifier: MIT
//
// Every kind of blit, placed at random, for what must hold for all of them.
#pragma once

#include <intaglio/image/blit.hpp>
#include <intaglio/image/rotozoom.hpp>
#include <intaglio/image/scale.hpp>
#include <intaglio/image/three_shear.hpp>
#include <tests/oracle/random.hpp>

namespace tests {

/// Calls `use(draw)` for each of the blits, where `draw(target, source, rule, clip)` is one with a place that
/// suits pictures of these sizes.
template <class Use>
void with_each_blit(oracle::Random& random, intaglio::linear::Size target_size,
                    intaglio::linear::Size source_size, Use use) {
  using namespace intaglio;
  const auto angle = number::Angle::from_steps(random.between(0, 65535));
  const auto scale = number::Fixed<16>::from_raw(random.between(20000, 200000));
  const linear::SubPoint position{random.between(0, 256 * target_size.width),
                                  random.between(0, 256 * target_size.height)};
  const linear::SubPoint pivot{128 * (source_size.width - 1), 128 * (source_size.height - 1)};
  const linear::Point corner{random.between(-9, target_size.width), random.between(-9, target_size.height)};
  const linear::Rect stretched{corner.x, corner.y, random.between(1, 60), random.between(1, 60)};
  use([=](const auto& target, const auto& source, const auto&... rule_and_clip) {
    return image::blit(target, corner, source, rule_and_clip...);
  });
  use([=](const auto& target, const auto& source, const auto&... rule_and_clip) {
    return image::blit_scaled(target, stretched, source, rule_and_clip...);
  });
  use([=](const auto& target, const auto& source, const auto&... rule_and_clip) {
    return image::blit_rotozoom(target, {position, pivot, angle, scale}, source, rule_and_clip...);
  });
  use([=](const auto& target, const auto& source, const auto&... rule_and_clip) {
    return image::blit_three_shear(target, {position, pivot, angle}, source, rule_and_clip...);
  });
}

}  // namespace tests
