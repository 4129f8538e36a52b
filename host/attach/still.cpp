// SPDX-License-Identifier: MIT
#include <host/attach/interruption.hpp>
#include <host/attach/still.hpp>
#include <host/failure.hpp>
#include <intaglio/image/nearest.hpp>

#include <array>
#include <chrono>
#include <cstdio>
#include <span>
#include <string>
#include <thread>
#include <vector>

namespace host {

namespace {

/// What each index of the picture is on the panel.
std::array<std::uint8_t, 256> indices_on(const hal::Capabilities& panel,
                                         std::span<const std::uint8_t> palette) {
  std::array<std::uint8_t, 256> index{};
  for (std::size_t i = 0; i < palette.size() / 3U; ++i)
    index[i] = panel.palette_entries > 0
                   ? static_cast<std::uint8_t>(i)
                   : intaglio::image::nearest_entry(
                         panel.fixed_palette, {palette[3U * i], palette[3U * i + 1U], palette[3U * i + 2U]});
  return index;
}

void put_pixel(std::span<std::uint8_t> row, int x, unsigned index, const hal::Capabilities& panel) {
  const unsigned bits = static_cast<unsigned>(panel.bits_per_pixel);
  const unsigned place = static_cast<unsigned>(x) * bits;
  const unsigned shift = panel.bit_order == hal::BitOrder::msb_first ? 8U - bits - place % 8U : place % 8U;
  std::uint8_t& byte = row[place / 8U];
  byte = static_cast<std::uint8_t>(byte | index << shift);
}

/// `rows` are zeros, of the panel's size.
void draw(std::span<std::uint8_t> rows, std::size_t stride, const IndexedPicture& picture,
          const hal::Capabilities& panel) {
  const std::array<std::uint8_t, 256> index = indices_on(panel, picture.palette_rgb);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      put_pixel(rows.subspan(static_cast<std::size_t>(y) * stride), x,
                index[picture.indices[static_cast<std::size_t>(y * picture.width + x)]], panel);
}

hal::Status show_on_write_panel(hal::Panel& panel, const IndexedPicture& picture) {
  const hal::Capabilities& c = panel.capabilities();
  const auto stride =
      (static_cast<std::size_t>(c.width) * static_cast<std::size_t>(c.bits_per_pixel) + 7U) / 8U;
  std::vector<std::uint8_t> rows(stride * static_cast<std::size_t>(c.height));
  draw(rows, stride, picture, c);
  if (c.palette_entries > 0)
    if (const hal::Status s = panel.load_palette(picture.palette_rgb); !s.ok()) return s;
  return panel.write({0, 0, c.width, c.height}, rows, static_cast<int>(stride));
}

hal::Status show_on_scan_out_panel(hal::Panel& panel, const IndexedPicture& picture) {
  const hal::Capabilities& c = panel.capabilities();
  const int buffer = c.buffers > 1 ? 1 : 0;
  const std::span<std::uint8_t> rows = panel.buffer(buffer);
  for (std::uint8_t& byte : rows) byte = 0;
  draw(rows, static_cast<std::size_t>(panel.buffer_stride()), picture, c);
  const std::span<const std::uint8_t> colours =
      c.palette_entries > 0 ? std::span(picture.palette_rgb) : std::span<const std::uint8_t>();
  if (const hal::Status s = panel.show(buffer, colours); !s.ok()) return s;
  while (panel.show_pending())
    if (const hal::Status s = panel.wait_for_vblank(); !s.ok()) return s;
  return {};
}

}  // namespace

void show_still(AttachedPanel& attached, const IndexedPicture& picture) {
  hal::Panel& panel = attached.panel();
  const hal::Capabilities& c = panel.capabilities();
  const auto size = [](int width, int height) {
    return std::to_string(width) + 'x' + std::to_string(height);
  };
  if (picture.width > c.width || picture.height > c.height)
    throw Failure("a picture of " + size(picture.width, picture.height) + " pixels doesn't fit on " +
                  attached.description());
  const std::size_t colours = picture.palette_rgb.size() / 3U;
  if (c.palette_entries > 0 && colours > static_cast<std::size_t>(c.palette_entries))
    throw Failure("a picture of " + std::to_string(colours) + " colours is too much for the " +
                  std::to_string(c.palette_entries) + " of " + attached.description());
  const hal::Status s =
      c.buffers > 0 ? show_on_scan_out_panel(panel, picture) : show_on_write_panel(panel, picture);
  if (s.ok()) return;
  const std::string fault = attached.fault();
  throw Failure(fault.empty() ? attached.description() + ": showing the picture failed" : fault);
}

void show_still_and_leave(const AttachOptions& options, const IndexedPicture& picture, bool hold) {
  watch_for_interruption(SecondSignal::waits);
  const std::unique_ptr<AttachedPanel> attached = attach(options);
  show_still(*attached, picture);
  const std::string notices = attached->notices();
  std::fputs(notices.c_str(), stderr);
  while (hold && !interrupted()) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  if (!hold && !attached->keep())
    throw Failure(attached->description() +
                  " shows a picture only while the program runs: --hold keeps it up");
}

}  // namespace host
