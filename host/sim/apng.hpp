// SPDX-License-Identifier: MIT
//
// Writes animated PNG files (PNG, Third Edition, chunks acTL, fcTL and fdAT), picture by picture, so that a
// long recording needs no more memory than two pictures.
//
// Rule: the file opens as a still picture of the first frame in viewers that know no animation. A frame holds
// only the rectangle that differs from the one before it. The number of frames stands near the file's
// beginning, so it is filled in by `finish`; a file that isn't finished goes away with its writer.
// Colours are stored in full (8 bits a channel) because palettes may change from frame to frame.
#pragma once

#include <host/sim/rgb_picture.hpp>

#include <cstdint>
#include <fstream>
#include <span>
#include <string>
#include <vector>

namespace host {

class ApngWriter {
 public:
  /// Starts the file. `frames_per_second` is 1..65535. Throws Failure if it can't be written.
  ApngWriter(const std::string& path, int width, int height, int frames_per_second);
  ApngWriter(const ApngWriter&) = delete;
  ApngWriter& operator=(const ApngWriter&) = delete;
  ~ApngWriter();

  /// Appends a frame of the size named at the start. Throws Failure on a wrong size or a failed
  /// write.
  void add(const RgbPicture& picture);
  /// Ends the file; at least one frame must have been added. Throws Failure if a write failed.
  void finish();

  [[nodiscard]] std::uint32_t frames() const { return frames_; }

 private:
  struct Area {
    int x, y, width, height;
  };
  [[nodiscard]] Area changed(const RgbPicture& picture) const;
  void write_chunk(const char (&type)[5], std::span<const std::uint8_t> data);
  void write_animation_control();

  std::string path_;
  std::ofstream file_;
  std::ofstream::pos_type animation_control_{};
  int frames_per_second_;
  bool finished_ = false;
  std::uint32_t frames_ = 0;
  std::uint32_t sequence_ = 0;
  RgbPicture last_;
};

}  // namespace host
