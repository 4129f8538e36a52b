// SPDX-License-Identifier: MIT
//
// Coverage over a mixed background: each pixel becomes the palette's nearest colour to the mixture of what is
// there and what covers it.
//
// Rule: a level of coverage is the nearest step of a blend table (image/blend_table.hpp); the pixel's index
// is replaced by the table's. Step 0 leaves the pixel as it is, the last step stores the colour's index. Bit
// budget: a look in a table. Error: 1/2 step, and what the table says of its entries.
// Textbook: section 2.8. Worst known input: two polygons that share an edge, one drawn over the other's
// blended pixels: the background shows through them by up to a quarter (coverage says how much, not where);
// raster/visible_area.hpp has the remedy.
#pragma once

#include <intaglio/image/blend_table.hpp>
#include <intaglio/image/surface.hpp>
#include <intaglio/raster/coverage.hpp>
#include <intaglio/raster/coverage_step.hpp>
#include <intaglio/raster/solid.hpp>
#include <intaglio/status.hpp>

#include <cstdint>

namespace intaglio::raster {

/// Blends the colour of a table into a surface.
template <image::PixelFormat F>
class BlendCoverage {
 public:
  /// `clip` as that of `Solid`; the table's memory must stay. Errors: table (made for a palette of fewer
  /// entries than the format has indices: too_small; `needed()` is how many), index (the format has none
  /// such).
  [[nodiscard]] static constexpr Result<BlendCoverage> over(const image::Surface<F>& surface,
                                                            const image::BlendTable& table,
                                                            const linear::Rect& clip) noexcept {
    if (table.entries() <= static_cast<int>(F::max_index))
      return Status{Error::too_small, Argument::table, F::max_index + 1};
    if (table.index() > static_cast<int>(F::max_index)) return Status{Error::out_of_range, Argument::index};
    return BlendCoverage(surface, table, clip);
  }
  /// The same on all of the surface.
  [[nodiscard]] static constexpr Result<BlendCoverage> over(const image::Surface<F>& surface,
                                                            const image::BlendTable& table) noexcept {
    return over(surface, table, surface.bounds());
  }

  /// Draws nothing.
  constexpr BlendCoverage() noexcept : solid_({}, 0) {}

  /// Where it can draw.
  [[nodiscard]] constexpr const linear::Rect& clip() const noexcept { return solid_.clip(); }
  /// Blends the pixels x_begin .. x_end-1 of row y. Precondition: they are inside the clip; x_begin < x_end.
  void span(int y, int x_begin, int x_end, int coverage) const noexcept {
    const int last = table_.steps() - 1;
    const auto step = static_cast<int>(coverage_step(coverage, static_cast<unsigned>(last)));
    if (step == 0) return;
    if (step == last) {
      solid_.span(y, x_begin, x_end);
      return;
    }
    const std::uint8_t* const blended = table_.row(step);
    const image::Surface<F>& surface = solid_.surface();
    if constexpr (F::bits == 8) {
      std::uint8_t* pixel = surface.byte_at(x_begin, y);
      for (std::uint8_t* const end = pixel + (x_end - x_begin); pixel != end; ++pixel)
        *pixel = blended[*pixel];
    } else {
      for (int x = x_begin; x < x_end; ++x) surface.set(x, y, blended[surface.get(x, y)]);
    }
  }

 private:
  constexpr BlendCoverage(const image::Surface<F>& surface, const image::BlendTable& table,
                          const linear::Rect& clip) noexcept
      : solid_(surface, static_cast<unsigned>(table.index()), clip), table_(table) {}

  Solid<F> solid_;
  image::BlendTable table_;
};

static_assert(CoverageSink<BlendCoverage<image::Indexed8>> && CoverageSink<BlendCoverage<image::Indexed4>>);

}  // namespace intaglio::raster
