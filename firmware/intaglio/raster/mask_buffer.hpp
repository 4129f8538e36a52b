// SPDX-License-Identifier: MIT
//
// The A-buffer: which parts of a pixel a polygon covers, as the bits of a word.
//
// Rule: a pixel has 4x4 or 4x8 parts (columns by rows), each a bit of its mask. A layer's mask has the parts
// whose middles its drawing covers, enlarged 4 times across and 4 or 8 times down (enlargement.hpp). Layers
// come front first; of each, what is visible are the bits that no layer in front has, and their number is its
// level (layer_sink.hpp has the rounding). As masks keep where a pixel is covered and not only how much,
// layers that share an edge don't show what is behind them through it.
//
// A span of parts turns over the bits from its begin and from its end to the right, by a table of the four
// masks that a row of parts can begin with; a running exclusive-or along the row makes masks of that. So a
// long span costs as much as a short one. Rows of pixels are done one at a time, and each layer is drawn once
// a row under a clip of that row (clipping changes no pixel), until nothing more can be seen there.
//
// Error bound, in a pixel that one straight edge crosses, against its area: 1/8 of the pixel (for 4x8 and
// edges that are flatter than 1:2, 1/16) and half a level, as for every grid of samples (supersample.hpp);
// the bound of each layer behind is larger by that of the edges in front. Bit budget: masks have 32 bits.
// Textbook: section 2.8.1. Worst known inputs: edges along columns; shapes between the middles of parts.
#pragma once

#include <intaglio/raster/enlargement.hpp>
#include <intaglio/raster/layer_sink.hpp>
#include <intaglio/raster/sample_level.hpp>
#include <intaglio/raster/sink.hpp>
#include <intaglio/status.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace intaglio::raster {

/// How a pixel is divided.
enum class MaskGrid : std::uint8_t {
  four_by_four = 4,   ///< 16 parts.
  four_by_eight = 8,  ///< 4 columns, 8 rows: 32 parts.
};

class MaskSink;

/// One visible column in the workspace: 8 bytes. Its content is the business of `cover_by_masks`.
class MaskCell {
 private:
  friend class MaskSink;
  template <LayerSink S, class Draw>
  friend Status cover_by_masks(S&& sink, MaskGrid grid, int layers, const std::span<MaskCell>& workspace,
                               Draw draw);
  std::uint32_t change_;   // of the layer's mask from the column to the left
  std::uint32_t covered_;  // by the layers in front
};

/// The span sink that an enlarged layer is drawn into: the parts of one row of pixels.
class MaskSink {
 public:
  static constexpr int across = 4;

  /// Precondition: a cell for each column of `parts`, which is a row of pixels, enlarged.
  MaskSink(MaskCell* cells, const linear::Rect& parts) noexcept : cells_(cells), parts_(parts) {}
  /// The parts that are looked at.
  [[nodiscard]] const linear::Rect& clip() const noexcept { return parts_; }
  /// Covers the parts x_begin .. x_end-1 of row y. Precondition: inside the clip.
  void span(int y, int x_begin, int x_end) const noexcept {
    const int row = (y - parts_.y) * across;
    turn_over(row, x_begin - parts_.x);
    turn_over(row, x_end - parts_.x);
  }

 private:
  /// Turns over the bits of a row of parts from x on.
  void turn_over(int row, int x) const noexcept {
    constexpr std::array<std::uint8_t, across> from{0b1111, 0b1110, 0b1100, 0b1000};
    constexpr std::uint32_t all = 0b1111;
    const int column = x / across;
    if (x >= parts_.width) return;
    const std::uint32_t mask = from[static_cast<unsigned>(x) % across];
    cells_[column].change_ ^= mask << static_cast<unsigned>(row);
    if (x + across < parts_.width) cells_[column + 1].change_ ^= (all ^ mask) << static_cast<unsigned>(row);
  }

  MaskCell* cells_;
  linear::Rect parts_;
};

/// Hands over what is visible of each of `layers` layers (front first, 0 .. 2^20). `draw` is called with the
/// number of a layer and a `MaskSink`, and draws the layer enlarged by `Enlargement(4, 4)` or `Enlargement(4,
/// 8)`, each enlarged pixel once; it answers with a `Status`. It is called once a layer for each row of
/// pixels of the sink's clip on which something may still be visible. `workspace` needs a cell for each
/// column of the clip. Errors: rule (the grid), count (the layers), workspace (too small: `needed()` cells);
/// those of `draw`, which nothing is handed over after. Cost: what it draws; about 20 instructions for each
/// end of a span of parts, and for each visible column a row and layer.
template <LayerSink S, class Draw>
Status cover_by_masks(S&& sink, MaskGrid grid, int layers, const std::span<MaskCell>& workspace, Draw draw) {
  if (grid != MaskGrid::four_by_four && grid != MaskGrid::four_by_eight)
    return {Error::out_of_range, Argument::rule};
  if (layers < 0 || layers > linear::coordinate_limit) return {Error::out_of_range, Argument::count};
  const int down = static_cast<int>(grid);
  const Enlargement enlarge(MaskSink::across, down);
  const linear::Rect clip = enlarge.window(sink.clip());
  if (clip.empty()) return {};
  const auto columns = static_cast<std::uint32_t>(clip.width);
  if (workspace.size() < columns) return {Error::too_small, Argument::workspace, columns};
  const std::span<MaskCell> cells = workspace.first(columns);
  const detail::SampleLevels levels(MaskSink::across * down);
  const std::uint32_t full = down == 8 ? ~std::uint32_t{0} : 0xFFFFU;
  for (int y = clip.y; y < clip.bottom(); ++y) {
    for (MaskCell& cell : cells) cell = MaskCell{};
    MaskSink parts(cells.data(), enlarge.area({clip.x, y, clip.width, 1}));
    bool open = true;
    for (int layer = 0; layer < layers && open; ++layer) {
      const Status status = draw(layer, parts);
      if (!status.ok()) return status;
      open = false;
      std::uint32_t mask = 0;
      detail::CoverageSpan run;
      const auto hand_over = [&] {
        if (run.coverage != 0) sink.span(layer, y, run.x_begin, run.x_end, run.coverage);
      };
      int x = clip.x;
      for (MaskCell& cell : cells) {
        mask ^= cell.change_;
        cell.change_ = 0;
        const std::uint32_t covered = cell.covered_ | mask;
        const int level = levels(std::popcount(covered)) - levels(std::popcount(cell.covered_));
        cell.covered_ = covered;
        open |= covered != full;
        if (level != run.coverage) {
          hand_over();
          run = {y, x, x, level};
        }
        run.x_end = ++x;
      }
      hand_over();
    }
  }
  return {};
}

}  // namespace intaglio::raster
