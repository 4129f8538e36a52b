// SPDX-License-Identifier: MIT
//
// The family of antialiasing: how much of each pixel a triangle covers, from none at all to the exact area.
// Samples s by s are the textbook's supersampling; of 3 by 3 it has a box and a Bartlett window.
//
// Each rung draws under the triangle's bounding box, as a program would.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/raster/coverage.hpp>
#include <intaglio/raster/layer_sink.hpp>
#include <intaglio/raster/mask_buffer.hpp>
#include <intaglio/raster/pitteway.hpp>
#include <intaglio/raster/supersample.hpp>
#include <intaglio/raster/triangle.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <firmware/lab/family.hpp>
#include <string_view>
#include <type_traits>

namespace lab {

namespace raster = intaglio::raster;
using Vertices = std::array<intaglio::linear::SubPoint, 3>;

inline constexpr int widest_drawing = 320;

[[nodiscard]] constexpr number::Bound levels(int thousandths) noexcept {
  return {thousandths, number::Unit::coverage_level};
}

/// Pixels are covered or not.
struct NoAntialiasing {
  static constexpr number::Bound bound = levels(255'000);
  template <class S>
  struct Whole {
    S* sink;
    [[nodiscard]] intaglio::linear::Rect clip() const noexcept { return sink->clip(); }
    void span(int y, int x_begin, int x_end) const noexcept {
      sink->span(y, x_begin, x_end, raster::full_coverage);
    }
  };
  template <class S>
  bool operator()(S& sink, const Vertices& t) const noexcept {
    return raster::fill_triangle(Whole<S>{&sink}, t[0], t[1], t[2]).ok();
  }
};

/// Samples of the library.
template <int scale, raster::SampleFilter filter>
struct Samples {
  static constexpr std::string_view slack =
      "held for any number of edges through a pixel; the worst pixels found have two";
  template <class S>
  bool operator()(S& sink, const Vertices& t) const noexcept {
    static std::array<raster::SampleCell, std::size_t{16} * widest_drawing> cells;
    constexpr raster::Supersampling grid{scale, scale, filter};
    constexpr raster::Enlargement by(scale);
    return raster::supersample(sink, grid, cells,
                               [&](const auto& samples) {
                                 return raster::fill_triangle(samples, by.place(t[0]), by.place(t[1]),
                                                              by.place(t[2]));
                               })
        .ok();
  }
};
struct Samples2x2 : Samples<2, raster::SampleFilter::box> {
  static constexpr number::Bound bound = levels(255'000);
};
struct Samples3x3 : Samples<3, raster::SampleFilter::box> {
  static constexpr number::Bound bound = levels(170'500);
};
struct Bartlett3x3 : Samples<3, raster::SampleFilter::bartlett> {
  static constexpr number::Bound bound = levels(255'000);
};
struct Samples4x4 : Samples<4, raster::SampleFilter::box> {
  static constexpr number::Bound bound = levels(128'000);
};

/// Bits of a mask.
struct Masks4x4 {
  static constexpr number::Bound bound = levels(128'000);
  static constexpr std::string_view slack = Samples4x4::slack;
  template <class S>
  bool operator()(S& sink, const Vertices& t) const noexcept {
    static std::array<raster::MaskCell, widest_drawing> cells;
    constexpr raster::Enlargement by(4);
    return raster::cover_by_masks(raster::OneLayer<S&>(sink), raster::MaskGrid::four_by_four, 1, cells,
                                  [&](int /*layer*/, raster::MaskSink& parts) {
                                    return raster::fill_triangle(parts, by.place(t[0]), by.place(t[1]),
                                                                 by.place(t[2]));
                                  })
        .ok();
  }
};

/// 17 samples along each of 15 rows: 255, so their number is the level. Rows come from above.
struct Samples15x17 {
  static constexpr number::Bound bound = levels(32'000);
  static constexpr std::string_view slack = Samples4x4::slack;
  static constexpr int across = 17;
  static constexpr int down = 15;

  template <class S>
  class Rows {
   public:
    explicit Rows(S& sink) noexcept : sink_(&sink), box_(sink.clip()), y_(box_.y) { changes().fill(0); }
    [[nodiscard]] intaglio::linear::Rect clip() const noexcept {
      return {box_.x * across, box_.y * down, box_.width * across, box_.height * down};
    }
    void span(int y, int x_begin, int x_end) noexcept {
      const int row = box_.y + static_cast<int>(static_cast<unsigned>(y - box_.y * down) / down);
      if (row != y_) hand_over(row);
      add(x_begin, 1);
      add(x_end, -1);
    }
    /// Hands the row over, and goes to another.
    void hand_over(int next_row) noexcept {
      int level = 0;
      int begin = 0;
      for (int x = 0; x < box_.width; ++x) {
        std::int16_t& change = changes()[static_cast<std::size_t>(x)];
        if (change == 0) continue;
        if (level != 0) sink_->span(y_, box_.x + begin, box_.x + x, level);
        level += change;
        begin = x;
        change = 0;
      }
      if (level != 0) sink_->span(y_, box_.x + begin, box_.right(), level);
      changes()[static_cast<std::size_t>(box_.width)] = 0;
      y_ = next_row;
    }

   private:
    static std::array<std::int16_t, widest_drawing + 2>& changes() noexcept {
      static std::array<std::int16_t, widest_drawing + 2> changes;
      return changes;
    }
    /// All samples of a row from x on.
    void add(int x, int sign) const noexcept {
      const auto place = static_cast<unsigned>(x - box_.x * across);
      const unsigned column = place / across;
      const auto left_out = static_cast<int>(place % across);
      std::int16_t* const change = &changes()[column];
      change[0] = static_cast<std::int16_t>(change[0] + sign * (across - left_out));
      change[1] = static_cast<std::int16_t>(change[1] + sign * left_out);
    }

    S* sink_;
    intaglio::linear::Rect box_;
    int y_;
  };

  template <class S>
  bool operator()(S& sink, const Vertices& t) const noexcept {
    const auto place = [](intaglio::linear::SubPoint p) {
      return intaglio::linear::SubPoint{p.x * across + 128 * (across - 1), p.y * down + 128 * (down - 1)};
    };
    Rows<S> rows(sink);
    const bool drawn = raster::fill_triangle(rows, place(t[0]), place(t[1]), place(t[2])).ok();
    rows.hand_over(0);
    return drawn;
  }
};

/// Bresenham's error as the level.
struct PittewayWatkinson {
  static constexpr number::Bound bound = levels(255'000);
  static constexpr std::string_view slack = "of pixels with corners no bound is proven";
  template <class S>
  bool operator()(S& sink, const Vertices& t) const noexcept {
    return raster::fill_convex_pitteway(sink, t).ok();
  }
};

/// The area itself.
struct ExactArea {
  static constexpr number::Bound bound = levels(501);
  template <class S>
  bool operator()(S& sink, const Vertices& t) const noexcept {
    static std::array<raster::CoverageCell, raster::coverage_cells(3, widest_drawing)> cells;
    return raster::fill_coverage(sink, raster::FillRule::non_zero, t, cells).ok();
  }
};

struct Antialiasing {
  static constexpr std::string_view name = "antialiasing";
  static constexpr std::string_view title = "Filling a triangle with smooth edges";
  using Rungs = number::Family<NoAntialiasing, ExactArea, Samples2x2, Samples3x3, Bartlett3x3, Samples4x4,
                               Masks4x4, Samples15x17, PittewayWatkinson>;
  using Default = ExactArea;
  static constexpr Load loads[] = {{"triangles, where one edge is in a pixel", 3},
                                   {"needles, everywhere", 3}};

  struct Input {
    Vertices triangle;
    intaglio::linear::Rect box;
  };
  /// The triangle that follows from a number: of some 40 pixels (every fourth with edges along rows and
  /// columns, every fourth along diagonals), or a needle up to two pixels wide.
  static Input triangle(int load, std::uint32_t seed) noexcept {
    using intaglio::linear::SubPoint;
    Random random(seed);
    const SubPoint a{random.between(20 * 256, 30 * 256), random.between(20 * 256, 30 * 256)};
    Vertices t{a, a, a};
    const auto near = [&](int reach) {
      return SubPoint{a.x + random.between(-reach, reach), a.y + random.between(-reach, reach)};
    };
    const int size = random.between(4 * 256, 20 * 256);
    if (load == 1) {
      t[1] = near(20 * 256);
      t[2] = {t[1].x + random.between(-512, 512), t[1].y + random.between(-512, 512)};
    } else if (seed % 4 == 0) {
      t[1].x += size;
      t[2].y += random.between(4 * 256, 20 * 256);
    } else if (seed % 4 == 1) {
      t[1] = {a.x + size, a.y + size};
      t[2] = {a.x + size, a.y - size};
    } else {
      t[1] = near(20 * 256);
      t[2] = near(20 * 256);
    }
    const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
    const auto [top, bottom] = std::minmax({t[0].y, t[1].y, t[2].y});
    const int x = (left + 128) >> 8;
    const int y = (top + 128) >> 8;
    return {t, {x, y, ((right + 128) >> 8) + 1 - x, ((bottom + 128) >> 8) + 1 - y}};
  }
  static Input input(int load, int i) noexcept { return triangle(load, static_cast<std::uint32_t>(i + 1)); }

  template <class R>
  static std::uint32_t run(const Input& in) noexcept {
    auto ramp = raster::RampCoverage<image::Indexed8>::over(canvas(), 0, 256, in.box);
    return ramp.ok() && R{}(ramp.value(), in.triangle) ? 1 : 0;
  }

  /// With one edge in a pixel: 1/(2*s) of it for s by s samples, and half a level (supersample.hpp has it,
  /// and what Bartlett's window adds); m/8 for Pitteway and Watkinson (pitteway.hpp). Anywhere: of a convex
  /// shape each of s rows has a sample too many or too few at most, 1/s of all; and as the rows' chords grow
  /// and then shrink, their sum is at most 1/s off the area.
  template <class R>
  static constexpr number::Bound bound(int load) noexcept {
    if (load == 1 || std::is_same_v<R, ExactArea>) return R::bound;
    if (std::is_same_v<R, NoAntialiasing>) return levels(127'500);
    if (std::is_same_v<R, Samples2x2> || std::is_same_v<R, Bartlett3x3>) return levels(64'250);
    if (std::is_same_v<R, Samples3x3>) return levels(43'000);
    if (std::is_same_v<R, Samples15x17>) return levels(8'500);
    return levels(32'400);
  }
};

}  // namespace lab
