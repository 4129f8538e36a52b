// SPDX-License-Identifier: MIT
//
// A screen of this machine as a panel with a palette: KMS, by libdrm, with dumb buffers and page flips.
//
// Rule: the program draws indices in memory of its own. `show` turns them to colours in a buffer that isn't
// displayed and asks the kernel to flip to it at the next VBLANK, so palette and frame change together. A
// `show` while a flip is under way waits for it, and then for the next VBLANK.
#pragma once

#include <hal/linux/screen_panel.hpp>
#include <hal/panels/frame_ticks.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace hal::linux_io {

/// The screens that `path`, a file of /dev/dri, has: "1920x1080" of those with something plugged in.
[[nodiscard]] std::vector<std::string> kms_screens(const std::string& path,
                                                   System& system = System::kernel());

class KmsPanel final : public ScreenPanel {
 public:
  /// `picture`: the program's size, enlarged by a whole number; {} is the whole screen. Throws DeviceError.
  explicit KmsPanel(const std::string& path, Extent picture = {}, System& system = System::kernel());
  /// Gives the screen back as it was.
  ~KmsPanel();

  /// Flips that have happened.
  [[nodiscard]] std::uint32_t flips() const noexcept { return flips_; }

 private:
  struct Screen;  // What libdrm knows of it.

  Status do_show(int index, std::span<const std::uint8_t> palette) noexcept override;
  bool do_show_pending() noexcept override;
  int do_on_display() noexcept override;
  Status do_load_palette(std::span<const std::uint8_t> palette) noexcept override;
  std::uint32_t do_vblank_count() noexcept override;
  Status do_wait_for_vblank() noexcept override;

  /// Puts a picture on one of the screen's buffers.
  void draw_on(std::size_t buffer, const Picture& picture) noexcept;
  Status flip(std::size_t to) noexcept;
  /// Takes notice of flips that have happened, waiting at most so long for one.
  Status take_events(int milliseconds) noexcept;
  void flipped() noexcept;
  /// Asks the kernel for its count, which `count_` is then. False: errno.
  bool query_vblank(bool wait) noexcept;

  std::unique_ptr<Screen> screen_;
  panels::FrameTicks ticks_;
  std::size_t shown_ = 0;  // Of the screen's buffers.
  std::optional<std::size_t> flipping_;
  std::optional<std::size_t> waiting_;  // For the flip under way.
  Picture asked_;                       // Of the last request, or on display.
  std::uint32_t flips_ = 0;
  std::uint32_t count_ = 0;  // Of the kernel's VBLANKs, as it was told last.
};

}  // namespace hal::linux_io
