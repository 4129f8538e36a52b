// SPDX-License-Identifier: MIT
//
// The device side of the report protocol: takes reports, drives a panel, sends reports. Freestanding, so any
// microcontroller with USB can be such a display.
//
// Rule: rectangles change a picture that isn't shown. COMMIT has it shown, colours and all, from the next
// VBLANK on, but only if its checksum is the one the host expects; so whatever is lost, doubled or garbled on
// the way, nothing is ever displayed but a frame that the host has committed. Until that VBLANK no report is
// taken (`ready`), which holds the host back.
//
// How it is called:
//
//     on an output report, when ready():  device.receive(report)   (and when not: leave it in the endpoint)
//     as often as possible:               device.poll()
//     when the input endpoint is free:    device.next(report)      (0: there is nothing to say)
//     on GET_REPORT of the feature:       device.describe(report)
//     on a bus reset or disconnection:    device.unplugged()
//
// Memory: this object (about 1 KB, most of it the palette); on a panel that scans out two buffers no more, on
// others one picture that the caller gives. Work: a report is handled in time proportional to the bytes of
// the rectangle that it covers, a commit in about 10 instructions a byte of the picture (the checksum).
// Nothing is assumed of what arrives: reports that make no sense spoil at most the frame they belong to.
#pragma once

#include <hal/hid/protocol.hpp>
#include <hal/input.hpp>
#include <hal/panel.hpp>

#include <array>
#include <cstdint>
#include <span>

namespace hal::hid {

struct DeviceOptions {
  std::size_t report_bytes = least_report_bytes;
  int window = most_window;
};

/// What happened so far; all wrap.
struct DeviceCounters {
  std::uint32_t accepted = 0;   ///< reports in sequence
  std::uint32_t repeated = 0;   ///< reports that had arrived before
  std::uint32_t early = 0;      ///< reports behind a gap
  std::uint32_t foreign = 0;    ///< reports of another session, of no type, too short
  std::uint32_t overrun = 0;    ///< reports that came when `ready` said no
  std::uint32_t committed = 0;  ///< frames that passed
  std::uint32_t rejected = 0;   ///< frames that didn't
  std::uint32_t sessions = 0;
};

class Device {
 public:
  /// Bytes of `memory` that a panel needs: 0 if it scans out two buffers or more, else one picture.
  [[nodiscard]] static std::size_t memory_for(const Capabilities& panel) noexcept;

  /// `panel` tells its VBLANKs (`vblank_count`), by a signal or a clock. `input` may be null.
  Device(Panel& panel, Input* input, std::span<std::uint8_t> memory,
         const DeviceOptions& options = {}) noexcept;
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  /// Errors: buffer (too little memory), panel (a pixel format or size the protocol doesn't have), invalid
  /// none (report size, window). A device with an error takes no report.
  [[nodiscard]] Status status() const noexcept { return status_; }

  /// True if an output report may be handed over now.
  [[nodiscard]] bool ready() const noexcept { return status_.ok() && committing_ == Stage::idle; }
  void receive(std::span<const std::uint8_t> report) noexcept;

  /// Sees what the panel, its beam and the keys have come to.
  void poll() noexcept;

  /// Writes the next input report and answers its size; 0: there is none. Errors: a `report` that is shorter
  /// than the report size gets none.
  [[nodiscard]] std::size_t next(std::span<std::uint8_t> report) noexcept;

  /// Writes the feature report: 64 bytes, or what fits.
  void describe(std::span<std::uint8_t> report) const noexcept;

  /// The host is gone. What is on display stays.
  void unplugged() noexcept;

  [[nodiscard]] const DeviceCounters& counters() const noexcept { return counters_; }
  /// The frame on display as the host numbers it; 0: none of this session.
  [[nodiscard]] std::uint16_t shown() const noexcept { return state_.shown; }
  [[nodiscard]] std::size_t report_bytes() const noexcept { return info_.report_bytes; }

 private:
  enum class Stage : std::uint8_t { idle, waiting_for_vblank, shown_by_panel };

  void open(const Report& report) noexcept;
  void take(const Report& report) noexcept;
  void take_palette(const Report& report) noexcept;
  void take_rectangle(const Report& report) noexcept;
  void take_runs(std::span<const std::uint8_t> tokens) noexcept;
  void take_commit(const Report& report) noexcept;
  void spoil(Verdict verdict) noexcept;
  void finish() noexcept;
  void appeared() noexcept;

  [[nodiscard]] bool scans_out() const noexcept;
  [[nodiscard]] std::span<std::uint8_t> row(int y) const noexcept;
  [[nodiscard]] std::uint32_t checksum() const noexcept;
  [[nodiscard]] std::span<const std::uint8_t> colours() const noexcept;
  [[nodiscard]] Rect aligned(const Rect& area) const noexcept;

  Panel* panel_;
  Input* input_;
  Status status_;
  DeviceInfo info_;
  DeviceState state_;
  DeviceCounters counters_;

  std::span<std::uint8_t> work_;
  int work_stride_ = 0;
  int back_ = 1;
  std::array<std::uint8_t, 768> palette_{};

  /// The rectangle that runs are written to, and how many of its bytes are.
  Rect area_{};
  std::size_t written_ = 0;
  /// What has changed since the last frame on display; only write panels need it.
  Rect changed_{};

  Verdict spoilt_ = Verdict::accepted;
  Stage committing_ = Stage::idle;
  std::uint16_t committing_frame_ = 0;
  std::uint32_t committed_at_ = 0;
  /// The panel's count when the session began.
  std::uint32_t vblanks_before_ = 0;

  bool has_session_ = false;
  bool tell_vblank_ = false;
  bool info_due_ = false;
  bool state_due_ = false;
  bool complaint_due_ = false;
  bool colours_due_ = false;
  std::uint8_t complaint_ = 0;
  std::uint8_t colours_from_ = 0;
  int unacknowledged_ = 0;
};

}  // namespace hal::hid
