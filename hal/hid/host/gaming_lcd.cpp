// SPDX-License-Identifier: MIT
#include <hal/hid/host/gaming_lcd.hpp>

namespace hal::hid {

namespace {

constexpr std::array<std::uint8_t, 6> lit_and_dark{255, 255, 255, 0, 0, 0};

// The round key left of the glass is `back`; the four below it are the arrows.
constexpr std::array<LcdKey, 7> g13_keys{{{6, 0, Key::back},
                                          {6, 1, Key::left},
                                          {6, 2, Key::up},
                                          {6, 3, Key::down},
                                          {6, 4, Key::right},
                                          {7, 1, Key::select},
                                          {7, 3, Key::select}}};
constexpr std::array<LcdKey, 6> g15_keys{{{2, 7, Key::back},
                                          {2, 1, Key::left},
                                          {2, 2, Key::up},
                                          {2, 3, Key::down},
                                          {2, 4, Key::right},
                                          {1, 6, Key::select}}};
constexpr std::array<LcdKey, 6> g510_keys{{{4, 0, Key::back},
                                           {4, 1, Key::left},
                                           {4, 2, Key::up},
                                           {4, 3, Key::down},
                                           {4, 4, Key::right},
                                           {3, 4, Key::select}}};

constexpr std::array<LcdDevice, 4> devices{{{"g13", 0xC21C, 1, 8, g13_keys, 1, 2},
                                            {"g15v2", 0xC227, 2, 5, g15_keys},
                                            {"g510", 0xC22D, 3, 5, g510_keys},
                                            {"g510", 0xC22E, 3, 5, g510_keys}}};

Capabilities capabilities_at(std::uint32_t millihertz) {
  return {.width = GamingLcd::width,
          .height = GamingLcd::height,
          .bits_per_pixel = 1,
          .bit_order = BitOrder::msb_first,
          .fixed_palette = lit_and_dark,
          .x_alignment = GamingLcd::width,
          .y_alignment = GamingLcd::height,
          .refresh_millihertz = millihertz};
}

}  // namespace

std::span<const LcdDevice> lcd_devices() { return devices; }

const LcdDevice* lcd_device(std::uint16_t product) {
  for (const LcdDevice& device : devices)
    if (device.product == product) return &device;
  return nullptr;
}

GamingLcd::GamingLcd(ReportPort& port, Clock* frame_clock, std::uint32_t millihertz)
    : WritePanel(capabilities_at(millihertz), frame_clock), port_(&port) {}

Status GamingLcd::do_write(const Rect& area, std::span<const std::uint8_t> pixels, int stride) noexcept {
  report_.fill(0);
  report_[0] = 3;
  for (int y = 0; y < area.height; ++y) {
    const auto row = pixels.subspan(static_cast<std::size_t>(y) * static_cast<std::size_t>(stride),
                                    std::size_t{width} / 8U);
    const auto page = header + static_cast<std::size_t>(y / 8) * width;
    for (std::size_t x = 0; x < width; ++x) {
      const unsigned pixel = static_cast<unsigned>(row[x / 8U]) >> (7U - x % 8U) & 1U;
      report_[page + x] =
          static_cast<std::uint8_t>(report_[page + x] | pixel << static_cast<unsigned>(y % 8));
    }
  }
  return port_->send(report_);
}

Status GamingLcd::clear() {
  report_.fill(0);
  report_[0] = 3;
  return port_->send(report_);
}

Keys LcdInput::do_poll() noexcept {
  // A device that never stops talking mustn't keep the program from its work.
  constexpr int most_reports = 64;
  std::array<std::uint8_t, 64> report{};
  for (int i = 0; i < most_reports; ++i) {
    const Received got = port_->receive(report, 0);
    if (!got.status.ok()) {
      if (got.status.error() == Error::disconnected) held_ = {};
      break;
    }
    if (got.size < device_->key_report_bytes || report[0] != device_->key_report) continue;
    Keys now;
    for (const LcdKey& key : device_->keys)
      if ((static_cast<unsigned>(report[key.byte]) >> key.bit & 1U) != 0) now.press(key.key);
    if (device_->stick_x != 0) {
      // Half of the way from the middle counts.
      constexpr int low = 64;
      constexpr int high = 192;
      if (report[device_->stick_x] < low) now.press(Key::left);
      if (report[device_->stick_x] >= high) now.press(Key::right);
      if (report[device_->stick_y] < low) now.press(Key::up);
      if (report[device_->stick_y] >= high) now.press(Key::down);
    }
    held_ = now;
  }
  return held_;
}

}  // namespace hal::hid
