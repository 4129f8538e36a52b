// SPDX-License-Identifier: MIT
//
// Clipping to a convex polygon: see the header for the rule.
#include <intaglio/clip/convex.hpp>
#include <intaglio/number/mul_div.hpp>

#include <cstddef>

namespace intaglio::clip {
namespace {

using linear::SubPoint;

constexpr SubPoint between(SubPoint from, SubPoint to) noexcept { return {to.x - from.x, to.y - from.y}; }
constexpr std::int64_t cross(SubPoint u, SubPoint v) noexcept {
  return std::int64_t{u.x} * v.y - std::int64_t{u.y} * v.x;
}
constexpr std::int64_t dot(SubPoint u, SubPoint v) noexcept {
  return std::int64_t{u.x} * v.x + std::int64_t{u.y} * v.y;
}

bool in_domain(const std::span<const SubPoint>& points) noexcept {
  for (const SubPoint p : points)
    if (!linear::in_domain(p)) return false;
  return true;
}

/// How a contour turns.
class Turns {
 public:
  void add(SubPoint edge) noexcept {
    if (edge == SubPoint{}) return;
    if (previous_ == SubPoint{}) {
      first_ = edge;
    } else {
      turn(edge);
    }
    previous_ = edge;
  }
  void close() noexcept {
    if (!(previous_ == SubPoint{})) turn(first_);
  }
  [[nodiscard]] bool left() const noexcept { return left_; }
  [[nodiscard]] bool flat() const noexcept { return !left_ && !right_; }
  /// One way only, and once round: in a convex contour x changes its direction twice.
  [[nodiscard]] bool convex() const noexcept { return !(left_ && right_) && !back_ && reversals_ <= 2; }

 private:
  void turn(SubPoint edge) noexcept {
    const std::int64_t side = cross(previous_, edge);
    left_ = left_ || side < 0;
    right_ = right_ || side > 0;
    back_ = back_ || (side == 0 && dot(previous_, edge) < 0);
    const int direction = edge.x < 0 ? -1 : edge.x > 0 ? 1 : 0;
    if (previous_.x != 0) direction_ = previous_.x < 0 ? -1 : 1;
    if (direction * direction_ < 0) ++reversals_;
  }

  SubPoint first_;
  SubPoint previous_;
  int direction_ = 0;  // of the last edge that wasn't upright
  int reversals_ = 0;
  bool left_ = false;
  bool right_ = false;
  bool back_ = false;
};

}  // namespace

namespace detail {

class ConvexPipeline {
 public:
  ConvexPipeline(const std::span<ClipStage>& stages, const std::span<SubPoint>& out) noexcept
      : stages_(stages), out_(out) {}

  static void set(ClipStage& stage, SubPoint from, SubPoint to) noexcept {
    stage = {};
    stage.from_ = from;
    stage.along_ = between(from, to);
  }

  /// Lets a vertex into a stage and all that comes of it through the later ones.
  void push(SubPoint vertex, std::size_t i) noexcept {
    for (;;) {
      if (i == stages_.size()) {
        if (count_ < out_.size()) out_[count_] = vertex;
        ++count_;
      } else if (pass(stages_[i], vertex)) {
        ++i;
        continue;
      }
      // On with the second vertex of the last stage that made two.
      do {
        if (i == 0) return;
        --i;
      } while (!stages_[i].has_waiting_);
      stages_[i].has_waiting_ = false;
      vertex = stages_[i].waiting_;
      ++i;
    }
  }

  /// The last edges: from each stage's last vertex to its first.
  void close() noexcept {
    for (std::size_t i = 0; i < stages_.size(); ++i)
      if (stages_[i].begun_) push(stages_[i].first_, i);
  }

  [[nodiscard]] std::size_t count() const noexcept { return count_; }

 private:
  /// Takes a vertex in and answers whether one comes out in its place; a second one waits in the stage.
  static bool pass(ClipStage& stage, SubPoint& vertex) noexcept {
    const SubPoint from = stage.last_;
    const std::int64_t from_side = stage.last_side_;
    const SubPoint to = vertex;
    const std::int64_t to_side = cross(stage.along_, between(stage.from_, to));
    stage.last_ = to;
    stage.last_side_ = to_side;
    if (!stage.begun_) {
      stage.begun_ = true;
      stage.first_ = to;
      return false;
    }
    if ((from_side > 0 && to_side < 0) || (from_side < 0 && to_side > 0)) {
      const std::int64_t whole = from_side - to_side;
      vertex.x = from.x + static_cast<int>(number::mul_div_nearest(to.x - from.x, from_side, whole));
      vertex.y = from.y + static_cast<int>(number::mul_div_nearest(to.y - from.y, from_side, whole));
      stage.has_waiting_ = to_side > 0;
      stage.waiting_ = to;
      return true;
    }
    return to_side >= 0;
  }

  std::span<ClipStage> stages_;
  std::span<SubPoint> out_;
  std::size_t count_ = 0;
};

}  // namespace detail

Result<std::span<SubPoint>> clip_to_convex(const std::span<const SubPoint>& polygon,
                                           const std::span<const SubPoint>& clipper,
                                           const std::span<SubPoint>& out,
                                           const std::span<ClipStage>& workspace) noexcept {
  using detail::ConvexPipeline;
  if (!in_domain(polygon) || !in_domain(clipper)) return Status{Error::out_of_domain, Argument::vertices};
  const std::size_t edges = clipper.size();
  const auto next = [&](std::size_t i) { return clipper[i + 1 == edges ? 0 : i + 1]; };
  Turns turns;
  for (std::size_t i = 0; i < edges; ++i) turns.add(between(clipper[i], next(i)));
  turns.close();
  if (turns.flat()) return Status{Error::empty, Argument::contours};
  if (!turns.convex()) return Status{Error::malformed, Argument::contours};
  if (workspace.size() < edges)
    return Status{Error::too_small, Argument::workspace, static_cast<std::uint32_t>(edges)};
  for (std::size_t i = 0; i < edges; ++i) {
    if (turns.left()) {
      ConvexPipeline::set(workspace[i], next(i), clipper[i]);
    } else {
      ConvexPipeline::set(workspace[i], clipper[i], next(i));
    }
  }
  if (polygon.size() < 3) return out.first(0);
  ConvexPipeline pipeline(workspace.first(edges), out);
  for (const SubPoint vertex : polygon) pipeline.push(vertex, 0);
  pipeline.close();
  if (pipeline.count() > out.size())
    return Status{Error::too_small, Argument::buffer, static_cast<std::uint32_t>(pipeline.count())};
  return out.first(pipeline.count());
}

}  // namespace intaglio::clip
