// SPDX-License-Identifier: MIT
//
// Display controllers. Any bytes into their models: breaches are told, nothing breaks. Any options, palettes,
// rectangles and faults of the bus through the drivers: what is accepted is shown, and no byte is a breach.
#include <hal/mock/strict_dcs.hpp>
#include <hal/mock/strict_ssd0323.hpp>
#include <hal/mock/strict_ssd1306.hpp>
#include <hal/mock/strict_ssd1322.hpp>
#include <hal/panels/expanded_panel.hpp>
#include <hal/panels/ili9341.hpp>
#include <hal/panels/ssd0323.hpp>
#include <hal/panels/ssd1306.hpp>
#include <hal/panels/ssd1322.hpp>
#include <hal/panels/st7789.hpp>
#include <hal/sim/virtual_clock.hpp>
#include <tests/fuzz/input.hpp>
#include <tests/hal/turned_glass.hpp>

#include <memory>

namespace fuzz {

namespace {

using glass::Pattern;
using glass::Rotation;
using hal::mock::StrictController;
using hal::panels::BusPanel;
using hal::panels::DcsOptions;

constexpr hal::Nanoseconds millisecond = 1'000'000;

std::unique_ptr<StrictController> any_model(int kind, hal::Clock& clock) {
  switch (kind) {
    case 0:
      return std::make_unique<hal::mock::StrictSt7789>(clock);
    case 1:
      return std::make_unique<hal::mock::StrictIli9341>(clock);
    case 2:
      return std::make_unique<hal::mock::StrictSsd1322>();
    case 3:
      return std::make_unique<hal::mock::StrictSsd0323>();
    default:
      return std::make_unique<hal::mock::StrictSsd1306>(128, 64, 2, 0x3C, 132);
  }
}

/// Whatever comes down the wires.
void any_bytes(Input& in) {
  hal::sim::VirtualClock clock;
  const auto model = any_model(in.choice(5), clock);
  std::size_t breaches = 0;
  model->on_breach([&](std::string_view) { ++breaches; });
  bool driven = false;
  while (!in.empty()) {
    const int action = in.byte();
    if (action < 32) {
      clock.advance(static_cast<hal::Nanoseconds>(action) * 5 * millisecond);
    } else if (action < 96) {
      model->data_command().set(action < 64).ignore();
      driven = true;
    } else if (action < 128) {
      model->fail_after(in.choice(4), in.choice(4));
    } else {
      std::vector<std::uint8_t> bytes(static_cast<std::size_t>(action - 127) & 31U);
      for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(in.byte());
      const std::array<std::uint8_t, 1> control{static_cast<std::uint8_t>(in.choice(3) * 0x40)};
      const std::size_t before = breaches;
      const bool i2c = action % 4 == 0;
      const hal::Status status = i2c ? model->i2c().write(0x3C, control, bytes) : model->spi().write(bytes);
      if (!i2c && !bytes.empty() && !driven && status.ok())
        require(breaches > before, "bytes nobody could tell apart weren't reported");
      // A fault lasts until the wire is mended.
      if (!status.ok()) model->fail_after(1 << 30);
    }
  }
  const Pattern shown = model->displayed();
  for (int step = 0; step < shown.height; ++step) {
    const int row = model->beam_row(step);
    require(row >= 0 && row < shown.height, "a beam beside the glass");
  }
}

/// Random rectangles through one driver, compared pixel by pixel.
class Bench {
 public:
  Bench(Input& in, BusPanel& driver, hal::Panel& panel, StrictController& model, Rotation rotation)
      : in_(&in), driver_(&driver), panel_(&panel), model_(&model), rotation_(rotation) {
    model.on_breach([](std::string_view what) { report(what); });
    colours_.resize(768);
  }

  /// `shown` is what a viewer sees for a colour at a place.
  template <class Shown>
  void run(const Shown& shown) {
    const hal::Capabilities& c = panel_->capabilities();
    if (in_->choice(4) == 0) model_->fail_after(in_->choice(200), in_->choice(4));
    if (!mended([&] { return driver_->start(); })) return;
    Pattern expected = Pattern::blank(c.width, c.height);
    compare(expected);
    for (int rounds = 0; !in_->empty() && rounds < 24; ++rounds) {
      if (in_->choice(4) == 0 && c.palette_entries > 0) load_palette();
      if (in_->choice(8) == 0) model_->fail_after(in_->choice(64), in_->choice(8));
      const hal::Rect area = any_area();
      const int stride = in_->choice(8) == 0 ? in_->any() : row_bytes(area.width) + in_->choice(3);
      pixels_.resize(static_cast<std::size_t>(in_->choice(8) == 0 ? in_->byte() : bytes_of(area, stride)));
      for (std::size_t i = 0; i < pixels_.size(); ++i)
        pixels_[i] = static_cast<std::uint8_t>(static_cast<unsigned>(in_->choice(2) * 85) + i * 37U);
      const bool good = well_formed(area, stride);
      const int before = model_->transfers();
      const hal::Status first = panel_->write(area, pixels_, stride);
      if (!good) {
        require(!first.ok() && model_->transfers() == before, "a bad rectangle was sent");
        continue;
      }
      if (!first.ok()) {
        require(first.error() == hal::Error::bus, "a good rectangle was refused");
        model_->fail_after(1 << 30);
        require(panel_->write(area, pixels_, stride).ok(), "a mended bus doesn't carry");
      }
      for (int y = 0; y < area.height; ++y)
        for (int x = 0; x < area.width; ++x)
          expected.at(area.x + x, area.y + y) = shown(index(x, y, stride), area.x + x, area.y + y);
      compare(expected);
    }
    if (in_->choice(2) == 0) model_->fail_after(in_->choice(8), in_->choice(4));
    if (!mended([&] { return driver_->stop(); })) return;
    compare(Pattern::blank(c.width, c.height));
  }

  [[nodiscard]] std::span<const std::uint8_t> colour(int index) const {
    return std::span(colours_).subspan(static_cast<std::size_t>(index) * 3, 3);
  }

 private:
  template <class Call>
  bool mended(const Call& call) {
    const hal::Status first = call();
    if (first.ok()) return true;
    if (first.error() != hal::Error::bus) return false;
    model_->fail_after(1 << 30);
    require(call().ok(), "a mended bus doesn't carry");
    return true;
  }
  void load_palette() {
    const auto entries = static_cast<std::size_t>(panel_->capabilities().palette_entries);
    const std::size_t count = std::min(1 + static_cast<std::size_t>(in_->byte()), entries);
    for (std::size_t i = 0; i < 3 * count; ++i)
      colours_[i] = static_cast<std::uint8_t>(static_cast<unsigned>(in_->choice(4) * 85) + i * 29U);
    require(panel_->load_palette(std::span(colours_).first(3 * count)).ok(), "a palette was refused");
  }
  /// Mostly on the panel and as it is aligned.
  hal::Rect any_area() {
    const hal::Capabilities& c = panel_->capabilities();
    hal::Rect area;
    any_side(c.width, c.x_alignment, area.x, area.width);
    any_side(c.height, c.y_alignment, area.y, area.height);
    return area;
  }
  void any_side(int length, int alignment, int& begin, int& extent) {
    if (in_->choice(16) == 0) {
      begin = in_->coordinate(0, length);
      extent = in_->length();
      return;
    }
    const int blocks = (length + alignment - 1) / alignment;
    const int first = in_->byte() * blocks / 256;
    begin = first * alignment;
    extent = std::min((1 + in_->byte() * (blocks - first) / 256) * alignment, length - begin);
  }
  [[nodiscard]] int row_bytes(int width) const {
    const std::int64_t bits = std::int64_t{width} * panel_->capabilities().bits_per_pixel;
    return static_cast<int>(std::clamp<std::int64_t>((bits + 7) / 8, 0, 4096));
  }
  [[nodiscard]] int bytes_of(const hal::Rect& area, int stride) const {
    return static_cast<int>(std::clamp<std::int64_t>(std::int64_t{area.height} * stride, 0, 100'000));
  }
  [[nodiscard]] bool well_formed(const hal::Rect& a, int stride) const {
    const hal::Capabilities& c = panel_->capabilities();
    const auto side = [](int begin, int extent, int length, int alignment) {
      if (begin < 0 || extent < 1 || begin > length || extent > length - begin) return false;
      const int end = begin + extent;
      return begin % alignment == 0 && (end % alignment == 0 || end == length);
    };
    if (!side(a.x, a.width, c.width, c.x_alignment) || !side(a.y, a.height, c.height, c.y_alignment))
      return false;
    const std::int64_t row = (std::int64_t{a.width} * c.bits_per_pixel + 7) / 8;
    return stride >= row &&
           static_cast<std::int64_t>(pixels_.size()) >= std::int64_t{a.height - 1} * stride + row;
  }
  [[nodiscard]] int index(int x, int y, int stride) const {
    const hal::Capabilities& c = panel_->capabilities();
    const int bit = x * c.bits_per_pixel;
    const int byte = pixels_[static_cast<std::size_t>(std::int64_t{y} * stride + bit / 8)];
    const bool low_first = c.bit_order == hal::BitOrder::lsb_first;
    return byte >> (low_first ? bit % 8 : 8 - c.bits_per_pixel - bit % 8) & ((1 << c.bits_per_pixel) - 1);
  }
  void compare(const Pattern& expected) const {
    require(glass::picture(model_->displayed(), rotation_) == expected, "another picture than was sent");
    model_->expect_idle();
  }

  Input* in_;
  BusPanel* driver_;
  hal::Panel* panel_;
  StrictController* model_;
  Rotation rotation_;
  std::vector<std::uint8_t> colours_;
  std::vector<std::uint8_t> pixels_;
};

Rotation any_rotation(Input& in) { return static_cast<Rotation>(in.choice(4)); }

template <class Driver, class Model>
void tft(Input& in) {
  constexpr std::array<int, 5> widths{1, 2, 4, 8, 3};
  DcsOptions options{.width = 1 + in.choice(40),
                     .height = 1 + in.choice(40),
                     .column_offset = in.choice(240),
                     .row_offset = in.byte() + in.choice(80),
                     .rotation = any_rotation(in),
                     .mirrored = in.choice(2) == 1,
                     .bgr = in.choice(2) == 1,
                     .invert = in.choice(2) == 1,
                     .scan_up = in.choice(2) == 1,
                     .te = static_cast<hal::panels::TearingEffect>(in.choice(3)),
                     .te_line = in.byte() + in.choice(80),
                     .bits_per_pixel = widths[static_cast<std::size_t>(in.choice(5))],
                     .bit_order = in.choice(2) == 1 ? hal::BitOrder::lsb_first : hal::BitOrder::msb_first};
  std::vector<std::uint8_t> workspace(static_cast<std::size_t>(in.choice(3) * 257));
  options.workspace = workspace;
  hal::sim::VirtualClock clock;
  const bool good = options.column_offset + options.width <= 240 &&
                    options.row_offset + options.height <= 320 && options.te_line < 320 &&
                    options.bits_per_pixel != 3 &&
                    (options.te_line == 0 || options.te != hal::panels::TearingEffect::vblank_and_hblank);
  hal::mock::DcsGlass mounted{options.width,    options.height, options.column_offset, options.row_offset,
                              options.mirrored, options.bgr,    options.invert};
  if (!good) mounted = {};
  Model model(clock, mounted);
  hal::panels::SpiPort port(model.spi(), model.data_command());
  Driver panel(port, clock, nullptr, options);
  if (!good) {
    require(panel.start() == hal::Status(hal::Error::invalid, hal::Part::panel), "bad options were taken");
    require(model.transfers() == 0, "bad options were sent");
    return;
  }
  Bench bench(in, panel, panel, model, options.rotation);
  bench.run([&](int index, int, int) {
    const auto c = bench.colour(index);
    const auto level = [](int channel, int most) { return (2 * channel * most + 255) / 510; };
    return level(c[0], 31) * 2048 + level(c[1], 63) * 32 + level(c[2], 31);
  });
  require(glass::beam_runs_as_told(panel.capabilities(), model, options.rotation), "the beam runs otherwise");
}

int same(int index, int, int) { return index; }

/// Behind a palette, if the bytes say so: then what is dithered is compared with how it was dithered in
/// front.
void oled(Input& in, BusPanel& driver, StrictController& model, Rotation rotation) {
  Bench plain(in, driver, driver, model, rotation);
  if (in.choice(2) == 0) return plain.run(same);
  std::vector<std::uint8_t> workspace(static_cast<std::size_t>(16 + in.byte() * 4));
  hal::panels::ExpandedPanel expanded(driver, workspace);
  Bench bench(in, driver, expanded, model, rotation);
  const int most = (1 << driver.capabilities().bits_per_pixel) - 1;
  bench.run([&](int index, int x, int y) {
    const auto c = bench.colour(index);
    const unsigned grey = hal::panels::grey_of(c[0], c[1], c[2]);
    if (most == 1) return hal::panels::dithered(grey, x, y) ? 1 : 0;
    return static_cast<int>((2U * grey * static_cast<unsigned>(most) + 255U) / 510U);
  });
}

}  // namespace

void run(Input in) {
  switch (in.choice(7)) {
    case 0:
      tft<hal::panels::St7789, hal::mock::StrictSt7789>(in);
      break;
    case 1:
      tft<hal::panels::Ili9341, hal::mock::StrictIli9341>(in);
      break;
    case 2: {
      const Rotation rotation = any_rotation(in);
      hal::mock::StrictSsd1322 model;
      hal::panels::SpiPort port(model.spi(), model.data_command());
      hal::panels::Ssd1322 panel(port, nullptr, nullptr, {.rotation = rotation});
      oled(in, panel, model, rotation);
      break;
    }
    case 3: {
      const Rotation rotation = any_rotation(in);
      hal::mock::StrictSsd0323 model;
      hal::panels::SpiPort port(model.spi(), model.data_command());
      hal::panels::Ssd0323 panel(port, nullptr, {.rotation = rotation});
      oled(in, panel, model, rotation);
      break;
    }
    case 4: {
      const Rotation rotation = any_rotation(in);
      hal::mock::StrictSsd1306 model(96, 16, 36, 0x3C, 132);
      hal::panels::I2cPort port(
          model.i2c(), 0x3C,
          in.choice(2) == 0 ? hal::panels::I2cFraming::single : hal::panels::I2cFraming::stream);
      hal::panels::Ssd1306 panel(port, hal::panels::ssd0303_96x16, nullptr, {.rotation = rotation});
      oled(in, panel, model, rotation);
      break;
    }
    default:
      any_bytes(in);
      break;
  }
}

}  // namespace fuzz
