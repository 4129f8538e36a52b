// SPDX-License-Identifier: MIT
#include <hal/linux/kms_panel.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fcntl.h>
#include <xf86drm.h>
#include <xf86drmMode.h>

namespace hal::linux_io {

namespace {

/// Objects of libdrm, each with its way to be given back.
template <auto release>
struct Release {
  template <class T>
  void operator()(T* object) const noexcept {
    release(object);
  }
};
template <class T, auto release>
using Owned = std::unique_ptr<T, Release<release>>;
using Resources = Owned<drmModeRes, drmModeFreeResources>;
using Connector = Owned<drmModeConnector, drmModeFreeConnector>;
using Encoder = Owned<drmModeEncoder, drmModeFreeEncoder>;
using Crtc = Owned<drmModeCrtc, drmModeFreeCrtc>;

/// One more than flips need: a picture may wait behind a flip that is under way.
constexpr std::size_t screen_buffers = 3;

int open_card(System& system, const std::string& path) {
  const int file = system.open(path.c_str(), O_RDWR);
  if (file < 0) throw DeviceError(cannot_open(path, "graphics card", errno));
  return file;
}

Connector plugged_in(int file, const drmModeRes& resources) {
  for (int i = 0; i < resources.count_connectors; ++i) {
    Connector connector(drmModeGetConnector(file, resources.connectors[i]));
    if (connector != nullptr && connector->connection == DRM_MODE_CONNECTED && connector->count_modes > 0)
      return connector;
  }
  return nullptr;
}

/// Which of the card's scan-out engines can drive a connector; below 0: none.
int engine_for(int file, const drmModeRes& resources, const drmModeConnector& connector) {
  for (int i = 0; i < connector.count_encoders; ++i) {
    const Encoder encoder(drmModeGetEncoder(file, connector.encoders[i]));
    if (encoder == nullptr) continue;
    for (int engine = 0; engine < resources.count_crtcs; ++engine)
      if ((encoder->possible_crtcs >> static_cast<unsigned>(engine) & 1U) != 0) return engine;
  }
  return -1;
}

/// Refreshes a second times 1000, from the mode's own clock where it has one.
std::uint32_t refresh_of(const drmModeModeInfo& mode) {
  const std::uint64_t pixels = static_cast<std::uint64_t>(mode.htotal) * mode.vtotal;
  if (mode.clock != 0 && pixels != 0) return static_cast<std::uint32_t>(mode.clock * 1'000'000ULL / pixels);
  return mode.vrefresh == 0 ? 60'000U : mode.vrefresh * 1000U;
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
  const File& file;
  std::uint32_t connector = 0;
  std::uint32_t engine = 0;
  int engine_index = 0;
  drmModeModeInfo mode{};
  Crtc before;  // As it was found.
  std::array<DumbBuffer, screen_buffers> buffers{};

  Screen(const File& card, const std::string& name) : file(card) {
    const int number = file.number();
    const Resources resources(drmModeGetResources(number));
    if (resources == nullptr)
      throw DeviceError(name + (errno == EOPNOTSUPP || errno == EINVAL || errno == ENOTTY
                                    ? " has no screens"
                                    : ": its screens can't be listed: " + error_text(errno)));
    const Connector found = plugged_in(number, *resources);
    if (found == nullptr) throw DeviceError(name + ": no screen is plugged in");
    engine_index = engine_for(number, *resources, *found);
    if (engine_index < 0) throw DeviceError(name + ": nothing can drive its screen");
    connector = found->connector_id;
    engine = resources->crtcs[engine_index];
    mode = found->modes[0];  // The one the screen prefers.
    std::uint64_t dumb = 0;
    if (drmGetCap(number, DRM_CAP_DUMB_BUFFER, &dumb) != 0 || dumb == 0)
      throw DeviceError(name + ": its driver has no buffers that programs can draw in");
    before.reset(drmModeGetCrtc(number, engine));
    try {
      for (DumbBuffer& buffer : buffers) make(buffer, name);
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

  void make(DumbBuffer& buffer, const std::string& name) {
    const auto fail = [&name](const char* what) {
      throw DeviceError(name + ": " + what + ": " + error_text(errno));
    };
    drm_mode_create_dumb create{};
    create.width = mode.hdisplay;
    create.height = mode.vdisplay;
    create.bpp = 32;
    if (drmIoctl(file.number(), DRM_IOCTL_MODE_CREATE_DUMB, &create) != 0) fail("a buffer can't be made");
    buffer.handle = create.handle;
    buffer.stride = create.pitch;
    if (drmModeAddFB(file.number(), mode.hdisplay, mode.vdisplay, 24, 32, create.pitch, create.handle,
                     &buffer.id) != 0)
      fail("a buffer can't be shown");
    drm_mode_map_dumb map{};
    map.handle = create.handle;
    if (drmIoctl(file.number(), DRM_IOCTL_MODE_MAP_DUMB, &map) != 0) fail("a buffer can't be mapped");
    void* const memory = file.system().map(file.number(), create.size, static_cast<off_t>(map.offset));
    if (memory == nullptr) fail("a buffer can't be mapped");
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

namespace {

Extent screen_size(const drmModeModeInfo& mode) { return {mode.hdisplay, mode.vdisplay}; }

Extent picture_size(Extent asked, Extent screen, const std::string& name) {
  if (asked == Extent{}) return screen;
  if (asked.width < 1 || asked.height < 1 || asked.width > screen.width || asked.height > screen.height)
    throw DeviceError(name + ": its screen has " + std::to_string(screen.width) + 'x' +
                      std::to_string(screen.height) + " pixels, too few for " + std::to_string(asked.width) +
                      'x' + std::to_string(asked.height));
  return asked;
}

}  // namespace

KmsPanel::KmsPanel(const std::string& path, Extent picture, System& system)
    : name_("graphics card " + path),
      file_(system, open_card(system, path)),
      screen_(std::make_unique<Screen>(file_, name_)),
      placement_(picture_size(picture, screen_size(screen_->mode), name_), screen_size(screen_->mode)),
      palette_(PixelLayout{}),
      ticks_(&clock_, refresh_of(screen_->mode)) {
  const Extent size = placement_.picture();
  capabilities_.width = size.width;
  capabilities_.height = size.height;
  capabilities_.bits_per_pixel = 8;
  capabilities_.palette_entries = 256;
  capabilities_.buffers = buffers;
  capabilities_.refresh_millihertz = refresh_of(screen_->mode);
  std::uint32_t count = 0;
  tells_vblanks_ = query_vblank(false, count);
  capabilities_.vblank_signal = tells_vblanks_;
  memory_.resize(static_cast<std::size_t>(buffers) * static_cast<std::size_t>(size.width) *
                 static_cast<std::size_t>(size.height));
}

KmsPanel::~KmsPanel() {
  // A flip under way would outlive its buffer.
  constexpr int longest_refresh = 100;
  take_events(longest_refresh).ignore();
}

std::span<std::uint8_t> KmsPanel::do_buffer(int index) noexcept {
  const std::size_t size = memory_.size() / static_cast<std::size_t>(buffers);
  return std::span(memory_).subspan(static_cast<std::size_t>(index) * size, size);
}

void KmsPanel::draw(int index, std::size_t on) noexcept {
  DumbBuffer& buffer = screen_->buffers[on];
  placement_.draw(do_buffer(index), palette_, buffer.memory, buffer.stride);
}

Status KmsPanel::flip(std::size_t to) noexcept {
  if (drmModePageFlip(file_.number(), screen_->engine, screen_->buffers[to].id, DRM_MODE_PAGE_FLIP_EVENT,
                      this) != 0)
    return fault_.note(name_, "a page flip failed", errno, Part::buffer);
  flipping_ = to;
  return {};
}

Status KmsPanel::do_show(int index, std::span<const std::uint8_t> palette) noexcept {
  take_events(0).ignore();
  palette_.load(palette);
  shown_index_ = index;
  std::size_t free = 0;
  while (free == shown_ || free == flipping_) ++free;
  draw(index, free);
  if (flipping_ == shown_) return flip(free);
  waiting_ = free;
  return {};
}

void KmsPanel::flipped() noexcept {
  ++flips_;
  const bool another = waiting_ != shown_;
  shown_ = flipping_;
  if (another) flip(waiting_).ignore();  // What fails is said by the next call: `fault_` has it.
  waiting_ = shown_;
}

Status KmsPanel::take_events(int milliseconds) noexcept {
  if (flipping_ == shown_) return {};
  drmEventContext handlers{};
  handlers.version = 2;
  handlers.page_flip_handler = [](int, unsigned, unsigned, unsigned, void* panel) {
    static_cast<KmsPanel*>(panel)->flipped();
  };
  pollfd ready{file_.number(), POLLIN, 0};
  const int come = file_.system().poll(&ready, 1, milliseconds);
  if (come < 0)
    return errno == EINTR ? Status{}
                          : fault_.note(name_, "waiting for a page flip failed", errno, Part::buffer);
  if (come == 0)
    return milliseconds == 0 ? Status{}
                             : fault_.note(name_, "a page flip didn't happen", ETIMEDOUT, Part::buffer);
  if ((ready.revents & POLLIN) == 0)
    return fault_.note(name_, "waiting for a page flip failed", ENODEV, Part::buffer);
  if (drmHandleEvent(file_.number(), &handlers) != 0)
    return fault_.note(name_, "reading of a page flip failed", errno, Part::buffer);
  return {};
}

bool KmsPanel::do_show_pending() noexcept {
  take_events(0).ignore();
  return flipping_ != shown_;
}

Status KmsPanel::do_write(const Rect&, std::span<const std::uint8_t>, int) noexcept {
  return {Error::unsupported, Part::buffer};
}

Status KmsPanel::do_load_palette(std::span<const std::uint8_t> palette) noexcept {
  palette_.load(palette);
  draw(shown_index_, waiting_ != shown_ ? waiting_ : flipping_);
  return {};
}

bool KmsPanel::query_vblank(bool wait, std::uint32_t& count) noexcept {
  drmVBlank vblank{};
  const auto high = static_cast<unsigned>(screen_->engine_index) << DRM_VBLANK_HIGH_CRTC_SHIFT;
  vblank.request.type =
      static_cast<drmVBlankSeqType>(DRM_VBLANK_RELATIVE | (high & DRM_VBLANK_HIGH_CRTC_MASK));
  vblank.request.sequence = wait ? 1 : 0;
  if (drmWaitVBlank(file_.number(), &vblank) != 0) return false;
  count = vblank.reply.sequence;
  return true;
}

std::uint32_t KmsPanel::do_vblank_count() noexcept {
  std::uint32_t count = 0;
  return tells_vblanks_ && query_vblank(false, count) ? count : ticks_.count();
}

Status KmsPanel::do_wait_for_vblank() noexcept {
  constexpr int longest = 1000;
  if (flipping_ != shown_) return take_events(longest);
  std::uint32_t count = 0;
  if (!tells_vblanks_) return ticks_.wait();
  if (query_vblank(true, count)) return {};
  return fault_.note(name_, "waiting for the VBLANK failed", errno, Part::panel);
}

}  // namespace hal::linux_io
