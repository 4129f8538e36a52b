// SPDX-License-Identifier: MIT
//
// Frame buffer devices that aren't there, of the kinds there are.
#include <hal/linux/fb_panel.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <linux/fb.h>
#include <string>
#include <sys/ioctl.h>
#include <vector>

namespace {

using hal::Error;
using hal::linux_io::DeviceError;
using hal::linux_io::Extent;
using hal::linux_io::FbPanel;
using hal::linux_io::System;
using testing::AllOf;
using testing::HasSubstr;

/// A device of 20x10 pixels, refreshed 500 times a second so that tests needn't wait.
class Device final : public System {
 public:
  explicit Device(unsigned bits, bool pans = true) {
    mode.xres = mode.xres_virtual = 20;
    mode.yres = mode.yres_virtual = 10;
    mode.pixclock = 10'000'000;  // Picoseconds: 20 * 10 pixels take 2 ms.
    set_bits(bits);
    fixed.ypanstep = pans ? 1 : 0;
    std::memcpy(fixed.id, "sixteen letters.", sizeof fixed.id);
    memory.resize(std::size_t{64} * 40);
    fixed.smem_len = static_cast<std::uint32_t>(memory.size());
    settle();
    red.resize(256, 0xABCD);
  }
  ~Device() override {
    EXPECT_EQ(open_files, 0) << "files are still open";
    EXPECT_EQ(maps, 0) << "memory is still mapped";
  }

  void set_bits(unsigned bits) {
    mode.bits_per_pixel = bits;
    fixed.visual = bits == 8 ? FB_VISUAL_PSEUDOCOLOR : FB_VISUAL_TRUECOLOR;
    if (bits == 16) {
      mode.red = {11, 5, 0};
      mode.green = {5, 6, 0};
      mode.blue = {0, 5, 0};
    } else {
      mode.red = {16, 8, 0};
      mode.green = {8, 8, 0};
      mode.blue = {0, 8, 0};
    }
  }

  int open(const char*, int) override {
    if (open_error != 0) return fail(open_error);
    ++open_files;
    return 5;
  }
  int close(int) override {
    --open_files;
    return 0;
  }
  void* map(int, std::size_t, off_t) override {
    if (map_error != 0) {
      errno = map_error;
      return nullptr;
    }
    ++maps;
    return memory.data();
  }
  void unmap(void*, std::size_t) override { --maps; }
  int ioctl(int, unsigned long request, void* argument) override {
    if (fault != 0) return fail(fault);
    switch (request) {
      case FBIOGET_VSCREENINFO:
        *static_cast<fb_var_screeninfo*>(argument) = mode;
        return 0;
      case FBIOGET_FSCREENINFO:
        *static_cast<fb_fix_screeninfo*>(argument) = fixed;
        return 0;
      case FBIOPUT_VSCREENINFO:
        if (fixed_mode) return fail(EINVAL);
        mode = *static_cast<fb_var_screeninfo*>(argument);
        settle();
        return 0;
      case FBIOGETCMAP: {
        const auto& map = *static_cast<fb_cmap*>(argument);
        std::copy(red.begin(), red.end(), map.red);
        return 0;
      }
      case FBIOPUTCMAP: {
        const auto& map = *static_cast<fb_cmap*>(argument);
        red.assign(map.red, map.red + map.len);
        happened.emplace_back("colours");
        return 0;
      }
      case FBIOPAN_DISPLAY:
        if (fixed.ypanstep == 0) return fail(EINVAL);
        mode.yoffset = static_cast<fb_var_screeninfo*>(argument)->yoffset;
        happened.emplace_back("pan");
        return 0;
      case FBIO_WAITFORVSYNC:
        ++waits;
        return tells_vblanks ? 0 : fail(ENOTTY);
      default:
        return fail(ENOTTY);
    }
  }

  /// What is on display, as it lies in memory.
  [[nodiscard]] std::uint32_t pixel(unsigned x, unsigned y) const {
    const unsigned bytes = mode.bits_per_pixel / 8U;
    std::uint32_t value = 0;
    for (unsigned i = 0; i < bytes; ++i)
      value |= static_cast<std::uint32_t>(memory.at((y + mode.yoffset) * fixed.line_length + x * bytes + i))
               << 8U * i;
    return value;
  }

  fb_var_screeninfo mode{};
  fb_fix_screeninfo fixed{};
  std::vector<std::uint8_t> memory;
  std::vector<std::uint16_t> red;
  std::vector<std::string> happened;
  bool fixed_mode = false;
  bool tells_vblanks = false;
  int waits = 0;
  int fault = 0;
  int open_error = 0;
  int map_error = 0;
  int open_files = 0;
  int maps = 0;

 private:
  static int fail(int error) {
    errno = error;
    return -1;
  }
  void settle() {
    const unsigned row = mode.xres * mode.bits_per_pixel / 8U + 8U;
    fixed.line_length = row;
    memory.resize(std::max<std::size_t>(memory.size(), std::size_t{row} * mode.yres_virtual));
    fixed.smem_len = static_cast<std::uint32_t>(memory.size());
  }
};

std::vector<std::uint8_t> ramp() {
  std::vector<std::uint8_t> colours;
  for (int i = 0; i < 256; ++i)
    for (const int step : {1, 3, 5}) colours.push_back(static_cast<std::uint8_t>(i * step));
  return colours;
}

/// Draws (a row at a time, for rows may lie apart) and shows.
void show(FbPanel& panel, int index, std::uint8_t seed) {
  const hal::Capabilities& c = panel.capabilities();
  const std::span<std::uint8_t> pixels = panel.buffer(index);
  for (int y = 0; y < c.height; ++y)
    for (int x = 0; x < c.width; ++x)
      pixels[static_cast<std::size_t>(y * panel.buffer_stride() + x)] =
          static_cast<std::uint8_t>(seed + 7 * x + 3 * y);
  ASSERT_TRUE(panel.show(index, ramp()).ok());
}

TEST(FrameBuffer, PseudoColourPansBetweenPicturesInItsOwnMemory) {
  Device device(8);
  FbPanel panel("/dev/fb0", {}, device);
  EXPECT_TRUE(panel.has_hardware_palette());
  EXPECT_TRUE(panel.pans());
  EXPECT_EQ(panel.buffer_stride(), 28);
  EXPECT_EQ(panel.buffer(1).data(), device.memory.data() + 280);
  for (int i = 1; i < 20; ++i) {
    device.happened.clear();
    show(panel, i % 2, static_cast<std::uint8_t>(i));
    EXPECT_TRUE(device.happened.empty() || !panel.show_pending()) << "before the VBLANK";
    while (panel.show_pending()) ASSERT_TRUE(panel.wait_for_vblank().ok());
    EXPECT_THAT(device.happened, testing::ElementsAre("colours", "pan"));
    EXPECT_EQ(device.mode.yoffset, i % 2 == 1 ? 10U : 0U);
    EXPECT_EQ(device.pixel(3, 4), static_cast<std::uint8_t>(i + 33));
    EXPECT_EQ(device.red[200], 200 * 257);
  }
}

TEST(FrameBuffer, PseudoColourThatCanNotPanIsCopied) {
  Device device(8, false);
  FbPanel panel("/dev/fb0", {}, device);
  EXPECT_TRUE(panel.has_hardware_palette());
  EXPECT_FALSE(panel.pans());
  show(panel, 1, 9);
  while (panel.show_pending()) ASSERT_TRUE(panel.wait_for_vblank().ok());
  EXPECT_EQ(device.pixel(3, 4), 9U + 33U);
  EXPECT_EQ(device.pixel(19, 9), static_cast<std::uint8_t>(9 + 133 + 27));
}

TEST(FrameBuffer, RealColoursAreMadeOfThePalette) {
  for (const unsigned bits : {16U, 24U, 32U})
    for (const bool pans : {false, true}) {
      Device device(bits, pans);
      FbPanel panel("/dev/fb0", {}, device);
      EXPECT_FALSE(panel.has_hardware_palette());
      EXPECT_EQ(panel.pans(), pans);
      show(panel, 1, 50);
      while (panel.show_pending()) ASSERT_TRUE(panel.wait_for_vblank().ok());
      const unsigned index = 50 + 7 * 3 + 3 * 4;
      const unsigned red = index & 255U;
      const unsigned green = 3U * index & 255U;
      const unsigned blue = 5U * index & 255U;
      EXPECT_EQ(device.pixel(3, 4), bits == 16 ? (red >> 3U) << 11U | (green >> 2U) << 5U | blue >> 3U
                                               : red << 16U | green << 8U | blue)
          << bits;
    }
}

TEST(FrameBuffer, ASizeIsAskedForAndElseThePictureIsEnlarged) {
  {
    Device device(8);
    FbPanel panel("/dev/fb0", {16, 12}, device);
    EXPECT_EQ(device.mode.xres, 16U);
    EXPECT_EQ(device.mode.yres_virtual, 24U);
    EXPECT_TRUE(panel.pans());
  }
  Device device(32);
  device.fixed_mode = true;
  FbPanel panel("/dev/fb0", {9, 5}, device);
  EXPECT_EQ(panel.capabilities().width, 9);
  show(panel, 1, 0);
  while (panel.show_pending()) ASSERT_TRUE(panel.wait_for_vblank().ok());
  EXPECT_EQ(device.pixel(0, 0), 0U) << "18x10 in the middle of 20x10";
  EXPECT_EQ(device.pixel(1 + 4, 2), (7U * 2U + 3U) * 0x010305U);
  EXPECT_EQ(device.pixel(1 + 5, 3), (7U * 2U + 3U) * 0x010305U);
}

TEST(FrameBuffer, VblanksAreTheDevicesWhereItTellsThem) {
  Device device(8);
  device.tells_vblanks = true;
  FbPanel panel("/dev/fb0", {}, device);
  EXPECT_TRUE(panel.tells_vblanks());
  EXPECT_EQ(panel.capabilities().refresh_millihertz, 500'000U);
  const std::uint32_t before = panel.vblank_count();
  const int waits = device.waits;
  ASSERT_TRUE(panel.wait_for_vblank().ok());
  EXPECT_EQ(device.waits, waits + 1);
  EXPECT_GT(panel.vblank_count(), before);
}

TEST(FrameBuffer, TheDeviceIsLeftBlankAndAsItWas) {
  Device device(8);
  const fb_var_screeninfo before = device.mode;
  {
    FbPanel panel("/dev/fb0", {16, 12}, device);
    show(panel, 1, 9);
    while (panel.show_pending()) ASSERT_TRUE(panel.wait_for_vblank().ok());
  }
  EXPECT_EQ(device.mode.xres, before.xres);
  EXPECT_EQ(device.mode.yres_virtual, before.yres_virtual);
  EXPECT_EQ(device.red[7], 0xABCD);
  EXPECT_TRUE(std::ranges::all_of(device.memory, [](std::uint8_t byte) { return byte == 0; }));
}

TEST(FrameBuffer, APictureCanBeKept) {
  Device device(8);
  {
    FbPanel panel("/dev/fb0", {}, device);
    show(panel, 1, 9);
    while (panel.show_pending()) ASSERT_TRUE(panel.wait_for_vblank().ok());
    panel.keep();
  }
  EXPECT_EQ(device.pixel(3, 4), 42U);
}

TEST(FrameBuffer, FaultsNameTheDevice) {
  Device device(8);
  FbPanel panel("/dev/fb0", {}, device);
  show(panel, 1, 9);
  device.fault = ENODEV;
  EXPECT_EQ(panel.wait_for_vblank().error(), Error::disconnected);
  EXPECT_THAT(panel.fault(), AllOf(HasSubstr("frame buffer /dev/fb0"), HasSubstr("gone")));
}

std::string refusal(Device& device, Extent picture = {}) {
  try {
    FbPanel("/dev/fb0", picture, device);
  } catch (const DeviceError& error) {
    return error.what();
  }
  return "it was accepted";
}

TEST(FrameBuffer, WhatCanNotBeHadIsSaid) {
  Device device(8);
  device.open_error = EACCES;
  EXPECT_THAT(refusal(device), HasSubstr("frame buffer /dev/fb0: permission denied; "));
  device.open_error = 0;
  device.fault = ENOTTY;
  EXPECT_THAT(refusal(device), HasSubstr("/dev/fb0 is no frame buffer"));
  device.fault = 0;
  device.map_error = ENOMEM;
  EXPECT_THAT(refusal(device), HasSubstr("memory can't be mapped"));
  device.map_error = 0;
  device.fixed_mode = true;
  EXPECT_THAT(refusal(device, {21, 10}), HasSubstr("20x10 pixels, too few for 21x10"));
  Device odd(4);
  EXPECT_THAT(refusal(odd), HasSubstr("4 bits"));
  EXPECT_EQ(hal::linux_io::fb_description("/dev/fb0", odd), "sixteen letters., 20x10, 4 bits a pixel");
}

}  // namespace
