// SPDX-License-Identifier: MIT
#include <hal/hid/host/link.hpp>
#include <hal/hid/host/patience.hpp>

#include <algorithm>

namespace hal::hid {

namespace {

constexpr Status silent{Error::timeout, Part::panel};
/// A clock that leaps, or a machine that slept, is no reason to give up: it must have been tried.
constexpr int least_attempts = 3;

bool same_panel(const DeviceInfo& a, const DeviceInfo& b) {
  DeviceInfo x = a;
  DeviceInfo y = b;
  x.nonce = y.nonce = 0;
  return encode(x) == encode(y);
}

}  // namespace

Link::Link(ReportPort& port, Clock& clock, const LinkOptions& options)
    : port_(&port),
      clock_(&clock),
      options_(options),
      nonce_(static_cast<std::uint32_t>(clock.now() >> 10U)) {}

Status Link::open() {
  if (const Status s = greet(); !s.ok()) return s;
  info_ = answer_info_;
  return fetch_colours();
}

Status Link::reopen() {
  if (const Status s = port_->reopen(); !s.ok()) return s;
  return renew();
}

Status Link::renew() {
  if (const Status s = greet(); !s.ok()) return s;
  // A program has laid out its picture for the panel that it found first.
  if (!same_panel(info_, answer_info_)) return {Error::unsupported, Part::panel};
  return {};
}

Status Link::greet() {
  constexpr int attempts = 3;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    ++counters_.sessions;
    nonce_ = (nonce_ + 1U) & 0x7FFFFFFFU;
    if ((nonce_ & 0xFFU) == 0) ++nonce_;
    session_ = static_cast<std::uint8_t>(nonce_ & 0xFFU);
    state_ = {};
    oldest_ = next_ = 0;
    gap_ = lost_ = false;
    const Status s = ask(ReportType::hello, encode(Hello{nonce_, true}), ReportType::capabilities);
    vblank_told_at_ = clock_->now();
    // A session in which something was sent already is one of another program that chose the same nonce.
    if (!s.ok() || answer_sequence_ == 0) return s;
  }
  return {Error::busy, Part::panel};
}

Status Link::fetch_colours() {
  fixed_palette_.clear();
  info_.capabilities.fixed_palette = {};
  if (info_.capabilities.palette_entries != 0) return {};
  const std::size_t all = std::size_t{3} << static_cast<unsigned>(info_.capabilities.bits_per_pixel);
  while (fixed_palette_.size() < all) {
    const std::array<std::uint8_t, 1> from{static_cast<std::uint8_t>(fixed_palette_.size() / 3U)};
    colours_wanted_ = all;
    if (const Status s = ask(ReportType::ask_colours, from, ReportType::colours); !s.ok()) return s;
  }
  info_.capabilities.fixed_palette = fixed_palette_;
  return {};
}

Status Link::ask(ReportType type, std::span<const std::uint8_t> payload, ReportType answer) {
  // Before the device has said how long its reports are, they are as short as can be.
  std::array<std::uint8_t, most_report_bytes> memory{};
  const auto report = std::span(memory).first(type == ReportType::hello ? least_report_bytes
                                                                        : std::size_t{info_.report_bytes});
  compose(report, {type, session_, 0, payload});
  answered_ = false;
  awaited_ = answer;
  const std::uint64_t senseless_before = counters_.senseless;
  for (Patience patience(*clock_, options_.patience, least_attempts); !patience.over();) {
    if (const Status s = put(report); !s.ok()) return s;
    ++counters_.sent;
    const Nanoseconds again = clock_->now() + options_.retry;
    Nanoseconds left = options_.retry;
    // Listens once even if the clock leaps in between.
    while (left != 0) {
      const Status s = listen(left);
      if (answered_) return {};
      if (!s.ok() && s.error() != Error::timeout) return s;
      if (lost_) return {Error::disconnected, Part::panel};
      const Nanoseconds now = clock_->now();
      left = again > now ? again - now : 0;
    }
  }
  return counters_.senseless != senseless_before ? Status{Error::unsupported, Part::panel} : silent;
}

void Link::hear(std::span<const std::uint8_t> bytes) {
  ++counters_.received;
  const auto report = parse(bytes);
  if (!report) {
    ++counters_.senseless;
    return;
  }
  // What an earlier session left in the queues isn't wrong, only late.
  if (report->session != session_) return;
  switch (report->type) {
    case ReportType::capabilities: {
      const auto info = decode_info(report->payload);
      if (!info) {
        ++counters_.senseless;
      } else if (awaited_ == ReportType::capabilities && info->nonce == nonce_) {
        answer_info_ = *info;
        answer_sequence_ = report->sequence;
        answered_ = true;
      }
      return;
    }
    case ReportType::colours: {
      const auto part = decode_palette(report->payload);
      if (!part) {
        ++counters_.senseless;
      } else if (awaited_ == ReportType::colours &&
                 static_cast<std::size_t>(part->first) * 3U == fixed_palette_.size()) {
        const std::size_t count = std::min(part->rgb.size(), colours_wanted_ - fixed_palette_.size());
        fixed_palette_.insert(fixed_palette_.end(), part->rgb.begin(),
                              part->rgb.begin() + static_cast<std::ptrdiff_t>(count));
        answered_ = true;
      }
      return;
    }
    case ReportType::status: {
      const auto state = decode_state(*report);
      if (!state) {
        ++counters_.senseless;
        return;
      }
      if (state->no_session) {
        // Until the session is open, the complaint is about something older.
        if (awaited_ != ReportType::capabilities || answered_) lost_ = true;
        return;
      }
      const auto acknowledged = static_cast<std::uint16_t>(state->next - oldest_);
      if (acknowledged > in_flight()) {
        // Older than what is known, or acknowledges what was never sent.
        ++counters_.senseless;
        return;
      }
      take_state(*state);
      return;
    }
    default:
      ++counters_.senseless;
  }
}

void Link::take_state(const DeviceState& state) {
  const bool waited = frame_waits();
  if (state.vblanks != state_.vblanks) vblank_told_at_ = clock_->now();
  state_ = state;
  const bool acknowledges = state.next != oldest_;
  if (acknowledges && !waited) measure(static_cast<std::uint16_t>((state.next - 1U) & 0xFFFFU));
  if (acknowledges) {
    oldest_ = state.next;
    start_waiting();
  }
  if (waited && !frame_waits()) {
    taking_since_ = clock_->now();
    pause_ = answer_time();
    resend_at_ = std::min(resend_at_, taking_since_ + pause_);
  }
  // A device tells of the same gap until it is filled; being told once a while is enough.
  const bool served = served_ && clock_->now() < resend_at_;
  gap_ = state.gap && in_flight() != 0 && !served;
}

void Link::measure(std::uint16_t acknowledged) {
  const Slot& slot = slot_of(acknowledged);
  // Which of the two was answered can't be told.
  if (slot.again) return;
  const Nanoseconds now = clock_->now();
  const Nanoseconds sent_at = std::max(slot.sent_at, taking_since_);
  // A longer one would be cut anyway.
  const Nanoseconds trip = std::min(now > sent_at ? now - sent_at : 0, options_.retry);
  if (!measured_) {
    measured_ = true;
    mean_ = trip;
    deviation_ = trip / 2U;
  }
  const Nanoseconds off = trip > mean_ ? trip - mean_ : mean_ - trip;
  deviation_ = (3U * deviation_ + off) / 4U;
  mean_ = (7U * mean_ + trip) / 8U;
}

Nanoseconds Link::answer_time() const {
  if (!measured_) return options_.retry;
  return std::clamp(mean_ + 4U * deviation_, std::min(options_.least_retry, options_.retry), options_.retry);
}

void Link::start_waiting() {
  attempts_ = 0;
  progress_at_ = clock_->now();
  pause_ = frame_waits() ? options_.retry : answer_time();
  resend_at_ = progress_at_ + pause_;
  served_ = false;
}

Status Link::listen(Nanoseconds patience) {
  std::array<std::uint8_t, most_report_bytes> memory{};
  // A device that never stops talking mustn't keep the program from its work.
  constexpr int most_reports = 64;
  for (int i = 0; i < most_reports; ++i) {
    const Received got = port_->receive(memory, i == 0 ? patience : 0);
    if (!got.status.ok()) return i == 0 || got.status.error() != Error::timeout ? got.status : Status{};
    hear(std::span(memory).first(got.size));
  }
  return {};
}

Status Link::drain() {
  const Status s = listen(0);
  return s.error() == Error::timeout ? Status{} : s;
}

Status Link::resend() {
  served_ = true;
  return resend(oldest_);
}

Status Link::resend(std::uint16_t first) {
  gap_ = false;
  ++attempts_;
  for (std::uint16_t sequence = first; sequence != next_; ++sequence) {
    slot_of(sequence).again = true;
    if (const Status s = put(slot(sequence)); !s.ok()) return s;
    ++counters_.resent;
  }
  resend_at_ = clock_->now() + pause_;
  return {};
}

Status Link::make_progress() {
  const std::uint16_t before = oldest_;
  if (gap_)
    if (const Status s = resend(); !s.ok()) return s;
  const Nanoseconds now = clock_->now();
  const Status s = listen(resend_at_ > now ? resend_at_ - now : 0);
  if (!s.ok() && s.error() != Error::timeout) return s;
  if (lost_) return {Error::disconnected, Part::panel};
  if (oldest_ != before) return {};
  const Nanoseconds later = clock_->now();
  if (later >= progress_at_ + options_.patience && attempts_ >= least_attempts) return silent;
  if (gap_ || later < resend_at_) return {};
  pause_ = std::min(pause_ * 2U, options_.retry * 8U);
  // Most often the last one was lost, of which no other tells; if not, the device says now where the gap is.
  return attempts_ == 0 ? resend(last()) : resend();
}

Status Link::transmit(ReportType type, std::span<const std::uint8_t> payload) {
  // A gap that is filled at once costs the least.
  if (const Status s = drain(); !s.ok()) return s;
  if (gap_)
    if (const Status s = resend(); !s.ok()) return s;
  while (in_flight() >= info_.window)
    if (const Status s = make_progress(); !s.ok()) return s;
  if (in_flight() == 0) start_waiting();
  compose(slot(next_), {type, session_, next_, payload});
  Slot& sent = slot_of(next_);
  const Status s = put(slot(next_));
  next_ = static_cast<std::uint16_t>((next_ + 1U) & 0xFFFFU);
  ++counters_.sent;
  sent.again = false;
  sent.sent_at = clock_->now();
  resend_at_ = sent.sent_at + pause_;
  return s;
}

Status Link::prompt() {
  if (next_ == 0 || in_flight() >= info_.window) return {};
  ++counters_.prompts;
  return put(slot(last()));
}

Status Link::put(std::span<const std::uint8_t> report) {
  const Status s = port_->send(report);
  if (s.ok() || s.error() == Error::disconnected) return s;
  // A report that the wire doesn't take is lost like others, and sent again.
  ++counters_.refused;
  return {};
}

Status Link::settle() {
  while (in_flight() != 0)
    if (const Status s = make_progress(); !s.ok()) return s;
  return {};
}

}  // namespace hal::hid
