// SPDX-License-Identifier: MIT
#include <firmware/apps/map/legend.hpp>

namespace apps::map {

// Literals that know their length: optimised for size, the compiler would call strlen for others.
using namespace std::string_view_literals;

namespace {

// Sub-pixels of one degree northwards, times 2^16; at most 43 bits.
std::int64_t degree(const Camera& camera) noexcept { return camera.scale_y * units_per_degree; }

void append_angle(Line& line, int angle, std::string_view positive, std::string_view negative) noexcept {
  // 1/256 unit to whole minutes, towards the nearest; a minute is three units.
  const int size = angle < 0 ? -angle : angle;
  const int minutes = (size + 384) / 768;
  line.number(minutes / 60).operator<<("°"sv).number(minutes % 60, 2)
      << "'"sv << (angle < 0 ? negative : positive);
}

}  // namespace

Line& Line::operator<<(std::string_view part) noexcept {
  for (const char c : part)
    if (length_ < text_.size()) text_[length_++] = c;
  return *this;
}

Line& Line::number(int value, int digits) noexcept {
  int power = 1;
  for (int i = 1; i < digits; ++i) power *= 10;
  while (value / power >= 10) power *= 10;
  for (; power > 0; power /= 10) {
    const char digit = static_cast<char>('0' + value / power % 10);
    *this << std::string_view(&digit, 1);
  }
  return *this;
}

Line place_text(const Camera& camera) noexcept {
  Line line;
  append_angle(line, -camera.y, "N"sv, "S"sv);
  line << " "sv;
  append_angle(line, camera.x, "E"sv, "W"sv);
  return line;
}

int graticule_step(const Camera& camera) noexcept {
  constexpr std::int64_t apart = std::int64_t{24} << (8 + scale_bits);
  for (const int step : {1, 2, 5, 10, 15})
    if (camera.scale_x * units_per_degree * step >= apart) return step;
  return 30;
}

ScaleBar scale_bar(const Camera& camera, int most_pixels) noexcept {
  ScaleBar best;
  // A degree is 111.2 km.
  for (const int length : {10, 20, 50, 100, 200, 500, 1000, 2000, 5000}) {
    const std::int64_t pixels = (degree(camera) * length * 10 / 1112) >> (8 + scale_bits);
    if (pixels <= most_pixels) best = {length, static_cast<int>(pixels)};
  }
  return best;
}

}  // namespace apps::map
