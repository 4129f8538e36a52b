// SPDX-License-Identifier: MIT
//
// A display on USB HID made of nothing but a kernel: the device side of the report protocol, with a simulated
// panel that runs in real time, behind a USB gadget or behind uhid.
//
//   hid_gadget usb  --digests FILE [OPTIONS]     f_hid on the first USB device controller (dummy_hcd's, say)
//   hid_gadget uhid --digests FILE [OPTIONS]     /dev/uhid
//
//   --size WxHxBITS     the panel (160x120x8)
//   --serial TEXT       its serial number (S1)
//   --drop N            every Nth report of the host is lost
//   --drop-answers N    every Nth report of the device is lost
//   --stall N,MS        after frame N it does nothing for MS milliseconds
//   --unplug N,MS       after frame N it is unplugged, for MS milliseconds
//
// FILE gets a line "frame N crc32 HEX" for each refresh of the panel that differs from the one before, N
// counting from 0, the digest that of intaglio-sim --digest over the lines as the beam fetched them: so a
// frame that was torn has a line, too. A host that shows frames of which no two in a row are alike finds its
// own lines there, and behind them one for the black frame with which it leaves.
// "ready" on standard output says that the device can be found. Ends with SIGTERM, and leaves nothing behind;
// then it prints what happened.
#include <hal/hid/device/device.hpp>
#include <hal/sim/panel.hpp>
#include <hal/sim/pixels.hpp>
#include <intaglio/image/digest.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <linux/uhid.h>
#include <memory>
#include <optional>
#include <poll.h>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <unistd.h>
#include <vector>

namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;
using hal::hid::Device;
using Milliseconds = std::chrono::milliseconds;

constexpr std::size_t report_bytes = hal::hid::least_report_bytes;

volatile std::sig_atomic_t ended = 0;

[[noreturn]] void fail(const std::string& what) {
  throw std::runtime_error(what + ": " + std::strerror(errno));
}

/// A fault that begins after a frame.
struct After {
  std::uint64_t frame = 0;
  Milliseconds time{0};
};

struct Options {
  bool usb = false;
  std::string size = "160x120x8";
  std::string serial = "S1";
  std::string digests;
  std::uint64_t drop = 0;
  std::uint64_t drop_answers = 0;
  std::optional<After> stall;
  std::optional<After> unplug;
};

After after(const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) throw std::runtime_error("'" + text + "' should be N,MS");
  return {std::stoull(text.substr(0, comma)), Milliseconds(std::stoll(text.substr(comma + 1)))};
}

Options parse(const std::vector<std::string>& words) {
  Options o;
  if (words.empty() || (words[0] != "usb" && words[0] != "uhid")) throw std::runtime_error("say usb or uhid");
  o.usb = words[0] == "usb";
  for (std::size_t i = 1; i < words.size(); i += 2) {
    if (i + 1 == words.size()) throw std::runtime_error(words[i] + " needs a value");
    const std::string& value = words[i + 1];
    if (words[i] == "--size")
      o.size = value;
    else if (words[i] == "--serial")
      o.serial = value;
    else if (words[i] == "--digests")
      o.digests = value;
    else if (words[i] == "--drop")
      o.drop = std::stoull(value);
    else if (words[i] == "--drop-answers")
      o.drop_answers = std::stoull(value);
    else if (words[i] == "--stall")
      o.stall = after(value);
    else if (words[i] == "--unplug")
      o.unplug = after(value);
    else
      throw std::runtime_error("no option " + words[i]);
  }
  return o;
}

/// How the kernel lets a program be a device.
class Plug {
 public:
  Plug() = default;
  Plug(const Plug&) = delete;
  Plug& operator=(const Plug&) = delete;
  virtual ~Plug() = default;
  virtual void insert() = 0;
  virtual void pull() = 0;
  [[nodiscard]] virtual int file() const = 0;
  /// The next output report, if there is one; empty: something else was dealt with.
  virtual std::optional<Bytes> read(const Device& device) = 0;
  /// False: not now.
  virtual bool write(const Bytes& report) = 0;
};

/// A USB gadget of configfs with the function f_hid, made and taken apart here.
class UsbPlug final : public Plug {
 public:
  explicit UsbPlug(const std::string& serial) {
    clear();
    make(root_);
    text(root_ / "idVendor", number(hal::hid::test_vendor));
    text(root_ / "idProduct", number(hal::hid::test_product));
    make(root_ / "strings/0x409");
    text(root_ / "strings/0x409/manufacturer", "Intaglio");
    text(root_ / "strings/0x409/product", "Intaglio test display");
    text(root_ / "strings/0x409/serialnumber", serial);
    make(root_ / "configs/c.1");
    make(function_);
    text(function_ / "protocol", "0");
    text(function_ / "subclass", "0");
    text(function_ / "report_length", std::to_string(report_bytes));
    constexpr auto descriptor = hal::hid::report_descriptor(report_bytes);
    text(function_ / "report_desc", {reinterpret_cast<const char*>(descriptor.data()), descriptor.size()});
    fs::create_symlink(function_, root_ / "configs/c.1/hid.usb0");
    for (const auto& entry : fs::directory_iterator("/sys/class/udc")) {
      controller_ = entry.path().filename().string();
      break;
    }
    if (controller_.empty()) throw std::runtime_error("no USB device controller; modprobe dummy_hcd");
  }
  ~UsbPlug() override {
    if (file_ >= 0) close(file_);
    clear();
  }

  void insert() override {
    text(root_ / "UDC", controller_);
    // The file is named by the function, and appears when the controller has it.
    std::string name;
    std::ifstream(function_ / "dev") >> name;
    const std::string minor = name.substr(name.find(':') + 1);
    const std::string path = "/dev/hidg" + minor;
    for (int i = 0; i < 200 && file_ < 0; ++i) {
      file_ = open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
      if (file_ < 0) std::this_thread::sleep_for(Milliseconds(10));
    }
    if (file_ < 0) fail(path);
  }
  void pull() override {
    close(file_);
    file_ = -1;
    text(root_ / "UDC", "\n");
  }
  [[nodiscard]] int file() const override { return file_; }
  std::optional<Bytes> read(const Device&) override {
    Bytes report(report_bytes);
    const ssize_t n = ::read(file_, report.data(), report.size());
    if (n <= 0) return {};
    report.resize(static_cast<std::size_t>(n));
    return report;
  }
  bool write(const Bytes& report) override {
    return ::write(file_, report.data(), report.size()) == static_cast<ssize_t>(report.size());
  }

 private:
  static std::string number(unsigned value) {
    std::array<char, 8> out{};
    std::snprintf(out.data(), out.size(), "0x%04x", value);
    return out.data();
  }
  static void make(const fs::path& folder) { fs::create_directories(folder); }
  static void text(const fs::path& path, std::string_view what) {
    const int f = open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (f < 0) fail(path.string());
    const ssize_t n = ::write(f, what.data(), what.size());
    close(f);
    if (n != static_cast<ssize_t>(what.size())) fail(path.string());
  }
  /// What an earlier run left behind, too. Folders of configfs go one by one, from the inside.
  void clear() {
    if (!fs::exists(root_)) return;
    if (const int f = open((root_ / "UDC").c_str(), O_WRONLY | O_CLOEXEC); f >= 0) {
      if (::write(f, "\n", 1) != 1) std::perror("unbinding");
      close(f);
    }
    unlink((root_ / "configs/c.1/hid.usb0").c_str());
    for (const char* folder : {"configs/c.1", "functions/hid.usb0", "strings/0x409", ""})
      rmdir((root_ / folder).c_str());
  }

  fs::path root_ = "/sys/kernel/config/usb_gadget/intaglio";
  fs::path function_ = root_ / "functions/hid.usb0";
  std::string controller_;
  int file_ = -1;
};

/// /dev/uhid: a HID device without USB. The kernel keeps 32 reports for us and drops the rest.
class UhidPlug final : public Plug {
 public:
  explicit UhidPlug(std::string serial) : serial_(std::move(serial)) {
    file_ = open("/dev/uhid", O_RDWR | O_NONBLOCK | O_CLOEXEC);
    if (file_ < 0) fail("/dev/uhid");
  }
  ~UhidPlug() override { close(file_); }

  void insert() override {
    uhid_event event{};
    event.type = UHID_CREATE2;
    auto& c = event.u.create2;
    std::snprintf(reinterpret_cast<char*>(c.name), sizeof c.name, "Intaglio test display");
    std::snprintf(reinterpret_cast<char*>(c.uniq), sizeof c.uniq, "%s", serial_.c_str());
    constexpr auto descriptor = hal::hid::report_descriptor(report_bytes);
    std::copy(descriptor.begin(), descriptor.end(), &c.rd_data[0]);
    c.rd_size = descriptor.size();
    c.bus = 3;  // BUS_USB
    c.vendor = hal::hid::test_vendor;
    c.product = hal::hid::test_product;
    send(event);
  }
  void pull() override {
    uhid_event event{};
    event.type = UHID_DESTROY;
    send(event);
    while (::read(file_, &event, sizeof event) > 0) {
    }
  }
  [[nodiscard]] int file() const override { return file_; }
  std::optional<Bytes> read(const Device& device) override {
    uhid_event event{};
    if (::read(file_, &event, sizeof event) <= 0) return {};
    if (event.type == UHID_OUTPUT) {
      const std::uint8_t* const data = &event.u.output.data[0];
      Bytes report(data, data + event.u.output.size);
      // The number of an unnumbered report comes along, as 0.
      if (report.size() == report_bytes + 1) report.erase(report.begin());
      return report;
    }
    uhid_event answer{};
    if (event.type == UHID_GET_REPORT) {
      answer.type = UHID_GET_REPORT_REPLY;
      answer.u.get_report_reply.id = event.u.get_report.id;
      answer.u.get_report_reply.size = report_bytes + 1;
      device.describe({&answer.u.get_report_reply.data[1], report_bytes});
      send(answer);
    } else if (event.type == UHID_SET_REPORT) {
      answer.type = UHID_SET_REPORT_REPLY;
      answer.u.set_report_reply.id = event.u.set_report.id;
      answer.u.set_report_reply.err = EIO;
      send(answer);
    }
    return Bytes{};
  }
  bool write(const Bytes& report) override {
    uhid_event event{};
    event.type = UHID_INPUT2;
    event.u.input2.size = static_cast<__u16>(report.size());
    std::copy(report.begin(), report.end(), &event.u.input2.data[0]);
    return ::write(file_, &event, sizeof event) > 0;
  }

 private:
  void send(const uhid_event& event) const {
    if (::write(file_, &event, sizeof event) < 0) fail("/dev/uhid");
  }

  std::string serial_;
  int file_ = -1;
};

/// Watches the beam: the digest of each refresh.
class Witness final : public hal::sim::Observer {
 public:
  Witness(const hal::Capabilities& panel, const std::string& file) : panel_(panel), file_(file) {
    if (!file_) throw std::runtime_error("cannot write " + file);
  }
  [[nodiscard]] std::uint64_t frames() const { return frames_; }

 private:
  void on_line(const hal::sim::ScannedLine& line) override {
    if (line.y == 0) {
      crc_ = {};
      number(panel_.width);
      number(panel_.height);
      crc_.add(line.palette);
    }
    for (int x = 0; x < panel_.width; ++x)
      crc_.add(hal::sim::pixel_at(line.pixels, x, panel_.bits_per_pixel, panel_.bit_order));
  }
  void on_vblank(std::uint64_t, hal::Nanoseconds) override {
    if (!first_ && crc_.value() == last_) return;
    last_ = crc_.value();
    // What a panel shows before its first frame is nobody's.
    if (!first_) {
      std::array<char, 48> line{};
      std::snprintf(line.data(), line.size(), "frame %llu crc32 %08x\n",
                    static_cast<unsigned long long>(frames_), last_);
      file_ << line.data() << std::flush;
      ++frames_;
    }
    first_ = false;
  }
  void number(int n) {
    for (unsigned shift = 0; shift < 32; shift += 8)
      crc_.add(static_cast<std::uint8_t>(static_cast<unsigned>(n) >> shift & 0xFFU));
  }

  hal::Capabilities panel_;
  std::ofstream file_;
  intaglio::image::Crc32 crc_;
  std::uint32_t last_ = 0;
  std::uint64_t frames_ = 0;
  bool first_ = true;
};

class Gadget {
 public:
  explicit Gadget(const Options& options)
      : options_(options),
        glass_(panel_of(options.size), clock_),
        device_(glass_, nullptr, {}),
        witness_(glass_.capabilities(), options.digests) {
    if (!device_.status().ok()) throw std::runtime_error("no device can have a panel of " + options.size);
    glass_.attach(witness_);
    if (options.usb)
      plug_ = std::make_unique<UsbPlug>(options.serial);
    else
      plug_ = std::make_unique<UhidPlug>(options.serial);
  }

  void run() {
    plug_->insert();
    std::puts("ready");
    std::fflush(stdout);
    while (ended == 0) {
      // Reports that can't be taken yet stay with the kernel.
      pollfd waiting{plug_->file(), static_cast<short>(device_.ready() ? POLLIN : 0), 0};
      ::poll(&waiting, 1, 1);
      turn();
    }
    plug_->pull();
    const auto& c = device_.counters();
    std::printf(
        "frames %llu reports %u dropped %llu repeated %u early %u foreign %u overrun %u rejected %u "
        "sessions %u\n",
        static_cast<unsigned long long>(frames_), c.accepted, static_cast<unsigned long long>(dropped_),
        c.repeated, c.early, c.foreign, c.overrun, c.rejected, c.sessions);
  }

 private:
  static hal::sim::PanelSpec panel_of(const std::string& size) {
    auto spec = hal::sim::find_panel(size);
    if (!spec) throw std::runtime_error("no panel '" + size + "'");
    return *std::move(spec);
  }

  void turn() {
    advance();
    while (device_.ready()) {
      const auto report = plug_->read(device_);
      if (!report) break;
      if (report->empty()) continue;
      ++reports_;
      if (options_.drop != 0 && reports_ % options_.drop == 0)
        ++dropped_;
      else
        device_.receive(*report);
      advance();
    }
    // Not before the last one is out: the next one then tells the latest.
    while (unsent_ || device_.next(answer_) != 0) {
      if (!unsent_) {
        ++answers_;
        if (options_.drop_answers != 0 && answers_ % options_.drop_answers == 0) {
          ++dropped_;
          continue;
        }
      }
      unsent_ = !plug_->write(answer_);
      if (unsent_) break;
    }
  }

  void advance() {
    const auto now = std::chrono::steady_clock::now() - start_;
    clock_.wait_until(static_cast<hal::Nanoseconds>(std::chrono::nanoseconds(now).count()));
    device_.poll();
    if (witness_.frames() != frames_) {
      frames_ = witness_.frames();
      appeared();
    }
  }

  void appeared() {
    if (options_.stall && frames_ == options_.stall->frame) std::this_thread::sleep_for(options_.stall->time);
    if (options_.unplug && frames_ == options_.unplug->frame) {
      plug_->pull();
      device_.unplugged();
      unsent_ = false;
      std::this_thread::sleep_for(options_.unplug->time);
      plug_->insert();
    }
  }

  Options options_;
  hal::sim::VirtualClock clock_;
  hal::sim::Panel glass_;
  Device device_;
  Witness witness_;
  std::unique_ptr<Plug> plug_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  Bytes answer_ = Bytes(report_bytes);
  bool unsent_ = false;
  std::uint64_t frames_ = 0;
  std::uint64_t reports_ = 0;
  std::uint64_t answers_ = 0;
  std::uint64_t dropped_ = 0;
};

}  // namespace

int main(int argc, char** argv) try {
  const auto end = [](int) { ended = 1; };
  std::signal(SIGTERM, end);
  std::signal(SIGINT, end);
  Gadget(parse({argv + 1, argv + argc})).run();
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "hid_gadget: %s\n", error.what());
  return 1;
}
