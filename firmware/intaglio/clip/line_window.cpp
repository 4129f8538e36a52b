// SPDX-License-Identifier: MIT
//
// Three clippers of line segments: see the header for the rule.
#include <intaglio/clip/line_window.hpp>

namespace intaglio::clip {
namespace {

using linear::SubPoint;
using linear::SubRect;
using number::Fraction;
using number::fraction;

constexpr Fraction start{0, 1};
constexpr Fraction end{1, 1};

/// A segment and the window that cuts it.
struct Cut {
  SubPoint a;
  SubPoint b;
  const SubRect& window;
  int dx = b.x - a.x;
  int dy = b.y - a.y;

  // Where the line meets the line of an edge; it must not be parallel to it.
  [[nodiscard]] Fraction at_left() const noexcept { return fraction(window.x - a.x, dx); }
  [[nodiscard]] Fraction at_right() const noexcept { return fraction(window.right() - a.x, dx); }
  [[nodiscard]] Fraction at_top() const noexcept { return fraction(window.y - a.y, dy); }
  [[nodiscard]] Fraction at_bottom() const noexcept { return fraction(window.bottom() - a.y, dy); }
  [[nodiscard]] Fraction at_edge(unsigned edge) const noexcept {
    return edge == 1 ? at_top() : edge == 2 ? at_right() : edge == 4 ? at_bottom() : at_left();
  }

  [[nodiscard]] ClippedLine between(Fraction enter, Fraction leave) const noexcept {
    if (enter > leave) return {};
    enter = number::reduced(enter);
    leave = number::reduced(leave);
    return {true, enter, leave, place_between(a, b, enter), place_between(a, b, leave)};
  }
};

Status check(SubPoint a, SubPoint b, const SubRect& window) noexcept {
  if (!linear::in_domain(a) || !linear::in_domain(b)) return {Error::out_of_domain, Argument::point};
  if (!linear::in_domain(window)) return {Error::out_of_domain, Argument::rectangle};
  return {};
}

constexpr bool hollow(const SubRect& window) noexcept { return window.width < 0 || window.height < 0; }
constexpr Fraction larger(Fraction s, Fraction t) noexcept { return s < t ? t : s; }
constexpr Fraction smaller(Fraction s, Fraction t) noexcept { return t < s ? t : s; }

/// The region code of the place at t.
unsigned code_at(const Cut& cut, Fraction t) noexcept {
  const FractionPoint p = place_between(cut.a, cut.b, t);
  const auto at = [&p](int edge) { return std::int64_t{edge} * p.denominator; };
  return (p.x < at(cut.window.x) ? left_of : 0U) | (p.x > at(cut.window.right()) ? right_of : 0U) |
         (p.y < at(cut.window.y) ? above : 0U) | (p.y > at(cut.window.bottom()) ? below : 0U);
}

/// Where to cut an end with this code, not 0.
Fraction cut_for(const Cut& cut, unsigned code) noexcept {
  if ((code & left_of) != 0) return cut.at_left();
  if ((code & right_of) != 0) return cut.at_right();
  return (code & above) != 0 ? cut.at_top() : cut.at_bottom();
}

}  // namespace

Result<ClippedLine> cohen_sutherland(SubPoint a, SubPoint b, const SubRect& window) noexcept {
  if (const Status status = check(a, b, window); !status.ok()) return status;
  if (hollow(window)) return ClippedLine{};
  const Cut cut{a, b, window};
  Fraction enter = start;
  Fraction leave = end;
  unsigned enter_code = region_code(a, window);
  unsigned leave_code = region_code(b, window);
  // A cut end stands on the edge exactly, and later cuts move it towards the other end, which isn't beyond
  // that edge: each end is cut once an axis at most.
  while ((enter_code | leave_code) != 0) {
    if ((enter_code & leave_code) != 0) return ClippedLine{};
    if (enter_code != 0) {
      enter = cut_for(cut, enter_code);
      enter_code = code_at(cut, enter);
    } else {
      leave = cut_for(cut, leave_code);
      leave_code = code_at(cut, leave);
    }
  }
  return cut.between(enter, leave);
}

Result<ClippedLine> skala(SubPoint a, SubPoint b, const SubRect& window) noexcept {
  if (const Status status = check(a, b, window); !status.ok()) return status;
  if (hollow(window)) return ClippedLine{};
  const Cut cut{a, b, window};
  if (a == b) return region_code(a, window) == 0 ? cut.between(start, end) : ClippedLine{};
  // Which corners are on the line's right, and which on the line itself.
  const int xs[] = {window.x, window.right(), window.right(), window.x};
  const int ys[] = {window.y, window.y, window.bottom(), window.bottom()};
  unsigned beside = 0;
  unsigned on = 0;
  for (unsigned i = 0; i < 4; ++i) {
    const std::int64_t side = std::int64_t{cut.dx} * (ys[i] - a.y) - std::int64_t{cut.dy} * (xs[i] - a.x);
    beside |= (side > 0 ? 1U : 0U) << i;
    on |= (side == 0 ? 1U : 0U) << i;
  }
  Fraction first;
  Fraction second;
  if (on == 15) {  // a window without area, and the line runs along it
    first = cut.dx != 0 ? cut.at_left() : cut.at_top();
    second = cut.dx != 0 ? cut.at_right() : cut.at_bottom();
  } else {
    // Corners on the line count as left of it. If the others are left of it, too, it only touches the window,
    // and those that it touches stand for the other side.
    const unsigned edges = skala_edges(beside == 0 ? on : beside);
    if (edges == 0) return ClippedLine{};
    const unsigned lower = edges & (~edges + 1U);
    first = cut.at_edge(lower);
    second = cut.at_edge(edges & ~lower);
  }
  return cut.between(larger(start, smaller(first, second)), smaller(end, larger(first, second)));
}

Result<ClippedLine> liang_barsky(SubPoint a, SubPoint b, const SubRect& window) noexcept {
  if (const Status status = check(a, b, window); !status.ok()) return status;
  if (hollow(window)) return ClippedLine{};
  const Cut cut{a, b, window};
  Fraction enter = start;
  Fraction leave = end;
  // Keeps what fulfils t * p <= q; false if nothing does.
  const auto keep = [&enter, &leave](int p, int q) {
    if (p == 0) return q >= 0;
    const Fraction t = fraction(q, p);
    if (p < 0) {
      enter = larger(enter, t);
    } else {
      leave = smaller(leave, t);
    }
    return enter <= leave;
  };
  const bool visible = keep(-cut.dx, a.x - window.x) && keep(cut.dx, window.right() - a.x) &&
                       keep(-cut.dy, a.y - window.y) && keep(cut.dy, window.bottom() - a.y);
  return visible ? cut.between(enter, leave) : ClippedLine{};
}

}  // namespace intaglio::clip
