// SPDX-License-Identifier: MIT
//
// Pixel response and ghosting: light follows what a pixel is sent with a delay, so that what was there shines
// through.
//
// Rule: in linear light, a frame time F after the pixel was sent a target, the rest of the way is
//   rest = (before - target) * 9^(-F / T),
// T the time from 10 % to 90 % of the way, up or down: of the exponential e^(-t/tau), T = tau ln 9. The
// picture of a refresh shows each pixel a frame time after its line was fetched. A pixel that no refresh has
// sent yet is dark. The factor counts in 1/2^31 (within 2^-26), light in 1/2^24, rounded a refresh: the light
// is off by at most 2^-24 / (1 - factor) for it.
// Budget: the rest is below 2^24, times the factor below 2^55.
#pragma once

#include <hal/sim/effects/effects.hpp>
#include <hal/sim/effects/light.hpp>

#include <span>
#include <vector>

namespace hal::sim {

/// 9^(-frame_time / response) in 1/2^31. response 1..500 ms in nanoseconds, or 0: nothing is left.
[[nodiscard]] std::int64_t left_after(Nanoseconds frame_time, Nanoseconds response);

class Response {
 public:
  /// `components` is three a pixel.
  Response(const ResponseTime& time, Nanoseconds frame_time, std::size_t components);

  /// One refresh sends these codes.
  void refresh(std::span<const std::uint8_t> rgb);
  /// What is seen after it.
  void look(std::span<std::uint8_t> rgb) const;

 private:
  std::int64_t left_rising_;
  std::int64_t left_falling_;
  std::vector<Light> light_;
};

}  // namespace hal::sim
