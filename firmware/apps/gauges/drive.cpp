// SPDX-License-Identifier: MIT
#include <intaglio/number/sine.hpp>

#include <array>
#include <cstddef>
#include <firmware/apps/gauges/drive.hpp>

namespace apps::gauges {
namespace {

using intaglio::number::Angle;
using intaglio::number::cosine;
using intaglio::number::sine;

struct Corner {
  int frame;
  int speed;  // km/h
  int rpm;
  int gear;
};

// Pulling away and up through six gears, a stretch on the motorway, and back down to the lights.
constexpr std::array<Corner, 29> corners{{
    {0, 0, 850, 1},      {6, 0, 1500, 1},     {14, 6, 1900, 1},     {62, 52, 6700, 1},    {72, 53, 4100, 2},
    {142, 96, 6800, 2},  {154, 97, 4900, 3},  {244, 138, 6700, 3},  {258, 138, 5300, 4},  {380, 176, 6600, 4},
    {394, 176, 5500, 5}, {560, 212, 6500, 5}, {600, 214, 6550, 5},  {616, 213, 5400, 6},  {700, 219, 5550, 6},
    {820, 190, 4800, 6}, {900, 186, 4700, 6}, {1000, 128, 3250, 6}, {1012, 126, 4400, 4}, {1090, 84, 2950, 4},
    {1102, 82, 4000, 3}, {1180, 46, 2250, 3}, {1192, 45, 3500, 2},  {1260, 18, 1400, 2},  {1310, 3, 900, 1},
    {1330, 0, 820, 1},   {1340, 0, 850, 0},   {1430, 0, 850, 0},    {1440, 0, 850, 0},
}};
constexpr int cycle = corners.back().frame;

// Twice the km/h*frames from the first corner to the last: the sum of the trapezoids.
constexpr int cycle_distance = [] {
  int sum = 0;
  for (std::size_t i = 1; i < corners.size(); ++i)
    sum += (corners[i].frame - corners[i - 1].frame) * (corners[i].speed + corners[i - 1].speed);
  return sum;
}();

// The last corner at or before a frame of the cycle.
std::size_t corner_before(int frame) noexcept {
  std::size_t i = corners.size() - 2;
  while (corners[i].frame > frame) --i;
  return i;
}

int between(int from, int to, int part, int whole) noexcept {
  return from * (1 << value_bits) + (to - from) * part * (1 << value_bits) / whole;
}

// The mean of the straight lines over the last 16 frames.
void follow(int frame, Readings& now) noexcept {
  constexpr int window = 16;
  int speed = 0;
  int rpm = 0;
  for (int back = 0; back < window; ++back) {
    const int at = (frame - back + cycle) % cycle;
    const std::size_t i = corner_before(at);
    const Corner& a = corners[i];
    const Corner& b = corners[i + 1];
    speed += between(a.speed, b.speed, at - a.frame, b.frame - a.frame);
    rpm += between(a.rpm, b.rpm, at - a.frame, b.frame - a.frame);
  }
  now.speed = speed / window;
  // An engine never runs quite evenly: +-16 turns a minute, 13 times a cycle of 256 frames.
  now.rpm = rpm / window + (sine(Angle::from_ratio(frame * 13, 256)).raw() >> 7);
}

// Twice the km/h*frames driven since the first frame of this cycle.
int distance_within(int frame) noexcept {
  const std::size_t i = corner_before(frame);
  int sum = 0;
  for (std::size_t k = 1; k <= i; ++k)
    sum += (corners[k].frame - corners[k - 1].frame) * (corners[k].speed + corners[k - 1].speed);
  const Corner& a = corners[i];
  const Corner& b = corners[i + 1];
  const int part = frame - a.frame;
  return sum + 2 * a.speed * part + (b.speed - a.speed) * part * part / (b.frame - a.frame);
}

// 0 .. 1000 .. 0 with soft ends: half a cosine wave each way.
int sweep(int part, int whole) noexcept {
  return (32768 - cosine(Angle::from_ratio(part, whole)).raw()) * 1000 >> 16;
}

constexpr unsigned bit(Light light) noexcept { return 1U << static_cast<unsigned>(light); }

unsigned lights_at(int frame, const Readings& now) noexcept {
  unsigned lights = 0;
  const bool blink = frame / 18 % 2 == 0;
  if (frame < 108 && blink) lights |= bit(Light::left);
  if (frame >= 1170 && frame < 1314 && blink) lights |= bit(Light::right);
  if (frame >= 400 && frame < 960) lights |= bit(Light::beam);
  if (now.fuel < 125) lights |= bit(Light::fuel);
  if (now.heat > 850 && frame / 10 % 2 == 0) lights |= bit(Light::heat);
  return lights;
}

}  // namespace

Readings readings_at(std::uint32_t frame) noexcept {
  Readings now;
  const auto count = static_cast<std::int64_t>(frame);
  now.brightness = count < fade_frames ? static_cast<int>(count) * 256 / fade_frames : 256;

  // A round in a second and a half.
  now.runner = static_cast<int>(count % 90) * 1000 / 90;

  const std::int64_t driven = count < test_frames ? 0 : count - test_frames;
  const auto lap = driven / cycle;
  const auto at = static_cast<int>(driven % cycle);

  // 22.5 l last for nine laps; the engine is warm after the first half of the first.
  constexpr int tank = 9 * cycle;
  now.fuel = 820 - static_cast<int>((driven + tank / 4) % tank * 760 / tank);
  const auto warm = static_cast<int>(driven < 700 ? driven : 700);
  now.heat = 180 + warm * 340 / 700 + (sine(Angle::from_ratio(driven, 977)).raw() * 24 >> 15);

  // 1 km/h is 1/216 m a frame, and distances are doubled.
  constexpr std::int64_t start = 12'345'600;
  const std::int64_t distance = lap * cycle_distance + distance_within(at);
  now.odometer = static_cast<int>((start + distance / 432) % 1'000'000'000);

  if (count < test_frames) {
    constexpr int rest = 16;
    const auto step = static_cast<int>(count);
    const int position = step < rest ? 0 : sweep(step - rest, test_frames - rest);
    now.speed = speed_limit * (1 << value_bits) * position / 1000;
    now.rpm = rpm_limit * (1 << value_bits) * position / 1000;
    now.lights = (1U << static_cast<unsigned>(light_count)) - 1U;
  } else {
    follow(at, now);
    now.gear = corners[corner_before(at)].gear;
    now.lights = lights_at(at, now);
  }
  return now;
}

}  // namespace apps::gauges
