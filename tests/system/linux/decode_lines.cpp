// SPDX-License-Identifier: MIT
//
// Reads what line_recorder wrote down as the display controller at the other end of the wires would, and says
// what was to be seen.
//
//   decode_lines RECORD RESULT ssd1306|ssd0323|st7789:WxH+X+Y DC RESET [SCK MOSI CS]
//
// Without SCK, MOSI and CS the bytes are those of the SPI bus; with them they are taken from the lines: a bit
// at each rising edge of SCK while CS is low, in SPI mode 0. RESULT gets a line `frame N crc32 X` for each
// picture that stood in the display memory at an edge event or at the end, if anything was written since the
// last, as intaglio-sim --digest prints them, and at the end `display on` or `display off`, and `held N` with
// the number of lines not let go.
#include <hal/mock/strict_dcs.hpp>
#include <hal/mock/strict_ssd0323.hpp>
#include <hal/mock/strict_ssd1306.hpp>
#include <intaglio/image/digest.hpp>

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

std::vector<std::string> arguments;

using hal::mock::Pattern;

/// The time of the record.
class RecordClock final : public hal::Clock {
 public:
  void set(hal::Nanoseconds time) { now_ = time; }

 private:
  hal::Nanoseconds do_now() noexcept override { return now_; }
  void do_wait_until(hal::Nanoseconds) noexcept override {}
  hal::Nanoseconds now_ = 0;
};

/// A controller and what its picture means.
struct Controller {
  RecordClock clock;
  std::unique_ptr<hal::mock::StrictSsd1306> ssd1306;
  std::unique_ptr<hal::mock::StrictSsd0323> ssd0323;
  std::unique_ptr<hal::mock::StrictSt7789> st7789;

  explicit Controller(const std::string& name) {
    if (name == "ssd1306") ssd1306 = std::make_unique<hal::mock::StrictSsd1306>(128, 64);
    if (name == "ssd0323") ssd0323 = std::make_unique<hal::mock::StrictSsd0323>();
    hal::mock::DcsGlass glass{.inverted = true};
    if (std::sscanf(name.c_str(), "st7789:%dx%d+%d+%d", &glass.width, &glass.height, &glass.column_offset,
                    &glass.row_offset) == 4)
      st7789 = std::make_unique<hal::mock::StrictSt7789>(clock, glass);
  }
  [[nodiscard]] bool known() const { return ssd1306 || ssd0323 || st7789; }
  [[nodiscard]] hal::mock::StrictController& get() const {
    if (ssd1306) return *ssd1306;
    if (ssd0323) return *ssd0323;
    return *st7789;
  }
  [[nodiscard]] bool on() const {
    if (ssd1306) return ssd1306->on();
    if (ssd0323) return ssd0323->on();
    return st7789->on();
  }
  [[nodiscard]] std::uint32_t digest(const Pattern& picture) const;
};

std::uint32_t Controller::digest(const Pattern& picture) const {
  intaglio::image::Crc32 crc;
  if (st7789) {
    for (const int colour : picture.pixels) {
      crc.add(static_cast<std::uint8_t>(colour >> 8));
      crc.add(static_cast<std::uint8_t>(colour));
    }
    return crc.value();
  }
  for (const int side : {picture.width, picture.height})
    for (unsigned shift = 0; shift < 32; shift += 8) crc.add(static_cast<std::uint8_t>(side >> shift));
  const int shades = ssd1306 ? 2 : 16;
  for (int i = 0; i < shades; ++i)
    for (int channel = 0; channel < 3; ++channel) crc.add(static_cast<std::uint8_t>(i * 255 / (shades - 1)));
  for (const int index : picture.pixels) crc.add(static_cast<std::uint8_t>(index));
  return crc.value();
}

/// Bytes out of three lines.
class ShiftRegister {
 public:
  void set_select(bool high) {
    selected_ = !high;
    bits_ = 0;
    count_ = 0;
  }
  void set_data(bool high) { data_ = high; }
  /// A byte, when its last bit has come in.
  std::optional<std::uint8_t> set_clock(bool high) {
    const bool rises = high && !clock_;
    clock_ = high;
    if (!rises || !selected_) return std::nullopt;
    bits_ = bits_ << 1U | (data_ ? 1U : 0U);
    if (++count_ % 8 != 0) return std::nullopt;
    return static_cast<std::uint8_t>(bits_);
  }
  [[nodiscard]] bool idle() const { return count_ % 8 == 0; }

 private:
  bool selected_ = false, data_ = false, clock_ = false;
  unsigned bits_ = 0;
  int count_ = 0;
};

TEST(Lines, FollowTheProtocolOfTheController) {
  std::ifstream record(arguments[0], std::ios::binary);
  ASSERT_TRUE(record) << arguments[0];
  std::ofstream result(arguments[1]);
  Controller controller(arguments[2]);
  ASSERT_TRUE(controller.known()) << arguments[2];
  const auto line_of = [](std::size_t i) { return i < arguments.size() ? std::stoi(arguments[i]) : -1; };
  const int data_command = line_of(3), reset = line_of(4), clock = line_of(5), data = line_of(6),
            select = line_of(7);

  ShiftRegister shift;
  std::set<int> held;
  std::uint64_t told = 0;
  int frames = 0;
  const auto look = [&](const Pattern& picture) {
    if (controller.get().data_bytes() == told) return;
    told = controller.get().data_bytes();
    char text[64];
    std::snprintf(text, sizeof text, "frame %d crc32 %08x\n", frames++, controller.digest(picture));
    result << text;
  };
  // What is seen until a panel goes dark is a picture as well.
  const auto send = [&](std::span<const std::uint8_t> bytes) {
    const Pattern before = controller.on() ? controller.get().displayed() : Pattern();
    controller.get().spi().write(bytes).ignore();
    if (!before.pixels.empty() && !controller.on()) look(before);
  };

  std::string word;
  while (record >> word) {
    if (word == "at") {
      hal::Nanoseconds time = 0;
      record >> time;
      controller.clock.set(time);
    } else if (word == "line") {
      int offset = 0, value = 0;
      record >> offset >> value;
      held.insert(offset);
      if (offset == data_command) controller.get().data_command().set(value != 0).ignore();
      if (offset == data) shift.set_data(value != 0);
      if (offset == select) shift.set_select(value != 0);
      if (offset == clock) {
        if (const auto byte = shift.set_clock(value != 0)) send({&*byte, 1});
      }
      if (offset == reset) {
        EXPECT_TRUE(shift.idle()) << "reset in mid-byte";
        if (value == 0 && controller.st7789) controller.st7789->hardware_reset();
      }
    } else if (word == "spi") {
      std::size_t count = 0;
      record >> count;
      record.get();
      std::vector<std::uint8_t> bytes(count);
      record.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(count));
      send(bytes);
    } else if (word == "event") {
      int offset = 0;
      record >> offset;
      if (controller.on()) look(controller.get().displayed());
    } else if (word == "release") {
      int offset = 0;
      record >> offset;
      held.erase(offset);
    } else {
      FAIL() << "no record begins with '" << word << "'";
    }
  }
  controller.get().expect_idle();
  if (controller.on()) look(controller.get().displayed());
  result << (controller.on() ? "display on\n" : "display off\n") << "held " << held.size() << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  arguments.assign(argv + 1, argv + argc);
  if (arguments.size() != 5 && arguments.size() != 8) {
    std::fputs("usage: decode_lines RECORD RESULT ssd1306|ssd0323|st7789:WxH+X+Y DC RESET [SCK MOSI CS]\n",
               stderr);
    return 2;
  }
  return RUN_ALL_TESTS();
}
