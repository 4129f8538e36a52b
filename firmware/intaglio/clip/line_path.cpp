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

constexpr int magnitude(int a) noexcept { return a < 0 ? -a : a; }
constexpr int larger(int a, int b) noexcept { return a > b ? a : b; }
constexpr int smaller(int a, int b) noexcept { return a < b ? a : b; }
constexpr void transpose(linear::Point& p) noexcept { p = {p.y, p.x}; }

}  // namespace

Status line_path(linear::Point a, linear::Point b, const linear::Rect& window, LinePath& path) noexcept {
  path.count = 0;
  if (!linear::in_domain(a) || !linear::in_domain(b)) return {Error::out_of_domain, Argument::point};
  // x and y change places in a steep line, and only there: from here on x is the major axis.
  linear::Point delta{b.x - a.x, b.y - a.y};
  linear::Point low{window.x, window.y};
  linear::Point high{window.right(), window.bottom()};
  const bool steep = magnitude(delta.y) > magnitude(delta.x);
  if (steep) {
    transpose(a);
    transpose(b);
    transpose(delta);
    transpose(low);
    transpose(high);
  }
  if (delta.x < 0) {
    a = b;
    delta = {-delta.x, -delta.y};
  }
  const bool backward = delta.y < 0;
  const Staircase stairs{static_cast<unsigned>(delta.x), static_cast<unsigned>(magnitude(delta.y)),
                         backward ? 1U : 0U};
  // The steps aside at which the line enters the window and has left it, in its own direction.
  const int enter = backward ? a.y - high.y + 1 : low.y - a.y;
  const int leave = backward ? a.y - low.y + 1 : high.y - a.y;
  const int begin = larger(stairs.first_at(enter), low.x - a.x);
  const int end = smaller(stairs.first_at(leave), high.x - a.x);
  if (begin >= end) return {};
  const Staircase::Step step = stairs.at(begin);
  linear::Point start{a.x + begin, a.y + (backward ? -step.minor : step.minor)};
  if (steep) transpose(start);
  path.start = start;
  path.count = end - begin;
  path.error = step.error;
  path.minor_step = static_cast<int>(2 * stairs.minor);
  path.major_step = 2 * delta.x;
  path.course = static_cast<Course>((steep ? 2U : 0U) + stairs.tie);
  return {};
}

}  // namespace intaglio::clip
