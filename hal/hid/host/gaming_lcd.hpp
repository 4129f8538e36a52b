// SPDX-License-Identifier: MIT
//
// The 160x43 black-and-white display of gaming keyboards (Logitech G13, G15 of the second kind, G510), and
// the keys around it.
//
// Rule: a frame is one output report of 992 bytes: report number 3, 31 zeros, then 960 bytes in pages of
// eight rows, a byte a column with bit 0 on top, 160 columns a page; of the sixth page three rows are seen. A
// set bit is dark on the lit glass. So every write sends the whole picture, and the panel asks for whole
// frames. The keys come in input reports of the device's own kind; each is told by the table of its device.
#pragma once

#include <hal/hid/host/report_port.hpp>
#include <hal/input.hpp>
#include <hal/panels/write_panel.hpp>

#include <array>
#include <cstdint>
#include <span>

namespace hal::hid {

/// A key: bit `bit` of byte `byte` of the input report.
struct LcdKey {
  std::uint8_t byte = 0;
  std::uint8_t bit = 0;
  Key key{};
};

struct LcdDevice {
  const char* name = "";
  std::uint16_t product = 0;
  /// The input report that tells of keys: its number and least length.
  std::uint8_t key_report = 0;
  std::uint8_t key_report_bytes = 0;
  std::span<const LcdKey> keys{};
  /// Bytes of a stick's x and y in that report; 0: there is no stick.
  std::uint8_t stick_x = 0;
  std::uint8_t stick_y = 0;
};

inline constexpr std::uint16_t logitech = 0x046D;

/// The devices of this kind.
[[nodiscard]] std::span<const LcdDevice> lcd_devices();
/// The one of this product number, or null.
[[nodiscard]] const LcdDevice* lcd_device(std::uint16_t product);

class GamingLcd final : public panels::WritePanel {
 public:
  static constexpr int width = 160;
  static constexpr int height = 43;
  static constexpr std::size_t report_bytes = 992;

  /// `frame_clock` gives the rhythm of frames: the device tells none, and takes about 30 a second.
  explicit GamingLcd(ReportPort& port, Clock* frame_clock = nullptr, std::uint32_t millihertz = 30'000);

  /// Clears the display. Errors: bus, disconnected.
  Status start() { return clear(); }
  /// The same: the display can't be switched off.
  Status stop() { return clear(); }

 private:
  static constexpr std::size_t header = 32;

  Status do_write(const Rect& area, std::span<const std::uint8_t> pixels, int stride) noexcept override;
  Status clear();

  ReportPort* port_;
  std::array<std::uint8_t, report_bytes> report_{3};
};

class LcdInput final : public Input {
 public:
  LcdInput(ReportPort& port, const LcdDevice& device) : port_(&port), device_(&device) {}

 private:
  Keys do_poll() noexcept override;

  ReportPort* port_;
  const LcdDevice* device_;
  Keys held_;
};

}  // namespace hal::hid
