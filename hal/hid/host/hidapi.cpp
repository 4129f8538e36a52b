// SPDX-License-Identifier: MIT
//
// A failed write doesn't say why. Whether the device is still there says a read that waits for nothing: it
// fails once the device is gone, with both libraries.
#include <hal/hid/host/hidapi.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <dlfcn.h>
#include <hidapi/hidapi.h>
#include <utility>

namespace hal::hid {

namespace {

using SteadyClock = std::chrono::steady_clock;

constexpr std::size_t longest_report = 2048;
/// As many as Linux keeps of those that a program doesn't read.
constexpr std::size_t most_kept = 64;

void append_utf8(std::string& text, std::uint32_t c) {
  const auto put = [&text](std::uint32_t byte) {
    text += static_cast<char>(static_cast<unsigned char>(byte));
  };
  if (c < 0x80U) {
    put(c);
  } else if (c < 0x800U) {
    put(0xC0U | c >> 6U);
    put(0x80U | (c & 63U));
  } else if (c < 0x10000U && (c < 0xD800U || c > 0xDFFFU)) {
    put(0xE0U | c >> 12U);
    put(0x80U | (c >> 6U & 63U));
    put(0x80U | (c & 63U));
  } else {
    put('?');
  }
}

/// What a device says of itself may be anything: what a terminal would act on is left out.
std::string utf8(const wchar_t* wide) {
  constexpr wchar_t last_control = 0x9F;
  std::string text;
  for (; wide != nullptr && *wide != 0; ++wide)
    if (*wide >= ' ' && (*wide < 0x7F || *wide > last_control))
      append_utf8(text, static_cast<std::uint32_t>(*wide));
  return text;
}

std::string hexadecimal(unsigned number) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  for (int shift = 12; shift >= 0; shift -= 4) text += digits[number >> static_cast<unsigned>(shift) & 15U];
  return text;
}

}  // namespace

std::string HidDevice::title() const {
  if (maker.empty() || product.starts_with(maker)) return product;
  return product.empty() ? maker : maker + ' ' + product;
}

struct HidApi::Functions {
  void* library = nullptr;
  /// Devices that are open.
  int open = 0;
  decltype(&hid_init) init = nullptr;
  decltype(&hid_exit) exit = nullptr;
  decltype(&hid_enumerate) enumerate = nullptr;
  decltype(&hid_free_enumeration) free_enumeration = nullptr;
  decltype(&hid_open_path) open_path = nullptr;
  decltype(&hid_write) write = nullptr;
  decltype(&hid_read_timeout) read_timeout = nullptr;
  decltype(&hid_send_feature_report) send_feature_report = nullptr;
  decltype(&hid_close) close = nullptr;
  decltype(&hid_error) error = nullptr;
};

HidApi::HidApi(Way way) : way_(way), functions_(std::make_unique<Functions>()) {
  const bool libusb = way == Way::libusb;
  const char* const file = libusb ? "libhidapi-libusb.so.0" : "libhidapi-hidraw.so.0";
  Functions& f = *functions_;
  f.library = dlopen(file, RTLD_NOW | RTLD_LOCAL);
  if (f.library == nullptr)
    throw HidError(std::string("USB HID needs ") + file +
                   ", Debian: " + (libusb ? "libhidapi-libusb0" : "libhidapi-hidraw0"));
  const auto find = [&](auto& function, const char* symbol) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(f.library, symbol));
    if (function == nullptr) throw HidError(std::string(file) + " has no " + symbol);
  };
  find(f.init, "hid_init");
  find(f.exit, "hid_exit");
  find(f.enumerate, "hid_enumerate");
  find(f.free_enumeration, "hid_free_enumeration");
  find(f.open_path, "hid_open_path");
  find(f.write, "hid_write");
  find(f.read_timeout, "hid_read_timeout");
  find(f.send_feature_report, "hid_send_feature_report");
  find(f.close, "hid_close");
  find(f.error, "hid_error");
  if (f.init() != 0) throw HidError(std::string(file) + " doesn't start");
}

// The libraries stay: they have threads of their own.
HidApi::~HidApi() = default;

const HidApi& HidApi::over(Way way) {
  static std::array<std::unique_ptr<HidApi>, 2> loaded;
  auto& api = loaded[static_cast<std::size_t>(way)];
  if (!api) api.reset(new HidApi(way));
  return *api;
}

std::string_view HidApi::name() const { return way_ == Way::libusb ? "libusb" : "hidraw"; }

void HidApi::look_again() const {
  if (functions_->open != 0) return;
  functions_->exit();
  functions_->init();
}

std::vector<HidDevice> HidApi::devices(std::uint16_t vendor, std::uint16_t product) const {
  std::vector<HidDevice> all;
  // All are asked for: the filter of some versions passes over devices whose parents lack an attribute.
  hid_device_info* const list = functions_->enumerate(0, 0);
  for (const hid_device_info* d = list; d != nullptr; d = d->next) {
    // One that is only just being plugged in may have no file yet.
    if (d->path == nullptr) continue;
    if ((vendor != 0 && d->vendor_id != vendor) || (product != 0 && d->product_id != product)) continue;
    all.push_back({d->path, utf8(d->serial_number), utf8(d->manufacturer_string), utf8(d->product_string),
                   d->vendor_id, d->product_id, d->usage_page, d->usage});
  }
  functions_->free_enumeration(list);
  return all;
}

struct HidApiPort::Handle {
  Handle(HidApi::Functions& functions, const std::string& path)
      : f(&functions), device(functions.open_path(path.c_str())) {
    if (device != nullptr) ++f->open;
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (device == nullptr) return;
    f->close(device);
    --f->open;
  }
  /// False once the device is gone. What it has said before hides that, so it is read and kept.
  [[nodiscard]] bool alive(std::deque<std::vector<std::uint8_t>>& kept) const {
    std::array<std::uint8_t, longest_report> report{};
    for (std::size_t i = 0; i <= most_kept; ++i) {
      const int n = f->read_timeout(device, report.data(), report.size(), 0);
      if (n <= 0) return n == 0;
      if (kept.size() == most_kept) kept.pop_front();
      kept.emplace_back(report.begin(), report.begin() + n);
    }
    return true;
  }

  HidApi::Functions* f;
  hid_device* device;
};

HidApiPort::HidApiPort(const HidApi& api, HidDevice device, Numbering numbering)
    : api_(&api),
      device_(std::move(device)),
      numbering_(numbering),
      handle_(std::make_unique<Handle>(api.functions(), device_.path)) {
  if (handle_->device == nullptr) {
    const std::string why = utf8(api.functions().error(nullptr));
    throw HidError("USB HID device " + description() + " can't be opened" + (why.empty() ? "" : ": " + why) +
                   "; may this user write to it (README.md, udev rule)?");
  }
}

HidApiPort::~HidApiPort() = default;

std::string HidApiPort::description() const {
  std::string text = hexadecimal(device_.vendor) + ':' + hexadecimal(device_.product_number);
  if (const std::string title = device_.title(); !title.empty()) text += " (" + title + ')';
  return text + " at " + device_.path;
}

std::span<const std::uint8_t> HidApiPort::framed(std::span<const std::uint8_t> report) {
  if (numbering_ == Numbering::numbered) return report;
  out_.assign(1, 0);
  out_.insert(out_.end(), report.begin(), report.end());
  return out_;
}

void HidApiPort::tell(const std::string& words) {
  constexpr std::size_t enough = 4096;
  if (notices_.size() < enough) notices_ += words + '\n';
}

Status HidApiPort::gone(const char* way) {
  gone_ = description() + " was unplugged";
  fault_ = gone_ + " (" + way + ')';
  tell(fault_);
  handle_.reset();
  kept_.clear();
  return {Error::disconnected, Part::panel};
}

Status HidApiPort::refused(const char* what, const char* way) {
  if (!handle_->alive(kept_)) return gone(way);
  fault_ = description() + " takes no " + what;
  return {Error::bus, Part::bus};
}

Status HidApiPort::do_send(std::span<const std::uint8_t> report) noexcept {
  if (!handle_) return {Error::disconnected, Part::panel};
  const auto bytes = framed(report);
  if (handle_->f->write(handle_->device, bytes.data(), bytes.size()) >= 0) return {};
  return refused("report", "writing");
}

Status HidApiPort::do_send_feature(std::span<const std::uint8_t> report) noexcept {
  if (!handle_) return {Error::disconnected, Part::panel};
  const auto bytes = framed(report);
  if (handle_->f->send_feature_report(handle_->device, bytes.data(), bytes.size()) >= 0) return {};
  return refused("feature report", "writing a feature");
}

Status HidApiPort::do_look() noexcept {
  if (!handle_) return {Error::disconnected, Part::panel};
  return handle_->alive(kept_) ? Status{} : gone("reading");
}

Received HidApiPort::do_receive(std::span<std::uint8_t> report, Nanoseconds patience) noexcept {
  if (!handle_) return {{Error::disconnected, Part::panel}, 0};
  if (!kept_.empty()) {
    const std::size_t size = std::min(kept_.front().size(), report.size());
    std::copy_n(kept_.front().begin(), size, report.begin());
    kept_.pop_front();
    return {{}, size};
  }
  constexpr Nanoseconds most = 1'000'000'000'000;
  constexpr Nanoseconds millisecond = 1'000'000;
  const auto until = SteadyClock::now() + std::chrono::nanoseconds(std::min(patience, most));
  for (;;) {
    const auto left =
        std::chrono::duration_cast<std::chrono::nanoseconds>(until - SteadyClock::now()).count();
    const int wait =
        left <= 0 ? 0 : static_cast<int>((static_cast<Nanoseconds>(left) + millisecond - 1) / millisecond);
    const int n = handle_->f->read_timeout(handle_->device, report.data(), report.size(), wait);
    if (n < 0) return {gone("reading"), 0};
    if (n > 0) return {{}, static_cast<std::size_t>(n)};
    // libusb hands out empty reports between others: they don't mean that the time is over.
    if (wait == 0) return {{Error::timeout, Part::bus}, 0};
  }
}

Status HidApiPort::do_reopen() noexcept {
  const bool away = handle_ == nullptr;
  if (gone_.empty()) gone_ = description() + " is gone";
  std::string why = " and isn't back";
  handle_.reset();
  kept_.clear();
  api_->look_again();
  for (const HidDevice& found : api_->devices(device_.vendor, device_.product_number)) {
    // Of a device with several interfaces only one is ours; libusb tells of no usages.
    if (found.usage_page != device_.usage_page || found.usage != device_.usage) continue;
    if (found.serial != device_.serial) {
      why = " and isn't back; the one at " + found.path + " has another serial number: " + found.serial;
      continue;
    }
    auto handle = std::make_unique<Handle>(api_->functions(), found.path);
    if (handle->device == nullptr) {
      why = " and is back at " + found.path +
            ", but can't be opened: " + utf8(api_->functions().error(nullptr));
      continue;
    }
    device_.path = found.path;
    handle_ = std::move(handle);
    if (away) tell(description() + " is back");
    fault_.clear();
    gone_.clear();
    return {};
  }
  fault_ = gone_ + why;
  return {Error::disconnected, Part::panel};
}

}  // namespace hal::hid
