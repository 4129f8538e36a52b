// SPDX-License-Identifier: MIT
//
// What the instruments show at a frame: a self-test, then a drive that repeats.
//
// Rule: a table of corner points (frame, speed, engine speed, gear), straight lines between them, and the
// mean of the last 16 frames, as a needle with some mass would follow. Everything is a pure function of the
// frame number; the odometer is the exact sum of the straight lines.
//
// Bit budget: frames have 32 bits; a cycle covers 150,000 km/h*frame (18 bits), so a distance has 40 of 64.
#pragma once

#include <cstdint>

namespace apps::gauges {

/// Frames a second the drive is written for.
inline constexpr int frame_rate = 60;
/// Frames in which the picture fades in.
inline constexpr int fade_frames = 30;
/// Frames of the self-test; needles sweep from rest to the end and back.
inline constexpr int test_frames = 84;

/// Ends of the scales.
inline constexpr int speed_limit = 240;  ///< km/h
inline constexpr int rpm_limit = 8000;   ///< turns a minute
inline constexpr int rpm_red = 6500;     ///< Where the red zone begins.
inline constexpr int speed_red = 200;

/// Fraction bits of `speed` and `rpm`.
inline constexpr int value_bits = 4;

/// Warning lights, as bits of `Readings::lights` and in the order they stand on the panel.
enum class Light : std::uint8_t { left, battery, oil, engine, fuel, heat, beam, right };
inline constexpr int light_count = 8;

/// Everything an instrument can show.
struct Readings {
  int speed = 0;        ///< km/h * 16, 0 .. speed_limit * 16
  int rpm = 0;          ///< turns a minute * 16, 0 .. rpm_limit * 16
  int gear = 0;         ///< 0 is neutral
  int fuel = 0;         ///< 0 .. 1000
  int heat = 0;         ///< coolant, 0 (cold) .. 1000 (boiling)
  int odometer = 0;     ///< metres, 0 .. 999,999,999
  int brightness = 0;   ///< 0 .. 256
  unsigned lights = 0;  ///< One bit a `Light`, lit at this very frame.
  int runner = 0;       ///< 0 .. 999: where a light that runs round the dials is, in thousandths of a round
};

/// The readings at a frame.
[[nodiscard]] Readings readings_at(std::uint32_t frame) noexcept;

}  // namespace apps::gauges
