// SPDX-License-Identifier: MIT
//
// Counts whole frames: scene by scene, variant by variant, frame by frame. After each count are reported:
// bytes of stack, and a digest of picture and palette, which must be the same on every core; the highest bit
// of the stack says that the program reported an error.
#include <cstdint>
#include <firmware/lab/count/probe.hpp>
#include <firmware/lab/count/stack_depth.hpp>
#include <firmware/lab/frames/digest.hpp>
#include <firmware/lab/frames/scene.hpp>

namespace {

void count(const lab::frames::Scene& scene, std::uint32_t frame) noexcept {
  const std::uintptr_t here = lab::stack_pointer();
  lab::StackDepth::paint();
  lab::probe::begin();
  const intaglio::Status status = scene.draw(frame);
  lab::probe::end();
  const std::uint32_t depth = lab::StackDepth::since_paint(here);
  lab::probe::report(status.ok() ? depth : depth | 1U << 31U);
  lab::probe::report(lab::frames::digest(scene));
}

}  // namespace

int main() {
  for (const lab::frames::Scene& scene : lab::frames::scenes()) {
    for (int variant = 0; variant < scene.variants(); ++variant) {
      scene.start_variant(variant);
      for (const std::uint32_t frame : lab::frames::looked_at) count(scene, frame);
    }
  }
  lab::probe::finish();
}
