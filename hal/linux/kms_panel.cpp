// SPDX-License-Identifier: MIT
#include <hal/linux/kms_panel.hpp>
#include <hal/linux/owned.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fcntl.h>
#include <xf86drm.h>
#include <xf86drmMode.h>

namespace hal::linux_io {

namespace {

using Resources = Owned<drmModeRes, drmModeFreeResources>;
using Connector = Owned<drmModeConnector, drmModeFreeConnector>;
using Encoder = Owned<drmModeEncoder, drmModeFreeEncoder>;
using Crtc = Owned<drmModeCrtc, drmModeFreeCrtc>;

/// One more than flips need: a picture may wait behind a flip that is under way.
constexpr std::size_t screen_buffers = 3;
constexpr std::uint64_t bytes_per_pixel = 4;
/// Of a buffer, in a machine of 32 bits too.
constexpr std::uint64_t most_memory = std::uint64_t{1} << 31U;

Connector plugged_in(int file, const drmModeRes& resources) {
  for (int i = 0; i < resources.count_connectors; ++i) {
    Connector connector(drmModeGetConnector(file, resources.connectors[i]));
    if (connector != nullptr && connector->connection == DRM_MODE_CONNECTED && connector->count_modes > 0)
      return connector;
  }
  return nullptr;
}

/// The kernel tells engines in 32 bits.
constexpr int most_engines = 32;

std::uint32_t bit(int engine) { return std::uint32_t{1} << static_cast<unsigned>(engine); }

/// The number of the engine that an encoder is driven by; below 0: none.
int driver_of(const drmModeRes& resources, const drmModeEncoder& encoder) {
  if (encoder.crtc_id == 0) return -1;
  for (int i = 0; i < std::min(resources.count_crtcs, most_engines); ++i)
    if (resources.crtcs[i] == encoder.crtc_id) return i;
  return -1;
}

/// Which of the card's scan-out engines is to drive a connector: the one that does, else one that drives no
/// other screen, else any that can. Below 0: none.
int engine_for(int file, const drmModeRes& resources, const drmModeConnector& connector) {
  std::uint32_t used = 0;
  for (int i = 0; i < resources.count_encoders; ++i) {
    const Encoder encoder(drmModeGetEncoder(file, resources.encoders[i]));
    const int engine = encoder == nullptr ? -1 : driver_of(resources, *encoder);
    if (engine < 0) continue;
    if (encoder->encoder_id == connector.encoder_id) return engine;
    used |= bit(engine);
  }
  std::uint32_t possible = 0;
  for (int i = 0; i < connector.count_encoders; ++i) {
    const Encoder encoder(drmModeGetEncoder(file, connector.encoders[i]));
    if (encoder != nullptr) possible |= encoder->possible_crtcs;
  }
  int any = -1;
  for (int i = std::min(resources.count_crtcs, most_engines) - 1; i >= 0; --i) {
    if ((possible & bit(i)) == 0) continue;
    if (any < 0 || (used & bit(i)) == 0 || (used & bit(any)) != 0) any = i;
  }
  return any;
}

/// Refreshes a second times 1000, from the mode's own clock where it has one.
std::uint64_t refresh_of(const drmModeModeInfo& mode) {
  std::uint64_t pixels = static_cast<std::uint64_t>(mode.htotal) * mode.vtotal;
  if (mode.clock == 0 || pixels == 0) return mode.vrefresh * 1000ULL;
  // Of an interlaced mode every other line is shown in a refresh; of others each may be shown several times.
  std::uint64_t clock = mode.clock;
  if ((mode.flags & DRM_MODE_FLAG_INTERLACE) != 0) clock *= 2;
  if ((mode.flags & DRM_MODE_FLAG_DBLSCAN) != 0) pixels *= 2;
  if (mode.vscan > 1) pixels *= mode.vscan;
  return clock * 1'000'000U / pixels;
}

}  // namespace

/// A buffer of the screen, in colours.
struct DumbBuffer {
  std::uint32_t handle = 0;
  std::uint32_t id = 0;
  std::size_t stride = 0;
  std::span<std::uint8_t> memory{};
};

struct KmsPanel::Screen {
  const DeviceFile& file;
  std::uint32_t connector = 0;
  std::uint32_t engine = 0;
  int engine_index = 0;
  drmModeModeInfo mode{};
  Extent size;
  Crtc before;  // As it was found.
  std::array<DumbBuffer, screen_buffers> buffers{};
  std::array<Picture, screen_buffers> pictures{};  // That they were drawn from.

  explicit Screen(const DeviceFile& card) : file(card) {
    const int number = file.number();
    const std::string& name = file.name();
    const Resources resources(drmModeGetResources(number));
    if (resources == nullptr) {
      if (errno == EOPNOTSUPP || errno == EINVAL) throw DeviceError(name + " has no screens");
      file.refuse("its screens can't be listed", errno);
    }
    const Connector found = plugged_in(number, *resources);
    if (found == nullptr) throw DeviceError(name + ": no screen is plugged in");
    engine_index = engine_for(number, *resources, *found);
    if (engine_index < 0) throw DeviceError(name + ": nothing can drive its screen");
    connector = found->connector_id;
    engine = resources->crtcs[engine_index];
    mode = found->modes[0];  // The one the screen prefers.
    size = checked_size(file, mode.hdisplay, mode.vdisplay);
    std::uint64_t dumb = 0;
    if (drmGetCap(number, DRM_CAP_DUMB_BUFFER, &dumb) != 0 || dumb == 0)
      throw DeviceError(name + ": its driver has no buffers that programs can draw in");
    before.reset(drmModeGetCrtc(number, engine));
    try {
      for (DumbBuffer& buffer : buffers) make(buffer);
      if (drmModeSetCrtc(number, engine, buffers[0].id, 0, 0, &connector, 1, &mode) != 0)
        throw DeviceError(name + ": the screen can't be had: " + error_text(errno) +
                          (errno == EACCES || errno == EPERM || errno == EBUSY
                               ? "; a desktop holds it, so run this on a text console (Ctrl+Alt+F3)"
                               : ""));
    } catch (...) {
      drop();
      throw;
    }
  }
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;
  ~Screen() {
    const bool was_on = before != nullptr && before->mode_valid != 0 && before->buffer_id != 0;
    if (was_on)
      drmModeSetCrtc(file.number(), engine, before->buffer_id, before->x, before->y, &connector, 1,
                     &before->mode);
    else
      drmModeSetCrtc(file.number(), engine, 0, 0, 0, nullptr, 0, nullptr);
    drop();
  }

  void make(DumbBuffer& buffer) {
    drm_mode_create_dumb create{};
    create.width = mode.hdisplay;
    create.height = mode.vdisplay;
    create.bpp = 8 * bytes_per_pixel;
    if (drmIoctl(file.number(), DRM_IOCTL_MODE_CREATE_DUMB, &create) != 0)
      file.refuse("a buffer can't be made", errno);
    buffer.handle = create.handle;
    buffer.stride = create.pitch;
    const std::uint64_t row = bytes_per_pixel * static_cast<std::uint64_t>(mode.hdisplay);
    if (create.pitch < row || create.size / create.pitch < mode.vdisplay || create.size > most_memory)
      throw DeviceError(file.name() + ": its driver says that a buffer has " + std::to_string(create.size) +
                        " bytes in rows of " + std::to_string(create.pitch) + ", which can't be");
    if (drmModeAddFB(file.number(), mode.hdisplay, mode.vdisplay, 24, 32, create.pitch, create.handle,
                     &buffer.id) != 0)
      file.refuse("a buffer can't be shown", errno);
    drm_mode_map_dumb map{};
    map.handle = create.handle;
    if (drmIoctl(file.number(), DRM_IOCTL_MODE_MAP_DUMB, &map) != 0)
      file.refuse("a buffer can't be mapped", errno);
    void* const memory = file.system().map(file.number(), create.size, map.offset);
    if (memory == nullptr) file.refuse("a buffer can't be mapped", errno);
    buffer.memory = {static_cast<std::uint8_t*>(memory), create.size};
    std::ranges::fill(buffer.memory, std::uint8_t{0});
  }

  void drop() noexcept {
    for (DumbBuffer& buffer : buffers) {
      if (!buffer.memory.empty()) file.system().unmap(buffer.memory.data(), buffer.memory.size());
      if (buffer.id != 0) drmModeRmFB(file.number(), buffer.id);
      drm_mode_destroy_dumb destroy{};
      destroy.handle = buffer.handle;
      if (buffer.handle != 0) drmIoctl(file.number(), DRM_IOCTL_MODE_DESTROY_DUMB, &destroy);
      buffer = {};
    }
  }
};

std::vector<std::string> kms_screens(const std::string& path, System& system) {
  const File file(system, system.open(path.c_str(), O_RDWR));
  std::vector<std::string> screens;
  if (file.number() < 0) return screens;
  const Resources resources(drmModeGetResources(file.number()));
  if (resources == nullptr) return screens;
  for (int i = 0; i < resources->count_connectors; ++i) {
    const Connector connector(drmModeGetConnector(file.number(), resources->connectors[i]));
    if (connector == nullptr || connector->connection != DRM_MODE_CONNECTED || connector->count_modes == 0)
      continue;
    screens.push_back(std::to_string(connector->modes[0].hdisplay) + 'x' +
                      std::to_string(connector->modes[0].vdisplay));
  }
  return screens;
}

KmsPanel::KmsPanel(const std::string& path, Extent picture, System& system)
    : ScreenPanel(system, "graphics card", path),
      screen_(std::make_unique<Screen>(file_)),
      ticks_(&clock(), likely_refresh(refresh_of(screen_->mode))) {
  set_up(picture, screen_->size, likely_refresh(refresh_of(screen_->mode)), query_vblank(false));
}

KmsPanel::~KmsPanel() {
  // A flip under way would outlive its buffer, and keep the screen from being given back.
  constexpr int longest_refresh = 100;
  waiting_.reset();
  take_events(longest_refresh).ignore();
}

void KmsPanel::draw_on(std::size_t buffer, const Picture& picture) noexcept {
  DumbBuffer& on = screen_->buffers.at(buffer);
  screen_->pictures.at(buffer) = picture;
  draw(picture, PixelPalette(PixelLayout{}, picture.colours), on.memory, on.stride);
}

Status KmsPanel::flip(std::size_t to) noexcept {
  if (drmModePageFlip(file_.number(), screen_->engine, screen_->buffers.at(to).id, DRM_MODE_PAGE_FLIP_EVENT,
                      this) != 0)
    return file_.note("a page flip failed", errno, Part::buffer);
  flipping_ = to;
  return {};
}

Status KmsPanel::do_show(int index, std::span<const std::uint8_t> palette) noexcept {
  take_events(0).ignore();
  if (const Status s = take_lost(); !s.ok()) return s;
  Picture next = asked_;
  next.buffer = index;
  next.load(palette);
  std::size_t free = 0;
  while (free == shown_ || free == flipping_) ++free;
  draw_on(free, next);
  replaced_ = waiting_.has_value();
  if (flipping_) {
    waiting_ = free;
  } else if (const Status s = flip(free); !s.ok()) {
    return s;
  }
  asked_ = next;
  return {};
}

void KmsPanel::flipped() noexcept {
  if (!flipping_) return;
  ++flips_;
  shown_ = *std::exchange(flipping_, std::nullopt);
  if (const auto next = std::exchange(waiting_, std::nullopt)) lost_ = flip(*next);
}

Status KmsPanel::take_events(int milliseconds) noexcept {
  if (!flipping_) return {};
  drmEventContext handlers{};
  handlers.version = 2;
  handlers.page_flip_handler = [](int, unsigned, unsigned, unsigned, void* panel) {
    static_cast<KmsPanel*>(panel)->flipped();
  };
  constexpr Nanoseconds millisecond = 1'000'000;
  const Nanoseconds end = clock().now() + static_cast<Nanoseconds>(milliseconds) * millisecond;
  pollfd ready{file_.number(), POLLIN, 0};
  int come = 0;
  for (int left = milliseconds;;) {
    come = file_.system().poll(&ready, 1, left);
    if (come >= 0 || errno != EINTR) break;
    // A signal ended it early.
    const Nanoseconds now = clock().now();
    left = now < end ? static_cast<int>((end - now) / millisecond) : 0;
  }
  if (come < 0) return file_.note("waiting for a page flip failed", errno, Part::buffer);
  if (come == 0)
    return milliseconds == 0 ? Status{} : file_.note("a page flip didn't happen", ETIMEDOUT, Part::buffer);
  if ((ready.revents & POLLIN) == 0)
    return file_.note("waiting for a page flip failed", ENODEV, Part::buffer);
  if (drmHandleEvent(file_.number(), &handlers) != 0)
    return file_.note("reading of a page flip failed", errno, Part::buffer);
  return {};
}

bool KmsPanel::do_show_pending() noexcept {
  take_events(0).ignore();
  return flipping_.has_value();
}

int KmsPanel::do_on_display() noexcept {
  take_events(0).ignore();
  return screen_->pictures.at(shown_).buffer;
}

Status KmsPanel::do_load_palette(std::span<const std::uint8_t> palette) noexcept {
  asked_.load(palette);
  for (const std::optional<std::size_t> buffer : {std::optional(shown_), flipping_, waiting_}) {
    if (!buffer) continue;
    Picture picture = screen_->pictures.at(*buffer);
    picture.load(palette);
    draw_on(*buffer, picture);
  }
  return {};
}

bool KmsPanel::query_vblank(bool wait) noexcept {
  drmVBlank vblank{};
  const auto high = static_cast<unsigned>(screen_->engine_index) << DRM_VBLANK_HIGH_CRTC_SHIFT;
  vblank.request.type =
      static_cast<drmVBlankSeqType>(DRM_VBLANK_RELATIVE | (high & DRM_VBLANK_HIGH_CRTC_MASK));
  vblank.request.sequence = wait ? 1 : 0;
  if (drmWaitVBlank(file_.number(), &vblank) != 0) return false;
  count_ = vblank.reply.sequence;
  return true;
}

std::uint32_t KmsPanel::do_vblank_count() noexcept {
  if (!tells_vblanks()) return ticks_.count();
  // What goes wrong here is told by the next wait; meanwhile no VBLANK is known.
  static_cast<void>(query_vblank(false));
  return count_;
}

Status KmsPanel::do_wait_for_vblank() noexcept {
  if (const Status s = take_lost(); !s.ok()) return s;
  constexpr int longest = 1000;
  // Drivers that know no VBLANK often flip at once.
  if (!tells_vblanks())
    if (const Status s = ticks_.wait(); !s.ok()) return s;
  if (flipping_) {
    const Status s = take_events(longest);
    return s.ok() ? take_lost() : s;
  }
  if (!tells_vblanks() || query_vblank(true)) return {};
  // The kernel's word for a VBLANK that doesn't come.
  return file_.note("waiting for the VBLANK failed", errno == EBUSY ? ETIMEDOUT : errno, Part::panel);
}

}  // namespace hal::linux_io
