// SPDX-License-Identifier: MIT
#include <hal/linux/fb_panel.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <linux/fb.h>
#include <sys/ioctl.h>
#include <utility>

namespace hal::linux_io {

namespace {

int open_device(System& system, const std::string& path) {
  const int file = system.open(path.c_str(), O_RDWR);
  if (file < 0) throw DeviceError(cannot_open(path, "frame buffer", errno));
  return file;
}

/// A colour map of the device, 16 bits a channel.
struct ColourMap {
  std::array<std::uint16_t, 256> red{};
  std::array<std::uint16_t, 256> green{};
  std::array<std::uint16_t, 256> blue{};
  fb_cmap map() { return {0, 256, red.data(), green.data(), blue.data(), nullptr}; }
};

std::uint32_t refresh_of(const fb_var_screeninfo& mode) {
  const std::uint64_t columns = mode.xres + mode.left_margin + mode.right_margin + mode.hsync_len;
  const std::uint64_t rows = mode.yres + mode.upper_margin + mode.lower_margin + mode.vsync_len;
  const std::uint64_t picoseconds = columns * rows * mode.pixclock;
  constexpr std::uint64_t second = 1'000'000'000'000'000;  // In picoseconds, times 1000.
  const std::uint64_t millihertz = picoseconds == 0 ? 0 : second / picoseconds;
  // What drivers without a clock of their own say is no use.
  return millihertz < 10'000 || millihertz > 500'000 ? 60'000U : static_cast<std::uint32_t>(millihertz);
}

PixelLayout layout_of(const fb_var_screeninfo& mode) {
  const auto channel = [](const fb_bitfield& field) {
    return PixelLayout::Channel{field.offset, field.length};
  };
  return {static_cast<int>(mode.bits_per_pixel + 7U) / 8, channel(mode.red), channel(mode.green),
          channel(mode.blue)};
}

/// Pixels that are looked up: a byte that is its own colour.
constexpr PixelLayout indices_themselves{.bytes = 1, .red = {0, 8}, .green = {0, 0}, .blue = {0, 0}};

}  // namespace

struct FbPanel::Device {
  const File& file;
  std::string name;
  fb_var_screeninfo before{};  // As it was found.
  ColourMap colours_before;
  fb_var_screeninfo mode{};
  fb_fix_screeninfo fixed{};
  std::span<std::uint8_t> memory;

  Device(const File& of, std::string called, Extent picture) : file(of), name(std::move(called)) {
    read();
    before = mode;
    if (fixed.visual == FB_VISUAL_PSEUDOCOLOR) {
      fb_cmap map = colours_before.map();
      file.control(FBIOGETCMAP, map);
    }
    choose_mode(picture);
    if (fixed.type != FB_TYPE_PACKED_PIXELS) throw DeviceError(name + ": its pixels aren't packed");
    const bool pseudo = fixed.visual == FB_VISUAL_PSEUDOCOLOR && mode.bits_per_pixel == 8;
    const bool real = (fixed.visual == FB_VISUAL_TRUECOLOR || fixed.visual == FB_VISUAL_DIRECTCOLOR) &&
                      (mode.bits_per_pixel == 16 || mode.bits_per_pixel == 24 || mode.bits_per_pixel == 32);
    if (!pseudo && !real)
      throw DeviceError(name + ": pixels of " + std::to_string(mode.bits_per_pixel) + " bits (visual " +
                        std::to_string(fixed.visual) + ") aren't known here");
    const std::size_t needed = static_cast<std::size_t>(fixed.line_length) * mode.yres;
    if (fixed.smem_len < needed) throw DeviceError(name + ": it has less memory than a picture needs");
    void* const mapped = file.system().map(file.number(), fixed.smem_len, 0);
    if (mapped == nullptr) throw DeviceError(name + ": its memory can't be mapped: " + error_text(errno));
    memory = {static_cast<std::uint8_t*>(mapped), fixed.smem_len};
  }
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;
  ~Device() { file.system().unmap(memory.data(), memory.size()); }

  void read() {
    if (file.control(FBIOGET_VSCREENINFO, mode) < 0 || file.control(FBIOGET_FSCREENINFO, fixed) < 0)
      throw DeviceError(
          name + (errno == ENOTTY || errno == EINVAL ? " is no frame buffer" : ": " + error_text(errno)));
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
      const bool taken = file.control(FBIOPUT_VSCREENINFO, wish) == 0;
      read();
      return taken;
    };
    const auto width = static_cast<std::uint32_t>(picture.width);
    const auto height = static_cast<std::uint32_t>(picture.height);
    if (picture != Extent{} && (mode.xres != width || mode.yres != height))
      static_cast<void>(ask(width, height));
    if (mode.yres_virtual < 2 * mode.yres) static_cast<void>(ask(mode.xres, mode.yres));
  }

  [[nodiscard]] Extent screen() const { return {static_cast<int>(mode.xres), static_cast<int>(mode.yres)}; }
  [[nodiscard]] bool has_room_for_two() const {
    return fixed.ypanstep != 0 && mode.yres % fixed.ypanstep == 0 && mode.yres_virtual >= 2 * mode.yres &&
           fixed.smem_len >= 2ULL * fixed.line_length * mode.yres;
  }
  [[nodiscard]] int pan_to(std::uint32_t row) {
    fb_var_screeninfo wish = mode;
    wish.xoffset = 0;
    wish.yoffset = row;
    wish.activate = FB_ACTIVATE_VBL;
    return file.control(FBIOPAN_DISPLAY, wish);
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

namespace {

Extent picture_size(Extent asked, Extent screen, const std::string& name) {
  if (asked == Extent{}) return screen;
  if (asked.width < 1 || asked.height < 1 || asked.width > screen.width || asked.height > screen.height)
    throw DeviceError(name + ": it has " + std::to_string(screen.width) + 'x' +
                      std::to_string(screen.height) + " pixels, too few for " + std::to_string(asked.width) +
                      'x' + std::to_string(asked.height));
  return asked;
}

}  // namespace

FbPanel::FbPanel(const std::string& path, Extent picture, System& system)
    : name_("frame buffer " + path),
      file_(system, open_device(system, path)),
      device_(std::make_unique<Device>(file_, name_, picture)),
      hardware_palette_(device_->mode.bits_per_pixel == 8),
      placement_(picture_size(picture, device_->screen(), name_), device_->screen()),
      palette_(hardware_palette_ ? indices_themselves : layout_of(device_->mode)),
      colours_(256U * 3U),
      period_(1'000'000'000'000U / refresh_of(device_->mode)),
      anchor_(clock_.now()) {
  const Extent size = placement_.picture();
  // A picture smaller than the device lies in its middle, so the program can't draw there directly.
  pans_ = device_->has_room_for_two() && device_->pan_to(0) == 0;
  if (size != device_->screen() && hardware_palette_) pans_ = false;
  capabilities_.width = size.width;
  capabilities_.height = size.height;
  capabilities_.bits_per_pixel = 8;
  capabilities_.palette_entries = 256;
  capabilities_.buffers = buffers;
  capabilities_.refresh_millihertz = refresh_of(device_->mode);
  std::uint32_t screen = 0;
  tells_vblanks_ = file_.control(FBIO_WAITFORVSYNC, screen) == 0;
  capabilities_.vblank_signal = tells_vblanks_;
  anchor_ = clock_.now();
  if (hardware_palette_) {
    std::vector<std::uint8_t> themselves(256U * 3U);
    for (std::size_t i = 0; i < 256; ++i) themselves[3U * i] = static_cast<std::uint8_t>(i);
    palette_.load(themselves);
  }
  if (!direct())
    memory_.resize(static_cast<std::size_t>(buffers) * static_cast<std::size_t>(size.width) *
                   static_cast<std::size_t>(size.height));
  std::ranges::fill(device_->memory, std::uint8_t{0});
  if (!put_palette().ok()) throw DeviceError(fault_.text());
}

FbPanel::~FbPanel() {
  if (kept_) return;
  std::ranges::fill(device_->memory, std::uint8_t{0});
  if (hardware_palette_) {
    fb_cmap map = device_->colours_before.map();
    file_.control(FBIOPUTCMAP, map);
  }
  device_->before.activate = FB_ACTIVATE_NOW;
  file_.control(FBIOPUT_VSCREENINFO, device_->before);
}

int FbPanel::do_buffer_stride() const noexcept {
  return direct() ? static_cast<int>(device_->fixed.line_length) : capabilities_.width;
}

std::span<std::uint8_t> FbPanel::page(int index) noexcept {
  const std::size_t size = static_cast<std::size_t>(device_->fixed.line_length) * device_->mode.yres;
  return device_->memory.subspan(pans_ ? static_cast<std::size_t>(index) * size : 0, size);
}

std::span<std::uint8_t> FbPanel::do_buffer(int index) noexcept {
  if (direct()) return page(index);
  const std::size_t size = memory_.size() / static_cast<std::size_t>(buffers);
  return std::span(memory_).subspan(static_cast<std::size_t>(index) * size, size);
}

Status FbPanel::put_palette() noexcept {
  if (!hardware_palette_) return {};
  ColourMap colours;
  for (std::size_t i = 0; i < 256; ++i) {
    // 255 is all of 65535.
    colours.red[i] = static_cast<std::uint16_t>(colours_[3U * i] * 257U);
    colours.green[i] = static_cast<std::uint16_t>(colours_[3U * i + 1U] * 257U);
    colours.blue[i] = static_cast<std::uint16_t>(colours_[3U * i + 2U] * 257U);
  }
  fb_cmap map = colours.map();
  return file_.control(FBIOPUTCMAP, map) == 0
             ? Status{}
             : fault_.note(name_, "loading colours failed", errno, Part::palette);
}

Status FbPanel::pan(int index) noexcept {
  const int done = device_->pan_to(static_cast<std::uint32_t>(index) * device_->mode.yres);
  return done == 0 ? Status{} : fault_.note(name_, "panning failed", errno, Part::buffer);
}

void FbPanel::draw(int index) noexcept {
  placement_.draw(do_buffer(index), palette_, page(index), device_->fixed.line_length);
}

Status FbPanel::take_effect() noexcept {
  pending_ = false;
  if (!pans_) draw(asked_);
  if (new_colours_)
    if (const Status s = put_palette(); !s.ok()) return s;
  new_colours_ = false;
  return pans_ ? pan(asked_) : Status{};
}

void FbPanel::notice() noexcept {
  const Nanoseconds now = clock_.now();
  const Nanoseconds over = now > anchor_ ? (now - anchor_) / period_ : 0;
  count_ += static_cast<std::uint32_t>(over);
  anchor_ += over * period_;
  if (!pending_ || count_ == asked_at_) return;
  if (const Status s = take_effect(); !s.ok()) last_ = s;
}

Status FbPanel::do_show(int index, std::span<const std::uint8_t> palette) noexcept {
  notice();
  if (const Status s = std::exchange(last_, {}); !s.ok()) return s;
  std::ranges::copy(palette, colours_.begin());
  new_colours_ = new_colours_ || !palette.empty();
  if (!hardware_palette_) {
    palette_.load(palette);
    // What isn't displayed can be drawn ahead of its time.
    if (pans_) draw(index);
  }
  asked_ = index;
  asked_at_ = count_;
  pending_ = true;
  return {};
}

bool FbPanel::do_show_pending() noexcept {
  notice();
  return pending_;
}

Status FbPanel::do_write(const Rect&, std::span<const std::uint8_t>, int) noexcept {
  return {Error::unsupported, Part::buffer};
}

Status FbPanel::do_load_palette(std::span<const std::uint8_t> palette) noexcept {
  std::ranges::copy(palette, colours_.begin());
  if (hardware_palette_) return put_palette();
  palette_.load(palette);
  draw(asked_);
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
  if (tells_vblanks_ && file_.control(FBIO_WAITFORVSYNC, screen) == 0) {
    // The device knows better than the clock when its VBLANK begins.
    const Nanoseconds now = clock_.now();
    count_ += std::max(1U, static_cast<std::uint32_t>((now - anchor_ + period_ / 2U) / period_));
    anchor_ = now;
  } else {
    clock_.wait_until(anchor_ + period_);
  }
  notice();
  if (const Status s = std::exchange(last_, {}); !s.ok()) return s;
  return count_ != before ? Status{} : Status{Error::timeout, Part::panel};
}

}  // namespace hal::linux_io
