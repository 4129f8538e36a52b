// SPDX-License-Identifier: MIT
//
// Blend tables: on a surface of palette indices, what becomes of a pixel when a colour covers a part of it.
//
// Rule: `steps` levels lead from nothing (step 0) to all (the last). For each step between and each index
// that may lie under the colour, the table holds the index whose colour is nearest to the mixture of the two.
// The mixture is one of light (`mix`, ramp.hpp), which is what the eye sees of finer pixels, or one of sRGB
// codes rounded to nearest, which is what most programs do; nearest is by the squared distance of the sRGB
// codes, each channel counting the same; of two as near, the lower index. Nothing covered leaves what is
// there, and all covered is the colour's own index: these two steps need no table.
//
// The table is made once, at start or on the host, and read with one look a pixel.
//
// Error bound: the entry is the nearest to a mixture that is off by at most 0.58 code a channel (codes: 0.5),
// so its distance from the exact mixture is at most 2 * sqrt(3) * 0.58 codes above that of the best entry.
// How near that is depends on the palette. Bit budget: a squared distance has 18 bits. Textbook: section 2.8,
// on displays with a colour look-up table. Worst known input: palettes without the colours between.
#pragma once

#include <intaglio/image/mix_rungs.hpp>
#include <intaglio/image/nearest.hpp>
#include <intaglio/image/palette.hpp>
#include <intaglio/image/ramp.hpp>
#include <intaglio/status.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace intaglio::image {

/// A table that was made by `make_blend_table`, to look up in.
class BlendTable {
 public:
  /// Bytes of a table for a palette of so many entries.
  [[nodiscard]] static constexpr std::size_t bytes(int entries, int steps) noexcept {
    return entries > 0 && steps > 2 ? static_cast<std::size_t>(entries) * static_cast<std::size_t>(steps - 2)
                                    : 0;
  }
  /// A table in memory that stays. `index` is the colour's.
  /// Errors: index, steps, table: as `make_blend_table`; palette (not 2 .. 256 entries).
  [[nodiscard]] static constexpr Result<BlendTable> over(std::span<const std::uint8_t> table, int entries,
                                                         int index, int steps) noexcept {
    if (entries < 2 || entries > 256) return Status{Error::out_of_range, Argument::palette};
    if (index < 0 || index >= entries) return Status{Error::out_of_range, Argument::index};
    if (steps < 2 || steps > 256) return Status{Error::out_of_range, Argument::steps};
    const std::size_t needed = bytes(entries, steps);
    if (table.size() < needed)
      return Status{Error::too_small, Argument::table, static_cast<std::uint32_t>(needed)};
    return BlendTable(table, entries, index, steps);
  }

  /// Two steps of no colour.
  constexpr BlendTable() noexcept = default;

  /// Indices that may lie under the colour: 0 .. entries()-1.
  [[nodiscard]] constexpr int entries() const noexcept { return entries_; }
  /// The index of the colour.
  [[nodiscard]] constexpr int index() const noexcept { return index_; }
  [[nodiscard]] constexpr int steps() const noexcept { return steps_; }
  /// What becomes of each index at this step. Precondition: 0 < step < steps()-1.
  [[nodiscard]] constexpr const std::uint8_t* row(int step) const noexcept {
    return table_.data() + (step - 1) * entries_;
  }

 private:
  constexpr BlendTable(std::span<const std::uint8_t> table, int entries, int index, int steps) noexcept
      : table_(table), entries_(entries), index_(index), steps_(steps) {}

  std::span<const std::uint8_t> table_;
  int entries_ = 0;
  int index_ = 0;
  int steps_ = 2;
};

/// In what a colour and what lies under it are mixed.
enum class BlendSpace : std::uint8_t {
  light,  ///< Linear light.
  code,   ///< sRGB codes.
};

/// Makes the row of one step, 0 < step < steps - 1, of the table of the colour `index` over every entry of a
/// palette (RGBRGB..., as `Palette::bytes()`): the part of `make_blend_table` for those who have no time for
/// all of it at once. The row has as many bytes as the palette entries. Errors: as there; position (no such
/// step), table (the row is too small); nothing is written then.
[[nodiscard]] constexpr Status make_blend_row(std::span<std::uint8_t> row,
                                              std::span<const std::uint8_t> palette, int index, int step,
                                              int steps, BlendSpace space = BlendSpace::light) noexcept {
  if (palette.size() % 3 != 0 || palette.size() < 6 || palette.size() > 768)
    return {Error::malformed, Argument::palette};
  const int entries = static_cast<int>(palette.size() / 3);
  if (index < 0 || index >= entries) return {Error::out_of_range, Argument::index};
  if (steps < 2 || steps > 256) return {Error::out_of_range, Argument::steps};
  if (step < 1 || step >= steps - 1) return {Error::out_of_range, Argument::position};
  if (row.size() < palette.size() / 3)
    return {Error::too_small, Argument::table, static_cast<std::uint32_t>(entries)};
  const auto colour = [&](int entry) {
    const std::size_t at = static_cast<std::size_t>(entry) * 3U;
    return Rgb{palette[at], palette[at + 1], palette[at + 2]};
  };
  for (int under = 0; under < entries; ++under)
    row[static_cast<std::size_t>(under)] = nearest_entry(
        palette,
        (space == BlendSpace::code ? mix_by<MixCodes> : mix)(colour(under), colour(index), step, steps - 1));
  return {};
}

/// Makes the table of the colour `index` over every entry of a palette, for 2 .. 256 steps, in the first
/// `BlendTable::bytes()` of `table`. Errors: palette (not 2 .. 256 whole entries: malformed), index (the
/// palette has none such), steps (outside 2 .. 256), table (too small: `needed()` bytes); nothing is written
/// then. Cost: about 10 instructions for each entry, step and candidate: 16 colours and 16 steps 40,000, 256
/// and 16 ten million.
[[nodiscard]] constexpr Status make_blend_table(std::span<std::uint8_t> table,
                                                std::span<const std::uint8_t> palette, int index, int steps,
                                                BlendSpace space = BlendSpace::light) noexcept {
  if (palette.size() % 3 != 0 || palette.size() < 6 || palette.size() > 768)
    return {Error::malformed, Argument::palette};
  const std::size_t entries = palette.size() / 3;
  const Result<BlendTable> checked = BlendTable::over(table, static_cast<int>(entries), index, steps);
  if (!checked.ok()) return checked.status();
  for (int step = 1; step < steps - 1; ++step)
    make_blend_row(table.subspan(static_cast<std::size_t>(step - 1) * entries), palette, index, step, steps,
                   space)
        .ignore();
  return {};
}

}  // namespace intaglio::image
