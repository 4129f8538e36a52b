// SPDX-License-Identifier: MIT
//
// A value along a run of pixels that is seen in perspective: texture coordinates, shades, depths.
//
// Rule: a value that changes evenly along a line in space doesn't change evenly along its picture. With the
// ends at depths w0 and w1 and n steps between them on the screen, step k lies
//     S(k) = w0*k / (w1*(n-k) + w0*k)
// of the way in space, and the value there is from + floor((to-from) * S(k)). Floors nest: with f fraction
// bits in a value, value >> f is the texel in which the exact value lies.
//
// The textbook derives S twice, and both are here, with the same bits: from the depths (`by_depths`;
// Heckbert's form, in which value/w and 1/w change evenly), and from where the middle of the line in space is
// seen (`by_midpoint`; the cross-ratio of four points on a line, which no projection changes). The second
// needs no depths: the picture's halves are to each other as the depths of the far and the near end.
//
// Rungs: an exact value at every pixel costs a division; `PerspectiveEvery<n>` is exact at every n-th pixel
// from the run's start and even in between; `PerspectiveAffine` at the ends only. Where the exact pixels are
// depends on the run, not on what of it is visible, so clipping changes no value.
//
// Error bound: a straight line across a stretch over which the value changes by d, and w1*(n-k) + w0*k from p
// to q, is off by at most |d| * |p-q| / (sqrt p + sqrt q)^2, which is reached; floors add less than 2.
// `bound(run)` of a rung says how much that is at the worst stretch, the one where that sum is least.
// Bit budget: |value| <= 2^23, so differences within 2^24; depths times steps below 2^32, as are their sums
// here; products below 2^56. Textbook: section 2.7. Worst known input: depths in a ratio of thousands, where
// all of the change happens in the last pixel.
#pragma once

#include <intaglio/number/division.hpp>
#include <intaglio/number/long_division.hpp>
#include <intaglio/number/root.hpp>
#include <intaglio/status.hpp>

#include <cstdint>

namespace intaglio::raster {

/// The largest magnitude of a value along a run.
inline constexpr int perspective_value_limit = 1 << 23;

/// A run: values at its two ends and how the way between them is foreshortened.
class Perspective {
 public:
  /// A run of `steps` steps (so steps + 1 pixels) from a value at depth `from_depth` to one at `to_depth`,
  /// in any unit. Errors: steps (fewer than 1), point (a value beyond `perspective_value_limit`),
  /// out_of_range position (a depth of 0, or a depth times steps of 2^32 or more: scale both down).
  [[nodiscard]] static constexpr Result<Perspective> by_depths(int from, int to, std::uint32_t from_depth,
                                                               std::uint32_t to_depth, int steps) noexcept {
    if (steps < 1) return Status{Error::empty, Argument::steps};
    if (!in_limit(from) || !in_limit(to)) return Status{Error::out_of_domain, Argument::point};
    const std::uint32_t deepest = UINT32_MAX / static_cast<std::uint32_t>(steps);
    if (from_depth == 0 || to_depth == 0 || from_depth > deepest || to_depth > deepest)
      return Status{Error::out_of_range, Argument::position};
    return Perspective(from, to, from_depth, to_depth, static_cast<std::uint32_t>(steps));
  }

  /// The same from the projected midpoint: where on the screen the middle of the line in space is seen, as
  /// its distances `before` from the run's start and `after` from its end, in any unit. Errors: as above.
  [[nodiscard]] static constexpr Result<Perspective> by_midpoint(int from, int to, std::uint32_t before,
                                                                 std::uint32_t after, int steps) noexcept {
    return by_depths(from, to, after, before, steps);
  }

  /// Draws nothing: one step from 0 to 0.
  constexpr Perspective() noexcept = default;

  [[nodiscard]] constexpr int from() const noexcept { return from_; }
  [[nodiscard]] constexpr int to() const noexcept { return to_; }
  [[nodiscard]] constexpr int steps() const noexcept { return static_cast<int>(steps_); }

  /// The exact value at step `k`, 0 .. steps(), rounded down. Cost: a division of 64 by 32 bits.
  [[nodiscard]] int at(int k) const noexcept {
    const auto step = static_cast<std::uint32_t>(k);
    const bool falls = to_ < from_;
    const auto change = static_cast<std::uint32_t>(falls ? from_ - to_ : to_ - from_);
    const auto [quotient, remainder] =
        number::long_divide(std::uint64_t{change} * (from_depth_ * step), denominator(step));
    const auto way = static_cast<int>(quotient);
    return falls ? from_ - way - (remainder != 0 ? 1 : 0) : from_ + way;
  }

  /// The largest error, in units of the value, of a straight line from step `begin` to step `end`, its own
  /// rounding and that of its ends included.
  [[nodiscard]] int chord_bound(int begin, int end) const noexcept {
    const std::uint32_t p = denominator(static_cast<std::uint32_t>(begin));
    const std::uint32_t q = denominator(static_cast<std::uint32_t>(end));
    const int rise = at(end) - at(begin);
    const std::uint64_t change = static_cast<std::uint64_t>(rise < 0 ? -rise : rise) + 1;
    const std::uint64_t roots = std::uint64_t{p} + q + 2 * number::isqrt(std::uint64_t{p} * q);
    return static_cast<int>((change * (p < q ? q - p : p - q) + roots - 1) / roots) + 2;
  }

  /// True if the value changes fastest at the run's end.
  [[nodiscard]] constexpr bool steepest_at_end() const noexcept { return from_depth_ < to_depth_; }

 private:
  constexpr Perspective(int from, int to, std::uint32_t from_depth, std::uint32_t to_depth,
                        std::uint32_t steps) noexcept
      : from_(from), to_(to), from_depth_(from_depth), to_depth_(to_depth), steps_(steps) {}

  [[nodiscard]] static constexpr bool in_limit(int value) noexcept {
    return -perspective_value_limit <= value && value <= perspective_value_limit;
  }
  [[nodiscard]] constexpr std::uint32_t denominator(std::uint32_t step) const noexcept {
    return to_depth_ * (steps_ - step) + from_depth_ * step;
  }

  int from_ = 0;
  int to_ = 0;
  std::uint32_t from_depth_ = 1;
  std::uint32_t to_depth_ = 1;
  std::uint32_t steps_ = 1;
};

/// The rung that divides at every pixel: exact, rounded down.
struct PerspectiveEveryPixel {
  [[nodiscard]] static constexpr int bound(const Perspective&) noexcept { return 1; }

  /// Walks along a run.
  class Walk {
   public:
    /// Stands on step `k`, 0 .. run.steps().
    constexpr Walk(const Perspective& run, int k) noexcept : run_(run), k_(k) {}
    [[nodiscard]] int value() const noexcept { return run_.at(k_); }
    constexpr void next() noexcept { ++k_; }

   private:
    Perspective run_;
    int k_;
  };
};

namespace detail {

/// Even steps from one value to another: value(j) = from + floor((to-from)*j / count), by a running error.
class EvenSteps {
 public:
  constexpr EvenSteps() noexcept = default;
  /// Stands on step `j` of `count`, 0 <= j <= count, 0 < count.
  EvenSteps(int from, int to, int count, int j) noexcept : count_(count) {
    const auto [step, rest] = number::floor_divide(to - from, count);
    step_ = step;
    rest_ = rest;
    value_ = from + step * j;
    error_ = -count;
    if (j == 0) return;
    const auto [way, error] =
        number::long_divide(std::uint64_t{static_cast<std::uint32_t>(rest)} * static_cast<std::uint32_t>(j),
                            static_cast<std::uint32_t>(count));
    value_ += static_cast<int>(way);
    error_ += static_cast<int>(error);
  }

  [[nodiscard]] constexpr int value() const noexcept { return value_; }
  constexpr void next() noexcept {
    value_ += step_;
    error_ += rest_;
    if (error_ < 0) return;
    error_ -= count_;
    ++value_;
  }

 private:
  int value_ = 0;
  int step_ = 0;
  int rest_ = 0;
  int count_ = 1;
  int error_ = -1;  // -count_ .. -1
};

}  // namespace detail

/// The rung that is exact at every `interval`-th pixel of the run and at its end, even in between: a division
/// for `interval` pixels.
template <int interval>
struct PerspectiveEvery {
  static_assert(2 <= interval);

  [[nodiscard]] static int bound(const Perspective& run) noexcept {
    const int n = run.steps();
    if (!run.steepest_at_end()) return run.chord_bound(0, n < interval ? n : interval);
    // The last stretch, which may be short, and the whole one before it.
    const int last = (n - 1) / interval * interval;
    const int short_bound = run.chord_bound(last, n);
    const int whole_bound = last == 0 ? 0 : run.chord_bound(last - interval, last);
    return short_bound < whole_bound ? whole_bound : short_bound;
  }

  class Walk {
   public:
    Walk(const Perspective& run, int k) noexcept : run_(run), next_(k / interval * interval) {
      to_ = run.at(next_);
      stretch(k - next_);
    }
    [[nodiscard]] int value() const noexcept { return steps_.value(); }
    void next() noexcept {
      if (--left_ == 0)
        stretch(0);
      else
        steps_.next();
    }

   private:
    /// Goes on to the stretch from `next_` on, `j` steps into it.
    void stretch(int j) noexcept {
      const int from = to_;
      const int whole = run_.steps() - next_;
      const int count = whole < interval ? whole : interval;
      if (count <= 0) {  // the run's last pixel
        steps_ = {from, from, 1, 0};
        left_ = 1;
        return;
      }
      next_ += count;
      to_ = run_.at(next_);
      steps_ = {from, to_, count, j};
      left_ = count - j;
    }

    Perspective run_;
    detail::EvenSteps steps_;
    int next_;  // where the stretch ends
    int to_;    // the value there
    int left_ = 0;
  };
};

/// The rung that is exact at the ends only, even in between: no perspective at all.
struct PerspectiveAffine {
  [[nodiscard]] static int bound(const Perspective& run) noexcept { return run.chord_bound(0, run.steps()); }

  class Walk {
   public:
    Walk(const Perspective& run, int k) noexcept : steps_(run.from(), run.to(), run.steps(), k) {}
    [[nodiscard]] int value() const noexcept { return steps_.value(); }
    void next() noexcept { steps_.next(); }

   private:
    detail::EvenSteps steps_;
  };
};

/// Hands the values of steps begin .. end-1 of a run over, in order: `take(value)`.
/// Precondition: 0 <= begin, end <= run.steps() + 1.
template <class Rung = PerspectiveEvery<16>, class Take>
void walk_perspective(const Perspective& run, int begin, int end, const Take& take) {
  if (begin >= end) return;
  typename Rung::Walk walk(run, begin);
  while (true) {
    take(walk.value());
    if (++begin == end) return;
    walk.next();
  }
}

}  // namespace intaglio::raster
