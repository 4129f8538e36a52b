// SPDX-License-Identifier: MIT
//
// Controllers on wires: SPI by a driver or by lines of GPIO, or I2C; lines for data/command, reset and
// tearing effect.
#include <hal/linux/gpio.hpp>
#include <hal/linux/i2c_device.hpp>
#include <hal/linux/monotonic_clock.hpp>
#include <hal/linux/spi_device.hpp>
#include <hal/panels/expanded_panel.hpp>
#include <hal/panels/modules.hpp>
#include <hal/panels/reset_line.hpp>
#include <host/attach/backend.hpp>
#include <host/attach/beam.hpp>
#include <host/failure.hpp>

#include <array>
#include <optional>
#include <utility>

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

/// "A?B" as two numbers of at most four digits, `between` being the sign between them.
std::optional<std::array<int, 2>> two_numbers(const std::string& text, char between) {
  const std::vector<std::string> parts = split(text, between);
  std::array<int, 2> numbers{};
  if (parts.size() != numbers.size()) return std::nullopt;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const bool digits = parts[i].find_first_not_of("0123456789") == std::string::npos;
    if (parts[i].empty() || parts[i].size() > 4 || !digits) return std::nullopt;
    numbers.at(i) = std::stoi(parts[i]);
  }
  return numbers;
}

/// Everything between this machine and a controller.
class Wires {
 public:
  Wires(const AttachOptions& options, std::uint8_t usual_address, hal::panels::I2cFraming framing)
      : options_(&options) {
    const int buses = !options.spi.empty() + !options.i2c.empty() + !options.bitbang.empty();
    if (buses != 1) throw Failure("a panel hangs on one of --spi, --i2c and --bitbang");
    if (options.i2c.empty() && options.data_command.empty())
      throw Failure("over SPI a panel needs the line that tells data from commands: --dc");
    if (!options.reset.empty()) reset_.emplace(line(options.reset), true);
    if (!options.i2c.empty()) {
      i2c_.emplace(options.i2c);
      i2c_port_.emplace(*i2c_, static_cast<std::uint8_t>(options.address.value_or(usual_address)), framing);
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
  [[nodiscard]] hal::linux_io::TeLine* te() { return te_ ? &*te_ : nullptr; }
  [[nodiscard]] const hal::linux_io::TeLine* te() const { return te_ ? &*te_ : nullptr; }
  [[nodiscard]] std::string take_notices() { return te_ ? te_->take_notices() : std::string(); }

  /// Pulls the reset line, if there is one.
  hal::Status reset() { return reset_ ? hal::panels::pulse_reset(*reset_, clock_) : hal::Status{}; }

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

using hal::panels::Module;

hal::panels::Rotation rotation_of(const AttachOptions& options) {
  return static_cast<hal::panels::Rotation>(options.rotate / 90);
}

hal::panels::ModuleGlass glass_of(const AttachOptions& options, const Module& module) {
  hal::panels::ModuleGlass glass;
  if (!options.size.empty()) {
    const auto size = two_numbers(options.size, 'x');
    if (!size || (*size)[0] == 0 || (*size)[1] == 0)
      throw Failure("--size is as 240x240, not '" + options.size + "'");
    glass.width = (*size)[0];
    glass.height = (*size)[1];
  }
  if (!options.offset.empty()) {
    const auto offset = two_numbers(options.offset, ',');
    if (!offset) throw Failure("--offset is as 0,80, not '" + options.offset + "'");
    glass.column_offset = (*offset)[0];
    glass.row_offset = (*offset)[1];
  }
  glass.bgr = options.bgr;
  glass.mirrored = options.mirror;
  if (glass != hal::panels::ModuleGlass{} && !module.any_glass)
    throw Failure(options.panel + " knows no --size, --offset, --bgr or --mirror");
  return glass;
}

std::string why_not(hal::Status status) {
  if (status.error() == hal::Error::unsupported || status.error() == hal::Error::invalid)
    return "it can't be set up as the options say";
  return "it doesn't answer";
}

class WiredPanel final : public AttachedPanel {
 public:
  WiredPanel(const AttachOptions& options, const Module& module)
      : options_(options),
        module_(&module),
        wires_(options_, module.i2c_address, module.i2c_framing),
        driver_(module.make(storage_, parts_of())) {
    if (options_.dither) {
      if (driver_.capabilities().palette_entries > 0)
        throw Failure(options_.panel + " has colours of its own: --dither is for panels of greys");
      expanded_.emplace(driver_, expansion_);
    }
    hal::Status s = wires_.reset();
    if (s.ok()) s = driver_.start();
    if (s.ok()) return;
    const std::string why = wires_.fault();
    // What was set up halfway must not stay on the glass.
    driver_.stop().ignore();
    throw Failure(options_.panel + ": " + (why.empty() ? why_not(s) : why));
  }
  ~WiredPanel() override {
    if (!kept_) driver_.stop().ignore();
  }

  hal::Panel& panel() override {
    if (expanded_) return *expanded_;
    return driver_;
  }
  std::string description() const override {
    const hal::Capabilities& c = driver_.capabilities();
    return options_.panel + ", " + std::to_string(c.width) + 'x' + std::to_string(c.height) + ", on " +
           wires_.description();
  }
  std::optional<Beam> beam() override {
    hal::linux_io::TeLine* const te = wires_.te();
    if (te == nullptr || module_->beam == nullptr) return std::nullopt;
    const std::optional<hal::Nanoseconds> refresh = measured_refresh(*te);
    // A timer knows nothing of the beam.
    if (!refresh || te->silent()) return std::nullopt;
    const std::optional<BusTimes> bus = measured_bus(driver_, wires_.clock());
    if (!bus) return std::nullopt;
    timing_ = beam_timing(module_->beam(use()), *refresh, *bus);
    const hal::Capabilities& c = driver_.capabilities();
    const std::string notice = tearing_notice(*timing_, c, clocked_bus());
    if (!notice.empty()) notices_ += options_.panel + ": " + notice;
    return Beam{&wires_.clock(), te, *timing_};
  }
  std::string notices() override { return std::exchange(notices_, {}) + wires_.take_notices(); }
  std::string fault() const override { return wires_.fault(); }
  std::string counters() const override {
    const auto line = [](const char* key, std::uint64_t value) {
      return std::string(key) + ' ' + std::to_string(value) + '\n';
    };
    std::string all;
    if (wires_.te() != nullptr) all += line("te_silences", wires_.te()->silences());
    if (timing_)
      all += line("refresh_ns", timing_->refresh) + line("bus_line_ns", timing_->bus_line) +
             line("bus_write_ns", timing_->bus_band);
    return all;
  }
  bool keep() override { return kept_ = true; }

 private:
  hal::panels::ModuleOptions use() {
    hal::panels::ModuleOptions use;
    use.refresh_millihertz = options_.refresh_millihertz;
    use.glass = glass_of(options_, *module_);
    use.rotation = rotation_of(options_);
    use.negative = options_.invert;
    if (options_.contrast) use.contrast = static_cast<std::uint8_t>(*options_.contrast);
    if (wires_.te() != nullptr) use.te = hal::panels::TearingEffect::vblank;
    use.workspace = workspace_;
    return use;
  }

  hal::panels::ModuleParts parts_of() {
    const Module& module = *module_;
    if (!options_.i2c.empty() && !module.i2c) throw Failure(options_.panel + " has no I2C");
    if (options_.i2c.empty() && !module.spi) throw Failure(options_.panel + " has no SPI");
    if (!options_.te.empty() && !module.te)
      throw Failure(options_.panel + " has no tearing-effect line for --te");
    hal::panels::ModuleParts parts;
    parts.port = &wires_.port();
    parts.clock = &wires_.clock();
    const std::uint32_t asked = options_.refresh_millihertz;
    parts.vblank = wires_.te(asked == 0 ? module.refresh_millihertz : asked);
    parts.options = use();
    return parts;
  }

  /// The bus of which a user could change the clock.
  [[nodiscard]] ClockedBus clocked_bus() const {
    const hal::Capabilities& c = driver_.capabilities();
    const bool columns = c.scan == hal::ScanDirection::left || c.scan == hal::ScanDirection::right;
    constexpr int bits_of_pixel = 16;  // Only TFTs have a TE line.
    return {options_.spi.empty() ? 0U : options_.spi_hertz,
            static_cast<std::uint32_t>((columns ? c.height : c.width) * bits_of_pixel)};
  }

  AttachOptions options_;
  const Module* module_;
  Wires wires_;
  std::array<std::uint8_t, 4096> workspace_{};  // As much as spidev takes at once.
  hal::panels::ModuleStorage storage_;
  hal::panels::BusPanel& driver_;
  std::array<std::uint8_t, 1024> expansion_{};
  std::optional<hal::panels::ExpandedPanel> expanded_;
  std::optional<intaglio::present::BeamTiming> timing_;
  std::string notices_;
  bool kept_ = false;
};

std::unique_ptr<AttachedPanel> attach_module(const AttachOptions& options) {
  return std::make_unique<WiredPanel>(options, *hal::panels::find_module(options.panel));
}

}  // namespace

std::vector<Backend> wired_backends() {
  std::vector<Backend> all;
  for (const Module& module : hal::panels::modules())
    all.push_back({module.name, module.description, attach_module});
  return all;
}

std::vector<std::string> list_wires() {
  std::vector<std::string> all;
  for (const std::string& path : files_of("/dev", "spidev")) all.push_back("--spi " + path + ": SPI device");
  for (const std::string& path : files_of("/dev", "i2c-")) all.push_back("--i2c " + path + ": I2C bus");
  for (const std::string& path : files_of("/dev", "gpiochip")) {
    const std::string name = path.substr(path.rfind('/') + 1U);
    const auto chip = hal::linux_io::gpiod::Chip::open(path);
    all.push_back("--gpio " + name + ": GPIO chip" +
                  (chip ? " [" + chip->label() + "], " + std::to_string(chip->line_count()) + " lines"
                        : ", which can't be opened"));
  }
  return all;
}

}  // namespace host
