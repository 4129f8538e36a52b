// SPDX-License-Identifier: MIT
//
// The family of circles: outlines by a table of sines, and by the midpoint's error in 16, 32 and 64 bits.
//
// Bit budget of the midpoint: |error| < 2*r + 8, so 16 bits hold up to the radius 16,383, 32 and 64 bits all
// of the domain. Unlike the library's circle these go around all of it, visible or not.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/number/angle.hpp>
#include <intaglio/number/sine.hpp>
#include <intaglio/raster/circle.hpp>
#include <intaglio/raster/sink.hpp>
#include <intaglio/raster/solid.hpp>
#include <intaglio/status.hpp>

#include <cstdint>
#include <firmware/lab/family.hpp>
#include <string_view>
#include <type_traits>

namespace lab {

/// Puts a pixel, if it is visible.
template <class S>
void put_visible(const S& sink, int x, int y) noexcept {
  const auto& clip = sink.clip();
  if (clip.x <= x && x < clip.right() && clip.y <= y && y < clip.bottom()) sink.span(y, x, x + 1);
}

/// Puts the eight images of a pixel of the octant 0 <= x <= y.
template <class S>
void put_octants(const S& sink, intaglio::linear::Point centre, int x, int y) noexcept {
  for (const bool swapped : {false, true}) {
    const int across = swapped ? y : x;
    const int down = swapped ? x : y;
    put_visible(sink, centre.x + across, centre.y + down);
    put_visible(sink, centre.x - across, centre.y + down);
    put_visible(sink, centre.x + across, centre.y - down);
    put_visible(sink, centre.x - across, centre.y - down);
  }
}

/// A radius of 0 .. most; else what is wrong with it.
[[nodiscard]] constexpr intaglio::Status check_radius(int radius, int most) noexcept {
  if (radius < 0 || radius > most) return {intaglio::Error::out_of_domain, intaglio::Argument::radius};
  return {};
}

/// As many points of an octant as it has columns and one more, each rounded to a pixel.
struct SineCircle {
  static constexpr number::Bound bound{168'000, number::Unit::wrong_pixel};
  static constexpr std::string_view domain = "radius up to 16,383";
  static constexpr int most = 16'383;
  template <class S>
  intaglio::Status operator()(const S& sink, intaglio::linear::Point centre, int radius) const noexcept {
    if (const auto status = check_radius(radius, most); !status.ok()) return status;
    constexpr unsigned octant = 8192U << 16U;
    const unsigned points = static_cast<unsigned>(radius) + 1;
    const unsigned step = octant / points;
    const auto scaled = [radius](int sine) { return (radius * sine + (1 << 14)) >> 15; };
    for (unsigned i = 0, angle = 0; i <= points; ++i, angle += step) {
      const auto turn = number::Angle::from_steps(static_cast<int>(angle >> 16U));
      put_octants(sink, centre, scaled(number::sine(turn).raw()), scaled(number::cosine(turn).raw()));
    }
    return {};
  }
};

/// The error of the octant, in so many bits.
template <class Int, int most>
struct MidpointCircle {
  static constexpr number::Bound bound = number::exactly(number::Unit::wrong_pixel);
  template <class S>
  intaglio::Status operator()(const S& sink, intaglio::linear::Point centre, int radius) const noexcept {
    if (const auto status = check_radius(radius, most); !status.ok()) return status;
    Int x = 0;
    auto y = static_cast<Int>(radius);
    auto error = static_cast<Int>(-radius);  // x^2 + y^2 - y - r^2
    while (x <= y) {
      put_octants(sink, centre, static_cast<int>(x), static_cast<int>(y));
      error = static_cast<Int>(error + 2 * x + 1);
      ++x;
      if (error >= 0) {
        --y;
        error = static_cast<Int>(error - 2 * y);
      }
    }
    return {};
  }
};
struct MidpointCircle16 : MidpointCircle<std::int16_t, 16'383> {
  static constexpr std::string_view domain = SineCircle::domain;
};
struct MidpointCircle32 : MidpointCircle<std::int32_t, intaglio::linear::coordinate_limit> {};
struct MidpointCircle64 : MidpointCircle<std::int64_t, intaglio::linear::coordinate_limit> {};

/// The library's.
struct CursorCircle {
  static constexpr number::Bound bound = MidpointCircle16::bound;
  template <class S>
  intaglio::Status operator()(const S& sink, intaglio::linear::Point centre, int radius) const noexcept {
    return intaglio::raster::draw_circle(sink, centre, radius);
  }
};

struct Circle {
  static constexpr std::string_view name = "circle";
  static constexpr std::string_view title = "Drawing a circle";
  using Rungs =
      number::Family<CursorCircle, MidpointCircle32, MidpointCircle16, MidpointCircle64, SineCircle>;
  using Default = CursorCircle;
  static constexpr Load loads[] = {
      {"radius up to 16", 32}, {"radius 40 to 110", 8}, {"radius 1,000, clipped", 4}};

  struct Input {
    intaglio::linear::Point centre;
    int radius;
  };
  static Input input(int load, int i) noexcept {
    Random random(static_cast<std::uint32_t>(i + 1));
    if (load == 0) return {{random.between(20, 299), random.between(20, 219)}, random.between(1, 16)};
    if (load == 1) return {{160, 120}, random.between(40, 110)};
    return {{160 + (i % 2 == 0 ? 950 : -980), 120 + random.between(-100, 100)}, 1000};
  }
  template <class R>
  static std::uint32_t run(const Input& in) noexcept {
    const intaglio::raster::Solid<image::Indexed8> pen(canvas(), 1);
    return R{}(pen, in.centre, in.radius).ok() ? 1 : 0;
  }

  /// Of the table of sines: the most that any circle of the load has wrong, all tried. (With a radius of
  /// 1,000, 105 were found, in windows around each of its rows.)
  template <class R>
  static constexpr number::Bound bound(int load) noexcept {
    constexpr int wrong[] = {32, 168, 120};
    return {std::is_same_v<R, SineCircle> ? 1000 * wrong[load] : 0, number::Unit::wrong_pixel};
  }
};

}  // namespace lab
