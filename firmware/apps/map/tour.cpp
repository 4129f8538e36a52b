// SPDX-License-Identifier: MIT
#include <intaglio/number/division.hpp>
#include <intaglio/number/sine.hpp>

#include <array>
#include <cstddef>
#include <firmware/apps/map/tour.hpp>

namespace apps::map {
namespace {

using intaglio::linear::Size;
using intaglio::number::Angle;
using intaglio::number::cosine;

struct Stop {
  int longitude;  // 1/100 degree, east
  int latitude;   // 1/100 degree, north
  int zoom;       // 1/256 octaves
};

constexpr int octave = 256;
// Eastwards round the world, so the date line is crossed with land in sight.
constexpr std::array<Stop, 15> stops{{
    {1000, 2000, 0},                  // the world
    {1280, 4200, octave * 9 / 2},     // Italy and the Adriatic
    {3100, 3850, octave * 7 / 2},     // Anatolia and the straits
    {5100, 2650, octave * 15 / 4},    // the Gulf
    {10600, 150, octave * 13 / 4},    // Malacca and the Java Sea
    {13600, 3750, octave * 7 / 2},    // Japan
    {13400, -2600, octave * 2},       // Australia
    {17300, -4050, octave * 15 / 4},  // New Zealand
    {17900, -7800, octave * 5 / 2},   // Ross Sea, where the date line meets the Antarctic
    {-15500, 1800, octave * 5 / 2},   // the Pacific
    {-17200, 6400, octave * 13 / 4},  // Bering Strait, across the date line
    {-7900, 2100, octave * 7 / 2},    // the Caribbean
    {-7000, -5100, octave * 15 / 4},  // Magellan Strait
    {2200, -3100, octave * 4},        // the Cape
    {-500, 5450, octave * 15 / 4},    // the British Isles
}};

constexpr int rest_frames = 40;
constexpr int flight_frames = 110;
constexpr int leg_frames = rest_frames + flight_frames;
// The first rest is short: a start-up that shows the world for long is a start-up that looks stuck.
constexpr int head_start = rest_frames - 12;

constexpr int one = 1 << 16;

// 3t^2 - 2t^3 for t in 0 .. 2^16, rounded down. 48 bits.
constexpr int smooth(int t) noexcept {
  const std::int64_t u = t;
  return static_cast<int>((u * u * (3 * one - 2 * u)) >> 32);
}

constexpr int between(int from, int to, int t) noexcept {
  return from + static_cast<int>((static_cast<std::int64_t>(to - from) * t) >> 16);
}

// 2^(zoom/256) in 1/2^16, zoom >= 0: exact at octaves, at most 0.4 % off between.
constexpr std::int64_t power_of_two(int zoom) noexcept {
  const std::int64_t f = zoom & 255;
  const std::int64_t mantissa = one + f * (168 * 256 + 88 * f) / 256;  // 1 + f*(0.656 + 0.344 f)
  return mantissa << static_cast<unsigned>(zoom >> 8);
}
static_assert(power_of_two(0) == one && power_of_two(256) == 2 * one && power_of_two(512) == 4 * one);

constexpr std::int64_t clamp(std::int64_t value, std::int64_t low, std::int64_t high) noexcept {
  return value < low ? low : value > high ? high : value;
}

// 1/100 degree in 1/256 unit.
constexpr int place(int hundredths) noexcept {
  return static_cast<int>(static_cast<std::int64_t>(hundredths) * units_per_degree * 256 / 100);
}

}  // namespace

Camera camera_at(std::uint32_t frame, Size size) noexcept {
  const std::uint64_t time = std::uint64_t{frame} + head_start;
  const auto leg = static_cast<std::size_t>(time / leg_frames % stops.size());
  const auto within = static_cast<int>(time % leg_frames) - rest_frames;
  const int t = within <= 0 ? 0 : within * one / flight_frames;
  const Stop& from = stops[leg];
  const Stop& to = stops[(leg + 1) % stops.size()];

  Camera camera;
  // Height first, then distance: seen from above, the way is short.
  const int climb = smooth(t);
  const int way = smooth(climb);
  constexpr int world = world_width * 256;
  int x_from = place(from.longitude);
  int x_to = place(to.longitude);
  if (x_to - x_from > world / 2) x_to -= world;
  if (x_from - x_to > world / 2) x_to += world;
  camera.x = between(x_from, x_to, way);
  if (camera.x > world / 2) camera.x -= world;
  if (camera.x < -world / 2) camera.x += world;
  camera.y = -between(place(from.latitude), place(to.latitude), way);

  // Between two stops, up by as much as two octaves.
  const std::int64_t hump = static_cast<std::int64_t>(climb) * (one - climb);  // at most 2^30
  const int lift = static_cast<int>((hump * 2 * octave) >> 30);
  camera.zoom = static_cast<int>(clamp(between(from.zoom, to.zoom, climb) - lift, 0, 8 * octave));

  const std::int64_t by_width = (std::int64_t{size.width} << 24) / world_width;
  const std::int64_t by_height = (std::int64_t{size.height} << 24) / (170 * units_per_degree);
  const std::int64_t cover = clamp(by_width > by_height ? by_width : by_height, 1, scale_limit);
  camera.scale_y = clamp((cover * power_of_two(camera.zoom)) >> 16, 1, scale_limit);

  // No look beyond the poles.
  const std::int64_t half = (std::int64_t{size.height} << (7 + scale_bits + camera_bits)) / camera.scale_y;
  const std::int64_t pole = 90 * units_per_degree * 256;
  const std::int64_t furthest = half < pole ? pole - half : 0;
  camera.y = static_cast<int>(clamp(camera.y, -furthest, furthest));

  // Beyond 60 degrees the map stays as wide as there: never more than two worlds side by side.
  const Angle latitude = Angle::from_ratio(camera.y, world);
  const std::int64_t shrink = clamp(cosine(latitude).raw(), 1 << 14, 1 << 15);
  camera.scale_x = clamp((camera.scale_y * shrink) >> 15, 1, scale_limit);

  // A day lasts six legs; the sun moves on while the camera flies.
  constexpr int day = 6 * leg_frames;
  const Angle hour = Angle::from_ratio(static_cast<std::int64_t>(time % day), day) + Angle::from_degrees(-40);
  camera.night = static_cast<int>(clamp(128 - (cosine(hour).raw() * 3 >> 8), 0, 256));
  return camera;
}

}  // namespace apps::map
