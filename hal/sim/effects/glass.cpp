// SPDX-License-Identifier: MIT
#include <hal/sim/effects/dead.hpp>
#include <hal/sim/effects/depth.hpp>
#include <hal/sim/effects/gamma.hpp>
#include <hal/sim/effects/glass.hpp>
#include <hal/sim/effects/grid.hpp>
#include <hal/sim/effects/scan.hpp>

namespace hal::sim {

Glass::Glass(Panel& panel, const Effects& effects)
    : panel_(&panel), effects_(effects), by_refresh_(effects.tearing || effects.response) {
  const Capabilities& c = panel.capabilities();
  const std::size_t components = 3U * static_cast<std::size_t>(c.width) * static_cast<std::size_t>(c.height);
  if (effects_.depth || effects_.gamma) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
      for (std::size_t value = 0; value < 256; ++value) {
        auto shown = static_cast<std::uint8_t>(value);
        if (effects_.depth) shown = at_depth(shown, effects_.depth->bits[channel]);
        if (effects_.gamma) shown = with_gamma(shown, *effects_.gamma);
        channels_[channel][value] = shown;
      }
    }
  }
  if (effects_.response) response_.emplace(*effects_.response, panel.frame_time(), components);
  if (!by_refresh_) return;
  scanning_.resize(components);
  scanned_.resize(components);
  panel.attach(*this);
}

Glass::~Glass() {
  if (by_refresh_) panel_->detach(*this);
}

View Glass::look() const {
  const Capabilities& c = panel_->capabilities();
  View view{c.width, c.height, {}};
  if (by_refresh_) {
    view.rgb = scanned_;
    if (response_) response_->look(view.rgb);
  } else {
    view.rgb = panel_->displayed().rgb;
    through_channels(view.rgb);
  }
  if (!effects_.dead.empty()) put_dead_pixels(effects_.dead, view.width, view.rgb);
  if (effects_.grid) view.rgb = enlarge(*effects_.grid, view.width, view.height, view.rgb);
  view.width = width();
  view.height = height();
  return view;
}

void Glass::on_line(const ScannedLine& line) {
  if (effects_.tearing) note_call(Effect::tearing);
  if (line.line == 0) from_first_line_ = true;
  const Capabilities& c = panel_->capabilities();
  const bool columns = by_columns(c.scan);
  const auto width = static_cast<std::size_t>(c.width);
  for (int i = 0; i < (columns ? c.height : c.width); ++i) {
    const std::size_t across = static_cast<std::size_t>(i);
    const std::size_t along = static_cast<std::size_t>(line.y);
    const std::size_t place = columns ? across * width + along : along * width + across;
    const std::size_t index =
        c.palette_on_write ? 0 : pixel_at(line.pixels, i, c.bits_per_pixel, c.bit_order);
    for (std::size_t channel = 0; channel < 3; ++channel)
      scanning_[3U * place + channel] = c.palette_on_write ? line.pixels[3U * across + channel]
                                                           : panel_->colour(line.palette, index, channel);
  }
}

void Glass::on_vblank(std::uint64_t /*refresh*/, Nanoseconds /*time*/) {
  if (!from_first_line_) return;  // Attached in the middle of a picture.
  scanned_ = scanning_;
  through_channels(scanned_);
  if (response_) response_->refresh(scanned_);
  if (seen_) seen_();
}

void Glass::through_channels(std::span<std::uint8_t> rgb) const {
  if (!effects_.depth && !effects_.gamma) return;
  for (std::size_t i = 0; i < rgb.size(); ++i) rgb[i] = channels_[i % 3U][rgb[i]];
}

}  // namespace hal::sim
