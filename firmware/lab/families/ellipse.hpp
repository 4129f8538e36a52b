// SPDX-License-Identifier: MIT
//
// The family of ellipses: outlines by a table of sines, and by the midpoint's error in 16, 32 and 64 bits.
//
// Bit budget of the midpoint, in quarters: 8*max(a^2*b, a*b^2), so 16 bits hold for half axes up to 15, 32 up
// to 645, 64 for all of the domain. Rungs refuse longer ones, and aren't measured under loads that have them.
// Unlike the library's ellipse these go around all of it, visible or not.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/number/angle.hpp>
#include <intaglio/number/sine.hpp>
#include <intaglio/raster/ellipse.hpp>
#include <intaglio/raster/sink.hpp>
#include <intaglio/raster/solid.hpp>
#include <intaglio/status.hpp>

#include <cstdint>
#include <firmware/lab/family.hpp>
#include <string_view>
#include <type_traits>

namespace lab {

/// Puts the four images of a pixel around a centre, those that are visible.
template <class S>
void put_quadrants(const S& sink, intaglio::linear::Point centre, int across, int down) noexcept {
  const auto& clip = sink.clip();
  const auto put = [&](int x, int y) {
    if (clip.x <= x && x < clip.right() && clip.y <= y && y < clip.bottom()) sink.span(y, x, x + 1);
  };
  put(centre.x + across, centre.y + down);
  put(centre.x - across, centre.y + down);
  put(centre.x + across, centre.y - down);
  put(centre.x - across, centre.y - down);
}

/// Half axes of 0 .. most; else what is wrong with them.
[[nodiscard]] constexpr intaglio::Status check_axes(int a, int b, int most) noexcept {
  if (a < 0 || b < 0 || a > most || b > most)
    return {intaglio::Error::out_of_domain, intaglio::Argument::radius};
  return {};
}

/// As many points of a quadrant as it has columns and rows, each rounded to a pixel.
struct SineEllipse {
  static constexpr number::Bound bound{152'000, number::Unit::wrong_pixel};
  static constexpr std::string_view domain = "half axes up to 16,383";
  static constexpr int most = 16'383;
  template <class S>
  intaglio::Status operator()(const S& sink, intaglio::linear::Point centre, int a, int b) const noexcept {
    if (const auto status = check_axes(a, b, most); !status.ok()) return status;
    constexpr unsigned quadrant = 16384U << 16U;
    const unsigned points = static_cast<unsigned>(a + b) + 1;
    const unsigned step = quadrant / points;
    for (unsigned i = 0, angle = 0; i <= points; ++i, angle += step) {
      const auto turn = number::Angle::from_steps(static_cast<int>(angle >> 16U));
      put_quadrants(sink, centre, (a * number::cosine(turn).raw() + (1 << 14)) >> 15,
                    (b * number::sine(turn).raw() + (1 << 14)) >> 15);
    }
    return {};
  }
};

/// The midpoint between two pixels is in or out: along columns where the curve is flat, then along rows.
template <class Int, class S>
void walk_midpoints(const S& sink, intaglio::linear::Point centre, int a, int b) noexcept {
  const auto aa = static_cast<Int>(a * a);
  const auto bb = static_cast<Int>(b * b);
  Int x = 0;
  auto y = static_cast<Int>(b);
  Int across = 0;                            // 8*b^2*x
  auto down = static_cast<Int>(8 * aa * y);  // 8*a^2*y
  auto d = static_cast<Int>(4 * bb - 4 * aa * y + aa);
  const auto put = [&] { put_quadrants(sink, centre, static_cast<int>(x), static_cast<int>(y)); };
  while (across < down) {
    put();
    ++x;
    across = static_cast<Int>(across + 8 * bb);
    if (d >= 0) {
      --y;
      down = static_cast<Int>(down - 8 * aa);
      d = static_cast<Int>(d - down);
    }
    d = static_cast<Int>(d + across + 4 * bb);
  }
  d = static_cast<Int>(d - (across + down) / 2 + 3 * (aa - bb));
  while (y >= 0) {
    put();
    --y;
    down = static_cast<Int>(down - 8 * aa);
    if (d < 0) {
      ++x;
      across = static_cast<Int>(across + 8 * bb);
      d = static_cast<Int>(d + across);
    }
    d = static_cast<Int>(d - down + 4 * aa);
  }
  // The tip of a flat one.
  y = 0;
  while (x <= a) put(), ++x;
}

/// The midpoints in so many bits.
template <class Int, int longest>
struct MidpointEllipse {
  static constexpr number::Bound bound{12'000, number::Unit::wrong_pixel};
  static constexpr int most = longest;
  template <class S>
  intaglio::Status operator()(const S& sink, intaglio::linear::Point centre, int a, int b) const noexcept {
    if (const auto status = check_axes(a, b, most); !status.ok()) return status;
    walk_midpoints<Int>(sink, centre, a, b);
    return {};
  }
};
struct MidpointEllipse16 : MidpointEllipse<std::int16_t, 15> {
  static constexpr std::string_view domain = "half axes up to 15";
};
struct MidpointEllipse32 : MidpointEllipse<std::int32_t, 645> {
  static constexpr std::string_view domain = "half axes up to 645";
};
struct MidpointEllipse64 : MidpointEllipse<std::int64_t, 1 << 19> {
  static constexpr std::string_view domain = "half axes up to 2^19";
};

/// The library's: row by row, those visible.
struct RowEllipse {
  static constexpr number::Bound bound = number::exactly(number::Unit::wrong_pixel);
  template <class S>
  intaglio::Status operator()(const S& sink, intaglio::linear::Point centre, int a, int b) const noexcept {
    return intaglio::raster::draw_ellipse(sink, centre, a, b);
  }
};

struct Ellipse {
  static constexpr std::string_view name = "ellipse";
  static constexpr std::string_view title = "Drawing an ellipse";
  using Rungs =
      number::Family<MidpointEllipse32, MidpointEllipse16, RowEllipse, MidpointEllipse64, SineEllipse>;
  using Default = RowEllipse;
  static constexpr Load loads[] = {
      {"half axes up to 15", 32}, {"half axes 40 to 110", 8}, {"half axes 300 to 450, clipped", 4}};

  struct Input {
    intaglio::linear::Point centre;
    int across;
    int down;
  };
  static Input input(int load, int i) noexcept {
    Random random(static_cast<std::uint32_t>(i + 1));
    if (load == 0) {
      return {
          {random.between(20, 299), random.between(20, 219)}, random.between(1, 15), random.between(1, 15)};
    }
    if (load == 1) return {{160, 120}, random.between(40, 110), random.between(40, 110)};
    return {{160, 500}, random.between(300, 450), random.between(300, 450)};
  }
  template <class R>
  static std::uint32_t run(const Input& in) noexcept {
    const intaglio::raster::Solid<image::Indexed8> pen(canvas(), 1);
    return R{}(pen, in.centre, in.across, in.down).ok() ? 1 : 0;
  }

  /// 16 bits are enough under the first load alone.
  template <class R>
  static constexpr bool takes(int load) noexcept {
    return !std::is_same_v<R, MidpointEllipse16> || load == 0;
  }
  /// The most that any ellipse of the load has wrong, all tried. Midpoints along one axis at a time miss
  /// pixels at the tips of slender ones.
  template <class R>
  static constexpr number::Bound bound(int load) noexcept {
    constexpr int of_sines[] = {32, 152, 120};
    constexpr int of_midpoints[] = {12, 8, 0};
    int wrong = of_midpoints[load];
    if (std::is_same_v<R, SineEllipse>) wrong = of_sines[load];
    if (std::is_same_v<R, RowEllipse>) wrong = 0;
    return {1000 * wrong, number::Unit::wrong_pixel};
  }
};

}  // namespace lab
