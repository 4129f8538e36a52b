// SPDX-License-Identifier: MIT
#include <hal/linux/fb_panel.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <linux/fb.h>
#include <sys/ioctl.h>
#include <unistd.h>
#include <utility>

namespace hal::linux_io {

namespace {

/// A colour map of the device, 16 bits a channel.
struct ColourMap {
  std::array<std::uint16_t, 256> red{};
  std::array<std::uint16_t, 256> green{};
  std::array<std::uint16_t, 256> blue{};
  fb_cmap map() { return {0, 256, red.data(), green.data(), blue.data(), nullptr}; }
};

/// The linear ramps that devices want which look up each channel of real colours by itself.
ColourMap ramps(const PixelLayout& layout) {
  const auto ramp = [](std::array<std::uint16_t, 256>& levels, unsigned bits) {
    const unsigned last = (1U << std::min(bits, 8U)) - 1U;
    for (unsigned i = 0; i < levels.size(); ++i)
      levels.at(i) =
          last == 0 ? std::uint16_t{0} : static_cast<std::uint16_t>(65'535U * std::min(i, last) / last);
  };
  ColourMap map;
  ramp(map.red, layout.red.bits);
  ramp(map.green, layout.green.bits);
  ramp(map.blue, layout.blue.bits);
  return map;
}

/// Refreshes a second times 1000.
std::uint64_t refresh_of(const fb_var_screeninfo& mode) {
  const std::uint64_t columns = mode.xres + mode.left_margin + mode.right_margin + mode.hsync_len;
  const std::uint64_t rows = mode.yres + mode.upper_margin + mode.lower_margin + mode.vsync_len;
  const std::uint64_t picoseconds = columns * rows * mode.pixclock;
  constexpr std::uint64_t second = 1'000'000'000'000'000;  // In picoseconds, times 1000.
  return picoseconds == 0 ? 0 : second / picoseconds;
}

PixelLayout layout_of(const fb_var_screeninfo& mode) {
  const auto channel = [](const fb_bitfield& field) {
    return PixelLayout::Channel{field.offset, field.length};
  };
  return {static_cast<int>(mode.bits_per_pixel / 8U), channel(mode.red), channel(mode.green),
          channel(mode.blue)};
}

}  // namespace

/// The device while this program has it: set as it was on every way out, and blank.
struct FbPanel::Device {
  const DeviceFile& file;
  fb_var_screeninfo before{};  // As it was found.
  bool looks_up = false;       // Colours, which it had before.
  ColourMap colours_before;
  fb_var_screeninfo mode{};
  fb_fix_screeninfo fixed{};
  Extent size;
  PixelLayout layout;
  std::span<std::uint8_t> mapped;  // Whole pages.
  std::span<std::uint8_t> memory;
  bool kept = false;

  Device(const DeviceFile& of, Extent picture) : Device(of) {
    choose_mode(picture);
    check();
    if (fixed.visual != FB_VISUAL_PSEUDOCOLOR) layout = layout_of(mode);
    if (!layout.possible()) throw DeviceError(file.name() + ": its colours aren't inside its pixels");
    map_memory();
    if (fixed.visual == FB_VISUAL_DIRECTCOLOR) put(ramps(layout));
  }
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;
  ~Device() {
    if (!kept) {
      std::ranges::fill(memory, std::uint8_t{0});
      if (looks_up) put(colours_before);
      before.activate = FB_ACTIVATE_NOW;
      file.control(FBIOPUT_VSCREENINFO, before);
    }
    if (!mapped.empty()) file.system().unmap(mapped.data(), mapped.size());
  }

  /// Asks for a size and for room for two pictures; what the device doesn't want stays as it is.
  void choose_mode(Extent picture) {
    const auto ask = [this](std::uint32_t width, std::uint32_t height) {
      fb_var_screeninfo wish = mode;
      wish.xres = wish.xres_virtual = width;
      wish.yres = height;
      wish.yres_virtual = 2 * height;
      wish.xoffset = wish.yoffset = 0;
      wish.activate = FB_ACTIVATE_NOW;
      file.control(FBIOPUT_VSCREENINFO, wish);
      read();
    };
    const auto width = static_cast<std::uint32_t>(picture.width);
    const auto height = static_cast<std::uint32_t>(picture.height);
    const bool asked = picture.width > 0 && picture.height > 0;
    if (asked && (mode.xres != width || mode.yres != height)) ask(width, height);
    if (mode.yres_virtual < 2 * mode.yres) ask(mode.xres, mode.yres);
  }

  /// Refuses what can't be drawn on, and numbers that can't be.
  void check() {
    const std::string& name = file.name();
    size = checked_size(file, mode.xres, mode.yres);
    if (fixed.type != FB_TYPE_PACKED_PIXELS) throw DeviceError(name + ": its pixels aren't packed");
    const bool pseudo = fixed.visual == FB_VISUAL_PSEUDOCOLOR && mode.bits_per_pixel == 8;
    const bool real = (fixed.visual == FB_VISUAL_TRUECOLOR || fixed.visual == FB_VISUAL_DIRECTCOLOR) &&
                      (mode.bits_per_pixel == 16 || mode.bits_per_pixel == 24 || mode.bits_per_pixel == 32);
    if (!pseudo && !real)
      throw DeviceError(name + ": pixels of " + std::to_string(mode.bits_per_pixel) + " bits (visual " +
                        std::to_string(fixed.visual) + ") aren't known here");
    if (fixed.line_length < mode.xres * (mode.bits_per_pixel / 8U) || fixed.line_length > longest_row)
      throw DeviceError(name + ": its driver says that a row of " + std::to_string(mode.xres) +
                        " pixels has " + std::to_string(fixed.line_length) + " bytes, which can't be");
    if (fixed.smem_len < picture_bytes())
      throw DeviceError(name + ": it has less memory than a picture needs");
  }

  void map_memory() {
    // What is mapped begins with a page, the device's memory perhaps not.
    const auto start = static_cast<std::size_t>(fixed.smem_start) % static_cast<std::size_t>(getpagesize());
    const std::size_t bytes = start + fixed.smem_len;
    void* const pages = file.system().map(file.number(), bytes, 0);
    if (pages == nullptr) file.refuse("its memory can't be mapped", errno);
    mapped = {static_cast<std::uint8_t*>(pages), bytes};
    memory = mapped.subspan(start);
  }

  [[nodiscard]] std::size_t picture_bytes() const {
    return static_cast<std::size_t>(fixed.line_length) * mode.yres;
  }
  [[nodiscard]] bool has_room_for_two() const {
    return fixed.ypanstep != 0 && mode.yres % fixed.ypanstep == 0 && mode.yres_virtual >= 2 * mode.yres &&
           fixed.smem_len / 2U >= picture_bytes();
  }
  [[nodiscard]] int pan_to(std::uint32_t row) {
    fb_var_screeninfo wish = mode;
    wish.xoffset = 0;
    wish.yoffset = row;
    wish.activate = FB_ACTIVATE_VBL;
    return file.control(FBIOPAN_DISPLAY, wish);
  }
  /// Loads colours; below 0: errno.
  int put(ColourMap colours) const {
    fb_cmap map = colours.map();
    return file.control(FBIOPUTCMAP, map);
  }

 private:
  static constexpr std::uint32_t longest_row = 1U << 20U;

  explicit Device(const DeviceFile& of) : file(of) {
    read();
    before = mode;
    looks_up = fixed.visual == FB_VISUAL_PSEUDOCOLOR || fixed.visual == FB_VISUAL_DIRECTCOLOR;
    if (!looks_up) return;
    fb_cmap map = colours_before.map();
    looks_up = file.control(FBIOGETCMAP, map) == 0;
  }

  void read() {
    if (file.control(FBIOGET_VSCREENINFO, mode) < 0 || file.control(FBIOGET_FSCREENINFO, fixed) < 0)
      file.refuse("it can't be asked", errno == EINVAL ? ENOTTY : errno);
  }
};

std::string fb_description(const std::string& path, System& system) {
  const File file(system, system.open(path.c_str(), O_RDWR));
  fb_var_screeninfo mode{};
  fb_fix_screeninfo fixed{};
  if (file.number() < 0 || file.control(FBIOGET_VSCREENINFO, mode) < 0 ||
      file.control(FBIOGET_FSCREENINFO, fixed) < 0)
    return {};
  // Its name may fill all of its place.
  const std::string id(fixed.id, strnlen(fixed.id, sizeof fixed.id));
  return id + ", " + std::to_string(mode.xres) + 'x' + std::to_string(mode.yres) + ", " +
         std::to_string(mode.bits_per_pixel) + " bits a pixel";
}

FbPanel::FbPanel(const std::string& path, Extent picture, System& system)
    : ScreenPanel(system, "frame buffer", path),
      device_(std::make_unique<Device>(file_, picture)),
      hardware_palette_(device_->mode.bits_per_pixel == 8),
      pans_(device_->has_room_for_two() && device_->pan_to(0) == 0),
      layout_(device_->layout),
      period_(1'000'000'000'000U / likely_refresh(refresh_of(device_->mode))),
      anchor_(0) {
  std::uint32_t screen = 0;
  const bool tells = file_.control(FBIO_WAITFORVSYNC, screen) == 0;
  anchor_ = clock().now();
  set_up(picture, device_->size, likely_refresh(refresh_of(device_->mode)), tells);
  const bool whole =
      capabilities().width == device_->size.width && capabilities().height == device_->size.height;
  // A picture smaller than the device lies in its middle, so the program can't draw there directly.
  if (!whole && hardware_palette_) pans_ = false;
  if (direct()) draw_in({page(0), page(1)}, static_cast<int>(device_->fixed.line_length));
  std::ranges::fill(device_->memory, std::uint8_t{0});
  if (!put(shown_).ok()) throw DeviceError(fault());
}

FbPanel::~FbPanel() = default;

void FbPanel::keep() noexcept { device_->kept = true; }

std::span<std::uint8_t> FbPanel::page(int index) noexcept {
  const std::size_t size = device_->picture_bytes();
  return device_->memory.subspan(pans_ ? static_cast<std::size_t>(index) * size : 0, size);
}

void FbPanel::draw_page(const Picture& picture) noexcept {
  draw(picture, hardware_palette_ ? PixelPalette::indices() : PixelPalette(layout_, picture.colours),
       page(picture.buffer), device_->fixed.line_length);
}

Status FbPanel::put(const Picture& picture) noexcept {
  if (!hardware_palette_) return {};
  ColourMap colours;
  for (std::size_t i = 0; i < 256; ++i) {
    // 255 is all of 65535.
    colours.red[i] = static_cast<std::uint16_t>(picture.colours[3U * i] * 257U);
    colours.green[i] = static_cast<std::uint16_t>(picture.colours[3U * i + 1U] * 257U);
    colours.blue[i] = static_cast<std::uint16_t>(picture.colours[3U * i + 2U] * 257U);
  }
  return device_->put(colours) == 0 ? Status{} : file_.note("loading colours failed", errno, Part::palette);
}

Status FbPanel::pan(int index) noexcept {
  const int done = device_->pan_to(static_cast<std::uint32_t>(index) * device_->mode.yres);
  return done == 0 ? Status{} : file_.note("panning failed", errno, Part::buffer);
}

Status FbPanel::take_effect() noexcept {
  pending_ = false;
  if (new_colours_)
    if (const Status s = put(asked_); !s.ok()) return s;
  if (!direct() && !drawn_ahead()) draw_page(asked_);
  if (pans_)
    if (const Status s = pan(asked_.buffer); !s.ok()) {
      // The old picture stays, and so do its colours.
      if (new_colours_) put(shown_).ignore();
      return s;
    }
  shown_ = asked_;
  new_colours_ = false;
  return {};
}

void FbPanel::notice() noexcept {
  const Nanoseconds now = clock().now();
  const Nanoseconds over = now > anchor_ ? (now - anchor_) / period_ : 0;
  count_ += static_cast<std::uint32_t>(over);
  anchor_ += over * period_;
  if (!pending_ || count_ == asked_at_) return;
  if (const Status s = take_effect(); !s.ok()) lost_ = s;
}

Status FbPanel::do_show(int index, std::span<const std::uint8_t> palette) noexcept {
  notice();
  if (const Status s = take_lost(); !s.ok()) return s;
  asked_.buffer = index;
  asked_.load(palette);
  new_colours_ = new_colours_ || !palette.empty();
  // What isn't displayed can be drawn ahead of its time.
  if (drawn_ahead()) draw_page(asked_);
  replaced_ = std::exchange(pending_, true);
  asked_at_ = count_;
  return {};
}

bool FbPanel::do_show_pending() noexcept {
  notice();
  return pending_;
}

int FbPanel::do_on_display() noexcept {
  notice();
  return shown_.buffer;
}

Status FbPanel::do_load_palette(std::span<const std::uint8_t> palette) noexcept {
  notice();
  asked_.load(palette);
  shown_.load(palette);
  if (hardware_palette_) {
    const Status s = put(shown_);
    new_colours_ = new_colours_ || !s.ok();
    return s;
  }
  draw_page(shown_);
  if (pending_ && drawn_ahead()) draw_page(asked_);
  return {};
}

std::uint32_t FbPanel::do_vblank_count() noexcept {
  notice();
  return count_;
}

Status FbPanel::do_wait_for_vblank() noexcept {
  notice();
  const std::uint32_t before = count_;
  std::uint32_t screen = 0;
  if (tells_vblanks() && file_.control(FBIO_WAITFORVSYNC, screen) == 0) {
    const Nanoseconds now = clock().now();
    if (synced_ && now - anchor_ < period_ / 4U) {
      // Two VBLANKs aren't that close: this driver doesn't wait.
      clock().wait_until(anchor_ + period_);
    } else {
      // The device knows better than the clock when its VBLANK begins.
      count_ += std::max(1U, static_cast<std::uint32_t>((now - anchor_ + period_ / 2U) / period_));
      anchor_ = now;
      synced_ = true;
    }
  } else {
    clock().wait_until(anchor_ + period_);
  }
  notice();
  if (const Status s = take_lost(); !s.ok()) return s;
  return count_ != before ? Status{} : Status{Error::timeout, Part::panel};
}

}  // namespace hal::linux_io
