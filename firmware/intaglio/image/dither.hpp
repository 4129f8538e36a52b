// SPDX-License-Identifier: MIT
//
// Dithering: pictures of 256 values shown with few levels.
//
// Rule: a value v of 0 .. 255 asks for v (n - 1) / 255 of n levels, and gets one of the two levels beside
// that.
// - `DitherNone` takes the nearest.
// - `DitherOrdered2`, `4` and `8` add the threshold (k + 1/2) / N^2 of the pixel's place in Bayer's matrix of
//   N x N (bayer.hpp) and round down. Each pixel stands alone, so bands and clips show the same picture.
// - `DitherThreeTap`, `DitherFourTap` (Floyd and Steinberg's) and `DitherSerpentine` take the nearest level
// to
//   the value and what its neighbours owe, and share out what they owe themselves: 6, 6 and 4 sixteenths to
//   the right, below and below right; or 7, 3, 5 and 1 to the right, below left, below and below right. By
//   the last, odd rows run from right to left, with left for right. Sixteenths that don't make a whole go on
//   to the next pixel, so nothing is lost but at the picture's sides and its last row.
// Values are what they are: levels of light for panels that pulse their pixels, codes where a palette's ramp
// is one of codes. A picture in colour is one for each channel, with a walk of its own.
//
// Error bound, of the mean of 8x8 neighbouring pixels in levels, whatever the picture: 1/2 for those without
// memory; for the others half a level of each share across the 8x8 pixels' border, 1.25/8, and less than
// 0.001 for the sixteenths. Of an even field and aligned tiles: 1/2, 1/8, 1/32, 1/128 for none and the
// ordered ones. Bit budget: v (n - 1) <= 65025 and what is owed, at most half a level of 255 (then so is each
// sum of shares, for a pixel's incoming shares add up to sixteen sixteenths at most). Textbook: section 1.4,
// on displays of few levels. Worst known inputs: pictures as fine as the matrix.
#pragma once

#include <intaglio/image/bayer.hpp>
#include <intaglio/image/blit.hpp>
#include <intaglio/image/overlap.hpp>
#include <intaglio/image/surface.hpp>
#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/number/bound.hpp>
#include <intaglio/status.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace intaglio::image {

/// A way to dither. A `Walk` goes through a picture row by row, every pixel of a row in turn: `begin_row(y)`
/// is true if that row goes from right to left, `next(value)` is the pixel's level.
template <class R>
concept DitherRung = number::Rung<R> && requires(typename R::Walk walk) {
  { R::memory(1) } -> std::same_as<int>;
  requires std::constructible_from<typename R::Walk, int, int, int, std::span<std::int16_t>>;
  { walk.begin_row(0) } -> std::same_as<bool>;
  { walk.next(std::uint8_t{}) } -> std::same_as<unsigned>;
};

namespace detail {

/// sum / 255, rounded down; sum <= 65534.
[[nodiscard]] constexpr unsigned over_255(unsigned sum) noexcept { return (sum + 1U + (sum >> 8U)) >> 8U; }

/// What Bayer's thresholds of 2^bits x 2^bits add, in 1/255: (k + 1/2) / 4^bits of 255, rounded down.
template <unsigned bits>
[[nodiscard]] consteval auto make_dither_offsets() {
  std::array<std::array<std::uint8_t, 1U << bits>, 1U << bits> offsets{};
  for (unsigned y = 0; y < 1U << bits; ++y)
    for (unsigned x = 0; x < 1U << bits; ++x)
      offsets[y][x] =
          static_cast<std::uint8_t>(255U * (2U * bayer_number(x, y, bits) + 1U) >> (2U * bits + 1U));
  return offsets;
}

template <unsigned bits>
inline constexpr auto dither_offsets = make_dither_offsets<bits>();

/// Dithering that looks at the pixel's place alone; 0 bits: not even at that.
template <unsigned bits>
struct OrderedDither {
  static constexpr number::Bound bound{500, number::Unit::palette_level};
  /// Numbers that a walk over rows of this width has to keep.
  static constexpr int memory(int /*width*/) noexcept { return 0; }

  class Walk {
   public:
    /// A walk along rows from column `left` on.
    constexpr Walk(int left, int /*width*/, int levels, std::span<std::int16_t> /*memory*/) noexcept
        : steps_(static_cast<unsigned>(levels - 1)), left_(static_cast<unsigned>(left)) {}
    constexpr bool begin_row(int y) noexcept {
      column_ = left_;
      row_ = &dither_offsets<bits>[static_cast<unsigned>(y) & mask];
      return false;
    }
    [[nodiscard]] constexpr unsigned next(std::uint8_t value) noexcept {
      return over_255(value * steps_ + (*row_)[column_++ & mask]);
    }

   private:
    static constexpr unsigned mask = (1U << bits) - 1U;
    unsigned steps_;
    unsigned left_;
    unsigned column_ = 0;
    const std::array<std::uint8_t, 1U << bits>* row_ = dither_offsets<bits>.data();
  };
};

/// Shares of what a pixel owes, in sixteenths.
struct DitherShares {
  int ahead;
  int below_behind;
  int below;
  int below_ahead;
};

/// Dithering that hands on what is owed.
template <DitherShares shares, bool serpentine>
struct DiffusedDither {
  static_assert(shares.ahead + shares.below_behind + shares.below + shares.below_ahead == 16);
  static constexpr number::Bound bound{157, number::Unit::palette_level};
  static constexpr std::string_view slack =
      "all pixels along the border of 8x8 owe half a level, those inside up and those outside down";
  /// Numbers that a walk over rows of this width has to keep.
  static constexpr int memory(int width) noexcept { return width + 2; }

  class Walk {
   public:
    /// A walk along rows of `width` pixels. Precondition: memory for `memory(width)` numbers, which are
    /// cleared.
    constexpr Walk(int /*left*/, int width, int levels, std::span<std::int16_t> memory) noexcept
        : steps_(levels - 1), width_(width), owed_(memory.data()) {
      std::fill_n(owed_, DiffusedDither::memory(width), std::int16_t{0});
    }
    constexpr bool begin_row(int y) noexcept {
      const bool back = serpentine && (y & 1) != 0;
      step_ = back ? -1 : 1;
      at_ = owed_ + (back ? width_ : 1);
      // What went beside the picture is lost.
      owed_[0] = 0;
      owed_[width_ + 1] = 0;
      ahead_ = 0;
      corner_ = 0;
      below_ = 0;
      rest_ = 0;
      return back;
    }
    [[nodiscard]] constexpr unsigned next(std::uint8_t value) noexcept {
      const int owed = *at_ + ahead_ + rest_;
      rest_ = owed & 15;
      // 127 is half a level, so this rounds to the nearest, and never below 0.
      const int wanted = value * steps_ + (owed >> 4);
      const unsigned level = over_255(static_cast<unsigned>(wanted + 127));
      const int error = wanted - static_cast<int>(level * 255U);
      ahead_ = error * shares.ahead;
      // The place behind now has all shares for the next row; this one's are collected till the next pixel.
      at_[-step_] = static_cast<std::int16_t>(below_ + error * shares.below_behind);
      below_ = corner_ + error * shares.below;
      corner_ = error * shares.below_ahead;
      *at_ = static_cast<std::int16_t>(below_);
      at_ += step_;
      return level;
    }

   private:
    int steps_;
    int width_;
    std::int16_t*
        owed_;  // in sixteenths: of the pixels before in this row for the next, of the others for this
    std::int16_t* at_ = nullptr;
    int step_ = 1;
    int ahead_ = 0;
    int corner_ = 0;
    int below_ = 0;
    int rest_ = 0;
  };
};

}  // namespace detail

/// The nearest level.
struct DitherNone : detail::OrderedDither<0> {};
/// By Bayer's 2x2 matrix.
struct DitherOrdered2 : detail::OrderedDither<1> {};
/// By Bayer's 4x4 matrix.
struct DitherOrdered4 : detail::OrderedDither<2> {};
/// By Bayer's 8x8 matrix; the default.
struct DitherOrdered8 : detail::OrderedDither<3> {};
/// Error diffusion to three neighbours.
struct DitherThreeTap : detail::DiffusedDither<detail::DitherShares{6, 0, 6, 4}, false> {};
/// Floyd and Steinberg's error diffusion, to four neighbours.
struct DitherFourTap : detail::DiffusedDither<detail::DitherShares{7, 3, 5, 1}, false> {};
/// The same, every other row from right to left.
struct DitherSerpentine : detail::DiffusedDither<detail::DitherShares{7, 3, 5, 1}, true> {};

/// The rungs of dithering.
using DitherFamily = number::Family<DitherNone, DitherOrdered2, DitherOrdered4, DitherOrdered8,
                                    DitherThreeTap, DitherFourTap, DitherSerpentine>;

/// Shows `source`, whose indices are values of 0 .. 255, in `levels` levels: indices 0 .. levels-1, the
/// corner of its bounds on `position`; pixels outside the target's bounds or outside `clip` stay as they are.
/// Ordered patterns lie by the target's coordinates; error diffusion needs `Rung::memory(width of the
/// source)` numbers of memory. Errors: position (outside the domain), rectangle (the clip is), steps (fewer
/// than 2 levels, or more than the target has indices), workspace (too small: `needed()`), mismatched source
/// (its memory meets that of the target inside `clip`). Nothing is drawn on error. Cost: without memory each
/// visible pixel, about 20 instructions; else about 35 for each pixel of the source down to its last visible
/// row, for each pixel depends on those before it.
template <DitherRung Rung = DitherOrdered8, PixelFormat F, class Byte>
Status blit_dithered(const Surface<F>& target, linear::Point position,
                     const PixelView<Indexed8, Byte>& source, int levels, std::span<std::int16_t> memory = {},
                     const linear::Rect& clip = everywhere) noexcept {
  if (!linear::in_domain(position)) return {Error::out_of_domain, Argument::position};
  if (!linear::in_domain(clip)) return {Error::out_of_domain, Argument::rectangle};
  if (levels < 2 || levels > static_cast<int>(F::max_index) + 1)
    return {Error::out_of_range, Argument::steps, F::max_index + 1U};
  const linear::Rect placed{position.x, position.y, source.size().width, source.size().height};
  const auto needed = static_cast<std::uint32_t>(Rung::memory(placed.width));
  if (memory.size() < needed) return {Error::too_small, Argument::workspace, needed};
  const linear::Rect part = linear::intersect(linear::intersect(placed, target.bounds()), clip);
  if (part.empty()) return {};
  const Picture<Indexed8> picture = source;
  if (detail::bytes_meet(target, part, picture)) return {Error::mismatched, Argument::source};

  constexpr bool remembers = Rung::memory(1) != 0;
  const linear::Rect walked =
      remembers ? linear::Rect{placed.x, placed.y, placed.width, part.bottom() - placed.y} : part;
  const linear::Point corner{picture.bounds().x - position.x, picture.bounds().y - position.y};
  typename Rung::Walk walk(walked.x, walked.width, levels, memory);
  for (int y = walked.y; y < walked.bottom(); ++y) {
    const bool back = walk.begin_row(remembers ? y - placed.y : y);
    const std::uint8_t* const row = picture.byte_at(corner.x + walked.x, corner.y + y);
    for (int i = 0; i < walked.width; ++i) {
      const int column = back ? walked.width - 1 - i : i;
      const int x = walked.x + column;
      const unsigned level = walk.next(row[column]);
      if (!remembers || (y >= part.y && x >= part.x && x < part.right())) target.set(x, y, level);
    }
  }
  return {};
}

}  // namespace intaglio::image
