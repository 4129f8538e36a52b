// SPDX-License-Identifier: MIT
//
// What all panels without frame buffers have in common: pixels are written to them, and nothing else works.
#pragma once

#include <hal/panel.hpp>

namespace hal::panels {

/// A panel that refuses what is for frame buffers. One kind of it adds `do_write`, `do_load_palette` and a
/// rhythm of frames.
class BufferlessPanel : public Panel {
 protected:
  explicit BufferlessPanel(const Capabilities& capabilities) noexcept : capabilities_(capabilities) {}
  ~BufferlessPanel() = default;

 private:
  const Capabilities& do_capabilities() const noexcept final { return capabilities_; }
  std::span<std::uint8_t> do_buffer(int) noexcept final { return {}; }
  int do_buffer_stride() const noexcept final { return 0; }
  Status do_show(int, std::span<const std::uint8_t>) noexcept final {
    return {Error::unsupported, Part::buffer};
  }
  bool do_show_pending() noexcept final { return false; }

  Capabilities capabilities_;
};

}  // namespace hal::panels
