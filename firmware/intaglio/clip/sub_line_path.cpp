// SPDX-License-Identifier: MIT
//
// The visible part of a line with sub-pixel ends.
//
// Rule: as in the header, with the line in 1/256 pixel. With M and m the magnitudes of the differences, the
// first end at X0 = 256*c0 - e along the major axis (c0 its nearest column, -128 <= e <= 128) and at
// 256*Y0 + f along the minor axis, column c0 + k lies on row
//     Y0 + floor(N(k) / (256*M)),  N(k) = (f + 128)*M - s + m*(256*k + e)
//        = Y0 + floor(V(k) / M),   V(k) = floor(N(k)/256) = V(0) + m*k:
// as on polygon edges the fraction bits leave the problem at set-up, and the walk is that of any line. s, 1
// where the minor coordinate was mirrored, keeps ties going to the larger coordinate.
//
// Bit budget: M <= 2^29, so |N(0)| <= 512*2^29 and V(0) < 2^30. N(0) >= 0: m*e >= -128*M, and where s is 1
// the major axis isn't mirrored, so e >= -127. Rows are within 2^22 of Y0, so M*J < 2^52.
#include <intaglio/clip/line_path.hpp>
#include <intaglio/number/long_division.hpp>

namespace intaglio::clip {
namespace {

/// Rows of columns: floor((start + minor*k) / major), k = 0..last.
struct SubStaircase {
  unsigned major;  ///< M >= 1
  unsigned minor;  ///< m <= M
  unsigned start;  ///< V(0)
  unsigned last;

  /// The first k on row `j` or a later one; last+1 if there is none.
  [[nodiscard]] int first_at(int j) const noexcept {
    if (j <= 0) return 0;
    const std::uint64_t target = std::uint64_t{major} * static_cast<unsigned>(j);
    if (target <= start) return 0;
    const std::uint64_t way = target - start;
    if (way > std::uint64_t{minor} * last) return static_cast<int>(last) + 1;
    return static_cast<int>(number::long_divide(way + minor - 1, minor).quotient);
  }
};

constexpr int fraction_mask = linear::subpixel_one - 1;

/// The nearest pixel, ties to the larger.
constexpr int nearest(int c) noexcept { return (c + linear::subpixel_one / 2) >> linear::subpixel_bits; }

/// A line's ends and the window along one axis.
struct Axis {
  int from, to;     ///< in 1/256 pixel
  int first, last;  ///< in whole pixels
  int low, high;    ///< of the window, half-open

  constexpr Axis(int a, int b, int window, int size) noexcept
      : from(a), to(b), first(nearest(a)), last(nearest(b)), low(window), high(window + size) {}
  constexpr void mirror() noexcept {
    from = -from;
    to = -to;
    first = -first;
    last = -last;
    const int top = low;
    low = 1 - high;
    high = 1 - top;
  }
};

}  // namespace

Status line_path(linear::SubPoint a, linear::SubPoint b, const linear::Rect& window,
                 LinePath& path) noexcept {
  path.count = 0;
  if (!linear::in_domain(a) || !linear::in_domain(b)) return {Error::out_of_domain, Argument::point};
  if (b.x < a.x) {
    const linear::SubPoint left = b;
    b = a;
    a = left;
  }
  Axis x(a.x, b.x, window.x, window.width);
  Axis y(a.y, b.y, window.y, window.height);
  path.up = b.y < a.y;
  if (path.up) y.mirror();
  path.steep = y.to - y.from > x.to - x.from;
  const Axis& major = path.steep ? y : x;
  const Axis& minor = path.steep ? x : y;

  const int length = major.to - major.from;
  const int rise = minor.to - minor.from;
  SubStaircase stairs{};
  stairs.major = length == 0 ? 1U : static_cast<unsigned>(length);
  stairs.minor = static_cast<unsigned>(rise);
  stairs.last = static_cast<unsigned>(major.last - major.first);
  const int tie = path.up && !path.steep ? 1 : 0;
  const int above = (minor.from & fraction_mask) + linear::subpixel_one / 2;
  const int ahead = major.first * linear::subpixel_one - major.from;
  const std::int64_t start = std::int64_t{above} * stairs.major - tie + std::int64_t{ahead} * rise;
  stairs.start = static_cast<unsigned>(start >> linear::subpixel_bits);

  const int row = minor.from >> linear::subpixel_bits;
  const int low = stairs.first_at(minor.low - row);
  const int high = stairs.first_at(minor.high - row);
  const int begin = low > major.low - major.first ? low : major.low - major.first;
  const int end = high < major.high - major.first ? high : major.high - major.first;
  if (begin >= end) return {};
  const auto [quotient, remainder] = number::long_divide(
      std::uint64_t{stairs.minor} * static_cast<unsigned>(begin) + stairs.start, stairs.major);
  path.count = end - begin;
  path.error = static_cast<int>(remainder) - static_cast<int>(stairs.major);
  path.minor_step = rise;
  path.major_step = static_cast<int>(stairs.major);
  const int column = major.first + begin;
  const int level = row + static_cast<int>(quotient);
  const int at_y = path.steep ? column : level;
  path.start = {path.steep ? level : column, path.up ? -at_y : at_y};
  return {};
}

}  // namespace intaglio::clip
