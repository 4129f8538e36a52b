// SPDX-License-Identifier: MIT
//
// All pixel formats as test types, and surfaces over the oracle's memory.
#pragma once

#include <intaglio/image/surface.hpp>
#include <tests/oracle/packed.hpp>

#include <gtest/gtest.h>

namespace tests {

using AllFormats =
    testing::Types<intaglio::image::Indexed1, intaglio::image::Indexed2, intaglio::image::Indexed4,
                   intaglio::image::Indexed8, intaglio::image::Indexed1Lsb, intaglio::image::Indexed2Lsb,
                   intaglio::image::Indexed4Lsb>;

/// A format at run time.
struct Layout {
  int bits;
  bool most_significant_first;
  bool operator==(const Layout&) const = default;
};
template <class F>
inline constexpr Layout layout_of{F::bits, F::order == intaglio::image::BitOrder::msb_first};

/// Memory of the oracle in the layout of a format.
inline oracle::Packed packed_rows(Layout layout, int width, int height, int extra_bytes = 0) {
  return {layout.bits, layout.most_significant_first, (width * layout.bits + 7) / 8 + extra_bytes, height};
}
template <class F>
oracle::Packed packed_rows(int width, int height, int extra_bytes = 0) {
  return packed_rows(layout_of<F>, width, height, extra_bytes);
}

/// The library's view of the same memory; fails the test if there is none.
template <class F>
intaglio::image::Surface<F> surface_over(oracle::Packed& memory, int width, int height) {
  const auto surface = intaglio::image::Surface<F>::over(memory.bytes(), {width, height}, memory.stride());
  EXPECT_TRUE(surface.ok());
  return surface.value();
}

}  // namespace tests
