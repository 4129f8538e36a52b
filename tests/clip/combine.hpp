// SPDX-License-Identifier: MIT
//
// `combine` and its rung called as a user would, with the result in rational numbers.
#pragma once

#include <intaglio/clip/boolean.hpp>
#include <intaglio/clip/greiner_hormann.hpp>
#include <tests/oracle/boolean.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace tests {

using Shape = std::vector<std::vector<intaglio::linear::SubPoint>>;
using intaglio::clip::BooleanRule;

inline constexpr BooleanRule all_rules[] = {BooleanRule::intersection, BooleanRule::join,
                                            BooleanRule::a_minus_b, BooleanRule::b_minus_a};

inline bool taken(BooleanRule rule, bool in_a, bool in_b) {
  if (rule == BooleanRule::intersection) return in_a && in_b;
  if (rule == BooleanRule::join) return in_a || in_b;
  return rule == BooleanRule::a_minus_b ? in_a && !in_b : in_b && !in_a;
}

struct Flat {
  std::vector<intaglio::linear::SubPoint> vertices;
  std::vector<int> lengths;
  explicit Flat(const Shape& shape) {
    for (const auto& contour : shape) {
      vertices.insert(vertices.end(), contour.begin(), contour.end());
      lengths.push_back(static_cast<int>(contour.size()));
    }
  }
  [[nodiscard]] intaglio::clip::BooleanOperand operand() const { return {vertices, lengths}; }
};

struct Combined {
  intaglio::Status status;
  oracle::RationalContours contours;
  /// Above zero if contours have the set on their left.
  [[nodiscard]] mpq_class area() const { return -oracle::signed_area(contours); }
};

/// Gives `combine` as much memory as it asks for.
template <class Entry, class Combine>
Combined combined_by(Combine combine, BooleanRule rule, const Shape& a, const Shape& b) {
  const Flat first(a);
  const Flat second(b);
  std::vector<Entry> workspace;
  std::vector<intaglio::clip::BooleanVertex> vertices;
  std::vector<int> lengths;
  for (int attempt = 0; attempt < 4; ++attempt) {
    const auto result = combine(rule, first.operand(), second.operand(), vertices, lengths, workspace);
    Combined answer{result.status(), {}};
    if (result.ok()) {
      std::size_t begin = 0;
      for (std::size_t c = 0; c < result.value().contours; ++c) {
        answer.contours.emplace_back();
        for (int i = 0; i < lengths[c]; ++i) {
          const auto& v = vertices[begin++];
          oracle::RationalPoint place{mpq_class(v.x, v.denominator), mpq_class(v.y, v.denominator)};
          place.x.canonicalize();
          place.y.canonicalize();
          answer.contours.back().push_back(place);
        }
      }
      return answer;
    }
    if (answer.status.error() != intaglio::Error::too_small) return answer;
    const std::size_t needed = answer.status.needed();
    if (answer.status.argument() == intaglio::Argument::workspace) workspace.resize(needed);
    if (answer.status.argument() == intaglio::Argument::vertices) vertices.resize(needed);
    if (answer.status.argument() == intaglio::Argument::contours) lengths.resize(needed);
  }
  return {intaglio::Status{intaglio::Error::too_small, intaglio::Argument::none}, {}};
}

inline Combined combined(BooleanRule rule, const Shape& a, const Shape& b) {
  return combined_by<intaglio::clip::BooleanPiece>(intaglio::clip::combine, rule, a, b);
}
/// By the walk of Greiner and Hormann.
inline Combined walked(BooleanRule rule, const Shape& a, const Shape& b) {
  return combined_by<intaglio::clip::RingNode>(intaglio::clip::combine_greiner_hormann, rule, a, b);
}

inline mpq_class exact_area(BooleanRule rule, const Shape& a, const Shape& b) {
  return oracle::combined_area(oracle::rational(a), oracle::rational(b),
                               [rule](bool in_a, bool in_b) { return tests::taken(rule, in_a, in_b); });
}

inline std::string text(const Shape& shape) {
  std::string out;
  for (const auto& contour : shape) {
    out += "/";
    for (const auto p : contour) out += " " + std::to_string(p.x) + "," + std::to_string(p.y);
  }
  return out;
}

}  // namespace tests
