// SPDX-License-Identifier: MIT
//
// A graphics card that isn't there; library.cpp is libdrm's interface to it, linked in place of the library.
#pragma once

#include <hal/linux/system.hpp>
#include <hal/sim/virtual_clock.hpp>

#include <cstdint>
#include <map>
#include <set>
#include <vector>

namespace fake_card {

/// Engines by their place in the card's list, where `none` drives nothing.
constexpr int none = -1;

struct Buffer {
  std::uint32_t stride = 0;
  std::vector<std::uint8_t> memory;
};

struct Card {
  int width = 100;
  int height = 70;
  bool plugged_in = true;
  bool has_dumb_buffers = true;
  bool tells_vblanks = true;
  bool flips_stick = false;    ///< They never happen.
  bool flips_at_once = false;  ///< They don't wait for the VBLANK.
  std::uint32_t clock = 0;     ///< kHz of the mode, whose lines and columns count blanking, too.
  std::uint16_t total_width = 0, total_height = 0;
  std::uint32_t mode_flags = 0;
  std::uint32_t refresh = 60;
  std::uint32_t pitch_lie = 0;  ///< What the driver says of buffers instead of the truth, unless 0.
  std::uint64_t size_lie = 0;
  int engines = 1;
  int driven_by = none;        ///< The engine of our screen,
  int other_driven_by = none;  ///< and of another.
  int resources_error = 0;
  int set_error = 0;
  int flip_error = 0;
  int flips_left = 1 << 30;  ///< Before they fail with `flip_error`.
  int vblank_error = 0;
  int signals = 0;                 ///< Waits that end early for one.
  std::uint32_t shown_before = 0;  ///< A frame buffer of whoever had the screen; 0: it was off.

  std::map<std::uint32_t, Buffer> buffers;               ///< By handle.
  std::map<std::uint32_t, std::uint32_t> frame_buffers;  ///< Handles by frame buffer.
  std::uint32_t shown = 0;                               ///< The frame buffer; 0: off.
  int engine = none;                                     ///< That was set last.
  std::uint32_t flip_to = 0;                             ///< 0: no flip is under way.
  std::uint32_t sequence = 41;
  std::vector<void*> events;
  void* flip_data = nullptr;
  int maps = 0;

  /// The next VBLANK.
  void vblank();
  /// XRGB of the pixel on display, 0 while off.
  [[nodiscard]] std::uint32_t pixel(int x, int y) const;
};

Card& card();
void reset();

class Kernel final : public hal::linux_io::System {
 public:
  int open(const char* path, int flags) override;
  int close(int file) override;
  int poll(pollfd* files, unsigned count, int milliseconds) override;
  void* map(int file, std::size_t size, std::uint64_t offset) override;
  void unmap(void* memory, std::size_t size) override;
  hal::Clock& clock() override { return time; }
  hal::sim::VirtualClock time;
  int open_error = 0;
  int open_files = 0;
};

}  // namespace fake_card
