// SPDX-License-Identifier: MIT
//
// Controllers on wires: SPI by a driver or by lines of GPIO, or I2C; lines for data/command, reset and
// tearing effect.
#include <hal/linux/gpio.hpp>
#include <hal/linux/i2c_device.hpp>
#include <hal/linux/monotonic_clock.hpp>
#include <hal/linux/spi_device.hpp>
#include <hal/panels/ssd0323.hpp>
#include <hal/panels/ssd1306.hpp>
#include <host/attach/backend.hpp>
#include <host/failure.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <optional>

namespace host {

namespace {

using hal::linux_io::LineAddress;

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts{""};
  for (const char c : text) {
    if (c == at)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

/// "A?B" as two numbers, `between` being the sign between them.
std::optional<std::array<int, 2>> two_numbers(const std::string& text, char between) {
  const std::vector<std::string> parts = split(text, between);
  std::array<int, 2> numbers{};
  if (parts.size() != numbers.size()) return std::nullopt;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::string& part = parts[i];
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), numbers[i]);
    if (error != std::errc{} || end != part.data() + part.size() || numbers[i] < 0) return std::nullopt;
  }
  return numbers;
}

/// Everything between this machine and a controller.
class Wires {
 public:
  explicit Wires(const AttachOptions& options) : options_(&options) {
    const int buses = !options.spi.empty() + !options.i2c.empty() + !options.bitbang.empty();
    if (buses != 1) throw Failure("a panel hangs on one of --spi, --i2c and --bitbang");
    if (options.i2c.empty() && options.data_command.empty())
      throw Failure("over SPI a panel needs the line that tells data from commands: --dc");
    if (!options.reset.empty()) reset_.emplace(line(options.reset), true);
    if (!options.i2c.empty()) {
      i2c_.emplace(options.i2c);
      i2c_port_.emplace(*i2c_, static_cast<std::uint8_t>(options.address));
    } else {
      data_command_.emplace(line(options.data_command), false);
      open_spi();
    }
  }

  [[nodiscard]] hal::panels::CommandPort& port() {
    if (i2c_port_) return *i2c_port_;
    return *spi_port_;
  }
  [[nodiscard]] hal::linux_io::MonotonicClock& clock() { return clock_; }
  /// The tearing-effect line; null if none was named. Taken at the first call.
  [[nodiscard]] hal::linux_io::TeLine* te(std::uint32_t refresh_millihertz) {
    if (!te_ && !options_->te.empty()) te_.emplace(line(options_->te), clock_, refresh_millihertz);
    return te_ ? &*te_ : nullptr;
  }
  [[nodiscard]] const hal::linux_io::TeLine* te() const { return te_ ? &*te_ : nullptr; }
  [[nodiscard]] std::string take_notices() { return te_ ? te_->take_notices() : std::string(); }

  /// Pulls the reset line, if there is one.
  hal::Status reset() {
    if (!reset_) return {};
    constexpr hal::Nanoseconds pulse = 10'000'000;
    constexpr hal::Nanoseconds recovery = 120'000'000;
    if (const hal::Status s = reset_->set(false); !s.ok()) return s;
    clock_.wait_until(clock_.now() + pulse);
    if (const hal::Status s = reset_->set(true); !s.ok()) return s;
    clock_.wait_until(clock_.now() + recovery);
    return {};
  }

  [[nodiscard]] std::string description() const {
    if (!options_->spi.empty()) return "SPI device " + options_->spi;
    if (!options_->i2c.empty()) return "I2C bus " + options_->i2c;
    return "GPIO lines " + options_->bitbang;
  }

  [[nodiscard]] std::string fault() const {
    for (const std::string& text : {spi_ ? spi_->fault() : "", bitbang_ ? bitbang_->fault() : "",
                                    i2c_ ? i2c_->fault() : "", data_command_ ? data_command_->fault() : "",
                                    reset_ ? reset_->fault() : "", te_ ? te_->fault() : ""})
      if (!text.empty()) return text;
    return {};
  }

 private:
  [[nodiscard]] LineAddress line(const std::string& text) const {
    return hal::linux_io::line_address(text, options_->gpio);
  }

  void open_spi() {
    if (!options_->spi.empty()) {
      spi_.emplace(options_->spi, hal::linux_io::SpiOptions{options_->spi_hertz, options_->spi_mode});
      spi_port_.emplace(*spi_, *data_command_);
      return;
    }
    std::vector<LineAddress> lines;
    for (const std::string& text : split(options_->bitbang, ',')) lines.push_back(line(text));
    if (lines.size() < 2 || lines.size() > 3)
      throw Failure("--bitbang takes two or three lines, SCK,MOSI or SCK,MOSI,CS, not '" + options_->bitbang +
                    "'");
    bitbang_.emplace(lines);
    spi_port_.emplace(*bitbang_, *data_command_);
  }

  const AttachOptions* options_;
  hal::linux_io::MonotonicClock clock_;
  std::optional<hal::linux_io::OutputLine> reset_;
  std::optional<hal::linux_io::OutputLine> data_command_;
  std::optional<hal::linux_io::SpiDevice> spi_;
  std::optional<hal::linux_io::BitBangSpi> bitbang_;
  std::optional<hal::linux_io::I2cDevice> i2c_;
  std::optional<hal::panels::SpiPort> spi_port_;
  std::optional<hal::panels::I2cPort> i2c_port_;
  std::optional<hal::linux_io::TeLine> te_;
};

/// A driver of a controller, as whoever switches it on and off sees it.
class Controller {
 public:
  Controller() = default;
  Controller(const Controller&) = delete;
  Controller& operator=(const Controller&) = delete;
  virtual ~Controller() = default;
  [[nodiscard]] virtual hal::Panel& panel() = 0;
  virtual hal::Status start() = 0;
  virtual hal::Status stop() = 0;
};

template <class Driver>
class Driven final : public Controller {
 public:
  template <class... Arguments>
  explicit Driven(Wires& wires, Arguments&&... arguments)
      : wires_(&wires), driver_(wires.port(), std::forward<Arguments>(arguments)...) {}
  hal::Panel& panel() override { return driver_; }
  hal::Status start() override { return driver_.start(); }
  hal::Status stop() override {
    if constexpr (requires(Driver & driver) { driver.stop(); }) {
      return driver_.stop();
    } else {
      // Display off, of all controllers of the SSD13xx family.
      constexpr std::array<std::uint8_t, 1> off{0xAE};
      return wires_->port().command(off);
    }
  }

 private:
  Wires* wires_;
  Driver driver_;
};

using MakeController = std::unique_ptr<Controller> (*)(Wires& wires, const AttachOptions& options);

std::string words_of(hal::Status status) {
  switch (status.error()) {
    case hal::Error::invalid:
      return "it can't be set up as the options say";
    case hal::Error::unsupported:
      return "it can't do what the options say";
    default:
      return "it doesn't answer";
  }
}

class WiredPanel final : public AttachedPanel {
 public:
  WiredPanel(const AttachOptions& options, MakeController make)
      : options_(options), wires_(options_), controller_(make(wires_, options_)) {
    hal::Status s = wires_.reset();
    if (s.ok()) s = controller_->start();
    if (s.ok()) return;
    const std::string why = wires_.fault();
    // What was set up halfway must not stay on the glass.
    controller_->stop().ignore();
    throw Failure(options_.panel + ": " + (why.empty() ? words_of(s) : why));
  }
  ~WiredPanel() override {
    if (!kept_) controller_->stop().ignore();
  }

  hal::Panel& panel() override { return controller_->panel(); }
  std::string description() const override {
    const hal::Capabilities& c = controller_->panel().capabilities();
    return options_.panel + ", " + std::to_string(c.width) + 'x' + std::to_string(c.height) + ", on " +
           wires_.description();
  }
  std::string notices() override { return wires_.take_notices(); }
  std::string fault() const override { return wires_.fault(); }
  std::string counters() const override {
    return wires_.te() == nullptr ? std::string()
                                  : "te_silences " + std::to_string(wires_.te()->silences()) + '\n';
  }
  bool keep() override { return kept_ = true; }

 private:
  AttachOptions options_;
  Wires wires_;
  std::unique_ptr<Controller> controller_;
  bool kept_ = false;
};

/// Options that a controller has no use for are said, not passed over.
void refuse(const AttachOptions& options, bool given, const char* option) {
  if (given) throw Failure(options.panel + " knows no " + option);
}

void refuse_colour_options(const AttachOptions& options) {
  refuse(options, options.bgr, "--bgr");
  refuse(options, options.mirror, "--mirror");
}

std::uint32_t refresh_of(const AttachOptions& options, std::uint32_t usual) {
  return options.refresh_millihertz == 0 ? usual : options.refresh_millihertz;
}

std::unique_ptr<Controller> make_ssd1306(Wires& wires, const AttachOptions& options) {
  refuse_colour_options(options);
  refuse(options, options.rotate != 0, "--rotate");
  refuse(options, options.invert, "--invert");
  refuse(options, options.contrast.has_value(), "--contrast");
  refuse(options, !options.offset.empty(), "--offset");
  refuse(options, !options.te.empty(), "--te: it has no such line");
  hal::panels::Ssd1306Module module =
      options.panel == "sh1106" ? hal::panels::sh1106_128x64 : hal::panels::ssd1306_128x64;
  if (!options.size.empty() && options.size != "128x64") {
    if (options.panel != "ssd1306" || options.size != "128x32")
      throw Failure(options.panel + " has 128x64 pixels" + (options.panel == "ssd1306" ? " or 128x32" : "") +
                    ", not " + options.size);
    module = hal::panels::ssd1306_128x32;
  }
  module.refresh_millihertz = refresh_of(options, module.refresh_millihertz);
  return std::make_unique<Driven<hal::panels::Ssd1306>>(wires, module, &wires.clock());
}

std::unique_ptr<Controller> make_ssd0323(Wires& wires, const AttachOptions& options) {
  refuse_colour_options(options);
  refuse(options, options.rotate != 0, "--rotate");
  refuse(options, options.invert, "--invert");
  refuse(options, !options.size.empty() && options.size != "128x64", "--size but 128x64");
  refuse(options, !options.te.empty(), "--te: it has no such line");
  hal::panels::Ssd0323Options module;
  if (options.contrast) module.contrast = static_cast<std::uint8_t>(*options.contrast / 2);
  if (!options.offset.empty()) {
    const auto offset = two_numbers(options.offset, ',');
    if (!offset || (*offset)[0] != 0 || (*offset)[1] > 79)
      throw Failure("--offset of " + options.panel + " is 0,ROW with a row of 0 to 79, not '" +
                    options.offset + "'");
    module.offset = static_cast<std::uint8_t>((*offset)[1]);
  }
  module.refresh_millihertz = refresh_of(options, module.refresh_millihertz);
  return std::make_unique<Driven<hal::panels::Ssd0323>>(wires, &wires.clock(), module);
}

template <MakeController make>
std::unique_ptr<AttachedPanel> attach_wired(const AttachOptions& options) {
  return std::make_unique<WiredPanel>(options, make);
}

/// Files of a folder whose names begin so, in order.
std::vector<std::string> files(const std::string& folder, const std::string& beginning) {
  std::vector<std::string> found;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(beginning)) found.push_back(entry.path().string());
  }
  std::ranges::sort(found);
  return found;
}

}  // namespace

std::vector<Backend> wired_backends() {
  return {
      {"ssd1306", "OLED, 128x64 or 128x32, black and white, SPI or I2C", attach_wired<make_ssd1306>},
      {"sh1106", "OLED, 128x64, black and white, SPI or I2C", attach_wired<make_ssd1306>},
      {"ssd0323", "OLED, 128x64, 16 greys, SPI or I2C", attach_wired<make_ssd0323>},
  };
}

std::vector<std::string> list_wires() {
  std::vector<std::string> all;
  for (const std::string& path : files("/dev", "spidev")) all.push_back("--spi " + path + ": SPI device");
  for (const std::string& path : files("/dev", "i2c-")) all.push_back("--i2c " + path + ": I2C bus");
  for (const std::string& path : files("/dev", "gpiochip")) {
    const std::string name = path.substr(path.rfind('/') + 1U);
    const auto chip = hal::linux_io::gpiod::Chip::open(path);
    all.push_back("--gpio " + name + ": GPIO chip" +
                  (chip ? " [" + chip->label() + "], " + std::to_string(chip->line_count()) + " lines"
                        : ", which can't be opened"));
  }
  return all;
}

}  // namespace host
