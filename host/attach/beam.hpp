// SPDX-License-Identifier: MIT
//
// The race between a real panel's bus and its beam: how fast each of them is, and what helps if the bus is
// too slow.
//
// Rule: neither is believed what its maker says. A refresh is the mean of some that the TE line told, those
// left out that leapt. The bus is timed as it will be used, drivers, system calls and colours included, by
// writing bands that frames will be cut into, and the least ones; the two differ by lines alone. Medians are
// taken, so a moment in which the machine was busy doesn't count.
#pragma once

#include <hal/clock.hpp>
#include <hal/panel.hpp>
#include <hal/panels/dcs_panel.hpp>
#include <hal/vblank.hpp>
#include <intaglio/present/band_cut.hpp>
#include <intaglio/present/beam_race.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace host {

/// The mean time from a VBLANK to the next; none if they aren't told.
[[nodiscard]] std::optional<hal::Nanoseconds> measured_refresh(hal::VblankSource& vblanks);

struct BusTimes {
  hal::Nanoseconds line = 0;  ///< To send a line of the beam.
  hal::Nanoseconds band = 0;  ///< What a write takes beside.
};
/// Writes index 0 to a write panel, some times over. None if a write fails.
[[nodiscard]] std::optional<BusTimes> measured_bus(hal::Panel& panel, hal::Clock& clock);

/// Bus and beam together, with a margin for what interrupts and sleeps of Linux are off.
[[nodiscard]] intaglio::present::BeamTiming beam_timing(const hal::panels::BeamLines& lines,
                                                        hal::Nanoseconds refresh, const BusTimes& bus);

/// True if frames of such a panel, sent behind the beam, aren't torn.
[[nodiscard]] bool tear_free(const intaglio::present::BeamTiming& timing, const hal::Capabilities& panel);
/// The slowest line, in nanoseconds, with which they aren't; 0 if no bus is fast enough.
[[nodiscard]] hal::Nanoseconds slowest_line(intaglio::present::BeamTiming timing,
                                            const hal::Capabilities& panel);

/// A bus with a clock.
struct ClockedBus {
  std::uint32_t hertz = 0;      ///< 0: it has none that a user could set.
  std::uint32_t line_bits = 0;  ///< Of a line of the beam.
  /// What a user writes before and after the number to set it.
  std::string_view set_by = "--spi-hz ";
  std::string_view unit = "";
};
/// The slowest clock, in whole 100 kHz, with which frames aren't torn, what a line takes beside its bits
/// being as it is; none if there is none up to 80 MHz, more than which no such panel takes.
[[nodiscard]] std::optional<std::uint32_t> sufficient_hertz(const intaglio::present::BeamTiming& timing,
                                                            const hal::Capabilities& panel,
                                                            const ClockedBus& bus);

/// Why frames of such a panel tear and what would help, a line; "" if they don't.
[[nodiscard]] std::string tearing_notice(const intaglio::present::BeamTiming& timing,
                                         const hal::Capabilities& panel, const ClockedBus& bus);

}  // namespace host
