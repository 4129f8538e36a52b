// SPDX-License-Identifier: MIT
//
// Combining polygons: see the header for the rule.
#include <intaglio/clip/boolean.hpp>
#include <intaglio/clip/boolean_edge.hpp>

#include <algorithm>
#include <utility>

namespace intaglio::clip {
namespace detail {

class BooleanWork {
 public:
  BooleanWork(const BooleanOperand& a, const BooleanOperand& b,
              const std::span<BooleanPiece>& pieces) noexcept
      : a_(a), b_(b), pieces_(pieces) {}

  /// How many pieces there can be at most.
  [[nodiscard]] std::size_t bound() const noexcept {
    std::size_t count = 1;
    for_all_edges([&](const Segment& edge, bool) {
      ++count;
      for_all_edges(
          [&](const Segment& other, bool) { for_each_cut(edge, other, [&](const auto&) { ++count; }); });
    });
    return count;
  }

  /// Cuts all edges; pieces run to the right, or straight down.
  void cut() noexcept {
    for_all_edges([this](Segment edge, bool of_b) {
      if (edge.b.x < edge.a.x || (edge.b.x == edge.a.x && edge.b.y < edge.a.y)) std::swap(edge.a, edge.b);
      BooleanPiece* const first = pieces_.data() + count_;
      BooleanPiece* last = first;  // pieces that begin at the cuts, then the end, unsorted
      const auto add = [&last](const BooleanVertex& place) { (last++)->from_ = place; };
      add(whole(edge.a));
      for_all_edges([&](const Segment& other, bool) { for_each_cut(edge, other, add); });
      add(whole(edge.b));
      std::sort(first, last, [](const auto& p, const auto& q) { return compare(p.from_, q.from_) < 0; });
      last = std::unique(first, last,
                         [](const auto& p, const auto& q) { return compare(p.from_, q.from_) == 0; });
      for (BooleanPiece* piece = first; piece + 1 != last; ++piece) {
        piece->to_ = piece[1].from_;
        piece->way_ = between(edge.a, edge.b);
        piece->of_b_ = of_b;
        ++count_;
      }
    });
  }

  /// Keeps one of the pieces that coincide if it is boundary, turned so that what is taken is on its left.
  void keep_boundary(BooleanRule rule) noexcept {
    BooleanPiece* const end = pieces_.data() + count_;
    std::sort(pieces_.data(), end, [](const auto& p, const auto& q) {
      const int by_from = compare(p.from_, q.from_);
      return by_from != 0 ? by_from < 0 : compare(p.to_, q.to_) < 0;
    });
    BooleanPiece* kept = pieces_.data();
    for (BooleanPiece* piece = pieces_.data(); piece != end;) {
      BooleanPiece one = *piece;
      bool crosses_a = false;
      bool crosses_b = false;
      for (; piece != end && compare(piece->from_, one.from_) == 0 && compare(piece->to_, one.to_) == 0;
           ++piece) {
        crosses_a = crosses_a != !piece->of_b_;
        crosses_b = crosses_b != piece->of_b_;
      }
      if (!crosses_a && !crosses_b) continue;
      bool in_a = false;
      bool in_b = false;
      for_all_edges([&](const Segment& edge, bool of_b) {
        if (is_above(edge, one.from_, one.way_)) (of_b ? in_b : in_a) ^= true;
      });
      const bool left = taken(rule, in_a, in_b);
      if (left == taken(rule, in_a != crosses_a, in_b != crosses_b)) continue;
      if (!left) {
        std::swap(one.from_, one.to_);
        one.way_ = {-one.way_.x, -one.way_.y};
      }
      one.used_ = false;
      *kept++ = one;
    }
    count_ = static_cast<std::size_t>(kept - pieces_.data());
    std::sort(pieces_.data(), kept,
              [](const auto& p, const auto& q) { return compare(p.from_, q.from_) < 0; });
  }

  /// Joins the pieces to contours.
  [[nodiscard]] BooleanResult walk(const std::span<BooleanVertex>& vertices,
                                   const std::span<int>& lengths) noexcept {
    BooleanResult result;
    for (std::size_t i = 0; i < count_; ++i) {
      if (pieces_[i].used_) continue;
      int length = 0;
      const auto add = [&](const BooleanVertex& vertex) {
        if (result.vertices < vertices.size()) vertices[result.vertices] = vertex;
        ++result.vertices;
        ++length;
      };
      BooleanPiece* const first = &pieces_[i];
      BooleanPiece* piece = first;
      do {
        piece->used_ = true;
        BooleanPiece* const next = after(*piece, first);
        if (cross(piece->way_, next->way_) != 0) add(next->from_);
        piece = next;
      } while (piece != first);
      if (result.contours < lengths.size()) lengths[result.contours] = length;
      ++result.contours;
    }
    return result;
  }

 private:
  template <class Visit>
  void for_all_edges(Visit visit) const noexcept {
    for_each_edge(a_, [&](const Segment& edge) { visit(edge, false); });
    for_each_edge(b_, [&](const Segment& edge) { visit(edge, true); });
  }

  /// The piece on which the contour goes on: of those that begin where `piece` ends and are free, or the
  /// first, the one furthest to the left, so that parts that touch at a corner become contours of their own.
  [[nodiscard]] BooleanPiece* after(const BooleanPiece& piece, BooleanPiece* first) noexcept {
    BooleanPiece* const end = pieces_.data() + count_;
    BooleanPiece* candidate =
        std::lower_bound(pieces_.data(), end, piece.to_,
                         [](const auto& p, const auto& place) { return compare(p.from_, place) < 0; });
    BooleanPiece* best = nullptr;
    for (; candidate != end && compare(candidate->from_, piece.to_) == 0; ++candidate) {
      if (candidate->used_ && candidate != first) continue;
      if (best == nullptr || further_left(piece.way_, candidate->way_, best->way_)) best = candidate;
    }
    return best;  // there is one: at each place as many pieces end as begin
  }

  /// True if, coming along `way`, u turns further to the left on the screen than v. None turns back.
  [[nodiscard]] static bool further_left(SubPoint way, SubPoint u, SubPoint v) noexcept {
    const std::int64_t turn_u = -cross(way, u);  // above zero: to the left
    const std::int64_t turn_v = -cross(way, v);
    if (sign(turn_u) != sign(turn_v)) return sign(turn_u) > sign(turn_v);
    return cross(v, u) < 0;
  }

  const BooleanOperand& a_;
  const BooleanOperand& b_;
  std::span<BooleanPiece> pieces_;
  std::size_t count_ = 0;
};

}  // namespace detail

Result<BooleanResult> combine(BooleanRule rule, const BooleanOperand& a, const BooleanOperand& b,
                              const std::span<BooleanVertex>& vertices, const std::span<int>& contour_lengths,
                              const std::span<BooleanPiece>& workspace) noexcept {
  if (rule > BooleanRule::b_minus_a) return Status{Error::out_of_range, Argument::rule};
  if (const Status status = detail::check(a); !status.ok()) return status;
  if (const Status status = detail::check(b); !status.ok()) return status;
  detail::BooleanWork work(a, b, workspace);
  const auto too_small = [](Argument argument, std::size_t needed) {
    return Status{Error::too_small, argument, static_cast<std::uint32_t>(needed)};
  };
  if (const std::size_t bound = work.bound(); workspace.size() < bound)
    return too_small(Argument::workspace, bound);
  work.cut();
  work.keep_boundary(rule);
  const BooleanResult result = work.walk(vertices, contour_lengths);
  if (result.vertices > vertices.size()) return too_small(Argument::vertices, result.vertices);
  if (result.contours > contour_lengths.size()) return too_small(Argument::contours, result.contours);
  return result;
}

}  // namespace intaglio::clip
