// SPDX-License-Identifier: MIT
//
// How much of each pixel a polygon covers: antialiasing by area.
//
// Rule: the coverage of pixel (x, y) is the integral over its square, [x-1/2, x+1/2) x [y-1/2, y+1/2), of how
// often the contours wind around a place, folded by the fill rule and rounded to the nearest of the levels 0
// to 255. Folding takes an integral w to min(|w|, 1) (non-zero) or to its distance from the nearest even
// number (even-odd).
//
// That is the exact area of the polygon in the pixel wherever
// - by even-odd, the windings met inside the pixel are k and k+1 for one k;
// - by non-zero, they are 0 and 1, or 0 and -1, or all positive, or all negative.
// So it is the area in every pixel for simple polygons of either direction, with holes that lie inside (by
// non-zero they must wind the other way) and for any contours that neither cross nor overlap. Where contours
// do cross, only the pixels in which more windings meet than named above differ from the area.
//
// The edges on a row are kept in order. One that crosses the row from side to side and shares no column with
// others covers its pixels by itself (coverage_edge.hpp), and two that share columns with each other only
// cover theirs by their difference. All others, and those that begin or end on the row, add to cells, one a
// column, that hold the change of the sum from pixel to pixel. Between them all is spans. Rows that only two
// edges cross are drawn without looking for any of that again.
//
// Error bound: an edge's area in a pixel is less than 2^-28 pixel off, and heights add up exactly, so nothing
// leaks to other pixels. With n edges through (or within such an error of) a pixel, its level is off by at
// most 1/2 + 2^-22 + n*2^-20 from 255 times the exact integral. What two polygons add for a shared edge
// cancels to the last bit, and what an edge adds doesn't depend on the clip or on other edges.
//
// Bit budget: |dx|, |dy| <= 2^29, products below 2^58; areas in a pixel below 2^31, so 2^20 edges sum to less
// than 2^51.
// Textbook: section 2.8.1, Catmull's area for one polygon. Worst known inputs: slivers thousands of pixels
// long and a fraction of a pixel wide, edges along the sides of pixels.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/raster/contours.hpp>
#include <intaglio/raster/coverage_edge.hpp>
#include <intaglio/raster/coverage_step.hpp>
#include <intaglio/raster/solid.hpp>
#include <intaglio/status.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

namespace intaglio::raster {

/// The level of a pixel that is covered whole.
inline constexpr int full_coverage = 255;
/// The most vertices that `fill_coverage` takes.
inline constexpr int coverage_vertex_limit = 1 << 20;

/// Takes the pixels (x_begin .. x_end-1, y), all covered to the same level, 1 to 255. `clip()` is as that of
/// a `SpanSink`.
template <class S>
concept CoverageSink = requires(S& s, int y, int x_begin, int x_end, int coverage) {
  s.span(y, x_begin, x_end, coverage);
  { s.clip() } -> std::convertible_to<linear::Rect>;
};

/// A coverage sink that takes what is covered of a row with less work than by spans of the sink:
/// `row(y, x).put(column, coverage)` is the same as `span(y, x + column, x + column + 1, coverage)`, and its
/// `span(begin, end, coverage)` as `span(y, x + begin, x + end, coverage)`. `down()` makes it the row below.
template <class S>
concept CoverageRowSink = CoverageSink<S> && requires(S& s, int y, int x, int column, int coverage) {
  s.row(y, x).put(column, coverage);
  s.row(y, x).span(column, column, coverage);
  s.row(y, x).down();
};

namespace detail {
class CoverageScan;
}

/// A piece of the workspace: 8 bytes. Its content is the business of `fill_coverage`.
class CoverageCell {
 private:
  friend class detail::CoverageScan;
  [[nodiscard, gnu::always_inline]] std::int64_t taken() noexcept {
    const std::int64_t change = change_;
    change_ = 0;
    return change;
  }
  // Or, on its own, an area.
  [[gnu::always_inline]] void hold(int area) noexcept { change_ = area; }
  [[nodiscard, gnu::always_inline]] int held() const noexcept { return static_cast<int>(change_); }
  [[nodiscard, gnu::always_inline]] int taken_held() noexcept {
    const int area = held();
    change_ = 0;
    return area;
  }
  std::int64_t change_;  // of the covered area from the column to the left
};

namespace detail {

/// Pixels of one row and one level.
struct CoverageSpan {
  int y = 0;
  int x_begin = 0;
  int x_end = 0;
  int coverage = 0;
};

/// The row of a sink that has none of its own.
template <CoverageSink S>
struct CoverageSpanRow {
  S* sink;
  int y;
  int x;
  void down() { ++y; }
  void span(int begin, int end, int coverage) const { sink->span(y, x + begin, x + end, coverage); }
  void put(int column, int coverage) const { span(column, column + 1, coverage); }
};

template <CoverageSink S>
[[nodiscard]] constexpr auto coverage_row(S& sink, int y, int x) {
  if constexpr (CoverageRowSink<S>)
    return sink.row(y, x);
  else
    return CoverageSpanRow<S>{&sink, y, x};
}

inline constexpr std::size_t cells_of_edge = sizeof(CoverageEdge) / sizeof(CoverageCell);
static_assert(sizeof(CoverageEdge) % sizeof(CoverageCell) == 0 &&
              alignof(CoverageEdge) == alignof(CoverageCell));

/// The coverage of a polygon, row by row.
class CoverageScan {
 public:
  /// `vertices` and `contour_lengths` must stay while rows are taken.
  CoverageScan(FillRule rule, const linear::Rect& clip, const std::span<const linear::SubPoint>& vertices,
               const std::span<const int>& contour_lengths) noexcept;

  /// Checks the arguments and finds the pixels to look at.
  [[nodiscard]] Status prepare() noexcept;
  /// How many cells it takes.
  [[nodiscard]] std::uint32_t count() const noexcept;
  /// Uses these cells. Error: workspace.
  [[nodiscard]] Status use(const std::span<CoverageCell>& cells) noexcept;
  /// Hands over what is covered, row by row.
  template <class S>
  void draw(S& sink) noexcept {
    // As the sink may write anywhere, members would be read again after each pixel.
    const int bottom = area_.bottom();
    const int mask = winding_mask(rule_);
    const CoverageEdge* const end = end_;
    if (area_.empty()) return;
    auto pixels = coverage_row(sink, area_.y, area_.x);
    for (int y = area_.y;; pixels.down()) {
      start_row(y);
      CoverageEdge& first = *head_.follower;
      if (first.plain > y && first.follower->follower == end) {
        y = draw_run(sink, y, first, *first.follower);
        if (y == bottom) return;
        pixels = coverage_row(sink, y, area_.x);
        start_row(y);
      }
      CoverageEdge* before = &head_;
      CoverageEdge* next = head_.follower;
      int winding = 0;
      int begin = 0;
      for (;;) {
        if (winding == 0) {
          CoverageEdge& edge = *next;
          const CoverageEdge::Piece piece = edge.piece();
          if (is_alone(edge, y)) {
            winding = edge.turn & mask;
            begin = piece.right + 1;
            edge.visit_columns<true>(piece, whole, 0, [&pixels](int column, std::uint32_t area) {
              put(pixels, column, static_cast<int>(area));
            });
            next = edge.follower;
            place(edge, next, before);
          }
        }
        CoverageEdge& edge = *next;
        const CoverageEdge::Piece piece = edge.piece();
        if (winding != 0 && is_alone(edge, y)) {
          winding = (winding + edge.turn) & mask;
          if (winding == 0) {
            if (begin < piece.left) pixels.span(begin, piece.left, full_coverage);
            edge.visit_columns<true>(piece, whole, 0, [&pixels](int column, std::uint32_t area) {
              put(pixels, column, whole - static_cast<int>(area));
            });
          }
          next = edge.follower;
          place(edge, next, before);
          continue;
        }
        if (&edge == end) break;
        const State state = is_pair(edge, *edge.follower, y, winding)
                                ? draw_pair(pixels, {before, winding, begin})
                                : draw_groups(pixels, {before, winding, begin});
        before = state.before;
        winding = state.winding;
        begin = state.begin;
        next = before->follower;
      }
      if (winding != 0 && begin < area_.width) pixels.span(begin, area_.width, full_coverage);
      if (++y == bottom) return;
    }
  }

 private:
  static constexpr int whole = CoverageEdge::whole;

  /// What is known of a row at a place in its list.
  struct State {
    CoverageEdge* before;  // the last edge left of it: those up to it are already on the next row
    int winding;           // there; by even-odd, modulo two
    int begin;             // if that means inside: from here to there all columns are
  };
  /// Edges whose columns overlap. From `end` on all columns are covered alike.
  struct Group {
    CoverageEdge* before;  // the last of them
    int begin;
    int end;
  };

  static constexpr unsigned level_bits = 23;
  static_assert(whole == full_coverage << level_bits);

  /// The level that is nearest to an area of 0 .. whole.
  [[nodiscard, gnu::always_inline]] static constexpr int level_of(int area) noexcept {
    return static_cast<int>((static_cast<unsigned>(area) + (1U << (level_bits - 1))) >> level_bits);
  }
  /// The windings that an area is, if it is one of whole pixels.
  [[nodiscard]] static constexpr int windings(std::int64_t area) noexcept {
    return static_cast<int>(area >> level_bits) / full_coverage;
  }
  /// What the rule, given by its mask, makes of an area. By even-odd, the area is brought to -whole .. whole:
  /// as what an edge adds to a pixel is no more than that, the steps are no more than edges.
  [[nodiscard]] static constexpr int folded(std::int64_t& area, int mask) noexcept {
    if (mask == 1) {
      while (area > whole) area -= 2 * std::int64_t{whole};
      while (area < -whole) area += 2 * std::int64_t{whole};
    }
    const std::int64_t size = area < 0 ? -area : area;
    return size < whole ? static_cast<int>(size) : whole;
  }
  template <class Row>
  [[gnu::always_inline]] static void put(const Row& pixels, int column, int area) noexcept {
    const int level = level_of(area);
    if (level != 0) pixels.put(column, level);
  }
  /// Draws rows from y on as long as these two edges cross them from side to side, with what they enclose
  /// between them, and no others begin. The first row that is left to draw.
  template <class S>
  [[nodiscard, gnu::noinline]] int draw_run(S& sink, int y, CoverageEdge& a, CoverageEdge& b) noexcept {
    if (a.turn == b.turn && rule_ != FillRule::even_odd) return y;
    const int plain = a.plain < b.plain ? a.plain : b.plain;
    const int bottom = area_.bottom() < waiting_->row ? area_.bottom() : waiting_->row;
    const int stop = plain < bottom ? plain : bottom;
    if (y >= stop || a.right >= b.left) return y;
    for (auto pixels = coverage_row(sink, y, area_.x);; pixels.down()) {
      const CoverageEdge::Piece enter = a.piece();
      a.visit_columns<true>(enter, whole, 0, [&pixels](int column, std::uint32_t area) {
        put(pixels, column, static_cast<int>(area));
      });
      a.go_on();
      const CoverageEdge::Piece leave = b.piece();
      b.visit_columns<true>(leave, whole, 0, [&pixels](int column, std::uint32_t area) {
        put(pixels, column, whole - static_cast<int>(area));
      });
      b.go_on();
      if (enter.right + 1 < leave.left) pixels.span(enter.right + 1, leave.left, full_coverage);
      if (++y == stop || a.right >= b.left) break;
    }
    if (b.left < a.left) {
      head_.follower = &b;
      a.follower = b.follower;
      b.follower = &a;
    }
    return y;
  }
  /// Whether an edge crosses the row from side to side and shares no column with the next one.
  [[nodiscard, gnu::always_inline]] static bool is_alone(const CoverageEdge& edge, int y) noexcept {
    return edge.plain > y && edge.follower->left > edge.right;
  }
  /// Whether these two edges, of which the second follows the first and shares columns with it, are a gap or
  /// a tip that crosses the row from side to side, with no other edge in its columns.
  [[nodiscard, gnu::always_inline]] bool is_pair(const CoverageEdge& a, const CoverageEdge& b, int y,
                                                 int winding) const noexcept {
    return a.plain > y && b.plain > y && a.turn != b.turn && winding >= -1 && winding <= 1 &&
           b.follower->left > a.right && b.follower->left > b.right;
  }
  /// Draws the two edges after `state.before`, which are a pair. On the way, the cells hold what the first
  /// piece covers and the second doesn't.
  template <class Row>
  [[nodiscard, gnu::noinline]] State draw_pair(const Row& pixels, const State& state) noexcept {
    CoverageCell* const cells = cells_;
    CoverageEdge* before = state.before;
    CoverageEdge& a = *before->follower;
    CoverageEdge& b = *a.follower;
    const CoverageEdge::Piece first = a.piece();
    const CoverageEdge::Piece second = b.piece();
    const int end = (first.right < second.right ? second.right : first.right) + 1;
    a.visit_columns<true>(first, whole, 0, [cells](int column, std::uint32_t area) {
      cells[column].hold(static_cast<int>(area));
    });
    for (int column = first.right + 1; column < end; ++column) cells[column].hold(whole);
    b.visit_columns<true>(second, whole, 0, [cells](int column, std::uint32_t area) {
      cells[column].hold(cells[column].held() - static_cast<int>(area));
    });
    for (int column = second.right + 1; column < end; ++column)
      cells[column].hold(cells[column].held() - whole);
    if (state.winding == 0) {
      for (int column = first.left; column < end; ++column) {
        const int between = cells[column].taken_held();
        put(pixels, column, between < 0 ? -between : between);
      }
    } else {
      // A pair that opens the other way than what is around it adds to it by even-odd only.
      const bool both_ways = rule_ == FillRule::even_odd;
      const bool opposed = state.winding != a.turn;
      if (state.begin < first.left) pixels.span(state.begin, first.left, full_coverage);
      for (int column = first.left; column < end; ++column) {
        const int between = cells[column].taken_held();
        const int size = between < 0 ? -between : between;
        put(pixels, column, (between > 0) == opposed || both_ways ? whole - size : whole);
      }
    }
    CoverageEdge* const follower = b.follower;
    const int winding = state.winding;
    place(a, &b, before);
    place(b, follower, before);
    return {before, winding, end};
  }
  /// Draws any edges: those of the group after `state.before`, and further ones as long as what is covered
  /// right of them isn't a number of whole pixels.
  template <class Row>
  [[nodiscard, gnu::noinline]] State draw_groups(const Row& pixels, State state) noexcept {
    const int mask = winding_mask(rule_);
    CoverageCell* const cells = cells_;
    std::int64_t area = std::int64_t{state.winding} * whole;
    int covered = folded(area, mask);
    do {
      const Group group = add_group(state.before);
      state.before = group.before;
      if (covered != 0 && state.begin < group.begin) pixels.span(state.begin, group.begin, level_of(covered));
      for (int column = group.begin; column < group.end; ++column) {
        area += cells[column].taken();
        put(pixels, column, folded(area, mask));
      }
      state.begin = group.end;
      area += cells[group.end].taken();
      const int winding = windings(area);
      state.winding = winding & mask;
      if (area == std::int64_t{winding} * whole) return state;
      covered = folded(area, mask);
    } while (state.before->follower != end_);
    const int level = level_of(covered);
    if (level != 0 && state.begin < area_.width) pixels.span(state.begin, area_.width, level);
    state.winding = 0;
    return state;
  }
  /// Adds the edges that begin on a row to those on it.
  [[gnu::always_inline]] void start_row(int y) noexcept {
    y_ = y;
    if (waiting_->row == y) start_edges();
  }
  /// Takes the edge after `before`, with this follower, to the next row, and keeps it in the list, in order.
  [[gnu::always_inline]] void place(CoverageEdge& edge, CoverageEdge* follower,
                                    CoverageEdge*& before) noexcept {
    if (edge.go_on() >= before->left) [[likely]] {
      before = &edge;
      return;
    }
    before->follower = follower;
    insert(edge);
  }
  /// Whether it is one of the columns of the window.
  [[nodiscard]] bool visible(int column) const noexcept {
    return static_cast<unsigned>(column) < static_cast<unsigned>(area_.width);
  }

  template <class Visit>
  void visit_edges(Visit visit) const noexcept;
  [[nodiscard]] int plain_until(const CoverageEdge& edge) const noexcept;
  [[nodiscard]] Group add_group(CoverageEdge* before) noexcept;
  [[nodiscard]] CoverageEdge* merged(CoverageEdge* a, CoverageEdge* b) noexcept;
  [[nodiscard]] CoverageEdge* sorted(CoverageEdge* begin, CoverageEdge* end) noexcept;
  void insert(CoverageEdge& edge) noexcept;
  void start_edges() noexcept;
  void start(CoverageEdge& edge) noexcept;
  void add_piece(const CoverageEdge& edge, const CoverageEdge::Piece& piece, std::uint32_t height) noexcept;

  std::span<const linear::SubPoint> vertices_;
  std::span<const int> contour_lengths_;
  CoverageCell* cells_ = nullptr;    // a column each, and one more
  CoverageEdge* end_ = nullptr;      // the entry at the end of all lists
  CoverageEdge head_{0, 0, 0};       // its followers are those on the row, by their leftmost column
  CoverageEdge* waiting_ = nullptr;  // the list of those that wait, by their first row
  linear::Rect area_;                // the clip; once prepared, the part of it that the polygon's box touches
  int y_ = 0;
  FillRule rule_;
};

}  // namespace detail

/// How many `CoverageCell`s are always enough for polygons with so many vertices under a clip so wide.
[[nodiscard]] constexpr std::size_t coverage_cells(std::size_t vertices, int clip_width) noexcept {
  const auto columns = static_cast<std::size_t>(clip_width > 0 ? clip_width : 0) + 1;
  return columns + detail::cells_of_edge * (vertices + 1);
}

/// How many `CoverageCell`s `fill_coverage` needs for this polygon under this clip: one for each of its
/// visible columns and one more, and eight (where addresses have 64 bits, nine) for each edge that is
/// neither level, nor above or below the clip, nor right of it, and for one more. Errors: as `fill_coverage`;
/// rectangle (clip outside the domain).
[[nodiscard]] Result<std::uint32_t> coverage_workspace(const std::span<const linear::SubPoint>& vertices,
                                                       const std::span<const int>& contour_lengths,
                                                       const linear::Rect& clip) noexcept;

/// Hands the coverage of the polygon over, row by row downwards, in spans of one level that end where edges
/// are, each pixel that has a level of 1 or more once, on a row in no particular order. The polygon is given
/// as to `fill_polygon`: contours are runs of `vertices` (in 1/256 pixel, |c| <= 2^28, at most 2^20 of them),
/// as long as `contour_lengths` says; those of fewer than three vertices are empty. `workspace` needs
/// `coverage_workspace` cells (`coverage_cells` are always enough). It need not be initialised, and holds
/// nothing of value afterwards. The level is at most 1/2 + 2^-22 + n*2^-20 from 255 times the exact area,
/// with n edges through the pixel; see the head of this file for polygons that cross themselves. Errors:
/// vertices (one is outside the domain; or too_large, with the limit), contours (mismatched), workspace (too
/// small: `needed()` cells), rule; nothing is handed over then. Cost: up to six divisions an edge; then about
/// 45 instructions for each row that an edge crosses and 15 for each pixel that it touches, twice that where
/// it meets one other, three times where it isn't alone otherwise; and what the sink takes.
template <CoverageSink S>
Status fill_coverage(S&& sink, FillRule rule, const std::span<const linear::SubPoint>& vertices,
                     const std::span<const int>& contour_lengths, const std::span<CoverageCell>& workspace) {
  detail::CoverageScan scan(rule, sink.clip(), vertices, contour_lengths);
  Status status = scan.prepare();
  if (status.ok()) status = scan.use(workspace);
  if (!status.ok()) return status;
  scan.draw(sink);
  return {};
}

/// The same with all vertices in one contour.
template <CoverageSink S>
Status fill_coverage(S&& sink, FillRule rule, const std::span<const linear::SubPoint>& vertices,
                     const std::span<CoverageCell>& workspace) {
  const int length = static_cast<int>(vertices.size());
  return fill_coverage(sink, rule, vertices, std::span<const int>(&length, 1), workspace);
}

/// Stores a step of a ramp of palette entries: the first for no coverage, the last for a whole pixel, between
/// them the nearest, first + round(coverage * (steps - 1) / 255). With 256 steps from index 0 the indices are
/// the levels themselves. The ramp (`image/ramp.hpp`) leads from the colour of what is there to that of the
/// polygon.
template <image::PixelFormat F>
class RampCoverage {
 public:
  /// A ramp of `steps` entries from index `first` on. `clip` as that of `Solid`.
  /// Errors: index (the format has no `first`), steps (none, or more than indices from `first` on: `needed()`
  /// is how many there are).
  [[nodiscard]] static constexpr Result<RampCoverage> over(const image::Surface<F>& surface, unsigned first,
                                                           int steps, const linear::Rect& clip) noexcept {
    if (first > F::max_index) return Status{Error::out_of_range, Argument::index};
    if (steps < 1) return Status{Error::empty, Argument::steps};
    const unsigned most = F::max_index + 1 - first;
    if (static_cast<unsigned>(steps) > most) return Status{Error::too_large, Argument::steps, most};
    return RampCoverage(surface, first, static_cast<unsigned>(steps) - 1, clip);
  }
  /// The same on all of the surface.
  [[nodiscard]] static constexpr Result<RampCoverage> over(const image::Surface<F>& surface, unsigned first,
                                                           int steps) noexcept {
    return over(surface, first, steps, surface.bounds());
  }

  /// Draws nothing.
  constexpr RampCoverage() noexcept = default;

  /// Where it can draw.
  [[nodiscard]] constexpr const linear::Rect& clip() const noexcept { return clip_; }
  /// The index for a level of 0 to 255.
  [[nodiscard]] constexpr unsigned index(int coverage) const noexcept { return ramp_.index(coverage); }
  /// Writes the pixels x_begin .. x_end-1 of row y. Precondition: they are inside the clip; x_begin < x_end.
  void span(int y, int x_begin, int x_end, int coverage) const noexcept {
    if constexpr (F::bits == 8) {
      // On the boundary of a shape most spans are this long.
      if (x_end - x_begin == 1) {
        row(y, x_begin).put(0, coverage);
        return;
      }
    }
    Solid<F>(surface_, index(coverage)).span(y, x_begin, x_end);
  }
  /// The pixels of row y from column x on, of which those inside the clip can be set one by one.
  [[nodiscard]] auto row(int y, int x) const noexcept requires(F::bits == 8) {
    struct Row {
      std::uint8_t* pixels;
      int stride;
      CoverageRamp ramp;
      image::Pattern full;
      [[gnu::always_inline]] void down() noexcept { pixels += stride; }
      [[gnu::always_inline]] void put(int column, int coverage) const noexcept {
        pixels[column] = static_cast<std::uint8_t>(ramp.index(coverage));
      }
      [[gnu::always_inline]] void span(int begin, int end, int coverage) const noexcept {
        const image::Pattern pattern(static_cast<std::uint8_t>(ramp.index(coverage)));
        image::fill_bytes(pixels + begin, end - begin, coverage == full_coverage ? full : pattern);
      }
    };
    return Row{surface_.byte_at(x, y), surface_.stride(), ramp_, full_};
  }

 private:
  constexpr RampCoverage(const image::Surface<F>& surface, unsigned first, unsigned last,
                         const linear::Rect& clip) noexcept
      : surface_(surface),
        clip_(Solid<F>(surface, first, clip).clip()),
        ramp_(first, last),
        full_(static_cast<std::uint8_t>(first + last)) {}

  image::Surface<F> surface_{};
  linear::Rect clip_{};
  CoverageRamp ramp_{};
  image::Pattern full_{0};  // of the last step
};

static_assert(CoverageRowSink<RampCoverage<image::Indexed8>> && CoverageSink<RampCoverage<image::Indexed4>>);

}  // namespace intaglio::raster
