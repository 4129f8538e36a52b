// SPDX-License-Identifier: MIT
//
// The visible part of a line: see the header for the rule.
#include <intaglio/clip/line_path.hpp>
#include <intaglio/number/long_division.hpp>

namespace intaglio::clip {
namespace {

/// The staircase j(k), k in 0..major, j in 0..minor.
struct Staircase {
  unsigned major;  ///< M
  unsigned minor;  ///< m <= M
  unsigned tie;    ///< s

  /// The first k with j(k) >= j; M+1 if there is none.
  [[nodiscard]] int first_at(int j) const noexcept {
    if (j <= 0) return 0;
    const auto target = static_cast<unsigned>(j);
    if (target > minor) return static_cast<int>(major) + 1;
    // ceil(n / 2m) with n = 2*M*j - M + s.
    const unsigned divisor = 2 * minor;
    const std::uint64_t n = std::uint64_t{major} * (2 * target - 1) + (divisor - 1 + tie);
    return static_cast<int>(number::long_divide(n, divisor).quotient);
  }

  struct Step {
    int minor;
    int error;
  };
  /// j(k), and the remainder of its division less 2*M.
  [[nodiscard]] Step at(int k) const noexcept {
    if (k == 0) return {0, -static_cast<int>(major + tie)};
    const unsigned divisor = 2 * major;
    const std::uint64_t n = std::uint64_t{2 * minor} * static_cast<unsigned>(k) + (major - tie);
    const auto [quotient, remainder] = number::long_divide(n, divisor);
    return {static_cast<int>(quotient), static_cast<int>(remainder) - static_cast<int>(divisor)};
  }
};

constexpr int larger(int a, int b) noexcept { return a > b ? a : b; }
constexpr int smaller(int a, int b) noexcept { return a < b ? a : b; }
constexpr void transpose(linear::Point& p) noexcept { p = {p.y, p.x}; }

}  // namespace

Status line_path(linear::Point a, linear::Point b, const linear::Rect& window, LinePath& path) noexcept {
  path.count = 0;
  if (!linear::in_domain(a) || !linear::in_domain(b)) return {Error::out_of_domain, Argument::point};
  if (b.x < a.x) {
    const linear::Point left = b;
    b = a;
    a = left;
  }
  path.up = b.y < a.y;
  // From here on in steps from `a` in the line's own direction: the length, and the window as `low` up to
  // `high`, half-open.
  linear::Point length{b.x - a.x, b.y - a.y};
  linear::Point low{window.x - a.x, window.y - a.y};
  linear::Point high{low.x + window.width, low.y + window.height};
  if (path.up) {
    const int top = low.y;
    length.y = -length.y;
    low.y = 1 - high.y;
    high.y = 1 - top;
  }
  path.steep = length.y > length.x;
  if (path.steep) {  // x, here and below, is the major axis
    transpose(length);
    transpose(low);
    transpose(high);
  }
  const Staircase stairs{static_cast<unsigned>(length.x), static_cast<unsigned>(length.y),
                         path.up && !path.steep ? 1U : 0U};
  const int begin = larger(stairs.first_at(low.y), low.x);
  const int end = smaller(stairs.first_at(high.y), high.x);
  if (begin >= end) return {};
  const Staircase::Step step = stairs.at(begin);
  path.count = end - begin;
  path.error = step.error;
  path.minor_step = 2 * length.y;
  path.major_step = 2 * length.x;
  linear::Point way{begin, step.minor};
  if (path.steep) transpose(way);
  path.start = {a.x + way.x, a.y + (path.up ? -way.y : way.y)};
  return {};
}

}  // namespace intaglio::clip
