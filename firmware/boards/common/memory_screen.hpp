// SPDX-License-Identifier: MIT
//
// A screen without a panel: frames are drawn into memory and nobody sees them. For cores that QEMU gives no
// display; their digests tell whether they draw the same bits.
#pragma once

#include <intaglio/image/surface.hpp>
#include <intaglio/present/screen_info.hpp>

#include <cstdint>
#include <span>

namespace boards {

template <intaglio::image::PixelFormat F>
class MemoryScreen {
 public:
  using Format = F;

  /// Draws frames of this size into `memory`.
  MemoryScreen(std::span<std::uint8_t> memory, const intaglio::present::ScreenInfo& info) noexcept
      : frame_(intaglio::image::Surface<F>::over(memory, info.size)), info_(info) {}

  [[nodiscard]] intaglio::Status status() const noexcept { return frame_.status(); }
  [[nodiscard]] intaglio::present::ScreenInfo info() const noexcept { return info_; }

  /// Draws a frame and hands it to `watch`.
  template <class Draw, class Watch>
  [[nodiscard]] intaglio::Status present(const Draw& draw, std::span<const std::uint8_t>, Watch&& watch) {
    if (const intaglio::Status s = draw(frame_.value()); !s.ok()) return s;
    watch(intaglio::image::Picture<F>(frame_.value()));
    return {};
  }
  [[nodiscard]] intaglio::Status wait_until_shown() noexcept { return {}; }
  [[nodiscard]] std::uint32_t missed_deadlines() const noexcept { return 0; }

 private:
  intaglio::Result<intaglio::image::Surface<F>> frame_;
  intaglio::present::ScreenInfo info_;
};

}  // namespace boards
