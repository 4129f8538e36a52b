// SPDX-License-Identifier: MIT
//
// A span as a value: what a scan (the part of a primitive that doesn't depend on the sink) hands out one at a
// time.
#pragma once

namespace intaglio::raster {

/// The pixels (x_begin .. x_end-1, y).
struct RowSpan {
  int y = 0;
  int x_begin = 0;
  int x_end = 0;
  friend constexpr bool operator==(const RowSpan&, const RowSpan&) noexcept = default;
};

}  // namespace intaglio::raster
