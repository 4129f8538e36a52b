// SPDX-License-Identifier: MIT
//
// A display controller behind a bus, as whoever switches it on and off sees it.
#pragma once

#include <hal/panels/write_panel.hpp>

namespace hal::panels {

class BusPanel : public WritePanel {
 public:
  /// Sets the controller up, clears its memory and switches the display on. After a reset, before anything
  /// else; may be called again at any time, after a fault too. Errors: bus, pin, panel (options that the
  /// controller can't take).
  Status start() noexcept { return do_start(); }
  /// Blanks the display and puts the controller to sleep. Tries every step even when one fails, and answers
  /// the first error; `start` wakes it.
  Status stop() noexcept { return do_stop(); }
  /// Puts the controller to sleep or wakes it; what it shows is kept. Waits as long as the data sheet asks.
  Status sleep(bool asleep) noexcept { return do_sleep(asleep); }
  /// 0: darkest, 255: brightest. Errors: unsupported (command) where the controller has no such register.
  Status set_contrast(std::uint8_t contrast) noexcept { return do_set_contrast(contrast); }

 protected:
  using WritePanel::WritePanel;
  ~BusPanel() = default;

 private:
  virtual Status do_start() noexcept = 0;
  virtual Status do_stop() noexcept = 0;
  virtual Status do_sleep(bool asleep) noexcept = 0;
  virtual Status do_set_contrast(std::uint8_t) noexcept { return {Error::unsupported, Part::command}; }
};

}  // namespace hal::panels
