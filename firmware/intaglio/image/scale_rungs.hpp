// SPDX-License-Identifier: MIT
//
// Ways to stretch and shrink a picture of values: rungs from the nearest pixel to exact means.
//
// Rule: the source's indices are values, 0 .. 255 (a palette's ramp of greys, say). For a source of w columns
// and a destination of W from x0 on:
// - of pictures that grow, true is the bilinear interpolation: the centre of destination pixel x lies
//   (2 (x - x0) + 1) w / 2W - 1/2 source pixels from the centre of the source's first column, rows alike;
//   beyond the outermost centres the picture goes on evenly. The value is that of the four pixels around,
//   weighted by nearness;
// - of pictures that shrink, true is the mean over the pixel's box, which goes from (x - x0) w / W to
//   (x - x0 + 1) w / W source pixels, each of them weighted by how much of it lies there.
// The rungs:
// - `ScaleNearest` shows the nearest pixel, which is `blit_scaled`;
// - `ScaleBilinear4` and `ScaleBilinear8` interpolate with the two weights rounded to 1/16 and 1/256, and the
//   value once;
// - `ScaleBox` takes the mean with exact weights, rounded once, halves up. It doesn't skip a pixel when it
//   shrinks; when it enlarges, borders between pixels are sharp and in their right place.
//
// Error, in values, of growing pictures (`bound`): of the nearest pixel 3/4 * 255, as its weight is at least
// a quarter; of the bilinear ones 255 for each weight's 2^-5 or 2^-9, another 2^-15 for the reciprocal that
// it is taken with, and 1/2 for the rounding, whatever the scale; of the box 3/4 * 255, as along an axis its
// weights differ from the true ones by less than a half, and 1/2. Of pictures that shrink in both directions
// (`shrinking_bound`): of the box 1/2; of the others all of 255, for what they skip may be different from
// what they show. Bit budget: sides up to 2^15, so parts have 16 bits, reciprocals 30 at most, and their
// product 31; values with two weights 24. A box's weights, in 1/W and 1/H source pixel, add up to w h <=
// 2^24, so sums have 32. Textbook: none. Worst known inputs: checkerboards; for shrinking, black where the
// nearest pixel is, white around.
#pragma once

#include <intaglio/image/blit.hpp>
#include <intaglio/image/overlap.hpp>
#include <intaglio/image/scale.hpp>
#include <intaglio/image/surface.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/number/bound.hpp>
#include <intaglio/number/long_division.hpp>
#include <intaglio/status.hpp>

#include <bit>
#include <cstdint>

namespace intaglio::image {

/// The longest side of pictures that are interpolated, and of where they are shown.
inline constexpr int bilinear_side_limit = 1 << 15;
/// The most pixels of a picture whose boxes are averaged.
inline constexpr std::uint32_t box_pixels_limit = 1U << 24U;

namespace detail {

/// What `blit_scaled` refuses, and sides above 2^15; else sets `part` to what is visible, if anything is.
template <class Byte>
Status visible_stretch(const Surface<Indexed8>& target, const linear::Rect& destination,
                       const PixelView<Indexed8, Byte>& source, const linear::Rect& clip,
                       linear::Rect& part) noexcept {
  if (!linear::in_domain(linear::Point{destination.x, destination.y}))
    return {Error::out_of_domain, Argument::position};
  if (!linear::in_domain(destination)) return {Error::out_of_domain, Argument::size};
  if (!linear::in_domain(clip)) return {Error::out_of_domain, Argument::rectangle};
  if (destination.width > bilinear_side_limit || destination.height > bilinear_side_limit)
    return {Error::too_large, Argument::size, bilinear_side_limit};
  const linear::Size size = source.size();
  if (size.width > bilinear_side_limit || size.height > bilinear_side_limit)
    return {Error::too_large, Argument::source, bilinear_side_limit};
  part = source.empty() ? linear::Rect{}
                        : linear::intersect(linear::intersect(destination, target.bounds()), clip);
  if (!part.empty() && bytes_meet(target, part, Picture<Indexed8>(source)))
    return {Error::mismatched, Argument::source};
  return {};
}

/// A weight of so many bits, 0 .. 2^bits, and the two pixels that it is for.
template <unsigned bits>
struct BilinearPair {
  int low;
  int high;
  unsigned weight;  ///< Of the high one.

  BilinearPair(const ScaleStep& step, int size, std::uint32_t reciprocal) noexcept
      : low(step.index() > 0 ? step.index() - 1 : 0),
        high(step.index() < size ? step.index() : size - 1),
        weight((step.part() * reciprocal + (1U << (30U - bits))) >> (31U - bits)) {}
};

/// Bilinear interpolation with weights of so many bits.
template <unsigned bits>
struct BilinearScale {
  static constexpr number::Bound shrinking_bound{255'000, number::Unit::palette_level};
  /// Shows `source` in `destination`, where that is in the target's bounds and in `clip`.
  /// Errors: position, size, rectangle, source as `blit_scaled`; too_large size or source: a side above 2^15.
  /// Cost: a division for columns and for rows, then about 50 instructions a visible pixel.
  template <class Byte>
  Status operator()(const Surface<Indexed8>& target, const linear::Rect& destination,
                    const PixelView<Indexed8, Byte>& source,
                    const linear::Rect& clip = everywhere) const noexcept {
    linear::Rect part;
    const Status status = visible_stretch(target, destination, source, clip, part);
    if (!status.ok() || part.empty()) return status;
    const Picture<Indexed8> picture = source;
    const linear::Size size = source.size();

    const auto first = ScaleStep::between(part.x - destination.x, size.width, destination.width);
    auto row = ScaleStep::between(part.y - destination.y, size.height, destination.height);
    const std::uint32_t across = (1U << 31U) / first.whole();
    const std::uint32_t down = (1U << 31U) / row.whole();
    const linear::Rect& from = picture.bounds();
    for (int y = part.y; y < part.bottom(); ++y, row.advance()) {
      const BilinearPair<bits> rows(row, size.height, down);
      const std::uint8_t* const above = picture.byte_at(from.x, from.y + rows.low);
      const std::uint8_t* const below = picture.byte_at(from.x, from.y + rows.high);
      std::uint8_t* to = target.byte_at(part.x, y);
      auto column = first;
      for (int left = part.width; left > 0; --left, column.advance()) {
        const BilinearPair<bits> columns(column, size.width, across);
        const auto mixed = [&columns](const std::uint8_t* values) {
          return values[columns.low] * (one - columns.weight) + values[columns.high] * columns.weight;
        };
        const unsigned value = mixed(above) * (one - rows.weight) + mixed(below) * rows.weight;
        *to++ = static_cast<std::uint8_t>((value + one * one / 2U) >> (2U * bits));
      }
    }
    return {};
  }

 private:
  static constexpr unsigned one = 1U << bits;
};

/// Some pixels side by side, in part those at the ends, and how much of them counts.
struct BoxSide {
  int first;
  int last;
  std::uint32_t first_weight;
  std::uint32_t whole;        ///< The weight of those between the first and the last.
  std::uint32_t last_weight;  ///< If 0, the last may not exist.

  /// The sum of at(i) over the pixels i, weighted.
  template <class At>
  [[nodiscard]] std::uint32_t sum(At at) const noexcept {
    std::uint32_t inside = 0;
    for (int i = first + 1; i < last; ++i) inside += at(i);
    std::uint32_t all = inside * whole + first_weight * at(first);
    if (last_weight != 0) all += last_weight * at(last);
    return all;
  }
};

/// The boxes of destination pixels along one axis, weights in 1/to of a source pixel. Copied to begin a row
/// anew.
class BoxStep {
 public:
  /// Stands on destination pixel `first`. Precondition: 0 <= first < to <= 2^15, 1 <= from <= 2^15.
  BoxStep(int first, int from, int to) noexcept
      : from_(static_cast<std::uint32_t>(from)),
        to_(static_cast<std::uint32_t>(to)),
        begin_(number::long_divide(static_cast<std::uint32_t>(first) * from_, to_)),
        step_(number::long_divide(from_, to_)),
        end_(after(begin_)) {}
  [[nodiscard]] BoxSide box() const noexcept {
    const auto first = static_cast<int>(begin_.quotient);
    if (begin_.quotient == end_.quotient) return {first, first, from_, to_, 0};
    return {first, static_cast<int>(end_.quotient), to_ - begin_.remainder, to_, end_.remainder};
  }
  /// On to the next destination pixel.
  void advance() noexcept {
    begin_ = end_;
    end_ = after(begin_);
  }

 private:
  [[nodiscard]] number::LongDivision after(number::LongDivision place) const noexcept {
    place.quotient += step_.quotient;
    place.remainder += step_.remainder;
    if (place.remainder >= to_) {
      place.remainder -= to_;
      ++place.quotient;
    }
    return place;
  }

  std::uint32_t from_;
  std::uint32_t to_;
  number::LongDivision begin_;  // in whole source pixels, and in 1/to of one
  number::LongDivision step_;
  number::LongDivision end_;
};

/// Means of values: sums divided by the same number again and again, rounded to the nearest, halves up.
///
/// The upper 12 bits of the divisor find the quotient or one less: the sum's lowest `shift_` bits, which are
/// left out, are less than 2^-11 of the divisor, and what the reciprocal lacks is less than 1 of 2^23, times
/// less than 2^8 2^12. That product stays below 2^23 times the quotient, so below 2^31.
class MeanOf {
 public:
  /// Precondition: 1 <= count <= 2^24.
  explicit MeanOf(std::uint32_t count) noexcept
      : count_(count),
        shift_(std::bit_width(count) > 12U ? static_cast<unsigned>(std::bit_width(count)) - 12U : 0U),
        reciprocal_(number::long_divide(std::uint64_t{1} << (shift_ + 23U), count).quotient) {}
  /// Precondition: sum <= 255 * count.
  [[nodiscard]] std::uint8_t operator()(std::uint32_t sum) const noexcept {
    sum += count_ / 2U;
    const std::uint32_t quotient = (sum >> shift_) * reciprocal_ >> 23U;
    return static_cast<std::uint8_t>(sum - quotient * count_ < count_ ? quotient : quotient + 1U);
  }

 private:
  std::uint32_t count_;
  unsigned shift_;
  std::uint32_t reciprocal_;
};

}  // namespace detail

/// The nearest pixel; the default, for it needs no ramp.
struct ScaleNearest {
  static constexpr number::Bound bound{191'250, number::Unit::palette_level};
  static constexpr number::Bound shrinking_bound{255'000, number::Unit::palette_level};
  /// As `blit_scaled`.
  template <class Byte>
  Status operator()(const Surface<Indexed8>& target, const linear::Rect& destination,
                    const PixelView<Indexed8, Byte>& source,
                    const linear::Rect& clip = everywhere) const noexcept {
    return blit_scaled(target, destination, source, Everything{}, clip);
  }
};
/// Bilinear, weights in 1/16.
struct ScaleBilinear4 : detail::BilinearScale<4> {
  static constexpr number::Bound bound{16'460, number::Unit::palette_level};
};
/// Bilinear, weights in 1/256.
struct ScaleBilinear8 : detail::BilinearScale<8> {
  static constexpr number::Bound bound{1'512, number::Unit::palette_level};
};
/// The mean over each pixel's box.
struct ScaleBox {
  static constexpr number::Bound bound{191'750, number::Unit::palette_level};
  static constexpr number::Bound shrinking_bound{500, number::Unit::palette_level};
  /// Errors: as the bilinear ones; too_large source: more than 2^24 pixels.
  /// Cost: two divisions for columns and for rows and one for the means, then about 50 instructions a visible
  /// pixel, 20 for each of the source's rows in its box, and 4 for each of the source's pixels there.
  template <class Byte>
  Status operator()(const Surface<Indexed8>& target, const linear::Rect& destination,
                    const PixelView<Indexed8, Byte>& source,
                    const linear::Rect& clip = everywhere) const noexcept {
    linear::Rect part;
    const Status status = detail::visible_stretch(target, destination, source, clip, part);
    if (!status.ok() || source.empty()) return status;
    const linear::Size size = source.size();
    const auto count = static_cast<std::uint32_t>(size.width) * static_cast<std::uint32_t>(size.height);
    if (count > box_pixels_limit) return {Error::too_large, Argument::source, box_pixels_limit};
    if (part.empty()) return {};

    const Picture<Indexed8> picture = source;
    const linear::Rect& from = picture.bounds();
    const detail::MeanOf mean(count);
    const detail::BoxStep first_column(part.x - destination.x, size.width, destination.width);
    detail::BoxStep row(part.y - destination.y, size.height, destination.height);
    for (int y = part.y; y < part.bottom(); ++y, row.advance()) {
      const detail::BoxSide rows = row.box();
      std::uint8_t* to = target.byte_at(part.x, y);
      detail::BoxStep column = first_column;
      for (int left = part.width; left > 0; --left, column.advance()) {
        const detail::BoxSide columns = column.box();
        *to++ = mean(rows.sum([&](int source_row) {
          const std::uint8_t* const values = picture.byte_at(from.x, from.y + source_row);
          return columns.sum([values](int source_column) { return std::uint32_t{values[source_column]}; });
        }));
      }
    }
    return {};
  }
};

/// The rungs of stretching, cheapest first; for shrinking `ScaleBox` is the only one that is near the truth.
using ScaleFamily = number::Family<ScaleNearest, ScaleBilinear4, ScaleBilinear8, ScaleBox>;

}  // namespace intaglio::image
