// SPDX-License-Identifier: MIT
#include <firmware/lab/frames/programs.hpp>

namespace lab::frames {
namespace {

alignas(16) constinit std::array<std::byte, room_bytes> room_memory{};
alignas(4) constinit std::array<std::uint8_t, static_cast<std::size_t>(size.width) * size.height> pixels{};
constinit std::array<Scene, 4> all{};

}  // namespace

void* room() noexcept { return room_memory.data(); }

intaglio::image::Surface<intaglio::image::Indexed8> canvas() noexcept {
  return intaglio::image::Surface<intaglio::image::Indexed8>::over(pixels, size).value();
}

std::span<const Scene> scenes() noexcept {
  all = {gauges(), map(), primitives(), testcard()};
  return all;
}

}  // namespace lab::frames
