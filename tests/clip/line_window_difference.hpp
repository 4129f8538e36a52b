// SPDX-License-Identifier: MIT
//
// The three line clippers against each other and against the definition.
#pragma once

#include <intaglio/clip/line_window.hpp>
#include <tests/oracle/integer.hpp>
#include <tests/oracle/line_window.hpp>

#include <cstdint>
#include <numeric>
#include <string>

namespace tests {

using intaglio::clip::ClippedLine;
using intaglio::clip::cohen_sutherland;
using intaglio::clip::FractionPoint;
using intaglio::clip::liang_barsky;
using intaglio::clip::skala;
using intaglio::linear::SubPoint;
using intaglio::linear::SubRect;
using intaglio::number::Fraction;

inline bool same_bits(const ClippedLine& a, const ClippedLine& b) {
  return a.visible == b.visible && a.enter.numerator == b.enter.numerator &&
         a.enter.denominator == b.enter.denominator && a.leave.numerator == b.leave.numerator &&
         a.leave.denominator == b.leave.denominator && a.from == b.from && a.to == b.to;
}

inline bool is_place(const FractionPoint& p, SubPoint a, SubPoint b, Fraction t) {
  const oracle::Wide d = t.denominator;
  return p.denominator == t.denominator && p.x == a.x * d + (oracle::Wide{b.x} - a.x) * t.numerator &&
         p.y == a.y * d + (oracle::Wide{b.y} - a.y) * t.numerator;
}

// "" if all three clippers answer as the oracle does, both ways round.
inline std::string difference(SubPoint a, SubPoint b, const SubRect& w) {
  const auto found = liang_barsky(a, b, w);
  if (!found.ok()) return "refused";
  const ClippedLine& line = found.value();
  if (!same_bits(line, cohen_sutherland(a, b, w).value()))
    return "Cohen-Sutherland differs from Liang-Barsky";
  if (!same_bits(line, skala(a, b, w).value())) return "Skala differs from Liang-Barsky";
  const auto expected =
      oracle::inside_part(a, b, w.x, w.y, std::int64_t{w.x} + w.width, std::int64_t{w.y} + w.height);
  const bool hollow = w.width < 0 || w.height < 0;
  if (line.visible != (expected.visible && !hollow)) return "visibility";
  if (!line.visible) return "";
  const auto is = [](Fraction t, std::int64_t n, std::int64_t d) {
    const std::int64_t g = std::gcd(n, d);
    return t.numerator == n / g && t.denominator == d / g;
  };
  if (!is(line.enter, expected.enter_n, expected.enter_d)) return "enter";
  if (!is(line.leave, expected.leave_n, expected.leave_d)) return "leave";
  if (!is_place(line.from, a, b, line.enter) || !is_place(line.to, a, b, line.leave)) return "places";
  const ClippedLine back = liang_barsky(b, a, w).value();
  if (a != b && (!(back.from == line.to) || !(back.to == line.from))) return "BA isn't AB turned round";
  return "";
}

}  // namespace tests
