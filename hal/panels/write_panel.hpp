// SPDX-License-Identifier: MIT
//
// What all drivers of panels with memory of their own have in common.
#pragma once

#include <hal/panels/bufferless_panel.hpp>
#include <hal/panels/frame_ticks.hpp>

namespace hal::panels {

/// A write panel: a driver adds `do_write`, a start, and `do_load_palette` if it has one.
class WritePanel : public BufferlessPanel {
 protected:
  /// `vblank` gives the rhythm of frames, as a tearing-effect line does; null: `frame_clock` does at
  /// `capabilities.refresh_millihertz` (at least 1); both null: no rhythm. Both outlive the panel.
  /// `capabilities.vblank_signal` is set to what is true.
  WritePanel(const Capabilities& capabilities, Clock* frame_clock, VblankSource* vblank = nullptr) noexcept
      : BufferlessPanel(told_by(vblank, capabilities)),
        ticks_(frame_clock, capabilities.refresh_millihertz),
        vblank_(vblank) {}
  ~WritePanel() = default;

  Status do_load_palette(std::span<const std::uint8_t>) noexcept override {
    return {Error::unsupported, Part::palette};
  }

 private:
  static Capabilities told_by(const VblankSource* vblank, Capabilities capabilities) noexcept {
    capabilities.vblank_signal = vblank != nullptr;
    return capabilities;
  }
  std::uint32_t do_vblank_count() noexcept final { return rhythm().count(); }
  Status do_wait_for_vblank() noexcept final { return rhythm().wait(); }
  VblankSource& rhythm() noexcept { return vblank_ != nullptr ? *vblank_ : ticks_; }

  FrameTicks ticks_;
  VblankSource* vblank_;
};

}  // namespace hal::panels
