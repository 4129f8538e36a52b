// SPDX-License-Identifier: MIT
#include <host/attach/beam.hpp>
#include <intaglio/present/frame_writer.hpp>

#include <algorithm>
#include <cstdio>
#include <vector>

namespace host {

namespace {

using intaglio::present::BandCut;
using intaglio::present::BeamTiming;
using intaglio::present::Travel;

constexpr hal::Nanoseconds margin = 200'000;
constexpr std::uint32_t fastest_panel = 80'000'000;
constexpr std::uint32_t hertz_step = 100'000;

hal::Nanoseconds median(std::vector<hal::Nanoseconds> times) {
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2U);
  std::nth_element(times.begin(), middle, times.end());
  return *middle;
}

BandCut cut_of(const hal::Capabilities& panel, int lines) {
  return intaglio::present::cut_along_scan(panel, panel.bits_per_pixel, lines);
}

bool open(const BeamTiming& timing, const hal::Capabilities& panel, Travel travel) {
  const intaglio::present::BandSizes sizes = cut_of(panel, intaglio::present::chased_lines).sizes(panel);
  return timing.valid(sizes.lines) && picture_window(timing, sizes, travel).open();
}

/// Of a write of the first band; 0 if it fails.
hal::Nanoseconds write_time(hal::Panel& panel, hal::Clock& clock, const hal::Rect& area) {
  const hal::Capabilities& c = panel.capabilities();
  const int stride = (c.width * c.bits_per_pixel + 7) / 8;
  const std::vector<std::uint8_t> dark(static_cast<std::size_t>(stride) * static_cast<std::size_t>(c.height));
  constexpr std::size_t samples = 5;
  constexpr hal::Nanoseconds patience = 500'000'000;
  std::vector<hal::Nanoseconds> times;
  const hal::Nanoseconds start = clock.now();
  do {
    const hal::Nanoseconds begin = clock.now();
    if (!panel.write(area, dark, stride).ok()) return 0;
    times.push_back(clock.now() - begin);
  } while (times.size() < samples && clock.now() - start < patience);
  return std::max<hal::Nanoseconds>(median(times), 1);
}

hal::Rect first_band(const BandCut& cut, const hal::Capabilities& panel) {
  const intaglio::linear::Rect band = cut.band(panel, 0);
  return {band.x, band.y, band.width, band.height};
}

std::string milliseconds(hal::Nanoseconds time) {
  char text[32];
  std::snprintf(text, sizeof text, "%llu.%llu ms",
                static_cast<unsigned long long>((time + 50'000U) / 1'000'000U),
                static_cast<unsigned long long>((time + 50'000U) / 100'000U % 10U));
  return text;
}

}  // namespace

std::optional<hal::Nanoseconds> measured_refresh(hal::VblankSource& vblanks) {
  constexpr int samples = 12;
  if (!vblanks.wait().ok()) return std::nullopt;
  std::vector<hal::Nanoseconds> gaps;
  hal::Nanoseconds last = vblanks.last();
  for (int i = 0; i < samples; ++i) {
    if (!vblanks.wait().ok()) return std::nullopt;
    const hal::Nanoseconds now = vblanks.last();
    if (now > last) gaps.push_back(now - last);
    last = now;
  }
  if (gaps.empty()) return std::nullopt;
  const hal::Nanoseconds usual = median(gaps);
  hal::Nanoseconds sum = 0;
  hal::Nanoseconds count = 0;
  for (const hal::Nanoseconds gap : gaps)
    if (gap > usual - usual / 16U && gap < usual + usual / 16U) {
      sum += gap;
      ++count;
    }
  return count == 0 ? usual : sum / count;
}

std::optional<BusTimes> measured_bus(hal::Panel& panel, hal::Clock& clock) {
  const hal::Capabilities& c = panel.capabilities();
  const hal::Rect band = first_band(cut_of(c, intaglio::present::chased_lines), c);
  const BandCut cut = cut_of(c, 1);
  const hal::Rect least = first_band(cut, c);
  const auto lines = static_cast<hal::Nanoseconds>(cut.columns ? band.width : band.height);
  const auto least_lines = static_cast<hal::Nanoseconds>(cut.columns ? least.width : least.height);
  const hal::Nanoseconds long_time = write_time(panel, clock, band);
  const hal::Nanoseconds short_time = write_time(panel, clock, least);
  if (long_time == 0 || short_time == 0) return std::nullopt;
  BusTimes bus;
  bus.line = std::max<hal::Nanoseconds>(long_time / lines, 1);
  if (lines > least_lines && long_time > short_time)
    bus.line = std::max<hal::Nanoseconds>((long_time - short_time) / (lines - least_lines), 1);
  bus.band = long_time > lines * bus.line ? long_time - lines * bus.line : 0;
  return bus;
}

BeamTiming beam_timing(const hal::panels::BeamLines& lines, hal::Nanoseconds refresh, const BusTimes& bus) {
  const auto total = static_cast<hal::Nanoseconds>(lines.total);
  return {.refresh = refresh,
          .first_line = refresh * static_cast<hal::Nanoseconds>(lines.before) / total,
          .scan_line = refresh / total,
          .bus_line = bus.line,
          .bus_band = bus.band,
          .margin = margin};
}

bool tear_free(const BeamTiming& timing, const hal::Capabilities& panel) {
  return open(timing, panel, cut_of(panel, intaglio::present::chased_lines).travel());
}

hal::Nanoseconds slowest_line(BeamTiming timing, const hal::Capabilities& panel) {
  // Whoever is fast can wait, so what is fast enough is an interval from the fastest on.
  hal::Nanoseconds fast = 0;
  hal::Nanoseconds slow = timing.refresh * 2U;
  while (slow - fast > 1) {
    timing.bus_line = fast + (slow - fast) / 2U;
    (tear_free(timing, panel) ? fast : slow) = timing.bus_line;
  }
  return fast;
}

std::optional<std::uint32_t> sufficient_hertz(const BeamTiming& timing, const hal::Capabilities& panel,
                                              const ClockedBus& bus) {
  if (bus.hertz == 0) return std::nullopt;
  constexpr std::uint64_t second = 1'000'000'000;
  const std::uint64_t bits = bus.line_bits * second / bus.hertz;
  const std::uint64_t rest = timing.bus_line > bits ? timing.bus_line - bits : 0;
  const std::uint64_t most = slowest_line(timing, panel);
  if (most <= rest) return std::nullopt;
  const std::uint64_t hertz = bus.line_bits * second / (most - rest) + 1U;
  const std::uint64_t whole = (hertz + hertz_step - 1U) / hertz_step * hertz_step;
  return whole > fastest_panel ? std::nullopt : std::optional(static_cast<std::uint32_t>(whole));
}

std::string tearing_notice(const BeamTiming& timing, const hal::Capabilities& panel, const ClockedBus& bus) {
  if (tear_free(timing, panel)) return {};
  const BandCut cut = cut_of(panel, intaglio::present::chased_lines);
  const auto lines = static_cast<hal::Nanoseconds>(cut.sizes(panel).lines);
  const auto bands = static_cast<hal::Nanoseconds>(cut.count);
  const hal::Nanoseconds most = slowest_line(timing, panel);
  std::string text = "the bus takes " + milliseconds(lines * timing.bus_line + bands * timing.bus_band) +
                     " for a picture and the beam " + milliseconds(timing.refresh) +
                     ", so pictures will be torn. ";
  if (most == 0) return text + "What each write takes beside its pixels is too much for any bus.\n";
  text += "At most " + milliseconds(lines * most + bands * timing.bus_band) + " would do";
  if (const auto hertz = sufficient_hertz(timing, panel, bus))
    text += ", as with " + std::string(bus.set_by) + std::to_string(*hertz) + std::string(bus.unit);
  else if (bus.hertz != 0)
    text += ", which no clock makes that such panels take";
  else
    text += ", as a driver for SPI (--spi) makes it";
  if (cut.travel() != Travel::along && open(timing, panel, Travel::along))
    text += "; so would a --rotate with which the beam goes down the picture";
  return text + "; fewer frames a second wouldn't.\n";
}

}  // namespace host
