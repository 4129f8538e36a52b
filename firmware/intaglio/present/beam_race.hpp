// SPDX-License-Identifier: MIT
//
// The race between bus and beam on a panel with one memory: when a band may be sent so that no refresh shows
// a part of it.
//
// Rule: lines are counted in the order of the scan. The beam fetches line i of a refresh during
//   [first_line + i * scan_line, first_line + (i + 1) * scan_line)
// after the VBLANK before that refresh; VBLANKs are `refresh` apart. A write begun at t sends the band's line
// i during [t + p(i), t + p(i) + bus_line), where p says how many lines of the band go before it. The new
// line is first seen in the refresh wanted, if it is sent after the beam of the refresh before has left it
// and before the beam of the wanted one comes:
//   t >= first_line + (i + 1) * scan_line - refresh - p(i)      and
//   t <= first_line + i * scan_line - bus_band - p(i) - bus_line      for all lines i of the band.
// Both are linear in i, so the first and the last line decide. A bus faster than the beam is bound by the
// last line at its earliest and the first at its latest; a slower one starts right behind the beam and must
// be through before the beam, a refresh later, catches up: all of H lines take at most about refresh + (H -
// 2) * scan_line, nearly two refreshes. A picture that is sent line after line is never torn if all its bands
// keep their windows for the same refresh. Bit budget: times are at most 10^9 ns, lines at most 2^20, so
// sums stay below 2^54 of 63 bits.
#pragma once

#include <hal/clock.hpp>
#include <intaglio/status.hpp>

#include <cstdint>

namespace intaglio::present {

/// How fast beam, bus and program are. Nanoseconds, each at most 10^9.
struct BeamTiming {
  hal::Nanoseconds refresh = 0;     ///< From a VBLANK signal to the next.
  hal::Nanoseconds first_line = 0;  ///< From the signal to the fetch of the first line.
  hal::Nanoseconds scan_line = 0;   ///< From the fetch of a line to that of the next.
  hal::Nanoseconds bus_line = 0;    ///< To send a line.
  hal::Nanoseconds bus_band = 0;    ///< What a write takes beside its pixels, at most.
  hal::Nanoseconds draw_line = 0;   ///< To draw a line, at most.
  hal::Nanoseconds margin = 0;      ///< How far beam and bus may be off all this (jitter, rounding).

  /// True if every time is in range, refresh and line times aren't 0, and `lines` fit in a refresh.
  [[nodiscard]] bool valid(int lines) const noexcept;
};

/// In what order a write sends the lines of a band.
enum class Travel : std::uint8_t {
  along,    ///< As the beam goes.
  against,  ///< The last line first: rows are sent downwards, the beam goes up.
  across,   ///< A part of every line with each row: the beam goes sideways.
};

/// When a write may begin, in nanoseconds after the VBLANK before the wanted refresh (usually below 0).
struct StartWindow {
  std::int64_t earliest = 0;
  std::int64_t latest = 0;
  [[nodiscard]] constexpr bool open() const noexcept { return earliest <= latest; }
};

/// When the band of lines first .. end - 1 may be sent. 0 <= first < end.
[[nodiscard]] StartWindow start_window(const BeamTiming& timing, int first, int end, Travel travel) noexcept;

/// How a picture is cut in the order of the scan: `first` lines, then as many as there are at a time, `band`;
/// the last may have fewer. 1 <= first <= lines, band >= 1.
struct BandSizes {
  int lines = 0;
  int first = 0;
  int band = 0;
};

/// When the first band of a whole picture may be sent so that all the others, each drawn and sent after the
/// one before, or later if its window opens later, keep their windows.
/// Not `open()`: the bus is too slow to be tear-free. Cost: a step a band.
[[nodiscard]] StartWindow picture_window(const BeamTiming& timing, const BandSizes& sizes,
                                         Travel travel) noexcept;

}  // namespace intaglio::present
