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
    // ceil(n / 2m) with n = 2*M*j - M + s, which is positive here.
    const unsigned divisor = 2 * minor;
    const std::uint64_t n = std::uint64_t{2 * major} * target - major + tie;
    return static_cast<int>(number::long_divide(n + (divisor - 1), divisor).quotient);
  }

  struct Step {
    int minor;
    int error;
  };
  /// j(k), and the remainder of its division less 2*M.
  [[nodiscard]] Step at(int k) const noexcept {
    if (k == 0) return {0, -static_cast<int>(major + tie)};
    const unsigned divisor = 2 * major;
    const std::uint64_t n = std::uint64_t{2 * minor} * static_cast<unsigned>(k) + major - tie;
    const auto [quotient, remainder] = number::long_divide(n, divisor);
    return {static_cast<int>(quotient), static_cast<int>(remainder) - static_cast<int>(divisor)};
  }
};

constexpr int larger(int a, int b) noexcept { return a > b ? a : b; }
constexpr int smaller(int a, int b) noexcept { return a < b ? a : b; }

}  // namespace

LinePath line_path(linear::Point a, linear::Point b, const linear::Rect& window) noexcept {
  int dx = b.x - a.x;
  int dy = b.y - a.y;
  const bool steep = (dy < 0 ? -dy : dy) > (dx < 0 ? -dx : dx);
  if ((steep ? dy : dx) < 0) {
    a = b;
    dx = -dx;
    dy = -dy;
  }
  // From here on in steps from the start along each axis, the minor one in the direction of the line.
  const int major = steep ? dy : dx;
  const int signed_minor = steep ? dx : dy;
  const bool backward = signed_minor < 0;
  const Staircase stairs{static_cast<unsigned>(major),
                         static_cast<unsigned>(backward ? -signed_minor : signed_minor), backward ? 1U : 0U};
  const int left = window.x - a.x;
  const int top = window.y - a.y;
  const int right = left + window.width;
  const int bottom = top + window.height;
  const int minor_begin = steep ? left : top;
  const int minor_end = steep ? right : bottom;
  const int begin =
      larger(larger(0, steep ? top : left), stairs.first_at(backward ? 1 - minor_end : minor_begin));
  const int end = smaller(smaller(major + 1, steep ? bottom : right),
                          stairs.first_at(backward ? 1 - minor_begin : minor_end));
  LinePath path;
  path.count = end - begin;
  if (path.count <= 0) return path;
  const Staircase::Step step = stairs.at(begin);
  const int aside = backward ? -step.minor : step.minor;
  path.start = {a.x + (steep ? aside : begin), a.y + (steep ? begin : aside)};
  path.error = step.error;
  path.minor_step = static_cast<int>(2 * stairs.minor);
  path.major_step = 2 * major;
  path.course = steep ? (backward ? Course::down_left : Course::down_right)
                      : (backward ? Course::right_up : Course::right_down);
  return path;
}

}  // namespace intaglio::clip
