// SPDX-License-Identifier: MIT
#include <intaglio/present/beam_chaser.hpp>
#include <intaglio/present/panel_port.hpp>

#include <algorithm>

namespace intaglio::present {

namespace {

/// Whole periods in a time, rounded up. The time is at least 0 and below 2^31 periods, the period at least 1.
std::uint32_t periods(std::int64_t time, hal::Nanoseconds period) noexcept {
  return static_cast<std::uint32_t>((static_cast<hal::Nanoseconds>(time) + period - 1U) / period);
}

}  // namespace

Status BeamChaser::prepare(const BandSizes& sizes, Travel travel) noexcept {
  if (!timing_.valid(sizes.lines)) return {Error::out_of_range, Argument::table};
  travel_ = travel;
  picture_ = picture_window(timing_, sizes, travel);
  return {};
}

Status BeamChaser::synchronise() noexcept {
  // Once there was one, a count of 0 has wrapped.
  if (!synchronised_ && vblanks_->count() == 0)
    if (const hal::Status s = vblanks_->wait(); !s.ok()) return to_status(s);
  const auto told = static_cast<std::int64_t>(vblanks_->last());
  if (!synchronised_) {
    number_ = vblanks_->count();
  } else if (told > signal_ && told <= now()) {
    // To the nearest: signals come with a jitter.
    const auto half = static_cast<std::int64_t>(timing_.refresh / 2U);
    number_ += periods(std::max<std::int64_t>(told - signal_ - half, 0), timing_.refresh);
  } else {
    return {};
  }
  synchronised_ = true;
  signal_ = told;
  return {};
}

Result<std::uint32_t> BeamChaser::aim(const Pacer& pacer) noexcept {
  if (const Status s = synchronise(); !s.ok()) return s;
  // Where no start is early enough, as early as possible is best.
  const std::int64_t latest = std::max(picture_.latest, picture_.earliest);
  const std::int64_t late = now() - (signal_ + latest);
  aimed_at_ = pacer.not_before_due(number_ + (late > 0 ? periods(late, timing_.refresh) : 0U));
  too_late_ = !picture_.open();
  return aimed_at_;
}

std::int64_t BeamChaser::on_clock(std::int64_t time) const noexcept {
  const auto ahead = static_cast<std::int32_t>(aimed_at_ - number_);
  return signal_ + ahead * static_cast<std::int64_t>(timing_.refresh) + time;
}

void BeamChaser::before_write(int first, int end) noexcept {
  const StartWindow window = start_window(timing_, first, end, travel_);
  const std::int64_t open = on_clock(window.earliest);
  if (open > now()) clock_->wait_until(static_cast<hal::Nanoseconds>(open));
  const auto takes = static_cast<std::int64_t>(timing_.bus_band) +
                     (end - first) * static_cast<std::int64_t>(timing_.bus_line);
  must_be_out_ = on_clock(window.latest) + takes;
  // A write that begins too late is also out too late, unless the bus is faster than was said.
  if (now() + takes > must_be_out_) too_late_ = true;
}

void BeamChaser::after_write() noexcept {
  if (now() > must_be_out_) too_late_ = true;
}

void BeamChaser::complete() noexcept {
  if (too_late_) ++torn_;
}

}  // namespace intaglio::present
