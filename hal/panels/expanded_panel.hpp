// SPDX-License-Identifier: MIT
//
// A palette in front of a panel that has none: the program draws 256 colours, the panel shows its greys.
//
// Rule: an index becomes grey (expansion.hpp), and the grey one of the panel's 2, 4 or 16 levels: the
// nearest, or for a panel of two levels an ordered dither. Both depend on the colour and the place alone, so
// partial writes fit together whatever their borders. A write goes out in pieces as large as the workspace
// holds, each of whole aligned blocks.
#pragma once

#include <hal/panels/bufferless_panel.hpp>
#include <hal/panels/expansion.hpp>

#include <array>

namespace hal::panels {

class ExpandedPanel final : public BufferlessPanel {
 public:
  /// `inner` is a write panel of 1, 2 or 4 bits a pixel with fixed colours: even greys, black first or white
  /// first. `workspace` takes the pixels for one of its writes; it holds at least one block of the panel's
  /// alignment (8 bytes for an SSD1306) and had better hold a row of blocks (128 bytes). Both outlive this.
  ExpandedPanel(Panel& inner, std::span<std::uint8_t> workspace) noexcept;

 private:
  /// Errors: unsupported (panel) if `inner` isn't what it should be, invalid (buffer) if the workspace is too
  /// small, and those of `inner`.
  Status do_write(const Rect& area, std::span<const std::uint8_t> pixels, int stride) noexcept override;
  Status do_load_palette(std::span<const std::uint8_t> palette) noexcept override;
  std::uint32_t do_vblank_count() noexcept override { return inner_->vblank_count(); }
  Status do_wait_for_vblank() noexcept override { return inner_->wait_for_vblank(); }

  /// Makes and sends a part of a write that the workspace holds.
  Status write_part(const Rect& part, std::span<const std::uint8_t> pixels, int stride, int first) noexcept;
  /// The panel's index for grey at a place of the panel.
  [[nodiscard]] unsigned level(unsigned grey, int x, int y) const noexcept;

  Panel* inner_;
  std::span<std::uint8_t> workspace_;
  std::array<std::uint8_t, 256> greys_{};
};

}  // namespace hal::panels
