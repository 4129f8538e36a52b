// SPDX-License-Identifier: MIT
#include <intaglio/raster/polygon_critical.hpp>

#include <algorithm>

namespace intaglio::raster::detail {

namespace {

/// The vertex before or after on a contour first .. last.
int neighbour(int vertex, int direction, int first, int last) noexcept {
  if (direction > 0) return vertex == last ? first : vertex + 1;
  return vertex == first ? last : vertex - 1;
}

}  // namespace

Status CriticalScan::prepare(const std::span<const linear::SubPoint>& vertices,
                             const std::span<const int>& contour_lengths) noexcept {
  const Status status = check_contours(vertices, contour_lengths);
  if (!status.ok()) return status;
  if (clip_.empty()) return {};
  vertices_ = vertices;
  int first = 0;
  for (const int length : contour_lengths) {
    add_contour(first, first + length - 1);
    first += length;
  }
  if (count_ > chains_.size())
    return {Error::too_small, Argument::workspace, static_cast<std::uint32_t>(count_)};
  const auto waiting = chains_.first(count_);
  const auto by_row = [](const PolygonChain& a, const PolygonChain& b) { return a.row_ < b.row_; };
  std::make_heap(waiting.begin(), waiting.end(), by_row);
  std::sort_heap(waiting.begin(), waiting.end(), by_row);
  return {};
}

void CriticalScan::add_contour(int first, int last) noexcept {
  for (int vertex = first; vertex <= last; ++vertex) {
    const int y = at(vertex).y;
    if (at(neighbour(vertex, 1, first, last)).y <= y) continue;
    // It goes down from here. A minimum, if it also does the other way from where the plateau begins.
    int begin = vertex;
    int before = neighbour(begin, -1, first, last);
    while (at(before).y == y) {
      begin = before;
      before = neighbour(begin, -1, first, last);
    }
    if (at(before).y < y) continue;
    add_chain(vertex, 1, first, last);
    add_chain(begin, -1, first, last);
  }
}

/// Stores the chain that goes down from a minimum, if it has visible rows.
void CriticalScan::add_chain(int vertex, int direction, int first, int last) noexcept {
  PolygonChain chain;
  chain.row_ = std::max(ceil_to_pixel(at(vertex).y), clip_.y);
  chain.vertex_ = vertex;
  chain.direction_ = direction;
  chain.first_ = first;
  chain.last_ = last;
  if (chain.row_ >= clip_.bottom() || !go_on(chain, chain.row_)) return;
  if (count_ < chains_.size()) chains_[count_] = chain;
  ++count_;
}

/// Puts the chain on its edge of `row`, which lies at or below its vertex; false if it ends above.
bool CriticalScan::go_on(PolygonChain& chain, int row) const noexcept {
  for (;;) {
    const linear::SubPoint& top = at(chain.vertex_);
    chain.vertex_ = neighbour(chain.vertex_, chain.direction_, chain.first_, chain.last_);
    const linear::SubPoint& bottom = at(chain.vertex_);
    if (bottom.y < top.y) return false;
    chain.end_ = ceil_to_pixel(bottom.y);
    if (chain.end_ <= row) continue;
    chain.edge_.start(top, bottom, row);
    return true;
  }
}

bool CriticalScan::next_row() noexcept {
  ++y_;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < active_; ++i) {
    PolygonChain& chain = chains_[i];
    if (chain.end_ > y_)
      chain.edge_.next();
    else if (!go_on(chain, y_))
      continue;
    if (kept != i) chains_[kept] = chain;
    ++kept;
  }
  active_ = kept;
  if (active_ == 0) {
    if (waiting_ == count_) return false;
    y_ = chains_[waiting_].row_;
  }
  if (y_ >= clip_.bottom()) return false;
  for (; waiting_ < count_ && chains_[waiting_].row_ == y_; ++waiting_)
    chains_[active_++] = chains_[waiting_];

  // Nearly sorted: from row to row few chains change places.
  for (std::size_t i = 1; i < active_; ++i) {
    if (chains_[i - 1].x() <= chains_[i].x()) continue;
    const PolygonChain chain = chains_[i];
    std::size_t place = i;
    for (; place > 0 && chains_[place - 1].x() > chain.x(); --place) chains_[place] = chains_[place - 1];
    chains_[place] = chain;
  }
  return true;
}

}  // namespace intaglio::raster::detail
