// SPDX-License-Identifier: MIT
//
// A write panel on USB that may be unplugged and plugged in again.
//
// Rule: what the program has sent is kept here. When the device is gone, it is looked for; once it is back,
// its controller is set up again and gets the whole picture, so the program notices nothing but the time that
// it took. That it is gone is seen by whatever is sent, and at each VBLANK.
#pragma once

#include <hal/clock.hpp>
#include <hal/hid/host/report_port.hpp>
#include <hal/panels/bufferless_panel.hpp>

#include <cstdint>
#include <functional>
#include <vector>

namespace hal::hid {

class ReplugPanel final : public panels::BufferlessPanel {
 public:
  /// Sets the controller up and clears its memory; called when the port is open again.
  using Restart = std::function<Status()>;

  /// `inner` is a write panel whose memory is all zeros now. It, the port behind it and the clock outlive
  /// this. Calls look for the device as long as `patience`; 0: not at all.
  ReplugPanel(Panel& inner, ReportPort& port, Clock& clock, Restart restart, Nanoseconds patience);

  /// How many times the device was gone and back.
  [[nodiscard]] std::uint64_t reconnects() const { return reconnects_; }

 private:
  /// Errors: those of `inner`; disconnected when patience ran out.
  Status do_write(const Rect& area, std::span<const std::uint8_t> pixels, int stride) noexcept override;
  Status do_load_palette(std::span<const std::uint8_t> palette) noexcept override;
  std::uint32_t do_vblank_count() noexcept override { return inner_->vblank_count(); }
  Status do_wait_for_vblank() noexcept override;

  /// Goes on after `s`.
  Status survive(Status s);
  Status restore();

  Panel* inner_;
  ReportPort* port_;
  Clock* clock_;
  Restart restart_;
  Nanoseconds patience_;
  int stride_;
  std::vector<std::uint8_t> picture_;
  std::vector<std::uint8_t> palette_;
  std::uint64_t reconnects_ = 0;
};

}  // namespace hal::hid
