// SPDX-License-Identifier: MIT
//
// A graphics card that isn't there; library.cpp is libdrm's interface to it, linked in place of the library.
#pragma once

#include <hal/linux/system.hpp>

#include <cstdint>
#include <map>
#include <set>
#include <vector>

namespace fake_card {

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
  bool flips_stick = false;  ///< They never happen.
  int resources_error = 0;
  int set_error = 0;
  int flip_error = 0;
  std::uint32_t shown_before = 0;  ///< A frame buffer of whoever had the screen; 0: it was off.

  std::map<std::uint32_t, Buffer> buffers;               ///< By handle.
  std::map<std::uint32_t, std::uint32_t> frame_buffers;  ///< Handles by frame buffer.
  std::uint32_t shown = 0;                               ///< The frame buffer; 0: off.
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
  void* map(int file, std::size_t size, off_t offset) override;
  void unmap(void* memory, std::size_t size) override;
  int open_error = 0;
  int open_files = 0;
};

}  // namespace fake_card
