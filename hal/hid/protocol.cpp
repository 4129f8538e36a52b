// SPDX-License-Identifier: MIT
#include <hal/hid/protocol.hpp>

#include <algorithm>

namespace hal::hid {

namespace {

constexpr std::array<std::uint8_t, 4> magic{'I', 'T', 'G', 'L'};

/// Puts numbers into bytes, low byte first.
class Writer {
 public:
  explicit constexpr Writer(std::span<std::uint8_t> out) noexcept : out_(out) {}
  constexpr Writer& number(std::uint32_t value, std::size_t bytes) noexcept {
    for (std::size_t i = 0; i < bytes; ++i, value >>= 8U) out_[at_++] = static_cast<std::uint8_t>(value);
    return *this;
  }
  constexpr Writer& byte(std::uint32_t value) noexcept { return number(value & 0xFFU, 1); }
  constexpr Writer& half(std::uint32_t value) noexcept { return number(value & 0xFFFFU, 2); }
  constexpr Writer& word(std::uint32_t value) noexcept { return number(value, 4); }

 private:
  std::span<std::uint8_t> out_;
  std::size_t at_ = 0;
};

/// Takes them out again. The caller has checked that there are enough bytes.
class Reader {
 public:
  explicit constexpr Reader(std::span<const std::uint8_t> in) noexcept : in_(in) {}
  constexpr std::uint32_t number(std::size_t bytes) noexcept {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < bytes; ++i) value |= static_cast<std::uint32_t>(in_[at_++]) << (8U * i);
    return value;
  }
  constexpr std::uint8_t byte() noexcept { return static_cast<std::uint8_t>(number(1)); }
  constexpr std::uint16_t half() noexcept { return static_cast<std::uint16_t>(number(2)); }
  constexpr std::uint32_t word() noexcept { return number(4); }

 private:
  std::span<const std::uint8_t> in_;
  std::size_t at_ = 0;
};

bool opens_with_magic(std::span<const std::uint8_t> payload) noexcept {
  return std::equal(magic.begin(), magic.end(), payload.begin());
}

constexpr std::uint32_t flag(bool set, unsigned bit) noexcept { return set ? 1U << bit : 0U; }
constexpr bool has(std::uint32_t flags, unsigned bit) noexcept { return (flags >> bit & 1U) != 0; }

}  // namespace

std::optional<Report> parse(std::span<const std::uint8_t> report) noexcept {
  if (report.size() < header_bytes) return {};
  Reader in(report);
  Report r;
  r.type = static_cast<ReportType>(in.byte());
  r.session = in.byte();
  r.sequence = in.half();
  const std::size_t length = in.half();
  if (length > report.size() - header_bytes) return {};
  r.payload = report.subspan(header_bytes, length);
  return r;
}

void compose(std::span<std::uint8_t> report, const Report& what) noexcept {
  if (report.size() < header_bytes) return;
  const auto body = report.subspan(header_bytes);
  const std::size_t length = std::min(what.payload.size(), body.size());
  Writer(report)
      .byte(static_cast<std::uint8_t>(what.type))
      .byte(what.session)
      .half(what.sequence)
      .half(static_cast<std::uint32_t>(length));
  if (what.payload.data() != body.data()) std::copy_n(what.payload.begin(), length, body.begin());
  std::fill(body.begin() + static_cast<std::ptrdiff_t>(length), body.end(), std::uint8_t{0});
}

std::array<std::uint8_t, Hello::bytes> encode(const Hello& hello) noexcept {
  std::array<std::uint8_t, Hello::bytes> out{};
  std::copy(magic.begin(), magic.end(), out.begin());
  Writer(std::span(out).subspan(magic.size()))
      .byte(version_major)
      .byte(version_minor)
      .word(hello.nonce)
      .byte(flag(hello.tell_vblank, 0));
  return out;
}

std::optional<Hello> decode_hello(std::span<const std::uint8_t> payload) noexcept {
  if (payload.size() < Hello::bytes || !opens_with_magic(payload)) return {};
  Reader in(payload.subspan(magic.size()));
  if (in.byte() != version_major) return {};
  in.byte();
  Hello hello;
  hello.nonce = in.word();
  hello.tell_vblank = has(in.byte(), 0);
  if ((hello.nonce & 0xFFU) == 0) return {};
  return hello;
}

std::array<std::uint8_t, DeviceInfo::bytes> encode(const DeviceInfo& info) noexcept {
  const Capabilities& c = info.capabilities;
  std::array<std::uint8_t, DeviceInfo::bytes> out{};
  std::copy(magic.begin(), magic.end(), out.begin());
  Writer(std::span(out).subspan(magic.size()))
      .byte(version_major)
      .byte(version_minor)
      .word(info.nonce)
      .half(info.report_bytes)
      .byte(info.window)
      .byte(flag(c.bit_order == BitOrder::lsb_first, 0) | flag(c.vblank_signal, 1) | flag(info.has_keys, 2))
      .half(static_cast<std::uint32_t>(c.width))
      .half(static_cast<std::uint32_t>(c.height))
      .byte(static_cast<std::uint32_t>(c.bits_per_pixel))
      .byte(static_cast<std::uint32_t>(c.scan))
      .half(static_cast<std::uint32_t>(c.palette_entries))
      .byte(static_cast<std::uint32_t>(c.palette_bits))
      .byte(0)
      .word(c.refresh_millihertz);
  return out;
}

std::optional<DeviceInfo> decode_info(std::span<const std::uint8_t> payload) noexcept {
  if (payload.size() < DeviceInfo::bytes || !opens_with_magic(payload)) return {};
  Reader in(payload.subspan(magic.size()));
  if (in.byte() != version_major) return {};
  in.byte();
  DeviceInfo info;
  Capabilities& c = info.capabilities;
  info.nonce = in.word();
  info.report_bytes = in.half();
  info.window = in.byte();
  const std::uint32_t flags = in.byte();
  c.bit_order = has(flags, 0) ? BitOrder::lsb_first : BitOrder::msb_first;
  c.vblank_signal = has(flags, 1);
  info.has_keys = has(flags, 2);
  c.width = in.half();
  c.height = in.half();
  c.bits_per_pixel = in.byte();
  const std::uint8_t scan = in.byte();
  c.palette_entries = in.half();
  c.palette_bits = in.byte();
  in.byte();
  c.refresh_millihertz = in.word();
  const int bits = c.bits_per_pixel;
  const bool possible = info.report_bytes >= least_report_bytes && info.report_bytes <= most_report_bytes &&
                        info.window >= 1 && info.window <= most_window && c.width >= 1 &&
                        c.width <= most_side && c.height >= 1 && c.height <= most_side &&
                        (bits == 1 || bits == 2 || bits == 4 || bits == 8) && scan <= 3 &&
                        c.palette_entries <= 1 << bits && c.palette_bits >= 1 && c.palette_bits <= 8 &&
                        c.refresh_millihertz >= least_millihertz;
  if (!possible) return {};
  c.scan = static_cast<ScanDirection>(scan);
  return info;
}

std::array<std::uint8_t, DeviceState::bytes> encode(const DeviceState& state) noexcept {
  std::array<std::uint8_t, DeviceState::bytes> out{};
  Writer(out)
      .byte(flag(state.gap, 0) | flag(state.no_session, 1) | flag(state.panel_failed, 2))
      .byte(static_cast<std::uint8_t>(state.verdict))
      .half(state.decided)
      .half(state.shown)
      .word(state.vblanks)
      .half(state.keys);
  return out;
}

std::optional<DeviceState> decode_state(const Report& report) noexcept {
  if (report.payload.size() < DeviceState::bytes) return {};
  Reader in(report.payload);
  DeviceState state;
  state.next = report.sequence;
  const std::uint32_t flags = in.byte();
  state.gap = has(flags, 0);
  state.no_session = has(flags, 1);
  state.panel_failed = has(flags, 2);
  const std::uint8_t verdict = in.byte();
  if (verdict > static_cast<std::uint8_t>(Verdict::mismatch)) return {};
  state.verdict = static_cast<Verdict>(verdict);
  state.decided = in.half();
  state.shown = in.half();
  state.vblanks = in.word();
  state.keys = in.half();
  return state;
}

std::array<std::uint8_t, rectangle_bytes> encode(const Rect& area) noexcept {
  std::array<std::uint8_t, rectangle_bytes> out{};
  Writer(out)
      .half(static_cast<std::uint32_t>(area.x))
      .half(static_cast<std::uint32_t>(area.y))
      .half(static_cast<std::uint32_t>(area.width))
      .half(static_cast<std::uint32_t>(area.height));
  return out;
}

std::optional<Rect> decode_rect(std::span<const std::uint8_t> payload) noexcept {
  if (payload.size() < rectangle_bytes) return {};
  Reader in(payload);
  Rect area;
  area.x = in.half();
  area.y = in.half();
  area.width = in.half();
  area.height = in.half();
  return area;
}

bool fits(const Rect& area, const Capabilities& panel) noexcept {
  if (area.x < 0 || area.y < 0 || area.width < 1 || area.height < 1 || area.x >= panel.width ||
      area.y >= panel.height || area.width > panel.width - area.x || area.height > panel.height - area.y)
    return false;
  const int a_byte = 8 / panel.bits_per_pixel;
  const int end = area.x + area.width;
  return area.x % a_byte == 0 && (end % a_byte == 0 || end == panel.width);
}

std::array<std::uint8_t, Commit::bytes> encode(const Commit& commit) noexcept {
  std::array<std::uint8_t, Commit::bytes> out{};
  Writer(out).half(commit.frame).word(commit.checksum);
  return out;
}

std::optional<Commit> decode_commit(std::span<const std::uint8_t> payload) noexcept {
  if (payload.size() < Commit::bytes) return {};
  Reader in(payload);
  Commit commit;
  commit.frame = in.half();
  commit.checksum = in.word();
  if (commit.frame == 0) return {};
  return commit;
}

std::optional<PalettePart> decode_palette(std::span<const std::uint8_t> payload) noexcept {
  if (payload.size() < 4 || (payload.size() - 1) % 3 != 0) return {};
  const PalettePart part{payload[0], payload.subspan(1)};
  if (static_cast<std::size_t>(part.first) + part.rgb.size() / 3U > 256U) return {};
  return part;
}

}  // namespace hal::hid
