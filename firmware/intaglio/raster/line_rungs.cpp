// SPDX-License-Identifier: MIT
#include <intaglio/number/long_division.hpp>
#include <intaglio/raster/line_rungs.hpp>

namespace intaglio::raster {

namespace detail {

std::uint32_t fixed_slope(const LineSlope& slope, unsigned fraction_bits) noexcept {
  if (slope.major == 0) return 0;
  if (slope.minor == slope.major) return fraction_bits < 32 ? 1U << fraction_bits : ~0U;
  const std::uint64_t up = slope.tie != 0 ? 0 : slope.major - 1;
  return number::long_divide((std::uint64_t{slope.minor} << fraction_bits) + up, slope.major).quotient;
}

Status line_frame(linear::Point a, linear::Point b, const linear::Rect& window, LineFrame& frame) noexcept {
  constexpr int limit = linear::coordinate_limit;
  const Status status = clip::line_path(a, b, {-limit, -limit, 2 * limit + 1, 2 * limit + 1}, frame.path);
  if (!status.ok()) return status;
  const clip::LinePath& path = frame.path;
  frame.slope = {static_cast<unsigned>(path.major_step) / 2, static_cast<unsigned>(path.minor_step) / 2,
                 path.up && !path.steep ? 1U : 0U};
  frame.low = {window.x - path.start.x, window.y - path.start.y};
  frame.high = {frame.low.x + window.width, frame.low.y + window.height};
  if (path.up) {
    const int top = frame.low.y;
    frame.low.y = 1 - frame.high.y;
    frame.high.y = 1 - top;
  }
  if (path.steep) {
    frame.low = {frame.low.y, frame.low.x};
    frame.high = {frame.high.y, frame.high.x};
  }
  return {};
}

}  // namespace detail

int DistanceLine::Stairs::at(int k) const noexcept {
  if (slope_.major == 0) return 0;
  const std::uint64_t line = std::uint64_t{2 * slope_.minor} * static_cast<unsigned>(k);
  return static_cast<int>(number::long_divide(line + slope_.major - slope_.tie, 2 * slope_.major).quotient);
}

}  // namespace intaglio::raster
