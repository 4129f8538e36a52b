// SPDX-License-Identifier: MIT
//
// The family of lines. The rungs for whole pixels take ends in 1/256 pixel at the pixels nearest to them.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/sub_rect.hpp>
#include <intaglio/raster/line.hpp>
#include <intaglio/raster/line_rungs.hpp>
#include <intaglio/raster/solid.hpp>

#include <cstdint>
#include <firmware/lab/family.hpp>
#include <string_view>
#include <type_traits>

namespace lab {

struct Line {
  static constexpr std::string_view name = "line";
  static constexpr std::string_view title = "Drawing a line";
  using Rungs = number::Family<intaglio::raster::SplitErrorLine, intaglio::raster::ExactLine,
                               intaglio::raster::SubPixelLine, intaglio::raster::RoundedLine,
                               intaglio::raster::DistanceLine>;
  using Default = intaglio::raster::ExactLine;
  static constexpr Load loads[] = {{"short, up to 16 pixels", 64},
                                   {"across the screen", 16},
                                   {"100,000 pixels long, clipped", 16},
                                   {"across the screen, ends in 1/256 pixel", 16}};
  static constexpr int longest = 100'000;

  struct Input {
    intaglio::linear::SubPoint from;
    intaglio::linear::SubPoint to;
    intaglio::linear::Point first;
    intaglio::linear::Point last;
  };
  /// Between places in 1/256 pixel.
  static Input between(intaglio::linear::SubPoint from, intaglio::linear::SubPoint to) noexcept {
    return {from, to, intaglio::linear::to_pixel_nearest(from), intaglio::linear::to_pixel_nearest(to)};
  }
  static Input between(intaglio::linear::Point from, intaglio::linear::Point to) noexcept {
    return between(intaglio::linear::to_subpixel(from), intaglio::linear::to_subpixel(to));
  }

  static Input input(int load, int i) noexcept {
    using intaglio::linear::Point;
    using intaglio::linear::SubPoint;
    Random random(static_cast<std::uint32_t>(i + 1000 * load));
    if (load == 0) {
      const Point from{random.between(20, 300), random.between(20, 220)};
      return between(from, Point{from.x + random.between(-15, 15), from.y + random.between(-15, 15)});
    }
    if (load == 1) {
      return between(Point{random.between(0, 319), random.between(0, 239)},
                     Point{random.between(0, 319), random.between(0, 239)});
    }
    if (load == 2) {
      const int x = random.between(-30'000, -1'000);
      const int y = random.between(-30'000, 30'000);
      const int long_way = random.between(2, 3);
      return between(Point{160 + x, 120 + y}, Point{160 - long_way * x, 120 - long_way * y});
    }
    return between(SubPoint{random.between(0, 319 * 256), random.between(0, 239 * 256)},
                   SubPoint{random.between(0, 319 * 256), random.between(0, 239 * 256)});
  }

  /// Draws on a sink.
  template <class R, class S>
  static intaglio::Status draw(const S& sink, const Input& line) noexcept {
    if constexpr (std::is_same_v<R, intaglio::raster::SubPixelLine>) {
      return intaglio::raster::draw_line(sink, line.from, line.to);
    } else {
      return intaglio::raster::draw_line_by<R>(sink, line.first, line.last);
    }
  }
  template <class R>
  static std::uint32_t run(const Input& line) noexcept {
    return draw<R>(intaglio::raster::Solid<image::Indexed8>(canvas(), 1), line).ok() ? 1 : 0;
  }

  /// A pixel that is beside its place counts twice: one is missing, one too many.
  /// - Short lines are below 182 pixels, so exact. Across the screen, line1 was tried with all differences of
  ///   two ends.
  /// - Of 100,000 pixels line1 can be off by more than a row, so that all that is visible is wrong. Line2 is
  ///   wrong where the exact place is less than k * 2^-32 < 2.4e-5 below a tie: with a slope of m/M in lowest
  ///   terms by an odd or even numerator below 4.7 over 2*M. In 320 steps each numerator occurs once, or,
  ///   where M/gcd is less, all are hundreds apart: so at two steps at most.
  /// - Ends taken at the nearest pixel move a line by up to a pixel along its minor axis: all may be wrong.
  template <class R>
  static constexpr number::Bound bound(int load) noexcept {
    using intaglio::raster::RoundedLine;
    using intaglio::raster::SplitErrorLine;
    constexpr bool rounded = std::is_same_v<R, RoundedLine>;
    constexpr bool split = std::is_same_v<R, SplitErrorLine>;
    constexpr bool whole = !std::is_same_v<R, intaglio::raster::SubPixelLine>;
    constexpr int all = 2 * 320 * 1000;
    int wrong = 0;
    if (load == 1 && rounded) wrong = 2 * 1000;
    if (load == 2 && rounded) wrong = all;
    if (load == 2 && split) wrong = 4 * 1000;
    if (load == 3 && whole) wrong = all;
    return {wrong, number::Unit::wrong_pixel};
  }
};

}  // namespace lab
