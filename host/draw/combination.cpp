// SPDX-License-Identifier: MIT
#include <host/draw/combination.hpp>

#include <array>
#include <gmpxx.h>
#include <span>

namespace host::draw {
namespace {

using intaglio::Argument;
using intaglio::Status;
using intaglio::clip::BooleanPiece;
using intaglio::clip::BooleanVertex;

struct Result {
  std::vector<BooleanVertex> vertices;
  std::vector<int> lengths;
};

/// Asks with no memory at first, then with what was said to be needed.
Status combine(const Combination& combination, Result& result) {
  const std::array<int, 1> a_length{static_cast<int>(combination.a.size())};
  const std::array<int, 1> b_length{static_cast<int>(combination.b.size())};
  std::vector<BooleanPiece> workspace;
  for (;;) {
    const auto made =
        intaglio::clip::combine(combination.rule, {combination.a, a_length}, {combination.b, b_length},
                                result.vertices, result.lengths, workspace);
    const Status status = made.status();
    if (made.ok()) {
      result.vertices.resize(made.value().vertices);
      result.lengths.resize(made.value().contours);
    }
    if (status.error() != intaglio::Error::too_small) return status;
    const std::size_t needed = status.needed();
    if (status.argument() == Argument::workspace) workspace.resize(needed);
    if (status.argument() == Argument::vertices) result.vertices.resize(needed);
    if (status.argument() == Argument::contours) result.lengths.resize(needed);
  }
}

/// In pixels.
mpq_class coordinate(std::int64_t numerator, std::int64_t denominator) {
  mpq_class value(mpz_class(numerator), mpz_class(denominator) * linear::subpixel_one);
  value.canonicalize();
  return value;
}

}  // namespace

std::string describe(const Combination& combination, Status& status) {
  Result result;
  status = combine(combination, result);
  if (!status.ok()) return {};
  std::string text;
  mpq_class twice_area = 0;
  std::span<const BooleanVertex> rest(result.vertices);
  for (const int length : result.lengths) {
    const auto contour = rest.first(static_cast<std::size_t>(length));
    rest = rest.subspan(contour.size());
    text += "contour";
    const BooleanVertex& last = contour.back();
    mpq_class before_x = coordinate(last.x, last.denominator);
    mpq_class before_y = coordinate(last.y, last.denominator);
    for (const BooleanVertex& vertex : contour) {
      const mpq_class x = coordinate(vertex.x, vertex.denominator);
      const mpq_class y = coordinate(vertex.y, vertex.denominator);
      text += " " + x.get_str() + " " + y.get_str();
      twice_area += x * before_y - before_x * y;  // the set is on the left, y goes down
      before_x = x;
      before_y = y;
    }
    text += "\n";
  }
  const mpq_class area = twice_area / 2;
  text += "area " + area.get_num().get_str() + "/" + area.get_den().get_str() + "\n";
  return text;
}

}  // namespace host::draw
