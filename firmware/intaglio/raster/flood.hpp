// SPDX-License-Identifier: MIT
//
// Flood fill: a colour spreads from a seed over a connected region of the picture.
//
// Rule: the region is the set of pixels that a path inside the clip joins to the seed, each step of it to one
// of 4 or of 8 neighbours, through pixels of the region's kind only. Interior-defined, that kind is the index
// the seed has; boundary-defined, it is any index but the border's and the fill's own. Each pixel of the
// region is written once. A fill with the index that is there already has nothing to do.
//
// Spans, not pixels: an entry of the workspace is a stretch of a row next to a run that is already filled.
// Taking an entry fills one whole run below or above it, and leaves entries for what this run touches:
// further along, behind to the left and right where it reaches past the stretch, and ahead. Entries are kept
// only while they hold a pixel of the region, and a run is filled only if all the entries it leaves find
// room. So nothing is ever lost: when memory runs out the picture is a correct part of the fill, and the
// entries are exactly what joins it to the rest.
//
// Bit budget: rows are within 2^22, doubled to hold the direction. Error: none. Textbook: section 2.6.6, with
// erratum E5 (a recursion that stops only at the fill's index overruns a border of another). Worst known
// input: a comb or a checkerboard by 8 neighbours, which leave an entry for every other pixel of a row.
#pragma once

#include <intaglio/image/surface.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/raster/row_span.hpp>
#include <intaglio/raster/sink.hpp>
#include <intaglio/raster/solid.hpp>
#include <intaglio/status.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace intaglio::raster {

/// Which pixels are neighbours.
enum class Connectivity : std::uint8_t {
  four,   ///< Those that share a side.
  eight,  ///< Those that share a side or a corner.
};

template <image::PixelFormat F>
class Flood;

/// One entry of a flood fill's workspace: 12 bytes. Its content is the business of `Flood`.
class FloodSpan {
 public:
  FloodSpan() noexcept = default;

 private:
  template <image::PixelFormat F>
  friend class Flood;
  constexpr FloodSpan(int y, int begin, int end, bool upwards) noexcept
      : row_(2 * y + (upwards ? 1 : 0)), begin_(begin), end_(end) {}
  [[nodiscard]] constexpr int y() const noexcept { return row_ >> 1; }
  [[nodiscard]] constexpr bool upwards() const noexcept { return (row_ & 1) != 0; }

  int row_ = 0;  // 2 * y, plus 1 if the filled run is below
  int begin_ = 0;
  int end_ = 0;
};
static_assert(sizeof(FloodSpan) == 12);

/// A flood fill under way. Made by `interior` or `up_to`, which read no more than the seed's pixel, and
/// carried out by `run`, in several calls if memory is short. `flood_fill` and `boundary_fill` are the short
/// way for one call.
template <image::PixelFormat F>
class Flood {
 public:
  /// A fill of nothing.
  Flood() noexcept = default;

  /// Will replace the region of the seed's index in `picture` by the index `fill`.
  /// Errors: point (seed outside the domain), rule (no such connectivity).
  [[nodiscard]] static Result<Flood> interior(const image::Picture<F>& picture, Connectivity connectivity,
                                              linear::Point seed, unsigned fill) noexcept {
    return make(picture, connectivity, seed, fill,
                in_clip(picture.bounds(), seed) ? picture.get(seed.x, seed.y) : 0, true);
  }

  /// Will fill from the seed up to pixels of the index `border`. Pixels that have the index `fill` at the
  /// beginning are a border too.
  /// Errors: point (seed outside the domain), rule (no such connectivity), index (the format has no such
  /// border).
  [[nodiscard]] static Result<Flood> up_to(unsigned border, const image::Picture<F>& picture,
                                           Connectivity connectivity, linear::Point seed,
                                           unsigned fill) noexcept {
    if (border > F::max_index) return Status{Error::out_of_range, Argument::index};
    return make(picture, connectivity, seed, fill, border, false);
  }

  /// Fills, or goes on filling where the call before ran out of memory. `sink` stores the index `fill` in
  /// `picture`; its clip bounds the region, and is the same in every call. A seed outside the clip fills
  /// nothing.
  /// Errors: workspace, too small. Then the pixels drawn so far belong to the region, each drawn once, and
  /// the first `pending()` entries of `workspace` say where to go on: the next call takes them, in the same
  /// memory or at the front of a larger workspace. With `needed()` entries it fills at least one more run;
  /// with as many as before it comes to the same answer.
  /// Cost: each pixel of the region, and each neighbour of it, is read about four times. When the workspace
  /// is full, all of it is searched for an entry that can still be taken.
  template <SpanSink S>
  Status run(S&& sink, const std::span<FloodSpan>& workspace) {
    clip_ = linear::intersect(sink.clip(), picture_.bounds());
    if (pending_ > workspace.size()) return too_small(pending_);
    std::size_t needed = 0;
    for (RowSpan span; next(workspace, span, needed);) sink.span(span.y, span.x_begin, span.x_end);
    return needed == 0 ? Status{} : too_small(needed);
  }

  /// Entries of the workspace that are still to be done: none before the first call and after the last.
  [[nodiscard]] std::size_t pending() const noexcept { return pending_; }

 private:
  [[nodiscard]] static Result<Flood> make(const image::Picture<F>& picture, Connectivity connectivity,
                                          linear::Point seed, unsigned fill, unsigned key,
                                          bool interior) noexcept {
    if (!linear::in_domain(seed)) return Status{Error::out_of_domain, Argument::point};
    if (connectivity != Connectivity::four && connectivity != Connectivity::eight)
      return Status{Error::out_of_range, Argument::rule};
    Flood flood;
    flood.picture_ = picture;
    flood.seed_ = seed;
    flood.reach_ = connectivity == Connectivity::eight ? 1 : 0;
    flood.fill_ = fill & F::max_index;
    flood.key_ = key;
    flood.interior_ = interior;
    flood.started_ = false;
    return flood;
  }

  [[nodiscard]] static Status too_small(std::size_t needed) noexcept {
    return {Error::too_small, Argument::workspace, static_cast<std::uint32_t>(needed)};
  }

  [[nodiscard]] bool inside(int x, int y) const noexcept {
    const unsigned index = picture_.get(x, y);
    return index != fill_ && (index == key_) == interior_;
  }

  /// Cuts an entry to the clip and to its first pixel of the region; false if there is none.
  [[nodiscard]] bool trim(FloodSpan& entry) const noexcept {
    const int y = entry.y();
    if (y < clip_.y || y >= clip_.bottom()) return false;
    entry.begin_ = std::max(entry.begin_, clip_.x);
    entry.end_ = std::min(entry.end_, clip_.right());
    while (entry.begin_ < entry.end_ && !inside(entry.begin_, y)) ++entry.begin_;
    return entry.begin_ < entry.end_;
  }

  /// Finds the next run to fill. False if there is none: `needed` is then the size of workspace that would
  /// let the fill go on, or 0 if it is complete.
  [[nodiscard]] bool next(const std::span<FloodSpan>& workspace, RowSpan& span,
                          std::size_t& needed) noexcept {
    needed = 0;
    if (!started_) {
      FloodSpan seed(seed_.y, seed_.x, seed_.x + 1, false);
      started_ = !trim(seed);
      if (started_) return false;
      const Run run = run_at(seed);
      needed = run.count;
      started_ = needed <= workspace.size();
      if (started_) fill(run, workspace, span);
      return started_;
    }
    for (std::size_t place = pending_; place-- > 0;) {
      FloodSpan& entry = workspace[place];
      if (!trim(entry)) {
        entry = workspace[--pending_];
        place = pending_;  // there is more room: try them all again
        needed = 0;
        continue;
      }
      const Run run = run_at(entry);
      const std::size_t after = pending_ - 1 + run.count;
      if (after <= workspace.size()) {
        entry = workspace[--pending_];
        fill(run, workspace, span);
        return true;
      }
      needed = needed == 0 ? after : std::min(needed, after);
    }
    return false;
  }

  /// A run to be filled and the entries it leaves.
  struct Run {
    RowSpan span;
    std::size_t count = 0;
    std::array<FloodSpan, 4> entries;
  };

  /// The first run of an entry, which has been trimmed.
  [[nodiscard]] Run run_at(const FloodSpan& entry) const noexcept {
    const int y = entry.y();
    int begin = entry.begin_;
    int end = begin + 1;
    while (begin > clip_.x && inside(begin - 1, y)) --begin;
    while (end < clip_.right() && inside(end, y)) ++end;
    const int left = begin - reach_;
    const int right = end + reach_;

    // Behind the run, between the entry's ends, everything is filled or not of the region. Nothing is behind
    // the seed.
    const bool upwards = entry.upwards();
    const int ahead = upwards ? y - 1 : y + 1;
    const int behind = upwards ? y + 1 : y - 1;
    const std::array<FloodSpan, 4> candidates{
        FloodSpan{y, end + 1, entry.end_, upwards},
        FloodSpan{behind, left, started_ ? entry.begin_ : right, !upwards},
        FloodSpan{behind, started_ ? entry.end_ : right, right, !upwards},
        FloodSpan{ahead, left, right, upwards}};
    Run run{{y, begin, end}, 0, {}};
    for (const FloodSpan& candidate : candidates) {
      run.entries[run.count] = candidate;
      if (trim(run.entries[run.count])) ++run.count;
    }
    return run;
  }

  /// Decides to fill a run: its entries have room.
  void fill(const Run& run, const std::span<FloodSpan>& workspace, RowSpan& span) noexcept {
    for (std::size_t i = 0; i < run.count; ++i) workspace[pending_++] = run.entries[i];
    span = run.span;
  }

  image::Picture<F> picture_;
  linear::Rect clip_{};
  linear::Point seed_{};
  int reach_ = 0;  // how far a neighbour in another row may be to the side
  unsigned fill_ = 0;
  unsigned key_ = 0;      // the region's index, or the border's
  bool interior_ = true;  // which of them
  bool started_ = true;
  std::size_t pending_ = 0;
};

/// Fills the region of the seed's index, inside the sink's clip, with the sink's index. `workspace` holds the
/// places where the fill goes on: 2 do for an empty area, 9 for a maze of 81x81 pixels, 49 for the dark
/// fields of a board of 64x64 by 8 neighbours. Errors: point (seed outside the domain), rule (no such
/// connectivity); nothing is drawn then. workspace (too small): part of the region is filled. A second call
/// with the same seed finds it filled and ends at once; fills that are to go on are run by `Flood`.
template <image::PixelFormat F>
Status flood_fill(const Solid<F>& sink, Connectivity connectivity, linear::Point seed,
                  const std::span<FloodSpan>& workspace) {
  auto flood = Flood<F>::interior(sink.surface(), connectivity, seed, sink.index());
  return flood.ok() ? flood.value().run(sink, workspace) : flood.status();
}

/// Fills from the seed up to pixels of the index `border` (or of the sink's own), inside the sink's clip.
/// Errors: as `flood_fill`; index (the format has no such border).
template <image::PixelFormat F>
Status boundary_fill(const Solid<F>& sink, unsigned border, Connectivity connectivity, linear::Point seed,
                     const std::span<FloodSpan>& workspace) {
  auto flood = Flood<F>::up_to(border, sink.surface(), connectivity, seed, sink.index());
  return flood.ok() ? flood.value().run(sink, workspace) : flood.status();
}

}  // namespace intaglio::raster
