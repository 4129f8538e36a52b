// SPDX-License-Identifier: MIT
#include <hal/sim/effects/power.hpp>
#include <hal/sim/effects/response.hpp>

namespace hal::sim {

std::int64_t left_after(Nanoseconds frame_time, Nanoseconds response) {
  if (response == 0 || frame_time / response >= 10U) return 0;  // 9^-10 is below 2^-31
  // log2(9) < 2^34 / 2^32, response < 2^29: the product is below 2^63.
  const std::uint64_t log9 = log2_of(9);
  const std::uint64_t y = log9 * (frame_time / response) + log9 * (frame_time % response) / response;
  return static_cast<std::int64_t>((two_to_minus(y) + 1U) >> 1U);
}

Response::Response(const ResponseTime& time, Nanoseconds frame_time, std::size_t components)
    : left_rising_(left_after(frame_time, time.rise)),
      left_falling_(left_after(frame_time, time.fall)),
      light_(components) {
  note_call(Effect::response);
}

void Response::refresh(std::span<const std::uint8_t> rgb) {
  note_call(Effect::response);
  for (std::size_t i = 0; i < light_.size(); ++i) {
    const Light target = decode(rgb[i]);
    const std::int64_t rest = light_[i] - target;
    const std::int64_t left = rest * (rest < 0 ? left_rising_ : left_falling_);
    constexpr std::int64_t one = std::int64_t{1} << 31;
    light_[i] = target + static_cast<Light>((left < 0 ? left - one / 2 : left + one / 2) / one);
  }
}

void Response::look(std::span<std::uint8_t> rgb) const {
  for (std::size_t i = 0; i < light_.size(); ++i) rgb[i] = encode(light_[i]);
}

}  // namespace hal::sim
