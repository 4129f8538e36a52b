// SPDX-License-Identifier: MIT
//
// What happened when on a simulated panel: the record that --trace writes and --explain reads.
//
// Rule: all times are the panel's virtual ones. Frames are those of the program, counted from 0; the panel
// counts requests from 1, and a frame dropped because it is late isn't requested. A frame is due `interval`
// refreshes after the frame before appeared or, if that was dropped as late, was due. It appears at the
// VBLANK that swaps it in; on a write panel when its first byte is sent.
#pragma once

#include <hal/sim/panel.hpp>
#include <hal/sim/tearing.hpp>
#include <intaglio/present/beam_chaser.hpp>
#include <intaglio/present/pacer.hpp>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

namespace host {

/// From `begin` to `end`, in virtual nanoseconds.
struct Span {
  hal::Nanoseconds begin = 0;
  hal::Nanoseconds end = 0;
  [[nodiscard]] hal::Nanoseconds length() const { return end - begin; }
};

/// One frame of the program.
struct FrameRecord {
  std::uint32_t number = 0;
  std::optional<Span> draw;       ///< From the first band to the last.
  std::vector<Span> transfers;    ///< Of a write panel.
  std::uint64_t bytes = 0;        ///< On the bus.
  std::optional<Span> presented;  ///< From the request until it was on display, or sent, or dropped.
  bool appeared = false;
  bool dropped = false;       ///< It was never requested, being late, or was replaced.
  std::uint32_t vblank = 0;   ///< At which it appeared.
  hal::Nanoseconds time = 0;  ///< When it appeared.
  std::uint32_t late = 0;     ///< Refreshes after it was due.
  std::optional<Span>
      deadline;  ///< From when the frame before appeared, or was due, to when this one was due.
};

/// One refresh: from its first line to its VBLANK; `blanking` to the next one's first line.
struct RefreshRecord {
  std::uint64_t number = 0;
  Span scan;
  Span blanking;
};

class Timeline final : private hal::sim::Observer {
 public:
  /// Must die before the panel. `interval`: refreshes a frame.
  Timeline(hal::sim::Panel& panel, hal::Clock& clock, int interval);
  ~Timeline() override;
  Timeline(const Timeline&) = delete;
  Timeline& operator=(const Timeline&) = delete;

  /// Frames are sent behind the beam: they appear in the refresh that they are aimed at.
  void chase(const intaglio::present::BeamChaser& chaser) { chaser_ = &chaser; }
  /// Drawing of a frame, or of a band of it, begins or ends now.
  void draw_begins(std::uint32_t frame);
  void draw_ends();
  /// The frame drawn last is too late, and isn't shown.
  void drop();
  /// What became of all frames, as `present` counts it.
  void set_counts(const intaglio::present::FrameCounts& counts) { counts_ = counts; }

  [[nodiscard]] const std::optional<intaglio::present::FrameCounts>& counts() const { return counts_; }
  /// The same with frames of the program, counted from 1, in place of the panel's requests.
  [[nodiscard]] std::vector<hal::sim::Tear> of_frames(std::vector<hal::sim::Tear> tears) const;
  [[nodiscard]] const std::vector<FrameRecord>& frames() const { return frames_; }
  [[nodiscard]] const std::vector<RefreshRecord>& refreshes() const { return refreshes_; }
  /// The edges that told the program of VBLANKs; empty where the scenario has no such line.
  [[nodiscard]] const std::vector<hal::Nanoseconds>& te_edges() const { return te_edges_; }
  [[nodiscard]] hal::sim::Panel& panel() const { return *panel_; }
  [[nodiscard]] hal::Nanoseconds now() const { return clock_->now(); }
  /// The time a frame has.
  [[nodiscard]] hal::Nanoseconds budget() const {
    return static_cast<hal::Nanoseconds>(interval_) * panel_->frame_time();
  }

 private:
  void on_line(const hal::sim::ScannedLine& line) override;
  void on_vblank(std::uint64_t refresh, hal::Nanoseconds time) override;
  void on_te(std::uint64_t refresh, hal::Nanoseconds time) override;
  void on_swap(std::uint32_t frame, hal::Nanoseconds time) override;
  void on_dropped(std::uint32_t frame, hal::Nanoseconds time) override;
  void on_transfer(const hal::sim::Transfer& transfer) override;
  void on_presented(const hal::sim::PresentedFrame& frame) override;

  void appear(FrameRecord& frame, std::uint32_t vblank, hal::Nanoseconds time);
  /// The deadline of a frame that was known at `time` to be in time or not: a budget from where the one
  /// before ended, but never later than that time, for an edge of VBLANK comes a little early by jitter or
  /// drift.
  [[nodiscard]] Span deadline(hal::Nanoseconds time) const {
    return {beginning_, std::min(beginning_ + budget(), time)};
  }
  /// The frame that the panel counts as `number`, or none: what was there at the start.
  FrameRecord* frame_of(std::uint32_t number);

  hal::sim::Panel* panel_;
  hal::Clock* clock_;
  const intaglio::present::BeamChaser* chaser_ = nullptr;
  int interval_;
  std::vector<FrameRecord> frames_;
  std::vector<std::uint32_t> requested_;  // Frames, by the panel's number less 1.
  std::optional<intaglio::present::FrameCounts> counts_;
  std::vector<RefreshRecord> refreshes_;
  std::vector<hal::Nanoseconds> te_edges_;
  std::optional<std::uint32_t> last_vblank_;
  hal::Nanoseconds beginning_ = 0;  // When the frame before appeared, or was due if it was dropped as late.
  std::uint32_t vblanks_ = 0;
  hal::Nanoseconds vblank_time_ = 0;  // Of the latest.
  std::uint32_t late_drops_ = 0;      // Since a frame appeared.
};

}  // namespace host
