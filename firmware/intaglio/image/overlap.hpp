// SPDX-License-Identifier: MIT
//
// Do two views look at the same memory? For copies that can't choose the order in which they read, and so
// refuse a source that they would overwrite.
#pragma once

#include <intaglio/image/surface.hpp>
#include <intaglio/linear/rect.hpp>

#include <cstdint>

namespace intaglio::image::detail {

/// True if any byte between the first and the last pixel of `part` lies between those of the whole source.
/// Precondition: neither is empty, and `part` is inside the target's bounds.
template <PixelFormat F, PixelFormat G>
[[nodiscard]] bool bytes_meet(const Surface<F>& target, const linear::Rect& part,
                              const Picture<G>& source) noexcept {
  // Compared as numbers: the views may look at different objects, whose pointers have no order.
  const auto address = [](const std::uint8_t* byte) { return reinterpret_cast<std::uintptr_t>(byte); };
  const linear::Rect& from = source.bounds();
  return address(target.byte_at(part.x, part.y)) <=
             address(source.byte_at(from.right() - 1, from.bottom() - 1)) &&
         address(source.byte_at(from.x, from.y)) <=
             address(target.byte_at(part.right() - 1, part.bottom() - 1));
}

}  // namespace intaglio::image::detail
