// SPDX-License-Identifier: MIT
//
// What all panels with memory of their own and fixed colours have in common.
#pragma once

#include <hal/panel.hpp>
#include <hal/panels/frame_ticks.hpp>

namespace hal::panels {

/// A write panel: a driver adds `do_write` and a start.
class WritePanel : public Panel {
 protected:
  /// `frame_clock` gives the rhythm of frames at `capabilities.refresh_millihertz`; null: no rhythm.
  WritePanel(const Capabilities& capabilities, Clock* frame_clock) noexcept
      : capabilities_(capabilities), ticks_(frame_clock, capabilities.refresh_millihertz) {}
  ~WritePanel() = default;

 private:
  const Capabilities& do_capabilities() const noexcept final { return capabilities_; }
  std::span<std::uint8_t> do_buffer(int) noexcept final { return {}; }
  int do_buffer_stride() const noexcept final { return 0; }
  Status do_show(int, std::span<const std::uint8_t>) noexcept final {
    return {Error::unsupported, Part::buffer};
  }
  bool do_show_pending() noexcept final { return false; }
  Status do_load_palette(std::span<const std::uint8_t>) noexcept final {
    return {Error::unsupported, Part::palette};
  }
  std::uint32_t do_vblank_count() noexcept final { return ticks_.count(); }
  Status do_wait_for_vblank() noexcept final {
    ticks_.wait();
    return {};
  }

  Capabilities capabilities_;
  FrameTicks ticks_;
};

}  // namespace hal::panels
