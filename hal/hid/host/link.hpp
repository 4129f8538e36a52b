// SPDX-License-Identifier: MIT
//
// The host's end of the report protocol: sessions, sequence numbers, flow control, and what is done when
// reports are lost.
//
// Rule: a report is kept until the device has acknowledged it, and no more are on their way than the device
// allows (16 at most), so no queue between the two is ever filled. The device takes reports only in sequence;
// when one is missing (it says so, or says nothing for a while) all from there on are sent again. The while
// is taken from the round trips that were measured, so a report that is lost at 60 Hz costs no VBLANK. While
// a frame waits for its VBLANK the device takes nothing, and that isn't measured.
#pragma once

#include <hal/clock.hpp>
#include <hal/hid/host/report_port.hpp>
#include <hal/hid/protocol.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace hal::hid {

struct LinkOptions {
  /// Without a word from the device for so long at most, reports are sent again; doubled each time, up to 8
  /// times this. Once the round trip is known, it is its mean and four times its mean deviation.
  Nanoseconds retry = 50'000'000;
  Nanoseconds least_retry = 2'000'000;
  /// Without progress for so long, the device is given up.
  Nanoseconds patience = 4'000'000'000;
};

/// What happened so far.
struct LinkCounters {
  std::uint64_t sent = 0;
  std::uint64_t resent = 0;
  std::uint64_t prompts = 0;  ///< reports to be told what wasn't heard in time
  std::uint64_t received = 0;
  std::uint64_t senseless = 0;  ///< input reports that can't be what they claim
  std::uint64_t refused = 0;    ///< reports that the port didn't take
  std::uint64_t sessions = 0;
};

class Link {
 public:
  /// Port and clock outlive the link.
  Link(ReportPort& port, Clock& clock, const LinkOptions& options = {});

  /// Opens a session and learns what the device is. Errors: timeout (nothing answers), unsupported (what
  /// answers is no such device, or of another version), disconnected, bus.
  Status open();
  /// Looks for the device again after it was disconnected, and opens a session. Errors: also unsupported,
  /// if it has become another one.
  Status reopen();
  /// Opens another session with the same device, after it has lost the last. Errors: as `reopen`.
  Status renew();

  /// What `open` learned; the fixed palette lies in the link.
  [[nodiscard]] const DeviceInfo& info() const { return info_; }
  /// What the device last said.
  [[nodiscard]] const DeviceState& state() const { return state_; }
  /// True if the device has lost the session: `renew` begins another.
  [[nodiscard]] bool lost() const { return lost_; }

  /// Room for the payload of a report.
  [[nodiscard]] std::size_t room() const { return info_.report_bytes - header_bytes; }
  /// Sends a report of a frame when the device allows it. Errors: timeout, disconnected, bus.
  Status transmit(ReportType type, std::span<const std::uint8_t> payload);
  /// Waits until the device has everything. Errors: timeout, disconnected, bus.
  Status settle();
  /// Takes what the device says, waiting no longer than this for the first report. Errors: timeout (it said
  /// nothing), disconnected, bus.
  Status listen(Nanoseconds patience);
  /// Takes what the device has said so far. Errors: disconnected, bus.
  Status drain();
  /// How long an answer takes at most, as a rule.
  [[nodiscard]] Nanoseconds answer_time() const;
  /// Has the device say its state, by a report that it has already. Errors: disconnected.
  Status prompt();

  /// When the device told of the VBLANK that it told of last.
  [[nodiscard]] Nanoseconds vblank_told_at() const { return vblank_told_at_; }
  [[nodiscard]] Clock& clock() const { return *clock_; }
  [[nodiscard]] Nanoseconds patience() const { return options_.patience; }
  [[nodiscard]] const LinkCounters& counters() const { return counters_; }

 private:
  struct Slot {
    std::array<std::uint8_t, most_report_bytes> bytes{};
    Nanoseconds sent_at = 0;
    bool again = false;
  };

  Status greet();
  Status fetch_colours();
  Status ask(ReportType type, std::span<const std::uint8_t> payload, ReportType answer);
  Status make_progress();
  /// All that are kept, or those from `first` on.
  Status resend();
  Status resend(std::uint16_t first);
  Status put(std::span<const std::uint8_t> report);
  void hear(std::span<const std::uint8_t> report);
  [[nodiscard]] std::uint16_t in_flight() const { return static_cast<std::uint16_t>(next_ - oldest_); }
  [[nodiscard]] std::uint16_t last() const { return static_cast<std::uint16_t>((next_ - 1U) & 0xFFFFU); }
  [[nodiscard]] Slot& slot_of(std::uint16_t sequence) { return slots_[sequence % slots_.size()]; }
  [[nodiscard]] std::span<std::uint8_t> slot(std::uint16_t sequence) {
    return std::span(slot_of(sequence).bytes).first(info_.report_bytes);
  }
  [[nodiscard]] bool frame_waits() const {
    return state_.decided != state_.shown && state_.verdict == Verdict::accepted;
  }
  void take_state(const DeviceState& state);
  void measure(std::uint16_t acknowledged);
  void start_waiting();

  ReportPort* port_;
  Clock* clock_;
  LinkOptions options_;
  DeviceInfo info_;
  std::vector<std::uint8_t> fixed_palette_;
  DeviceState state_;
  LinkCounters counters_;

  std::uint32_t nonce_;
  std::uint8_t session_ = 0;
  bool lost_ = false;

  std::array<Slot, most_window> slots_{};
  std::uint16_t oldest_ = 0;
  std::uint16_t next_ = 0;
  bool gap_ = false;
  Nanoseconds progress_at_ = 0;
  Nanoseconds resend_at_ = 0;
  Nanoseconds pause_ = 0;
  int attempts_ = 0;
  /// All from `oldest_` on were sent again.
  bool served_ = false;

  Nanoseconds vblank_told_at_ = 0;
  /// Of a round trip, once one was measured.
  bool measured_ = false;
  Nanoseconds mean_ = 0;
  Nanoseconds deviation_ = 0;
  /// Since when the device takes reports.
  Nanoseconds taking_since_ = 0;

  /// The answer that `ask` waits for.
  bool answered_ = false;
  ReportType awaited_{};
  DeviceInfo answer_info_;
  std::uint16_t answer_sequence_ = 0;
  std::size_t colours_wanted_ = 0;
};

}  // namespace hal::hid
