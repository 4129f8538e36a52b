// SPDX-License-Identifier: MIT
//
// The walk of Greiner and Hormann: see the header for the rule.
#include <intaglio/clip/boolean_edge.hpp>
#include <intaglio/clip/greiner_hormann.hpp>

#include <algorithm>

namespace intaglio::clip {
namespace detail {

namespace {

/// On which side of the edge's line the place lies.
int side_of(const Segment& edge, SubPoint p) noexcept {
  return sign(cross(between(edge.a, edge.b), between(edge.a, p)));
}

bool is_on(const Segment& edge, SubPoint p) noexcept {
  return side_of(edge, p) == 0 && (p == edge.a || p == edge.b || inside(p, edge));
}

/// True if an end of one edge lies on the other.
bool touch(const Segment& e, const Segment& f) noexcept {
  return is_on(e, f.a) || is_on(e, f.b) || is_on(f, e.a) || is_on(f, e.b);
}

/// True if each edge has its ends on both sides of the other.
bool cross_inside(const Segment& e, const Segment& f) noexcept {
  return side_of(e, f.a) * side_of(e, f.b) < 0 && side_of(f, e.a) * side_of(f, e.b) < 0;
}

}  // namespace

class GreinerHormannWork {
 public:
  GreinerHormannWork(const BooleanOperand& a, const BooleanOperand& b,
                     const std::span<RingNode>& nodes) noexcept
      : a_(a), b_(b), nodes_(nodes) {}

  /// How many nodes there will be; false in `apart` if the operands touch.
  [[nodiscard]] std::size_t bound(bool& apart) const noexcept {
    std::size_t count = a_.vertices.size() + b_.vertices.size();
    apart = true;
    for_each_ring_edge(a_, [&](const Segment& e, int) {
      for_each_ring_edge(b_, [&](const Segment& f, int) {
        apart = apart && !touch(e, f);
        if (cross_inside(e, f)) count += 2;
      });
    });
    return count;
  }

  /// Makes the rings; false if an edge meets two others in one place.
  [[nodiscard]] bool link() noexcept {
    link_vertices(a_);
    link_vertices(b_);
    const int first_of_b = static_cast<int>(a_.vertices.size());
    bool apart = true;
    for_each_ring_edge(a_, [&](const Segment& e, int from_a) {
      for_each_ring_edge(b_, [&](const Segment& f, int from_b) {
        if (!apart || !cross_inside(e, f)) return;
        for_each_cut(e, f, [&](const BooleanVertex& place) {
          const int in_a = static_cast<int>(count_++);
          const int in_b = static_cast<int>(count_++);
          at(in_a) = at(in_b) = RingNode();
          at(in_a).place_ = at(in_b).place_ = place;
          at(in_a).neighbour_ = in_b;
          at(in_b).neighbour_ = in_a;
          apart = insert(in_a, from_a, e) && insert(in_b, first_of_b + from_b, f);
        });
      });
    });
    return apart;
  }

  /// Says of each part between crossings whether it belongs to the result, and walks them.
  [[nodiscard]] BooleanResult walk(BooleanRule rule, const std::span<BooleanVertex>& vertices,
                                   const std::span<int>& lengths) noexcept {
    vertices_ = vertices;
    lengths_ = lengths;
    // Of a set that is taken away, or joined to, what lies outside the other one is kept.
    mark(a_, 0, b_, rule == BooleanRule::join || rule == BooleanRule::a_minus_b);
    mark(b_, static_cast<int>(a_.vertices.size()), a_,
         rule == BooleanRule::join || rule == BooleanRule::b_minus_a);
    for (std::size_t i = a_.vertices.size() + b_.vertices.size(); i < count_; ++i)
      if (!nodes_[i].used_) walk_from(static_cast<int>(i));
    return result_;
  }

 private:
  /// Calls `visit(edge, index of its first vertex)` for the edges that have a length, of contours that have
  /// an area.
  template <class Visit>
  static void for_each_ring_edge(const BooleanOperand& operand, Visit visit) noexcept {
    int first = 0;
    for (const int length : operand.contour_lengths) {
      for (int i = 0; length >= 3 && i < length; ++i) {
        const SubPoint* const contour = operand.vertices.data() + first;
        const Segment edge{contour[i], contour[i + 1 == length ? 0 : i + 1]};
        if (!(edge.a == edge.b)) visit(edge, first + i);
      }
      first += length;
    }
  }

  [[nodiscard]] RingNode& at(int index) noexcept { return nodes_[static_cast<std::size_t>(index)]; }
  [[nodiscard]] bool is_crossing(int index) noexcept { return at(index).neighbour_ >= 0; }

  void link_vertices(const BooleanOperand& operand) noexcept {
    const SubPoint* vertex = operand.vertices.data();
    for (const int length : operand.contour_lengths) {
      const int first = static_cast<int>(count_);
      for (int i = 0; i < length; ++i, ++vertex, ++count_) {
        RingNode& node = nodes_[count_] = RingNode();
        node.place_ = whole(*vertex);
        node.next_ = first + (i + 1 == length ? 0 : i + 1);
        node.previous_ = first + (i == 0 ? length : i) - 1;
      }
    }
  }

  /// Puts a crossing into its place behind the vertex at which the edge begins; false if it is taken.
  [[nodiscard]] bool insert(int crossing, int from, const Segment& edge) noexcept {
    const bool rises = edge.a.x != edge.b.x ? edge.a.x < edge.b.x : edge.a.y < edge.b.y;
    int before = from;
    while (is_crossing(at(before).next_)) {
      const int order = compare(at(at(before).next_).place_, at(crossing).place_);
      if (order == 0) return false;
      if ((order > 0) == rises) break;
      before = at(before).next_;
    }
    const int after = at(before).next_;
    at(crossing).next_ = after;
    at(crossing).previous_ = before;
    at(after).previous_ = at(before).next_ = crossing;
    return true;
  }

  void mark(const BooleanOperand& operand, int first, const BooleanOperand& other,
            bool keep_outside) noexcept {
    for (const int length : operand.contour_lengths) {
      if (length >= 3) mark_ring(first, other, keep_outside);
      first += length;
    }
  }

  void mark_ring(int first, const BooleanOperand& other, bool keep_outside) noexcept {
    bool kept = keep_outside;
    for_each_ring_edge(other, [&](const Segment& edge, int) {
      // It lies on no edge, so the direction doesn't matter.
      kept ^= is_above(edge, at(first).place_, {1, 0});
    });
    bool crosses = false;
    int index = first;
    do {
      if (is_crossing(index)) {
        kept = !kept;
        at(index).kept_ahead_ = kept;
        crosses = true;
      }
      index = at(index).next_;
    } while (index != first);
    if (crosses || !kept) return;
    do {
      add(at(index).place_);
      index = at(index).next_;
    } while (index != first);
    end_contour();
  }

  void walk_from(int start) noexcept {
    int index = start;
    do {
      const bool ahead = at(index).kept_ahead_;
      at(index).used_ = at(at(index).neighbour_).used_ = true;
      do {
        add(at(index).place_);
        index = ahead ? at(index).next_ : at(index).previous_;
      } while (!is_crossing(index));
      index = at(index).neighbour_;
    } while (index != start && at(index).neighbour_ != start);
    end_contour();
  }

  void add(const BooleanVertex& vertex) noexcept {
    if (result_.vertices < vertices_.size()) vertices_[result_.vertices] = vertex;
    ++result_.vertices;
    ++length_;
  }
  void end_contour() noexcept {
    if (result_.contours < lengths_.size()) lengths_[result_.contours] = length_;
    ++result_.contours;
    length_ = 0;
  }

  const BooleanOperand& a_;
  const BooleanOperand& b_;
  std::span<RingNode> nodes_;
  std::size_t count_ = 0;
  std::span<BooleanVertex> vertices_;
  std::span<int> lengths_;
  BooleanResult result_;
  int length_ = 0;
};

}  // namespace detail

Result<BooleanResult> combine_greiner_hormann(BooleanRule rule, const BooleanOperand& a,
                                              const BooleanOperand& b,
                                              const std::span<BooleanVertex>& vertices,
                                              const std::span<int>& contour_lengths,
                                              const std::span<RingNode>& workspace) noexcept {
  if (rule > BooleanRule::b_minus_a) return Status{Error::out_of_range, Argument::rule};
  if (const Status status = detail::check(a); !status.ok()) return status;
  if (const Status status = detail::check(b); !status.ok()) return status;
  const Status touching{Error::unsupported, Argument::vertices};
  detail::GreinerHormannWork work(a, b, workspace);
  bool apart = true;
  const std::size_t bound = work.bound(apart);
  if (!apart) return touching;
  const auto too_small = [](Argument argument, std::size_t needed) {
    return Status{Error::too_small, argument, static_cast<std::uint32_t>(needed)};
  };
  if (workspace.size() < bound) return too_small(Argument::workspace, bound);
  if (!work.link()) return touching;
  const BooleanResult result = work.walk(rule, vertices, contour_lengths);
  if (result.vertices > vertices.size()) return too_small(Argument::vertices, result.vertices);
  if (result.contours > contour_lengths.size()) return too_small(Argument::contours, result.contours);
  return result;
}

}  // namespace intaglio::clip
