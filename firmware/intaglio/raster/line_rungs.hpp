// SPDX-License-Identifier: MIT
//
// Other ways to a line: rungs beside the exact one of line.hpp.
//
// Rule: a line's pixel after k of M steps along the major axis lies j(k) steps along the minor one, which
// exactly is floor((2*m*k + M - s) / (2*M)) (clip/line_path.hpp). The rungs:
// - `RoundedLine` (the book's line1): j(k) = the position S*k rounded to an integer, S the slope m/M with 16
//   fraction bits;
// - `SplitErrorLine` (line2): only the position's fraction is kept, so S has 32 fraction bits and a step of
//   one is a carry;
// - `ExactLine` (line3): Bresenham's, which is `draw_line`;
// - `SubPixelLine`: the same for ends in 1/256 pixel;
// - `DistanceLine` (the book's first): of the two next pixels the one nearer to the line, by products at
//   each.
//
// Where pixels halfway between two rows go on (s = 0), S is rounded up, where they stay (s = 1), down: so the
// error never moves a pixel off a tie. All rungs draw a line from b to a as from a to b, and clipping changes
// no pixel of theirs.
//
// Error: S is off by less than 2^-f, so after k steps the position is off by less than k * 2^-f pixel, on one
// side. A pixel differs from the exact one only if that reaches the next tie, at least 1/(2*M) away: not
// where k <= 2^(f-1)/M. So lines up to 2^((f-1)/2) long are exact: 181 pixels for line1, 46340 for line2.
// Beyond, the last pixel can miss the end. Of line1 the worst slope has 1 wrong pixel at length 320, 13 at
// 1000, 182 at 4000 and, where they begin to be two rows off, 67,000 at 100,000; of line2 some 100 at 10^6.
// Bit budget: S*k has 21 + f bits. Textbook: section 2.3, exercises. Worst known inputs: slopes just below a
// ratio of small numbers; above 46340 pixels, (100000, 23046).
//
// A pixel of a flat line takes 19 instructions with line1, 7 with line2, 8 with line3 and 19 by distance on
// Cortex-M3; line2 and the others take a division more to begin. Line1 and the distance are dominated.
#pragma once

#include <intaglio/clip/line_path.hpp>
#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/number/bound.hpp>
#include <intaglio/raster/cursor.hpp>
#include <intaglio/raster/line.hpp>
#include <intaglio/raster/sink.hpp>
#include <intaglio/status.hpp>

#include <concepts>
#include <cstdint>

namespace intaglio::raster {

/// A line's slope: minor steps for major steps.
struct LineSlope {
  unsigned major;  ///< M, 0..2^21
  unsigned minor;  ///< m, 0..M
  unsigned tie;    ///< s: 1 if pixels halfway between two rows stay on the first, else 0
};

/// A way to draw lines. `Stairs(slope)` are its steps: `at(k)` is j(k), `start(k)` goes there, `next()` goes
/// on by one major step and is true if it goes on by a minor step, too. `bound` says how far beyond the half
/// pixel of exact lines a pixel can be from the line, at most; `bound_for(length)` the same for lines that
/// long, and `wrong_pixels(length)` how many of their pixels can differ from the exact line's.
template <class R>
concept LineRung = number::Rung<R> && requires(const R& rung, typename R::Stairs stairs, LineSlope slope) {
  { rung(slope, 0) } -> std::same_as<int>;
  { R::bound_for(0) } -> std::same_as<number::Bound>;
  { R::wrong_pixels(0) } -> std::same_as<int>;
  requires std::constructible_from<typename R::Stairs, LineSlope>;
  { stairs.at(0) } -> std::same_as<int>;
  stairs.start(0);
  { stairs.next() } -> std::same_as<bool>;
};

/// Draws the line from `a` to `b`, both ends included, by a rung. Errors: out_of_domain point. Cost: a
/// division, some hundred instructions where the line is clipped, and for each visible pixel what a step of
/// the rung takes.
template <LineRung Rung, SpanSink S>
Status draw_line_by(S&& sink, linear::Point a, linear::Point b);

namespace detail {

inline constexpr int longest_line = 2 * linear::coordinate_limit;

/// m/M with so many fraction bits, up to 32: rounded up, or down where ties stay. 1 with 32 bits is 1 -
/// 2^-32, which makes no difference up to 2^31 steps.
[[nodiscard]] std::uint32_t fixed_slope(const LineSlope& slope, unsigned fraction_bits) noexcept;

/// What rungs with a rounded slope have in common.
template <class R, unsigned fraction_bits>
struct FixedSlopeLine {
  /// What the error of the slope makes of a length, in thousandths of a pixel, rounded up.
  static constexpr number::Bound bound_for(int length) noexcept {
    constexpr std::int64_t one = std::int64_t{1} << fraction_bits;
    return number::pixels(static_cast<int>((std::int64_t{length} * 1000 + one - 1) / one));
  }
  static constexpr int wrong_pixels(int length) noexcept {
    constexpr std::int64_t half = std::int64_t{1} << (fraction_bits - 1);
    return std::int64_t{length} * length <= half ? 0 : length - static_cast<int>(half / length);
  }
  static constexpr number::Bound bound = bound_for(longest_line);

  /// j(k).
  [[nodiscard]] int operator()(const LineSlope& slope, int k) const noexcept {
    return typename R::Stairs(slope).at(k);
  }
  /// Draws the line from `a` to `b`: `draw_line_by`.
  template <SpanSink S>
  Status operator()(S&& sink, linear::Point a, linear::Point b) const {
    return draw_line_by<R>(sink, a, b);
  }

 protected:
  /// Positions along the minor axis in 2^-fraction_bits, plus one half.
  class Positions {
   public:
    explicit Positions(const LineSlope& line) noexcept
        : slope_(fixed_slope(line, fraction_bits)), half_((1U << (fraction_bits - 1)) - line.tie) {}
    [[nodiscard]] int at(int k) const noexcept { return static_cast<int>(position(k) >> fraction_bits); }

   protected:
    [[nodiscard]] std::uint32_t slope() const noexcept { return slope_; }
    [[nodiscard]] std::uint64_t position(int k) const noexcept {
      return std::uint64_t{slope_} * static_cast<unsigned>(k) + half_;
    }

   private:
    std::uint32_t slope_;
    std::uint32_t half_;
  };
};

}  // namespace detail

/// The book's line1.
struct RoundedLine : detail::FixedSlopeLine<RoundedLine, 16> {
  class Stairs : public Positions {
   public:
    using Positions::Positions;
    void start(int k) noexcept { position_ = position(k); }
    [[nodiscard]] bool next() noexcept {
      const std::uint64_t row = position_ >> 16U;
      position_ += slope();
      return position_ >> 16U != row;
    }

   private:
    std::uint64_t position_ = 0;
  };
};

/// The book's line2.
struct SplitErrorLine : detail::FixedSlopeLine<SplitErrorLine, 32> {
  class Stairs : public Positions {
   public:
    using Positions::Positions;
    void start(int k) noexcept { fraction_ = static_cast<std::uint32_t>(position(k)); }
    [[nodiscard]] bool next() noexcept {
      fraction_ += slope();
      return fraction_ < slope();
    }

   private:
    std::uint32_t fraction_ = 0;
  };
};

/// A line by comparing distances, from scratch at each pixel.
struct DistanceLine {
  static constexpr number::Bound bound_for(int) noexcept { return number::pixels(0); }
  static constexpr int wrong_pixels(int) noexcept { return 0; }
  static constexpr number::Bound bound = number::pixels(0);

  class Stairs {
   public:
    explicit Stairs(const LineSlope& slope) noexcept : slope_(slope) {}
    [[nodiscard]] int at(int k) const noexcept;
    void start(int k) noexcept {
      step_ = static_cast<unsigned>(k);
      row_ = static_cast<unsigned>(at(k));
    }
    [[nodiscard]] bool next() noexcept {
      ++step_;
      // The line is m*k/M down; the pixel below is nearer if that is beyond row + 1/2.
      const std::uint64_t line = std::uint64_t{2 * slope_.minor} * step_;
      const std::uint64_t middle = std::uint64_t{slope_.major} * (2 * row_ + 1) + slope_.tie;
      if (line < middle) return false;
      ++row_;
      return true;
    }

   private:
    LineSlope slope_;
    unsigned step_ = 0;
    unsigned row_ = 0;
  };

  /// j(k).
  [[nodiscard]] int operator()(const LineSlope& slope, int k) const noexcept { return Stairs(slope).at(k); }
  /// Draws the line from `a` to `b`: `draw_line_by`.
  template <SpanSink S>
  Status operator()(S&& sink, linear::Point a, linear::Point b) const {
    return draw_line_by<DistanceLine>(sink, a, b);
  }
};

/// The book's line3, the default: `draw_line`.
struct ExactLine : DistanceLine {
  using DistanceLine::operator();
  template <SpanSink S>
  Status operator()(S&& sink, linear::Point a, linear::Point b) const {
    return draw_line(sink, a, b);
  }
};

/// The default for ends in 1/256 pixel; between pixels it draws what `ExactLine` does, and takes longer to
/// begin.
struct SubPixelLine : DistanceLine {
  using DistanceLine::operator();
  template <SpanSink S>
  Status operator()(S&& sink, linear::Point a, linear::Point b) const {
    if (!linear::in_domain(a) || !linear::in_domain(b)) return {Error::out_of_domain, Argument::point};
    return draw_line(sink, linear::to_subpixel(a), linear::to_subpixel(b));
  }
  /// (A template of the points, as `draw_line` is, so that {x, y} goes on meaning pixels.)
  template <SpanSink S, std::same_as<linear::SubPoint> P>
  Status operator()(S&& sink, P a, P b) const {
    return draw_line(sink, a, b);
  }
};

/// The rungs of lines.
using LineFamily = number::Family<RoundedLine, SplitErrorLine, ExactLine, DistanceLine, SubPixelLine>;

namespace detail {

/// A whole line in a frame in which it runs to the right and down, the longer axis first, from its left end.
struct LineFrame {
  clip::LinePath path;  ///< Of the whole line; its count is 0 if it isn't in the domain.
  LineSlope slope;
  linear::Point low;   ///< The window, from here ..
  linear::Point high;  ///< .. to here, which is outside.
};
[[nodiscard]] Status line_frame(linear::Point a, linear::Point b, const linear::Rect& window,
                                LineFrame& frame) noexcept;

/// The first step on row `j` or a later one; M + 1 if there is none.
template <class Stairs>
[[nodiscard]] int first_at(const Stairs& stairs, const LineSlope& slope, int j) noexcept {
  if (j <= 0) return 0;
  int low = 0;
  int high = static_cast<int>(slope.major);
  if (stairs.at(high) < j) return high + 1;
  while (low < high) {
    const int middle = low + (high - low) / 2;
    if (stairs.at(middle) >= j)
      high = middle;
    else
      low = middle + 1;
  }
  return low;
}

template <bool steep, class Cursor, class Stairs>
void walk_stairs(Cursor cursor, Stairs stairs, int count) {
  while (true) {
    cursor.put();
    if (--count == 0) return;
    const bool minor = stairs.next();
    if (minor || steep) cursor.down();
    if (minor || !steep) cursor.right();
  }
}

}  // namespace detail

template <LineRung Rung, SpanSink S>
Status draw_line_by(S&& sink, linear::Point a, linear::Point b) {
  if constexpr (std::same_as<Rung, ExactLine>) {
    return draw_line(sink, a, b);
  } else if constexpr (std::same_as<Rung, SubPixelLine>) {
    return Rung{}(sink, a, b);
  } else {
    detail::LineFrame frame;
    const Status status = detail::line_frame(a, b, sink.clip(), frame);
    if (!status.ok()) return status;
    typename Rung::Stairs stairs(frame.slope);
    const int low = detail::first_at(stairs, frame.slope, frame.low.y);
    const int high = detail::first_at(stairs, frame.slope, frame.high.y);
    const int begin = low > frame.low.x ? low : frame.low.x;
    const int end = high < frame.high.x ? high : frame.high.x;
    if (begin >= end) return {};
    stairs.start(begin);
    const auto& [start, count, error, minor_step, major_step, steep, up] = frame.path;
    const int row = stairs.at(begin);
    const int x = start.x + (steep ? row : begin);
    const int y = steep ? begin : row;
    auto cursor = cursor_at(sink, x, start.y + (up ? -y : y));
    if (up) cursor.turn_over();
    if (steep)
      detail::walk_stairs<true>(cursor, stairs, end - begin);
    else
      detail::walk_stairs<false>(cursor, stairs, end - begin);
    return {};
  }
}

}  // namespace intaglio::raster
