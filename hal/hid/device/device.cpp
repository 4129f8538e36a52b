// SPDX-License-Identifier: MIT
#include <hal/hid/crc32.hpp>
#include <hal/hid/device/device.hpp>
#include <hal/hid/run_length.hpp>

#include <algorithm>

namespace hal::hid {

namespace {

constexpr std::uint8_t mark_of(std::uint32_t nonce) noexcept {
  return static_cast<std::uint8_t>(nonce & 0xFFU);
}

/// The least rectangle that covers both; an empty one has no width.
Rect united(const Rect& a, const Rect& b) noexcept {
  if (a.width == 0) return b;
  const int x = std::min(a.x, b.x);
  const int y = std::min(a.y, b.y);
  return {x, y, std::max(a.x + a.width, b.x + b.width) - x, std::max(a.y + a.height, b.y + b.height) - y};
}

bool same_pixels(const Capabilities& a, const Capabilities& b) noexcept {
  return a.width == b.width && a.height == b.height && a.bits_per_pixel == b.bits_per_pixel &&
         a.palette_entries == b.palette_entries && a.palette_bits == b.palette_bits;
}

std::uint16_t bits_of(const Keys& keys) noexcept {
  unsigned bits = 0;
  for (unsigned key = 0; key <= static_cast<unsigned>(Key::back); ++key)
    if (keys.held(static_cast<Key>(key))) bits |= 1U << key;
  return static_cast<std::uint16_t>(bits);
}

}  // namespace

std::size_t Device::memory_for(const Capabilities& panel) noexcept {
  return panel.buffers >= 2 ? 0 : picture_bytes(panel);
}

Device::Device(Panel& panel, Input* input, std::span<std::uint8_t> memory,
               const DeviceOptions& options) noexcept
    : panel_(&panel), input_(input) {
  info_.capabilities = panel.capabilities();
  info_.has_keys = input != nullptr;
  const bool sizes = options.report_bytes >= least_report_bytes &&
                     options.report_bytes <= most_report_bytes && options.window >= 1 &&
                     options.window <= most_window;
  if (!sizes) {
    status_ = {Error::invalid, Part::none};
    return;
  }
  info_.report_bytes = static_cast<std::uint16_t>(options.report_bytes);
  info_.window = static_cast<std::uint8_t>(options.window);
  // What the host would refuse, or what doesn't fit into the report, isn't offered.
  const auto offered = decode_info(encode(info_));
  if (!offered || !same_pixels(offered->capabilities, info_.capabilities)) {
    status_ = {Error::unsupported, Part::panel};
    return;
  }
  if (scans_out()) {
    work_ = panel.buffer(back_);
    work_stride_ = panel.buffer_stride();
  } else if (memory.size() < memory_for(panel.capabilities())) {
    status_ = {Error::invalid, Part::buffer};
    return;
  } else {
    work_ = memory;
    work_stride_ = static_cast<int>(row_bytes(info_.capabilities.width, info_.capabilities.bits_per_pixel));
  }
}

bool Device::scans_out() const noexcept { return info_.capabilities.buffers >= 2; }

std::span<std::uint8_t> Device::row(int y) const noexcept {
  const Capabilities& c = info_.capabilities;
  return work_.subspan(static_cast<std::size_t>(y) * static_cast<std::size_t>(work_stride_),
                       row_bytes(c.width, c.bits_per_pixel));
}

std::span<const std::uint8_t> Device::colours() const noexcept {
  return std::span(palette_).first(static_cast<std::size_t>(info_.capabilities.palette_entries) * 3U);
}

std::uint32_t Device::checksum() const noexcept {
  Crc32 crc;
  crc.add(colours());
  for (int y = 0; y < info_.capabilities.height; ++y) crc.add(row(y));
  return crc.value();
}

Rect Device::aligned(const Rect& area) const noexcept {
  const Capabilities& c = info_.capabilities;
  // Also at whole bytes of the rows.
  int x_step = c.x_alignment;
  while (x_step * c.bits_per_pixel % 8 != 0) x_step += c.x_alignment;
  const int x = area.x - area.x % x_step;
  const int y = area.y - area.y % c.y_alignment;
  const auto up = [](int end, int step, int limit) {
    return std::min((end + step - 1) / step * step, limit);
  };
  return {x, y, up(area.x + area.width, x_step, c.width) - x,
          up(area.y + area.height, c.y_alignment, c.height) - y};
}

void Device::unplugged() noexcept {
  has_session_ = false;
  info_due_ = state_due_ = complaint_due_ = colours_due_ = false;
  committing_frame_ = 0;
  state_.decided = state_.shown = 0;
}

void Device::open(const Report& report) noexcept {
  const auto hello = decode_hello(report.payload);
  if (!hello) {
    ++counters_.foreign;
    return;
  }
  tell_vblank_ = hello->tell_vblank;
  info_due_ = true;
  // The host asks again when an answer was lost; then its session has begun already.
  if (has_session_ && hello->nonce == info_.nonce) return;
  ++counters_.sessions;
  has_session_ = true;
  info_.nonce = hello->nonce;
  const std::uint16_t keys = state_.keys;
  state_ = {};
  vblanks_before_ = panel_->vblank_count();
  state_.keys = keys;
  committing_frame_ = 0;
  spoilt_ = Verdict::accepted;
  area_ = {};
  written_ = 0;
  unacknowledged_ = 0;
  state_due_ = complaint_due_ = colours_due_ = false;
}

void Device::receive(std::span<const std::uint8_t> bytes) noexcept {
  if (!status_.ok()) return;
  const auto report = parse(bytes);
  if (!report) {
    ++counters_.foreign;
    return;
  }
  if (report->type == ReportType::hello) {
    open(*report);
    return;
  }
  if (!has_session_ || report->session != mark_of(info_.nonce)) {
    ++counters_.foreign;
    complaint_due_ = true;
    complaint_ = report->session;
    return;
  }
  switch (report->type) {
    case ReportType::ask_colours:
      if (!report->payload.empty()) {
        colours_due_ = true;
        colours_from_ = report->payload.front();
      }
      return;
    case ReportType::palette:
    case ReportType::rectangle:
    case ReportType::pixels:
    case ReportType::commit:
      break;
    default:
      ++counters_.foreign;
      return;
  }
  if (!ready()) {
    ++counters_.overrun;
    return;
  }
  if (report->sequence != state_.next) {
    // Ahead by less than half the circle is beyond a gap, else it was here before.
    const bool early = static_cast<std::uint16_t>(report->sequence - state_.next) < 0x8000U;
    ++(early ? counters_.early : counters_.repeated);
    if (!early || !state_.gap) state_due_ = true;
    if (early) state_.gap = true;
    return;
  }
  ++counters_.accepted;
  state_.next = static_cast<std::uint16_t>((state_.next + 1U) & 0xFFFFU);
  state_.gap = false;
  if (++unacknowledged_ >= (info_.window + 1) / 2) state_due_ = true;
  take(*report);
}

void Device::take(const Report& report) noexcept {
  switch (report.type) {
    case ReportType::palette:
      take_palette(report);
      return;
    case ReportType::rectangle:
      take_rectangle(report);
      return;
    case ReportType::pixels:
      take_runs(report.payload);
      return;
    default:
      take_commit(report);
      return;
  }
}

void Device::spoil(Verdict verdict) noexcept {
  if (spoilt_ == Verdict::accepted) spoilt_ = verdict;
}

void Device::take_palette(const Report& report) noexcept {
  const auto part = decode_palette(report.payload);
  if (!part) {
    spoil(Verdict::malformed);
    return;
  }
  const std::size_t first = static_cast<std::size_t>(part->first) * 3U;
  if (first + part->rgb.size() > colours().size()) {
    spoil(Verdict::outside);
    return;
  }
  std::copy(part->rgb.begin(), part->rgb.end(), palette_.begin() + static_cast<std::ptrdiff_t>(first));
}

void Device::take_rectangle(const Report& report) noexcept {
  area_ = {};
  written_ = 0;
  const auto area = decode_rect(report.payload);
  if (!area) {
    spoil(Verdict::malformed);
    return;
  }
  if (!fits(*area, info_.capabilities)) {
    spoil(Verdict::outside);
    return;
  }
  area_ = *area;
  changed_ = united(changed_, area_);
  take_runs(report.payload.subspan(rectangle_bytes));
}

void Device::take_runs(std::span<const std::uint8_t> tokens) noexcept {
  const int bits = info_.capabilities.bits_per_pixel;
  const std::size_t across = row_bytes(area_.width, bits);
  const std::size_t all = across * static_cast<std::size_t>(area_.height);
  while (!tokens.empty()) {
    const auto token = take_token(tokens);
    if (!token) {
      spoil(Verdict::malformed);
      return;
    }
    if (token->count > all - written_) {
      spoil(Verdict::outside);
      return;
    }
    if (token->kind == Token::Kind::skip) {
      written_ += token->count;
      continue;
    }
    // Row by row, so that what is covered by one token is written in a few copies.
    for (std::size_t done = 0; done < token->count;) {
      const std::size_t x = written_ % across;
      const std::size_t count = std::min(token->count - done, across - x);
      const auto line =
          row(area_.y + static_cast<int>(written_ / across)).subspan(row_bytes(area_.x, bits) + x, count);
      if (token->kind == Token::Kind::run)
        std::fill(line.begin(), line.end(), token->bytes.front());
      else
        std::copy_n(token->bytes.begin() + static_cast<std::ptrdiff_t>(done), count, line.begin());
      done += count;
      written_ += count;
    }
  }
}

void Device::take_commit(const Report& report) noexcept {
  state_due_ = true;
  const auto commit = decode_commit(report.payload);
  Verdict verdict = spoilt_;
  if (!commit && verdict == Verdict::accepted) verdict = Verdict::malformed;
  if (commit && verdict == Verdict::accepted && commit->checksum != checksum()) verdict = Verdict::mismatch;
  spoilt_ = Verdict::accepted;
  area_ = {};
  written_ = 0;
  state_.verdict = verdict;
  state_.decided = commit ? commit->frame : std::uint16_t{0};
  if (verdict != Verdict::accepted) {
    ++counters_.rejected;
    return;
  }
  ++counters_.committed;
  committing_frame_ = commit->frame;
  committing_ = Stage::waiting_for_vblank;
  committed_at_ = panel_->vblank_count();
  if (scans_out()) finish();
}

void Device::finish() noexcept {
  Status s;
  if (scans_out()) {
    s = panel_->show(back_, colours());
    if (s.ok()) committing_ = Stage::shown_by_panel;
  } else if (info_.capabilities.buffers == 1) {
    const auto screen = panel_->buffer(0);
    const auto stride = static_cast<std::size_t>(panel_->buffer_stride());
    for (int y = 0; y < info_.capabilities.height; ++y) {
      const auto from = row(y);
      std::copy(from.begin(), from.end(),
                screen.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(y) * stride));
    }
    if (!colours().empty()) s = panel_->load_palette(colours());
  } else {
    if (!colours().empty()) s = panel_->load_palette(colours());
    // Colours that are applied to pixels on their way take effect only where pixels are sent.
    const Rect whole{0, 0, info_.capabilities.width, info_.capabilities.height};
    const Rect area = info_.capabilities.palette_on_write ? whole : aligned(changed_);
    if (s.ok() && area.width > 0) {
      const std::size_t first = row_bytes(area.x, info_.capabilities.bits_per_pixel);
      s = panel_->write(
          area,
          work_.subspan(static_cast<std::size_t>(area.y) * static_cast<std::size_t>(work_stride_) + first),
          work_stride_);
    }
  }
  // What failed is tried again at the next VBLANK; nothing is lost by that but time.
  state_.panel_failed = !s.ok();
  if (!s.ok()) {
    state_due_ = true;
    committing_ = Stage::waiting_for_vblank;
    committed_at_ = panel_->vblank_count();
  } else if (!scans_out()) {
    appeared();
  }
}

void Device::appeared() noexcept {
  committing_ = Stage::idle;
  changed_ = {};
  state_due_ = true;
  if (committing_frame_ != 0) state_.shown = committing_frame_;
  committing_frame_ = 0;
  if (!scans_out()) return;
  // The next frame is made of this one.
  const int front = back_;
  back_ = 1 - back_;
  work_ = panel_->buffer(back_);
  const auto from = panel_->buffer(front);
  std::copy_n(from.begin(), std::min(from.size(), work_.size()), work_.begin());
}

void Device::poll() noexcept {
  if (!status_.ok()) return;
  // The request first, the count after it: a frame is never told to be shown before its VBLANK is.
  if (committing_ == Stage::shown_by_panel && !panel_->show_pending()) appeared();
  const std::uint32_t vblanks = panel_->vblank_count();
  if (vblanks - vblanks_before_ != state_.vblanks) {
    state_.vblanks = vblanks - vblanks_before_;
    if (tell_vblank_) state_due_ = true;
  }
  if (committing_ == Stage::waiting_for_vblank && vblanks != committed_at_) finish();
  if (input_ != nullptr) {
    const std::uint16_t keys = bits_of(input_->poll());
    if (keys != state_.keys) {
      state_.keys = keys;
      state_due_ = true;
    }
  }
}

std::size_t Device::next(std::span<std::uint8_t> report) noexcept {
  const std::size_t size = info_.report_bytes;
  if (!status_.ok() || report.size() < size) return 0;
  report = report.first(size);
  const std::uint8_t mark = mark_of(info_.nonce);
  if (info_due_) {
    info_due_ = false;
    compose(report, {ReportType::capabilities, mark, state_.next, encode(info_)});
    return size;
  }
  if (complaint_due_) {
    complaint_due_ = false;
    DeviceState unknown;
    unknown.no_session = true;
    compose(report, {ReportType::status, complaint_, 0, encode(unknown)});
    return size;
  }
  if (!has_session_) return 0;
  if (colours_due_) {
    colours_due_ = false;
    const auto fixed = info_.capabilities.fixed_palette;
    const std::size_t first = std::size_t{colours_from_} * 3U;
    std::size_t count = 0;
    report[header_bytes] = colours_from_;
    if (first < fixed.size())
      count = std::min(fixed.size() - first, static_cast<std::size_t>(palette_entries_in(size)) * 3U);
    if (count != 0)
      std::copy_n(fixed.begin() + static_cast<std::ptrdiff_t>(first), count,
                  report.begin() + header_bytes + 1);
    compose(report, {ReportType::colours, mark, 0, report.subspan(header_bytes, 1U + count)});
    return size;
  }
  if (state_due_) {
    state_due_ = false;
    unacknowledged_ = 0;
    compose(report, {ReportType::status, mark, state_.next, encode(state_)});
    return size;
  }
  return 0;
}

void Device::describe(std::span<std::uint8_t> report) const noexcept {
  DeviceInfo info = info_;
  info.nonce = 0;
  compose(report, {ReportType::capabilities, 0, 0, encode(info)});
}

}  // namespace hal::hid
