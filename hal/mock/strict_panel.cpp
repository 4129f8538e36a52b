// SPDX-License-Identifier: MIT
#include <hal/mock/strict_panel.hpp>
#include <hal/sim/pixels.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>

namespace hal::mock {

namespace {

using sim::pixel_at;
using sim::set_pixel;

// Bytes before and after every frame buffer that no one may write.
constexpr std::size_t guard_bytes = 64;

/// What a guard byte holds: no two neighbours equal, so that a fill is seen.
std::uint8_t guard_value(std::size_t place) { return static_cast<std::uint8_t>(0x5A + place * 29U); }

std::string pixel_text(int x, int y) { return '(' + std::to_string(x) + ", " + std::to_string(y) + ')'; }

std::string_view text_of(Error error) {
  constexpr std::array<std::string_view, 7> texts{"none", "invalid", "misaligned", "unsupported",
                                                  "busy", "timeout", "bus"};
  return texts[static_cast<std::size_t>(error)];
}

std::string_view text_of(Part part) {
  constexpr std::array<std::string_view, 10> texts{"none",   "rectangle", "pixels", "stride", "palette",
                                                   "buffer", "command",   "bus",    "pin",    "panel"};
  return texts[static_cast<std::size_t>(part)];
}

Capabilities panel_of(int width, int height, int bits_per_pixel) {
  return {.width = width,
          .height = height,
          .bits_per_pixel = bits_per_pixel,
          .palette_entries = 1 << bits_per_pixel};
}

}  // namespace

Capabilities scan_out_panel(int width, int height, int bits_per_pixel, int buffers) {
  Capabilities c = panel_of(width, height, bits_per_pixel);
  c.buffers = buffers;
  c.vblank_signal = true;
  return c;
}

Capabilities write_panel(int width, int height, int bits_per_pixel, int x_alignment, int y_alignment) {
  Capabilities c = panel_of(width, height, bits_per_pixel);
  c.x_alignment = x_alignment;
  c.y_alignment = y_alignment;
  return c;
}

void Recorder::span(int y, int x_begin, int x_end) {
  if (x_begin >= x_end) {
    ADD_FAILURE() << "empty span in row " << y << ": " << x_begin << " .. " << x_end;
    return;
  }
  if (y < clip_.y || y >= clip_.y + clip_.height || x_begin < clip_.x || x_end > clip_.x + clip_.width) {
    ADD_FAILURE() << "span outside the clip: row " << y << ", columns " << x_begin << " .. " << x_end - 1
                  << "; the clip has columns " << clip_.x << " .. " << clip_.x + clip_.width - 1 << ", rows "
                  << clip_.y << " .. " << clip_.y + clip_.height - 1;
    return;
  }
  if (panel_->presented(buffer_)) {
    ADD_FAILURE() << "pixel " << pixel_text(x_begin, y) << " was drawn on frame buffer " << buffer_
                  << " after it had been presented";
    return;
  }
  panel_->begin_drawing();
  std::vector<int> again;
  for (int x = x_begin; x < x_end; ++x)
    if (panel_->draw(buffer_, x, y, index_)) again.push_back(x);
  if (!again.empty() && !panel_->rules_.drawing_twice)
    ADD_FAILURE() << "drawn twice in a frame: " << pixel_text(again.front(), y) << ", " << again.size()
                  << " pixels in this span";
}

Recorder Recorder::clipped(int x, int y, int width, int height) const {
  const int left = std::max(x, clip_.x);
  const int top = std::max(y, clip_.y);
  const int right = std::min(x + width, clip_.x + clip_.width);
  const int bottom = std::min(y + height, clip_.y + clip_.height);
  return {*panel_, buffer_, index_, {left, top, std::max(right - left, 0), std::max(bottom - top, 0)}};
}

StrictPanel::StrictPanel(const Capabilities& capabilities, const StrictRules& rules)
    : capabilities_(capabilities),
      rules_(rules),
      row_bytes_(sim::row_bytes(capabilities.width, capabilities.bits_per_pixel)),
      stride_(row_bytes_ + rules.row_padding),
      writes_(Pattern::blank(capabilities.width, capabilities.height)) {
  const auto count = static_cast<std::size_t>(std::max(capabilities_.buffers, 1));
  for (std::size_t i = 0; i < count; ++i) {
    Buffer buffer;
    for (std::size_t place = 0; place < pixel_bytes() + 2U * guard_bytes; ++place)
      buffer.memory.push_back(guard_value(place));
    for (int y = 0; y < capabilities_.height; ++y) {
      const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(stride_) + guard_bytes;
      std::fill_n(buffer.memory.begin() + static_cast<std::ptrdiff_t>(row), row_bytes_, std::uint8_t{0});
    }
    buffers_.push_back(std::move(buffer));
  }
  palette_.assign(static_cast<std::size_t>(capabilities_.palette_entries) * 3U, 0);
  if (palette_.empty())
    palette_.assign(capabilities_.fixed_palette.begin(), capabilities_.fixed_palette.end());
}

StrictPanel::~StrictPanel() { check(); }

std::size_t StrictPanel::pixel_bytes() const {
  return static_cast<std::size_t>(capabilities_.height - 1) * static_cast<std::size_t>(stride_) +
         static_cast<std::size_t>(row_bytes_);
}

std::span<const std::uint8_t> StrictPanel::rows_of(int buffer) const {
  return std::span(buffers_[static_cast<std::size_t>(buffer)].memory).subspan(guard_bytes, pixel_bytes());
}

Pattern StrictPanel::pattern_of(std::span<const std::uint8_t> rows) const {
  Pattern pattern = Pattern::blank(capabilities_.width, capabilities_.height);
  for (int y = 0; y < pattern.height; ++y)
    for (int x = 0; x < pattern.width; ++x)
      pattern.at(x, y) =
          pixel_at(rows.subspan(static_cast<std::size_t>(y) * static_cast<std::size_t>(stride_)), x,
                   capabilities_.bits_per_pixel, capabilities_.bit_order);
  return pattern;
}

Pattern StrictPanel::picture_of(int buffer) const { return pattern_of(rows_of(buffer)); }

void StrictPanel::check() {
  for (int i = 0; i < static_cast<int>(buffers_.size()); ++i) {
    check_guards(i);
    check_presented(i);
  }
}

void StrictPanel::check_guards(int index) {
  std::vector<std::uint8_t>& memory = buffers_[static_cast<std::size_t>(index)].memory;
  const auto stride = static_cast<std::size_t>(stride_);
  for (std::size_t place = 0; place < memory.size(); ++place) {
    const bool before = place < guard_bytes;
    const bool after = place >= guard_bytes + pixel_bytes();
    const std::size_t inside = place - guard_bytes;
    const bool padding = !before && !after && inside % stride >= static_cast<std::size_t>(row_bytes_);
    if (!(before || after || padding) || memory[place] == guard_value(place)) continue;
    memory[place] = guard_value(place);
    ADD_FAILURE() << "frame buffer " << index << " was written outside its pixels: "
                  << (before ? "byte " + std::to_string(guard_bytes - place) + " before its start"
                      : after
                          ? "byte " + std::to_string(inside - pixel_bytes()) + " after its end"
                          : "byte " + std::to_string(inside % stride - static_cast<std::size_t>(row_bytes_)) +
                                " after the end of row " + std::to_string(inside / stride));
  }
}

void StrictPanel::check_presented(int index) {
  Buffer& buffer = buffers_[static_cast<std::size_t>(index)];
  if (!buffer.presented) return;
  const std::string difference =
      side_by_side(pattern_of(*buffer.presented), picture_of(index), colour_wanted());
  if (difference.empty()) return;
  ADD_FAILURE() << "frame buffer " << index << " was changed after it had been presented: " << difference;
  buffer.presented->assign(rows_of(index).begin(), rows_of(index).end());
}

void StrictPanel::vblank() {
  check();
  ++vblanks_;
  if (!pending_) return;
  // What was on display until now may be drawn on again; an only buffer too.
  if (*pending_ != displayed_ || buffers_.size() == 1)
    buffers_[static_cast<std::size_t>(displayed_)].presented.reset();
  displayed_ = *pending_;
  palette_ = pending_palette_;
  pending_.reset();
}

Recorder StrictPanel::recorder(int index, int buffer) {
  const int most = std::max(capabilities_.buffers, 1) - 1;
  if (buffer < 0 || buffer > most) ADD_FAILURE() << "there is no frame buffer " << buffer;
  return {*this, std::clamp(buffer, 0, most), index, {0, 0, capabilities_.width, capabilities_.height}};
}

void StrictPanel::forget_writes() { writes_ = Pattern::blank(capabilities_.width, capabilities_.height); }

void StrictPanel::begin_drawing() {
  if (std::exchange(frame_ended_, false)) forget_writes();
}

bool StrictPanel::draw(int buffer, int x, int y, int index) {
  Buffer& target = buffers_[static_cast<std::size_t>(buffer)];
  const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(stride_) + guard_bytes;
  set_pixel(std::span(target.memory).subspan(row), x, capabilities_.bits_per_pixel, capabilities_.bit_order,
            static_cast<std::uint8_t>(index));
  return ++writes_.at(x, y) > 1;
}

Status StrictPanel::take_fault() { return std::exchange(fault_, {}); }

std::span<std::uint8_t> StrictPanel::do_buffer(int index) noexcept {
  check();
  return std::span(buffers_[static_cast<std::size_t>(index)].memory).subspan(guard_bytes, pixel_bytes());
}

Status StrictPanel::do_show(int index, std::span<const std::uint8_t> palette) noexcept {
  check();
  if (const Status s = take_fault(); !s.ok()) return s;
  if (pending_ && !rules_.skipping_frames)
    ADD_FAILURE() << "the frame in buffer " << *pending_
                  << " was never displayed: another was presented before its VBLANK";
  replaced_ = pending_.has_value();
  if (pending_) {
    buffers_[static_cast<std::size_t>(*pending_)].presented.reset();
  } else {
    pending_palette_ = palette_;
  }
  pending_ = index;
  std::copy(palette.begin(), palette.end(), pending_palette_.begin());
  const auto rows = rows_of(index);
  buffers_[static_cast<std::size_t>(index)].presented.emplace(rows.begin(), rows.end());
  frame_ended_ = true;
  return {};
}

Status StrictPanel::do_write(const Rect& area, std::span<const std::uint8_t> pixels, int stride) noexcept {
  if (const Status s = take_fault(); !s.ok()) return s;
  int again = 0;
  for (int y = 0; y < area.height; ++y) {
    const auto from = pixels.subspan(static_cast<std::size_t>(y) * static_cast<std::size_t>(stride));
    for (int x = 0; x < area.width; ++x)
      again += draw(0, area.x + x, area.y + y,
                    pixel_at(from, x, capabilities_.bits_per_pixel, capabilities_.bit_order))
                   ? 1
                   : 0;
  }
  if (again > 0 && !rules_.drawing_twice)
    ADD_FAILURE() << again << " pixels of the rectangle at " << pixel_text(area.x, area.y)
                  << " were written twice in a frame";
  return {};
}

Status StrictPanel::do_load_palette(std::span<const std::uint8_t> palette) noexcept {
  if (const Status s = take_fault(); !s.ok()) return s;
  std::copy(palette.begin(), palette.end(), palette_.begin());
  return {};
}

Status StrictPanel::do_wait_for_vblank() noexcept {
  vblank();
  return {};
}

void StrictPanel::do_refused(Status status) noexcept {
  ADD_FAILURE() << "the panel refused a call: " << text_of(status.error()) << ' ' << text_of(status.part());
}

void StrictPanel::compare(std::string_view what, std::initializer_list<std::string_view> rows,
                          const Pattern& actual, const char* file, int line) const {
  std::string error;
  const std::vector<std::string_view> text(rows);
  const Pattern expected = Pattern::parse(text, error);
  if (!error.empty()) {
    ADD_FAILURE_AT(file, line) << "the expected picture: " << error;
    return;
  }
  const std::string difference = side_by_side(expected, actual, colour_wanted());
  if (!difference.empty()) ADD_FAILURE_AT(file, line) << what << ": " << difference;
}

void StrictPanel::expect_picture(std::initializer_list<std::string_view> rows, const char* file, int line) {
  compare("the display", rows, displayed(), file, line);
}

void StrictPanel::expect_buffer(int buffer, std::initializer_list<std::string_view> rows, const char* file,
                                int line) {
  compare("frame buffer " + std::to_string(buffer), rows, picture_of(buffer), file, line);
}

void StrictPanel::expect_writes(std::initializer_list<std::string_view> rows, const char* file, int line) {
  compare("writes", rows, writes_, file, line);
}

}  // namespace hal::mock
