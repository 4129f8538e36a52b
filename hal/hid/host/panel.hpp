// SPDX-License-Identifier: MIT
//
// A display that speaks the report protocol, as a panel of this program.
//
// Rule: the panel has two frame buffers here. `show` sends what differs from the frame before (bytes that
// stay are skipped, runs are packed), then the checksum of the whole, and returns when the device has
// accepted it; buffer and colours take effect together at the device's next VBLANK. A frame that the device
// refuses is sent again, whole. So is the first one after the device was gone.
//
// The device gone: every call answers `Error::disconnected` until it is back, and `show` looks for it each
// time. With a `replug_patience` `show` and `wait_for_vblank` wait so long for it, and show again what was on
// display. Its serial number and its capabilities must be the same.
#pragma once

#include <hal/hid/host/link.hpp>
#include <hal/input.hpp>
#include <hal/panel.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace hal::hid {

struct HidPanelOptions {
  /// How long a call waits for a device that was unplugged.
  Nanoseconds replug_patience = 0;
};

/// What happened so far.
struct HidPanelCounters {
  std::uint64_t frames = 0;      ///< accepted by the device
  std::uint64_t whole = 0;       ///< of these sent whole
  std::uint64_t rejected = 0;    ///< refused by the device
  std::uint64_t reconnects = 0;  ///< sessions after the first
};

class HidPanel final : public Panel {
 public:
  /// A panel on a link that was opened; it outlives the panel.
  explicit HidPanel(Link& link, const HidPanelOptions& options = {});

  [[nodiscard]] const HidPanelCounters& counters() const { return counters_; }
  /// False while the device is gone.
  [[nodiscard]] bool connected() const { return connected_; }

 private:
  const Capabilities& do_capabilities() const noexcept override { return capabilities_; }
  std::span<std::uint8_t> do_buffer(int index) noexcept override {
    return buffers_[static_cast<std::size_t>(index)];
  }
  int do_buffer_stride() const noexcept override { return static_cast<int>(row_bytes_); }
  Status do_show(int index, std::span<const std::uint8_t> palette) noexcept override;
  bool do_show_pending() noexcept override;
  Status do_write(const Rect&, std::span<const std::uint8_t>, int) noexcept override {
    return {Error::unsupported, Part::buffer};
  }
  Status do_load_palette(std::span<const std::uint8_t> palette) noexcept override;
  std::uint32_t do_vblank_count() noexcept override;
  Status do_wait_for_vblank() noexcept override;

  Status present(std::span<const std::uint8_t> picture);
  Status send_frame(std::span<const std::uint8_t> picture);
  Status send_palette();
  Status send_rect(const Rect& area, std::span<const std::uint8_t> picture);
  Status reconnect();
  Status recover();
  [[nodiscard]] Rect difference(std::span<const std::uint8_t> picture) const;
  [[nodiscard]] bool pending() const { return committed_ != 0 && link_->state().shown != committed_; }
  [[nodiscard]] Nanoseconds period() const { return 1'000'000'000'000U / capabilities_.refresh_millihertz; }
  [[nodiscard]] Nanoseconds vblank_patience() const;
  /// How long until the device should have told of the next VBLANK.
  [[nodiscard]] Nanoseconds next_vblank() const;
  Status note(const Status& status);

  Link* link_;
  HidPanelOptions options_;
  Capabilities capabilities_;
  std::size_t row_bytes_;
  std::array<std::vector<std::uint8_t>, 2> buffers_;
  std::vector<std::uint8_t> palette_;
  HidPanelCounters counters_;

  /// What the device holds, if that is known.
  std::vector<std::uint8_t> held_;
  std::vector<std::uint8_t> held_palette_;
  bool known_ = false;
  bool shown_before_ = false;
  bool connected_ = true;
  std::uint16_t frame_ = 0;
  /// The frame that was accepted last in this session; 0: none.
  std::uint16_t committed_ = 0;
  /// VBLANKs of the sessions before this one.
  std::uint32_t vblanks_before_ = 0;
};

/// The keys of such a display.
class HidInput final : public Input {
 public:
  explicit HidInput(Link& link) noexcept : link_(&link) {}

 private:
  Keys do_poll() noexcept override;

  Link* link_;
};

}  // namespace hal::hid
