// SPDX-License-Identifier: MIT
//
// The functions of libdrm that are used, over a card that isn't there: one screen, one engine.
#include "fake_card.hpp"

#include <cerrno>
#include <cstdlib>
#include <memory>
#include <xf86drm.h>
#include <xf86drmMode.h>

namespace fake_card {

namespace {
std::unique_ptr<Card> the_card = std::make_unique<Card>();
constexpr int file_number = 9;
constexpr std::uint32_t connector_id = 31;
constexpr std::uint32_t encoder_id = 32;
constexpr std::uint32_t other_encoder_id = 33;
constexpr std::uint32_t first_engine_id = 40;

std::uint32_t engine_id(int engine) {
  return engine == none ? 0U : first_engine_id + static_cast<std::uint32_t>(engine);
}

int fail(int error) {
  errno = error;
  return -1;
}

template <class T>
T* zeroed(std::size_t count = 1) {
  return static_cast<T*>(std::calloc(count, sizeof(T)));
}
}  // namespace

Card& card() { return *the_card; }
void reset() { the_card = std::make_unique<Card>(); }

void Card::vblank() {
  ++sequence;
  if (flip_to == 0 || flips_stick) return;
  shown = flip_to;
  flip_to = 0;
  events.push_back(flip_data);
}

std::uint32_t Card::pixel(int x, int y) const {
  const auto frame = frame_buffers.find(shown);
  if (frame == frame_buffers.end()) return 0;
  const Buffer& buffer = buffers.at(frame->second);
  const std::size_t at = static_cast<std::size_t>(y) * buffer.stride + static_cast<std::size_t>(x) * 4U;
  return static_cast<std::uint32_t>(buffer.memory.at(at)) |
         static_cast<std::uint32_t>(buffer.memory.at(at + 1U)) << 8U |
         static_cast<std::uint32_t>(buffer.memory.at(at + 2U)) << 16U;
}

int Kernel::open(const char*, int) {
  if (open_error != 0) return fail(open_error);
  ++open_files;
  return file_number;
}
int Kernel::close(int) {
  --open_files;
  return 0;
}
int Kernel::poll(pollfd* files, unsigned, int milliseconds) {
  if (milliseconds > 0 && card().signals > 0) {
    --card().signals;
    time.advance(1'000'000);
    return fail(EINTR);
  }
  if (card().events.empty() && milliseconds > 0) card().vblank();
  files->revents = card().events.empty() ? 0 : POLLIN;
  return card().events.empty() ? 0 : 1;
}
void* Kernel::map(int, std::size_t, std::uint64_t offset) {
  ++card().maps;
  return card().buffers.at(static_cast<std::uint32_t>(offset >> 12)).memory.data();
}
void Kernel::unmap(void*, std::size_t) { --card().maps; }

}  // namespace fake_card

using fake_card::card;
using fake_card::fail;
using fake_card::zeroed;

extern "C" {

int drmGetCap(int, uint64_t, uint64_t* value) {
  *value = card().has_dumb_buffers ? 1 : 0;
  return 0;
}

int drmIoctl(int, unsigned long request, void* argument) {
  if (request == DRM_IOCTL_MODE_CREATE_DUMB) {
    auto& create = *static_cast<drm_mode_create_dumb*>(argument);
    create.handle = static_cast<std::uint32_t>(card().buffers.size()) + 1U;
    create.pitch = create.width * 4U + 64U;
    create.size = static_cast<std::uint64_t>(create.pitch) * create.height;
    card().buffers[create.handle] = {create.pitch, std::vector<std::uint8_t>(create.size, 0x77)};
    if (card().pitch_lie != 0) create.pitch = card().pitch_lie;
    if (card().size_lie != 0) create.size = card().size_lie;
    return 0;
  }
  if (request == DRM_IOCTL_MODE_MAP_DUMB) {
    auto& map = *static_cast<drm_mode_map_dumb*>(argument);
    map.offset = static_cast<std::uint64_t>(map.handle) << 12U;
    return 0;
  }
  card().buffers.erase(static_cast<drm_mode_destroy_dumb*>(argument)->handle);
  return 0;
}

drmModeRes* drmModeGetResources(int) {
  if (card().resources_error != 0) {
    errno = card().resources_error;
    return nullptr;
  }
  auto* const all = zeroed<drmModeRes>();
  all->count_connectors = 1;
  all->count_encoders = 2;
  all->count_crtcs = card().engines;
  all->connectors = zeroed<std::uint32_t>();
  all->encoders = zeroed<std::uint32_t>(2);
  all->crtcs = zeroed<std::uint32_t>(static_cast<std::size_t>(card().engines));
  *all->connectors = fake_card::connector_id;
  all->encoders[0] = fake_card::other_encoder_id;
  all->encoders[1] = fake_card::encoder_id;
  for (int i = 0; i < card().engines; ++i) all->crtcs[i] = fake_card::engine_id(i);
  return all;
}
void drmModeFreeResources(drmModeRes* all) {
  std::free(all->connectors);
  std::free(all->encoders);
  std::free(all->crtcs);
  std::free(all);
}

drmModeConnector* drmModeGetConnector(int, uint32_t id) {
  auto* const connector = zeroed<drmModeConnector>();
  connector->connector_id = id;
  connector->connection = card().plugged_in ? DRM_MODE_CONNECTED : DRM_MODE_DISCONNECTED;
  connector->count_modes = card().plugged_in ? 1 : 0;
  connector->modes = zeroed<drmModeModeInfo>();
  connector->modes->hdisplay = static_cast<std::uint16_t>(card().width);
  connector->modes->vdisplay = static_cast<std::uint16_t>(card().height);
  connector->modes->vrefresh = card().refresh;
  connector->modes->clock = card().clock;
  connector->modes->htotal = card().total_width;
  connector->modes->vtotal = card().total_height;
  connector->modes->flags = card().mode_flags;
  connector->encoder_id = card().driven_by == fake_card::none ? 0U : fake_card::encoder_id;
  connector->count_encoders = 1;
  connector->encoders = zeroed<std::uint32_t>();
  *connector->encoders = fake_card::encoder_id;
  return connector;
}
void drmModeFreeConnector(drmModeConnector* connector) {
  std::free(connector->modes);
  std::free(connector->encoders);
  std::free(connector);
}

drmModeEncoder* drmModeGetEncoder(int, uint32_t id) {
  auto* const encoder = zeroed<drmModeEncoder>();
  encoder->encoder_id = id;
  encoder->possible_crtcs = (1U << static_cast<unsigned>(card().engines)) - 1U;
  const bool ours = id == fake_card::encoder_id;
  encoder->crtc_id = fake_card::engine_id(ours ? card().driven_by : card().other_driven_by);
  return encoder;
}
void drmModeFreeEncoder(drmModeEncoder* encoder) { std::free(encoder); }

drmModeCrtc* drmModeGetCrtc(int, uint32_t) {
  auto* const engine = zeroed<drmModeCrtc>();
  engine->buffer_id = card().shown_before;
  engine->mode_valid = card().shown_before != 0 ? 1 : 0;
  return engine;
}
void drmModeFreeCrtc(drmModeCrtc* engine) { std::free(engine); }

int drmModeSetCrtc(int, uint32_t engine, uint32_t frame, uint32_t, uint32_t, uint32_t*, int,
                   drmModeModeInfo*) {
  if (engine < fake_card::first_engine_id) return fail(ENOENT);
  if (card().flip_to != 0) return fail(EBUSY);
  if (card().set_error != 0) return fail(card().set_error);
  card().shown = frame;
  card().engine = static_cast<int>(engine - fake_card::first_engine_id);
  return 0;
}

int drmModeAddFB(int, uint32_t, uint32_t, uint8_t depth, uint8_t bits, uint32_t, uint32_t handle,
                 uint32_t* id) {
  if (depth != 24 || bits != 32) return fail(EINVAL);
  *id = handle + 100U;
  card().frame_buffers[*id] = handle;
  return 0;
}
int drmModeRmFB(int, uint32_t id) {
  card().frame_buffers.erase(id);
  return 0;
}

int drmModePageFlip(int, uint32_t, uint32_t frame, uint32_t flags, void* data) {
  if (card().flip_error != 0 && card().flips_left-- <= 0) return fail(card().flip_error);
  if (card().flip_to != 0) return fail(EBUSY);
  if (flags != DRM_MODE_PAGE_FLIP_EVENT || !card().frame_buffers.contains(frame)) return fail(EINVAL);
  card().flip_to = frame;
  card().flip_data = data;
  if (card().flips_at_once) card().vblank();
  return 0;
}

int drmHandleEvent(int, drmEventContext* handlers) {
  std::vector<void*> all;
  all.swap(card().events);
  for (void* const data : all) handlers->page_flip_handler(0, card().sequence, 0, 0, data);
  return 0;
}

int drmWaitVBlank(int, drmVBlank* vblank) {
  if (!card().tells_vblanks) return fail(EOPNOTSUPP);
  if (card().vblank_error != 0) return fail(card().vblank_error);
  for (unsigned i = 0; i < vblank->request.sequence; ++i) card().vblank();
  vblank->reply.sequence = card().sequence;
  return 0;
}

}  // extern "C"
