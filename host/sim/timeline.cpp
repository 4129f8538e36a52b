// SPDX-License-Identifier: MIT
#include <host/sim/timeline.hpp>

#include <algorithm>

namespace host {

Timeline::Timeline(hal::sim::Panel& panel, hal::Clock& clock, int interval)
    : panel_(&panel), clock_(&clock), interval_(interval) {
  panel.attach(*this);
}

Timeline::~Timeline() { panel_->detach(*this); }

void Timeline::draw_begins(std::uint32_t frame) {
  while (frames_.size() <= frame) {
    frames_.emplace_back();
    frames_.back().number = static_cast<std::uint32_t>(frames_.size() - 1U);
  }
  FrameRecord& record = frames_[frame];
  if (!record.draw) record.draw = Span{clock_->now(), clock_->now()};
}

void Timeline::draw_ends() { frames_.back().draw->end = clock_->now(); }

FrameRecord* Timeline::frame_of(std::uint32_t number) {
  if (number == 0 || number > requested_.size()) return nullptr;
  const std::uint32_t frame = requested_[number - 1U];
  return frame < frames_.size() ? &frames_[frame] : nullptr;
}

std::vector<hal::sim::Tear> Timeline::of_frames(std::vector<hal::sim::Tear> tears) const {
  const auto rename = [this](std::optional<std::uint32_t>& number) {
    if (number && *number > 0 && *number <= requested_.size()) number = requested_[*number - 1U] + 1U;
  };
  for (hal::sim::Tear& tear : tears) {
    rename(tear.above);
    rename(tear.below);
  }
  return tears;
}

void Timeline::drop() {
  FrameRecord& frame = frames_.back();
  frame.dropped = true;
  frame.time = clock_->now();
  // At least one VBLANK has come since, and if it was an early one the frame was due then.
  frame.deadline = deadline(vblank_time_ > beginning_ ? vblank_time_ : frame.time);
  beginning_ = frame.deadline->end;
  ++late_drops_;
}

void Timeline::on_line(const hal::sim::ScannedLine& line) {
  if (line.line != 0) return;
  if (!refreshes_.empty()) refreshes_.back().blanking.end = line.time;
  refreshes_.push_back({line.refresh, {line.time, line.time}, {line.time, line.time}});
}

void Timeline::on_vblank(std::uint64_t refresh, hal::Nanoseconds time) {
  vblanks_ = static_cast<std::uint32_t>(refresh + 1U);
  vblank_time_ = time;
  if (refreshes_.empty()) return;
  refreshes_.back().scan.end = time;
  refreshes_.back().blanking = {time, time};
}

void Timeline::on_te(std::uint64_t /*refresh*/, hal::Nanoseconds time) { te_edges_.push_back(time); }

void Timeline::on_presented(const hal::sim::PresentedFrame& frame) {
  // Whoever draws ahead requests a frame before the next is begun, so it is the one drawn last.
  if (frame.number == requested_.size() + 1U) {
    const auto drawn = static_cast<std::uint32_t>(frames_.size());
    const std::uint32_t before = requested_.empty() ? 0 : requested_.back() + 1U;
    requested_.push_back(drawn > before ? drawn - 1U : before);
  }
  // Also told of colours loaded for the frame on display.
  FrameRecord* const record = frame_of(frame.number);
  if (record == nullptr || record->presented) return;
  const bool sent = !record->transfers.empty();
  record->presented = Span{sent ? record->transfers.front().begin : clock_->now(), clock_->now()};
}

void Timeline::on_swap(std::uint32_t frame, hal::Nanoseconds time) {
  FrameRecord* const record = frame_of(frame);
  if (record == nullptr) return;
  record->presented->end = time;
  // Told in the VBLANK itself, before it is counted.
  if (record->transfers.empty()) appear(*record, vblanks_ + 1U, time);
}

void Timeline::on_dropped(std::uint32_t frame, hal::Nanoseconds time) {
  FrameRecord* const record = frame_of(frame);
  if (record == nullptr) return;
  record->dropped = true;
  record->presented->end = time;
}

void Timeline::on_transfer(const hal::sim::Transfer& transfer) {
  if (frames_.empty()) return;
  FrameRecord& frame = frames_.back();
  if (frame.transfers.empty())
    appear(frame, chaser_ != nullptr ? chaser_->aimed_at() : transfer.vblank, transfer.begin);
  frame.transfers.push_back({transfer.begin, transfer.end});
  frame.bytes += transfer.bytes;
}

void Timeline::appear(FrameRecord& frame, std::uint32_t vblank, hal::Nanoseconds time) {
  frame.appeared = true;
  frame.vblank = vblank;
  frame.time = time;
  if (last_vblank_) {
    const std::uint32_t interval = static_cast<std::uint32_t>(interval_) * (1U + late_drops_);
    const std::uint32_t passed = vblank - *last_vblank_;
    frame.late = passed > interval ? passed - interval : 0;
    frame.deadline = deadline(time);
  }
  last_vblank_ = vblank;
  beginning_ = time;
  late_drops_ = 0;
}

}  // namespace host
