// SPDX-License-Identifier: MIT
//
// How a picture is cut into bands: from the top, or as the beam goes.
//
// Rule: every band but the last has the same number of lines, a multiple of the panel's alignment; bands of
// columns begin at whole bytes, too.
#pragma once

#include <hal/panel.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/present/beam_race.hpp>

#include <cstddef>
#include <cstdint>

namespace intaglio::present {

/// Rows of a band in `memory` bytes at `stride` bytes a row on this panel; 0 if not even the least aligned
/// group of rows fits.
[[nodiscard]] int band_rows(const hal::Capabilities& panel, int stride, std::size_t memory) noexcept;

/// How a picture is cut: `count` bands of `lines` rows or columns; the last may have fewer.
struct BandCut {
  int lines = 0;
  int count = 0;
  bool columns = false;
  bool backwards = false;  ///< The last band goes first.

  /// Band `step` in the order in which they are sent.
  [[nodiscard]] linear::Rect band(const hal::Capabilities& panel, int step) const noexcept;
  /// The lines of a band.
  [[nodiscard]] constexpr int lines_of(const linear::Rect& band) const noexcept {
    return columns ? band.width : band.height;
  }
  /// How this goes behind a beam.
  [[nodiscard]] BandSizes sizes(const hal::Capabilities& panel) const noexcept;
  [[nodiscard]] constexpr Travel travel() const noexcept {
    return columns ? Travel::across : (backwards ? Travel::against : Travel::along);
  }
  /// Its first line in the order of the scan.
  [[nodiscard]] int first_scanned(const hal::Capabilities& panel, int step) const noexcept;
};

/// Rows from the top, as many as fit `memory` bytes; none (`count` 0) if that is too little.
[[nodiscard]] BandCut rows_from_top(const hal::Capabilities& panel, int bits_per_pixel,
                                    std::size_t memory) noexcept;
/// The same in the direction of the scan.
[[nodiscard]] BandCut along_scan(const hal::Capabilities& panel, int bits_per_pixel,
                                 std::size_t memory) noexcept;
/// Bands of about so many lines (at least as many as the alignment asks for) in the direction of the scan.
[[nodiscard]] BandCut cut_along_scan(const hal::Capabilities& panel, int bits_per_pixel, int lines) noexcept;
/// Bytes that the least band of this kind needs.
[[nodiscard]] std::uint32_t least_memory(const hal::Capabilities& panel, int bits_per_pixel,
                                         bool columns) noexcept;

}  // namespace intaglio::present
