// SPDX-License-Identifier: MIT
//
// Frame buffer devices that aren't there, of the kinds there are.
#include <hal/linux/fb_panel.hpp>
#include <hal/sim/virtual_clock.hpp>
#include <intaglio/present/swap_chain.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <linux/fb.h>
#include <optional>
#include <string>
#include <sys/ioctl.h>
#include <utility>
#include <vector>

namespace {

using hal::Error;
using hal::linux_io::DeviceError;
using hal::linux_io::Extent;
using hal::linux_io::FbPanel;
using hal::linux_io::System;
using testing::AllOf;
using testing::HasSubstr;

/// A device of 20x10 pixels, refreshed 500 times a second, in virtual time.
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
  void* map(int, std::size_t size, std::uint64_t) override {
    EXPECT_EQ(size, fixed.smem_start % 4096U + fixed.smem_len);
    if (map_error != 0) {
      errno = map_error;
      return nullptr;
    }
    ++maps;
    return memory.data();
  }
  void unmap(void*, std::size_t) override { --maps; }
  int ioctl(int, unsigned long request, void* argument) override {
    if (signals > 0 && signals-- > 0) return fail(EINTR);
    if (fault != 0) return fail(fault);
    if (request == failing) return fail(failure);
    switch (request) {
      case FBIOGET_VSCREENINFO:
        *static_cast<fb_var_screeninfo*>(argument) = mode;
        return 0;
      case FBIOGET_FSCREENINFO:
        *static_cast<fb_fix_screeninfo*>(argument) = fixed;
        if (row_lie) static_cast<fb_fix_screeninfo*>(argument)->line_length = *row_lie;
        if (memory_lie) static_cast<fb_fix_screeninfo*>(argument)->smem_len = *memory_lie;
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
        green.assign(map.green, map.green + map.len);
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
        if (!tells_vblanks) return fail(ENOTTY);
        if (waits_for_vblank) time.advance(refresh);
        return 0;
      default:
        return fail(ENOTTY);
    }
  }

  hal::Clock& clock() override { return time; }
  /// The next VBLANK.
  void vblank() { time.advance(refresh); }

  /// What is on display, as it lies in memory.
  [[nodiscard]] std::uint32_t pixel(unsigned x, unsigned y) const {
    const unsigned bytes = mode.bits_per_pixel / 8U;
    std::uint32_t value = 0;
    for (unsigned i = 0; i < bytes; ++i)
      value |= static_cast<std::uint32_t>(memory.at((y + mode.yoffset) * fixed.line_length + x * bytes + i))
               << 8U * i;
    return value;
  }

  static constexpr hal::Nanoseconds refresh = 2'000'000;
  hal::sim::VirtualClock time;
  fb_var_screeninfo mode{};
  fb_fix_screeninfo fixed{};
  std::optional<std::uint32_t> row_lie, memory_lie;
  std::vector<std::uint8_t> memory;
  std::vector<std::uint16_t> red, green;
  std::vector<std::string> happened;
  bool fixed_mode = false;
  bool tells_vblanks = false;
  bool waits_for_vblank = true;
  int waits = 0;
  int signals = 0;            ///< Requests that end early for one.
  int fault = 0;              ///< Of every request,
  unsigned long failing = 0;  ///< of this one.
  int failure = EIO;
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
    const std::size_t start = fixed.smem_start % 4096U;
    memory.resize(std::max<std::size_t>(memory.size(), start + std::size_t{row} * mode.yres_virtual));
    fixed.smem_len = static_cast<std::uint32_t>(memory.size() - start);
  }
};

std::vector<std::uint8_t> ramp() {
  std::vector<std::uint8_t> colours;
  for (int i = 0; i < 256; ++i)
    for (const int step : {1, 3, 5}) colours.push_back(static_cast<std::uint8_t>(i * step));
  return colours;
}

std::string refusal(Device& device, Extent picture = {}) {
  try {
    FbPanel("/dev/fb0", picture, device);
  } catch (const DeviceError& error) {
    return error.what();
  }
  return "it was accepted";
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

TEST(FrameBuffer, ASmallPictureOfADeviceThatLooksColoursUpLiesInTheMiddleToo) {
  Device device(8);
  device.mode.yres_virtual = 20;
  device.memory.assign(device.memory.size(), 0x55);
  device.fixed_mode = true;
  FbPanel panel("/dev/fb0", {9, 5}, device);
  EXPECT_FALSE(panel.pans());
  show(panel, 1, 0);
  while (panel.show_pending()) ASSERT_TRUE(panel.wait_for_vblank().ok());
  EXPECT_EQ(device.pixel(0, 0), 0U) << "18x10 in the middle of 20x10";
  EXPECT_EQ(device.pixel(1 + 4, 2), 7U * 2U + 3U);
  EXPECT_EQ(device.pixel(1 + 5, 3), 7U * 2U + 3U);
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

TEST(FrameBuffer, SignalsAreNoFaults) {
  Device device(8);
  device.signals = 2;
  FbPanel panel("/dev/fb0", {}, device);
  show(panel, 1, 9);
  device.signals = 5;
  ASSERT_TRUE(panel.wait_for_vblank().ok());
  EXPECT_EQ(panel.on_display(), 1);
}

TEST(FrameBuffer, ADriverThatDoesNotWaitIsWaitedForByTheClock) {
  Device device(8);
  device.tells_vblanks = true;
  device.waits_for_vblank = false;
  FbPanel panel("/dev/fb0", {}, device);
  for (int i = 0; i < 101; ++i) ASSERT_TRUE(panel.wait_for_vblank().ok());
  EXPECT_EQ(device.time.now(), 100U * Device::refresh);
  EXPECT_EQ(panel.vblank_count(), 101U);
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

/// The kinds of devices there are.
struct Kind {
  unsigned bits;
  bool pans;
  [[nodiscard]] std::string name() const { return std::to_string(bits) + (pans ? "panning" : "copied"); }
};
void PrintTo(const Kind& kind, std::ostream* out) { *out << kind.name(); }
class EveryFrameBuffer : public testing::TestWithParam<Kind> {
 protected:
  Device device_{GetParam().bits, GetParam().pans};

  /// The colour of the device's first pixel as it is seen, 8 bits of red.
  [[nodiscard]] unsigned red_seen() const {
    const std::uint32_t pixel = device_.pixel(0, 0);
    if (device_.mode.bits_per_pixel == 8) return device_.red.at(pixel) / 257U;
    return device_.mode.bits_per_pixel == 16 ? (pixel >> 11U) * 8U : pixel >> 16U & 255U;
  }
  static void fill(FbPanel& panel, int buffer, std::uint8_t index) {
    std::ranges::fill(panel.buffer(buffer), index);
  }
};
/// Colours whose entry i is i + `first` of red.
std::vector<std::uint8_t> reds(int first, int entries = 256) {
  std::vector<std::uint8_t> colours;
  for (int i = 0; i < entries; ++i)
    colours.insert(colours.end(), {static_cast<std::uint8_t>(i + first), 0, 0});
  return colours;
}

TEST_P(EveryFrameBuffer, TellsWhatIsOnDisplayAndWhatWasReplaced) {
  FbPanel panel("/dev/fb0", {}, device_);
  EXPECT_EQ(panel.on_display(), 0) << "a panel starts with it";
  fill(panel, 1, 8);
  ASSERT_TRUE(panel.show(1, reds(0)).ok());
  EXPECT_FALSE(panel.show_replaced());
  EXPECT_EQ(panel.on_display(), 0) << "before the VBLANK";
  EXPECT_EQ(red_seen(), 0U);
  ASSERT_TRUE(panel.show(0, {}).ok());
  EXPECT_TRUE(panel.show_replaced());
  fill(panel, 1, 16);
  ASSERT_TRUE(panel.show(1, {}).ok());
  EXPECT_TRUE(panel.show_replaced());
  device_.vblank();
  EXPECT_EQ(panel.on_display(), 1);
  EXPECT_FALSE(panel.show_pending());
  EXPECT_EQ(red_seen(), 16U) << "with the colours of a request that was replaced";
  ASSERT_TRUE(panel.show(0, {}).ok());
  EXPECT_FALSE(panel.show_replaced());
}

TEST_P(EveryFrameBuffer, ShowsNothingOfARequestAheadOfItsVblank) {
  FbPanel panel("/dev/fb0", {}, device_);
  fill(panel, 0, 8);
  fill(panel, 1, 32);
  ASSERT_TRUE(panel.show(0, reds(0)).ok());
  EXPECT_EQ(red_seen(), 0U);
  device_.vblank();
  EXPECT_FALSE(panel.show_pending());
  EXPECT_EQ(red_seen(), 8U);
  ASSERT_TRUE(panel.show(0, reds(64)).ok()) << "again, in other colours";
  EXPECT_EQ(red_seen(), 8U);
  device_.vblank();
  EXPECT_FALSE(panel.show_pending());
  EXPECT_EQ(red_seen(), 72U);
  // Colours loaded alone are seen at once, but not those of the request.
  ASSERT_TRUE(panel.show(1, reds(128)).ok());
  ASSERT_TRUE(panel.load_palette(reds(16, 9)).ok());
  EXPECT_EQ(red_seen(), 24U) << "entry 8, of buffer 0";
  ASSERT_TRUE(panel.load_palette(reds(24, 1)).ok());
  EXPECT_EQ(red_seen(), 24U);
  device_.vblank();
  EXPECT_EQ(panel.on_display(), 1);
  EXPECT_EQ(red_seen(), 160U);
  fill(panel, 0, 8);
  ASSERT_TRUE(panel.show(0, {}).ok());
  device_.vblank();
  EXPECT_EQ(panel.on_display(), 0);
  EXPECT_EQ(red_seen(), 24U) << "what was loaded stays";
}

TEST_P(EveryFrameBuffer, ColoursLoadedReachARequestThatWaits) {
  FbPanel panel("/dev/fb0", {}, device_);
  fill(panel, 1, 32);
  ASSERT_TRUE(panel.show(1, reds(0)).ok());
  ASSERT_TRUE(panel.load_palette(reds(64)).ok());
  device_.vblank();
  EXPECT_EQ(panel.on_display(), 1);
  EXPECT_EQ(red_seen(), 96U);
  // A request whose VBLANK is over is on display.
  fill(panel, 0, 8);
  ASSERT_TRUE(panel.show(0, {}).ok());
  device_.vblank();
  ASSERT_TRUE(panel.load_palette(reds(128)).ok());
  EXPECT_EQ(red_seen(), 136U);
  if (!panel.has_hardware_palette()) return;
  // Those that couldn't be loaded are with the next request.
  device_.failing = FBIOPUTCMAP;
  EXPECT_EQ(panel.load_palette(reds(0)).error(), Error::bus);
  device_.failing = 0;
  EXPECT_EQ(red_seen(), 136U);
  for (int i = 0; i < 2; ++i) {
    device_.happened.clear();
    ASSERT_TRUE(panel.show(0, {}).ok());
    device_.vblank();
    EXPECT_FALSE(panel.show_pending());
    EXPECT_EQ(red_seen(), 8U);
    EXPECT_EQ(std::ranges::count(device_.happened, "colours"), i == 0 ? 1 : 0) << "the device has them";
  }
}

TEST_P(EveryFrameBuffer, KeepsWhatItShowsAndItsColoursIfTheNextFails) {
  FbPanel panel("/dev/fb0", {}, device_);
  fill(panel, 0, 8);
  ASSERT_TRUE(panel.show(0, reds(0)).ok());
  device_.vblank();
  ASSERT_EQ(panel.on_display(), 0);
  fill(panel, 1, 32);
  for (const unsigned long request : std::array<unsigned long, 2>{FBIOPUTCMAP, FBIOPAN_DISPLAY}) {
    if (request == FBIOPAN_DISPLAY ? !panel.pans() : !panel.has_hardware_palette()) continue;
    device_.failing = request;
    ASSERT_TRUE(panel.show(1, reds(96)).ok());
    device_.vblank();
    EXPECT_EQ(panel.on_display(), 0);
    EXPECT_FALSE(panel.show_pending());
    EXPECT_EQ(red_seen(), 8U);
    EXPECT_EQ(panel.show(1, {}).error(), Error::bus) << "the next call says so";
    EXPECT_THAT(panel.fault(), HasSubstr("frame buffer /dev/fb0: "));
    device_.failing = 0;
    ASSERT_TRUE(panel.show(1, {}).ok());
    device_.vblank();
    EXPECT_EQ(panel.on_display(), 1);
    EXPECT_EQ(red_seen(), 128U) << "with the colours of the request that failed";
    ASSERT_TRUE(panel.show(0, reds(0)).ok());
    device_.vblank();
    EXPECT_EQ(panel.on_display(), 0);
  }
}

TEST_P(EveryFrameBuffer, FramesAreCountedAsTheyAppear) {
  FbPanel panel("/dev/fb0", {}, device_);
  using Chain = intaglio::present::SwapChain<intaglio::image::Indexed8>;
  for (const auto order : {intaglio::present::Order::every, intaglio::present::Order::latest}) {
    Chain chain(panel, {1, intaglio::present::Late::show, order});
    int seen = 0;
    int last_seen = -1;
    const auto look = [&] {
      const int on_display = panel.on_display();
      if (std::exchange(last_seen, on_display) != on_display) ++seen;
    };
    look();
    seen = 0;
    for (int frame = 1; frame <= 40; ++frame) {
      auto drawn = chain.begin();
      ASSERT_TRUE(drawn.ok());
      look();
      for (int i = 0; i < frame * 7 % 4; ++i) {
        device_.vblank();
        look();
      }
      ASSERT_TRUE(chain.present(std::move(drawn).value(), reds(frame)).ok());
    }
    ASSERT_TRUE(chain.wait_until_shown().ok());
    look();
    EXPECT_EQ(chain.counts().shown, static_cast<unsigned>(seen));
    EXPECT_EQ(chain.counts().shown + chain.counts().dropped, 40U);
  }
}

INSTANTIATE_TEST_SUITE_P(, EveryFrameBuffer,
                         testing::Values(Kind{8, true}, Kind{8, false}, Kind{16, true}, Kind{32, true},
                                         Kind{32, false}),
                         [](const auto& kind) { return kind.param.name(); });

TEST(FrameBuffer, TheDeviceIsAsItWasWhereItIsRefused) {
  const auto left_alone = [](Device& device, Extent picture, const std::string& words) {
    const fb_var_screeninfo before = device.mode;
    EXPECT_THAT(refusal(device, picture), HasSubstr(words));
    EXPECT_EQ(device.mode.xres, before.xres) << words;
    EXPECT_EQ(device.mode.yres_virtual, before.yres_virtual) << words;
  };
  Device odd(4);
  left_alone(odd, {16, 12}, "4 bits");
  Device unmappable(8);
  unmappable.map_error = ENOMEM;
  left_alone(unmappable, {16, 12}, "memory can't be mapped");
  Device colourless(8);
  colourless.failing = FBIOPUTCMAP;
  left_alone(colourless, {16, 12}, "loading colours failed");
}

TEST(FrameBuffer, ADriverThatLiesIsRefused) {
  const auto refusal_of = [](const auto& lie) {
    Device device(32);
    device.fixed_mode = true;
    lie(device);
    return refusal(device);
  };
  EXPECT_THAT(refusal_of([](Device& d) { d.row_lie = 0; }),
              AllOf(HasSubstr("frame buffer /dev/fb0: "), HasSubstr("a row of 20 pixels has 0 bytes")));
  EXPECT_THAT(refusal_of([](Device& d) { d.row_lie = 79; }), HasSubstr("which can't be"));
  EXPECT_THAT(refusal_of([](Device& d) { d.row_lie = 0xFFFF'FFFF; }), HasSubstr("which can't be"));
  EXPECT_THAT(refusal_of([](Device& d) { d.memory_lie = 879; }), HasSubstr("less memory"));
  EXPECT_THAT(refusal_of([](Device& d) { d.mode.xres = 0; }), HasSubstr("0x10 pixels, which no screen has"));
  EXPECT_THAT(refusal_of([](Device& d) { d.mode.yres = 0x8000'0000; }), HasSubstr("which no screen has"));
  for (const fb_bitfield& field : {fb_bitfield{32, 8, 0}, fb_bitfield{28, 8, 0}, fb_bitfield{32, 0, 0},
                                   fb_bitfield{0xFFFF'FFF8, 8, 0}, fb_bitfield{8, 40, 0}})
    EXPECT_THAT(refusal_of([&](Device& d) { d.mode.green = field; }), HasSubstr("inside its pixels"));
}

TEST(FrameBuffer, OfWideChannelsTheUpperBitsAreUsed) {
  Device device(32);
  device.mode.red = {20, 10, 0};
  device.mode.green = {10, 10, 0};
  device.mode.blue = {0, 10, 0};
  FbPanel panel("/dev/fb0", {}, device);
  std::ranges::fill(panel.buffer(1), std::uint8_t{1});
  ASSERT_TRUE(panel.show(1, std::vector<std::uint8_t>{0, 0, 0, 0x81, 0x42, 0xFF}).ok());
  ASSERT_TRUE(panel.wait_for_vblank().ok());
  EXPECT_EQ(device.pixel(0, 0), 0x81U << 22U | 0x42U << 12U | 0xFFU << 2U);
}

TEST(FrameBuffer, ChannelsThatAreLookedUpGetRamps) {
  Device device(16);
  device.fixed.visual = FB_VISUAL_DIRECTCOLOR;
  {
    const FbPanel panel("/dev/fb0", {}, device);
    EXPECT_EQ(device.red.at(0), 0U);
    EXPECT_EQ(device.red.at(1), 65'535U / 31U);
    EXPECT_EQ(device.red.at(31), 65'535U);
    EXPECT_EQ(device.green.at(31), 65'535U * 31U / 63U);
    EXPECT_EQ(device.green.at(63), 65'535U);
  }
  EXPECT_EQ(device.red.at(31), 0xABCD);
}

TEST(FrameBuffer, MemoryThatBeginsInsideAPageIsFound) {
  Device device(8);
  device.fixed.smem_start = 0xE000'0123;
  device.memory.resize(0x123 + device.fixed.smem_len);
  FbPanel panel("/dev/fb0", {}, device);
  EXPECT_EQ(panel.buffer(0).data(), device.memory.data() + 0x123);
}

}  // namespace
