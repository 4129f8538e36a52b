// SPDX-License-Identifier: MIT
//
// HID devices of this machine, through hidapi.
//
// Rule: hidapi's two libraries have the same functions: that over the kernel's hidraw files, and that over
// libusb, which takes the device away from the kernel. Both can be used by one program, so they are loaded
// when they are wanted; a machine that has neither is told which package is missing.
#pragma once

#include <hal/hid/host/report_port.hpp>

#include <cstdint>
#include <deque>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hal::hid {

/// A device that can't be used. The text is the whole message.
class HidError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A device as hidapi finds it.
struct HidDevice {
  std::string path;
  std::string serial;
  std::string maker;
  std::string product;
  std::uint16_t vendor = 0;
  std::uint16_t product_number = 0;
  /// 0 where the library can't tell (libusb).
  std::uint16_t usage_page = 0;
  std::uint16_t usage = 0;

  /// What its maker calls it: "Logitech G13"; may be empty.
  [[nodiscard]] std::string title() const;
};

class HidApi {
 public:
  enum class Way : std::uint8_t { hidraw, libusb };

  /// The library, loaded once. Throws HidError if it isn't installed.
  [[nodiscard]] static const HidApi& over(Way way);

  /// All devices, or those of a vendor (0: any) and product (0: any).
  [[nodiscard]] std::vector<HidDevice> devices(std::uint16_t vendor = 0, std::uint16_t product = 0) const;
  [[nodiscard]] std::string_view name() const;
  /// Forgets what it knows of devices, unless one is open: libusb learns of new ones from a service that not
  /// every system runs.
  void look_again() const;

  struct Functions;
  [[nodiscard]] Functions& functions() const { return *functions_; }

  HidApi(const HidApi&) = delete;
  HidApi& operator=(const HidApi&) = delete;
  ~HidApi();

 private:
  explicit HidApi(Way way);

  Way way_;
  std::unique_ptr<Functions> functions_;
};

/// Whether the first byte of reports is their number.
enum class Numbering : std::uint8_t { none, numbered };

class HidApiPort final : public ReportPort {
 public:
  /// Opens a device. Throws HidError.
  HidApiPort(const HidApi& api, HidDevice device, Numbering numbering);
  ~HidApiPort();

  [[nodiscard]] const HidDevice& device() const { return device_; }
  /// "046d:c21c (Logitech G13) at /dev/hidraw3"
  [[nodiscard]] std::string description() const;
  /// What went wrong last, or "".
  [[nodiscard]] const std::string& fault() const { return fault_; }
  /// That it was unplugged and is back: a line each, told once.
  [[nodiscard]] std::string take_notices() { return std::exchange(notices_, {}); }

 private:
  struct Handle;

  Status do_send(std::span<const std::uint8_t> report) noexcept override;
  Received do_receive(std::span<std::uint8_t> report, Nanoseconds patience) noexcept override;
  Status do_send_feature(std::span<const std::uint8_t> report) noexcept override;
  Status do_look() noexcept override;
  Status do_reopen() noexcept override;

  std::span<const std::uint8_t> framed(std::span<const std::uint8_t> report);
  Status refused(const char* what, const char* way);
  Status gone(const char* way);
  void tell(const std::string& words);

  const HidApi* api_;
  HidDevice device_;
  Numbering numbering_;
  std::unique_ptr<Handle> handle_;
  std::vector<std::uint8_t> out_;
  /// Reports that came when only the life of the device was looked at.
  std::deque<std::vector<std::uint8_t>> kept_;
  std::string fault_;
  /// What is to be said of a device that is gone; "" while it is there.
  std::string gone_;
  std::string notices_;
};

}  // namespace hal::hid
