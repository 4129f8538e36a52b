// SPDX-License-Identifier: MIT
#include <intaglio/present/beam_race.hpp>

#include <algorithm>

namespace intaglio::present {

namespace {

constexpr hal::Nanoseconds longest = 1'000'000'000U;
constexpr int most_lines = 1 << 20;

constexpr std::int64_t time(hal::Nanoseconds t) noexcept { return static_cast<std::int64_t>(t); }

/// From the start of a write of `lines` lines to its end.
constexpr std::int64_t write_time(const BeamTiming& t, int lines) noexcept {
  return time(t.bus_band) + lines * time(t.bus_line);
}

}  // namespace

bool BeamTiming::valid(int lines) const noexcept {
  for (const hal::Nanoseconds t : {refresh, first_line, scan_line, bus_line, bus_band, draw_line, margin})
    if (t > longest) return false;
  return lines >= 1 && lines <= most_lines && scan_line > 0 && bus_line > 0 &&
         static_cast<hal::Nanoseconds>(lines) * scan_line <= refresh;
}

StartWindow start_window(const BeamTiming& t, int first, int end, Travel travel) noexcept {
  const std::int64_t bus = time(t.bus_line);
  const std::int64_t margin = time(t.margin);
  const auto fetched = [&t](int line) { return time(t.first_line) + line * time(t.scan_line); };
  // When, after the start, the line's first pixel may go out and its last pixel is out.
  const auto begins = [&](int line) {
    return travel == Travel::across ? 0 : (travel == Travel::along ? line - first : end - 1 - line) * bus;
  };
  const auto is_out = [&](int line) {
    return time(t.bus_band) + (travel == Travel::across ? (end - first) * bus : begins(line) + bus);
  };
  const auto after_beam = [&](int line) {
    return fetched(line + 1) - time(t.refresh) + margin - begins(line);
  };
  const auto before_beam = [&](int line) { return fetched(line) - margin - is_out(line); };
  return {std::max(after_beam(first), after_beam(end - 1)),
          std::min(before_beam(first), before_beam(end - 1))};
}

StartWindow picture_window(const BeamTiming& t, const BandSizes& sizes, Travel travel) noexcept {
  // From the last band back to the first: each must begin early enough for those behind it.
  const int behind_first = (sizes.lines - sizes.first + sizes.band - 1) / sizes.band;
  StartWindow window;
  bool open = true;
  int next = 0;
  for (int i = behind_first; i >= 0; --i) {
    const int first = i == 0 ? 0 : sizes.first + (i - 1) * sizes.band;
    const int count = i == 0 ? sizes.first : std::min(sizes.band, sizes.lines - first);
    StartWindow own = start_window(t, first, first + count, travel);
    if (next > 0)
      own.latest = std::min(own.latest, window.latest - write_time(t, count) - next * time(t.draw_line));
    open = open && own.open();
    window = own;
    next = count;
  }
  // One band that can't keep its window tears the picture.
  if (!open) window.latest = std::min(window.latest, window.earliest - 1);
  return window;
}

}  // namespace intaglio::present
