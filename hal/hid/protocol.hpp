// SPDX-License-Identifier: MIT
//
// The report protocol between a host and a display that is a USB HID device: what the reports hold. What they
// mean, and why, is written in PROTOCOL.md; this is the one place where their bytes are counted.
//
// Rule: every report has a header of six bytes and is padded with zeros to the report size; numbers are
// little-endian. A decoder answers nothing unless every field of the report can be what it claims, so what
// comes out of one can be used without further checks.
#pragma once

#include <hal/panel.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace hal::hid {

inline constexpr std::uint8_t version_major = 1;
inline constexpr std::uint8_t version_minor = 0;

/// Bytes of a report, the same in both directions; what is needed to begin fits the least.
inline constexpr std::size_t least_report_bytes = 64;
inline constexpr std::size_t most_report_bytes = 1024;
inline constexpr std::size_t header_bytes = 6;
/// Reports that may be on their way at once: half of the 32 that a Linux uhid queue holds before it drops.
inline constexpr int most_window = 16;
/// Sides of the largest picture.
inline constexpr int most_side = 4096;
/// A frame in 10 seconds: a host waits some frames for a VBLANK before it gives a device up.
inline constexpr std::uint32_t least_millihertz = 100;
/// Bytes of a RECTANGLE's payload in front of its runs.
inline constexpr std::size_t rectangle_bytes = 8;

enum class ReportType : std::uint8_t {
  // host to device
  hello = 0x01,
  ask_colours = 0x02,
  palette = 0x10,
  rectangle = 0x11,
  pixels = 0x12,
  commit = 0x13,
  // device to host
  capabilities = 0x81,
  status = 0x82,
  colours = 0x83,
};

/// A report taken apart: the payload is what its length field covers.
struct Report {
  ReportType type{};
  std::uint8_t session = 0;
  std::uint16_t sequence = 0;
  std::span<const std::uint8_t> payload{};
};

/// Nothing, if the report is shorter than its header or its length says more than there is.
[[nodiscard]] std::optional<Report> parse(std::span<const std::uint8_t> report) noexcept;

/// Writes a report: header and payload, then zeros to the end. The payload is cut to what fits. `payload` may
/// lie in `report` where it belongs already.
void compose(std::span<std::uint8_t> report, const Report& what) noexcept;

/// Opens a session, or asks again for what the device answered.
struct Hello {
  /// Chosen by the host, another one each time; its low byte marks the reports of the session and isn't 0.
  std::uint32_t nonce = 0;
  /// A STATUS at every VBLANK, not only when something happened.
  bool tell_vblank = true;
  static constexpr std::size_t bytes = 11;
};
[[nodiscard]] std::array<std::uint8_t, Hello::bytes> encode(const Hello& hello) noexcept;
/// Nothing also for another major version.
[[nodiscard]] std::optional<Hello> decode_hello(std::span<const std::uint8_t> payload) noexcept;

/// What the device is. Also the feature report, then with nonce 0.
struct DeviceInfo {
  std::uint32_t nonce = 0;
  std::uint16_t report_bytes = least_report_bytes;
  std::uint8_t window = most_window;
  bool has_keys = false;
  /// `fixed_palette` is empty: it is asked for by itself.
  Capabilities capabilities{};
  static constexpr std::size_t bytes = 32;
};
[[nodiscard]] std::array<std::uint8_t, DeviceInfo::bytes> encode(const DeviceInfo& info) noexcept;
/// Nothing if a field is out of its range, or of another major version.
[[nodiscard]] std::optional<DeviceInfo> decode_info(std::span<const std::uint8_t> payload) noexcept;

/// What became of a frame.
enum class Verdict : std::uint8_t {
  accepted = 0,   ///< It is shown from the next VBLANK on.
  malformed = 1,  ///< A report of it makes no sense.
  outside = 2,    ///< A rectangle or a colour that the panel doesn't have.
  mismatch = 3,   ///< The checksum differs from that of what the device holds.
};

/// The state of the device: each holds all of it, so none of them is missed for long.
struct DeviceState {
  /// The sequence number that the device takes next: all before it have arrived.
  std::uint16_t next = 0;
  /// Something beyond `next` has arrived: reports were lost.
  bool gap = false;
  /// The device knows no session with the mark in the header.
  bool no_session = false;
  /// The panel behind the device refuses what is sent to it.
  bool panel_failed = false;
  Verdict verdict = Verdict::accepted;
  /// The frame that the verdict is about; 0: none yet.
  std::uint16_t decided = 0;
  /// The frame on display; 0: none of this session.
  std::uint16_t shown = 0;
  /// VBLANKs since the session began; wraps.
  std::uint32_t vblanks = 0;
  /// Bit n is key n of `hal::Key`.
  std::uint16_t keys = 0;
  static constexpr std::size_t bytes = 12;
};
[[nodiscard]] std::array<std::uint8_t, DeviceState::bytes> encode(const DeviceState& state) noexcept;
/// `next` comes from the header.
[[nodiscard]] std::optional<DeviceState> decode_state(const Report& report) noexcept;

/// Where the runs of a RECTANGLE go.
[[nodiscard]] std::array<std::uint8_t, rectangle_bytes> encode(const Rect& area) noexcept;
/// Any four numbers; whether they lie on the panel says `fits`.
[[nodiscard]] std::optional<Rect> decode_rect(std::span<const std::uint8_t> payload) noexcept;
/// True if the rectangle lies on the panel, isn't empty, and consists of whole bytes of its rows.
[[nodiscard]] bool fits(const Rect& area, const Capabilities& panel) noexcept;

struct Commit {
  /// Numbers frames; never 0.
  std::uint16_t frame = 0;
  /// CRC-32 over the palette's bytes and then the picture's, row by row.
  std::uint32_t checksum = 0;
  static constexpr std::size_t bytes = 6;
};
[[nodiscard]] std::array<std::uint8_t, Commit::bytes> encode(const Commit& commit) noexcept;
[[nodiscard]] std::optional<Commit> decode_commit(std::span<const std::uint8_t> payload) noexcept;

/// Entries of a palette from `first` on, as PALETTE and COLOURS carry them.
struct PalettePart {
  int first = 0;
  std::span<const std::uint8_t> rgb{};
};
/// Nothing unless there are whole entries, at least one, and none above 255.
[[nodiscard]] std::optional<PalettePart> decode_palette(std::span<const std::uint8_t> payload) noexcept;
/// Entries that one report carries.
[[nodiscard]] constexpr int palette_entries_in(std::size_t report_bytes) noexcept {
  return static_cast<int>((report_bytes - header_bytes - 1) / 3);
}

/// Bytes of a row of pixels.
[[nodiscard]] constexpr std::size_t row_bytes(int width, int bits_per_pixel) noexcept {
  return (static_cast<std::size_t>(width) * static_cast<std::size_t>(bits_per_pixel) + 7U) / 8U;
}
/// Bytes of a picture whose rows lie close together.
[[nodiscard]] constexpr std::size_t picture_bytes(const Capabilities& panel) noexcept {
  return row_bytes(panel.width, panel.bits_per_pixel) * static_cast<std::size_t>(panel.height);
}

/// How the device is found: by the usage in its report descriptor. The vendor and product numbers are those
/// that pid.codes keeps for tests; whoever sells a device takes their own.
inline constexpr std::uint16_t usage_page = 0xFF49;
inline constexpr std::uint8_t usage = 0x01;
inline constexpr std::uint16_t test_vendor = 0x1209;
inline constexpr std::uint16_t test_product = 0x0002;

/// The report descriptor: input, output and feature reports without numbers.
[[nodiscard]] constexpr std::array<std::uint8_t, 35> report_descriptor(std::size_t report_bytes) noexcept {
  const auto low = static_cast<std::uint8_t>(report_bytes & 0xFFU);
  const auto high = static_cast<std::uint8_t>(report_bytes >> 8U);
  return {
      0x06,
      usage_page & 0xFF,
      usage_page >> 8,  // usage page: vendor defined
      0x09,
      usage,  // usage: display
      0xA1,
      0x01,  // collection: application
      0x15,
      0x00,
      0x26,
      0xFF,
      0x00,  //   logical minimum 0, maximum 255
      0x75,
      0x08,  //   report size: 8 bits
      0x96,
      low,
      high,
      0x09,
      0x02,
      0x81,
      0x02,  //   input, `report_bytes` times
      0x96,
      low,
      high,
      0x09,
      0x03,
      0x91,
      0x02,  //   output
      0x95,
      0x40,
      0x09,
      0x04,
      0xB1,
      0x02,  //   feature, 64 times
      0xC0   // end of collection
  };
}

}  // namespace hal::hid
