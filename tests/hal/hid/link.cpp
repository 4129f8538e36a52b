// SPDX-License-Identifier: MIT
//
// Host and device joined by a wire on which things go wrong: whatever is lost, doubled, late or garbled, the
// device never displays anything but frames that the program has shown, whole and with their colours, and in
// the end it displays the last one.
#include <tests/hal/hid/wire.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace {

using hal::Error;
using hal::Key;
using hal::Nanoseconds;
using hal::hid::Device;
using hal::hid::HidInput;
using hal::hid::HidPanel;
using hal::hid::HidPanelOptions;
using hal::hid::Link;
using hal::sim::PanelSpec;
using hal::sim::VirtualClock;
using tests::hid::Bytes;
using tests::hid::Direction;
using tests::hid::Fate;
using tests::hid::Wire;

/// Frames that a program might show: mostly a little changes, at times everything, and colours come and go.
class Film {
 public:
  Film(const hal::Capabilities& panel, std::uint32_t seed)
      : random_(seed),
        row_(hal::hid::row_bytes(panel.width, panel.bits_per_pixel)),
        picture_(hal::hid::picture_bytes(panel)),
        palette_(static_cast<std::size_t>(panel.palette_entries) * 3U) {}

  void next() {
    switch (random_() % 8U) {
      case 0:
        for (auto& byte : picture_) byte = static_cast<std::uint8_t>(random_());
        break;
      case 1:
        std::fill(picture_.begin(), picture_.end(), static_cast<std::uint8_t>(random_()));
        break;
      case 2:
        break;
      default: {
        const std::size_t left = random_() % row_;
        const std::size_t width = 1 + random_() % (row_ - left);
        const std::size_t rows = picture_.size() / row_;
        const std::size_t top = random_() % rows;
        const std::size_t height = 1 + random_() % (rows - top);
        const auto byte = static_cast<std::uint8_t>(random_());
        for (std::size_t y = top; y < top + height; ++y)
          std::fill_n(picture_.begin() + static_cast<std::ptrdiff_t>(y * row_ + left), width, byte);
      }
    }
    if (!palette_.empty() && random_() % 3U == 0)
      palette_[random_() % palette_.size()] = static_cast<std::uint8_t>(random_());
  }
  [[nodiscard]] const Bytes& picture() const { return picture_; }
  [[nodiscard]] const Bytes& palette() const { return palette_; }

 private:
  std::mt19937 random_;
  std::size_t row_;
  Bytes picture_;
  Bytes palette_;
};

PanelSpec write_panel(int width, int height, int bits, int x_alignment, int y_alignment) {
  PanelSpec spec = hal::sim::paletted(width, height, bits);
  spec.capabilities.buffers = 0;
  spec.capabilities.x_alignment = x_alignment;
  spec.capabilities.y_alignment = y_alignment;
  return spec;
}

/// Buttons that a test holds down.
class Buttons final : public hal::Input {
 public:
  hal::Keys held;

 private:
  hal::Keys do_poll() noexcept override { return held; }
};

/// A device at the end of a wire and a program that shows a film on it.
class Show {
 public:
  explicit Show(const PanelSpec& spec, const HidPanelOptions& options = {},
                const hal::hid::DeviceOptions& device_options = {})
      : glass(spec, clock),
        memory(Device::memory_for(glass.capabilities())),
        device(glass, &buttons, memory, device_options),
        wire(clock, device),
        link(wire, clock),
        options_(options) {}

  void open() {
    ASSERT_TRUE(device.status().ok());
    const hal::Status s = link.open();
    ASSERT_TRUE(s.ok()) << static_cast<int>(s.error());
    panel.emplace(link, options_);
    film.emplace(panel->capabilities(), 7U);
  }

  /// Shows the next frame and waits until it is on display.
  hal::Status frame() {
    film->next();
    const int buffer = static_cast<int>(shown_ % 2U);
    std::copy(film->picture().begin(), film->picture().end(), panel->buffer(buffer).begin());
    allowed_.push_back(*film);
    if (const hal::Status s = panel->show(buffer, film->palette()); !s.ok()) return s;
    ++shown_;
    while (panel->show_pending()) {
      if (const hal::Status s = panel->wait_for_vblank(); !s.ok()) return s;
      expect_a_frame();
    }
    expect_shown();
    return {};
  }

  void run(int frames) {
    for (int i = 0; i < frames && !testing::Test::HasFailure(); ++i) {
      const hal::Status s = frame();
      ASSERT_TRUE(s.ok()) << "frame " << i << ": " << static_cast<int>(s.error());
    }
  }

  /// Shows the next frame without waiting for it.
  hal::Status rush() {
    film->next();
    const int buffer = static_cast<int>(shown_++ % 2U);
    std::copy(film->picture().begin(), film->picture().end(), panel->buffer(buffer).begin());
    allowed_.push_back(*film);
    return panel->show(buffer, film->palette());
  }

  /// What the glass shows is the last frame that the program has shown.
  void expect_shown() {
    ASSERT_EQ(displayed(), indices(film->picture()));
    ASSERT_EQ(colours(), colours_of(*film));
  }
  /// It is one of the last three, whole.
  void expect_a_frame() {
    const auto now = displayed();
    const std::size_t first = allowed_.size() >= 3 ? allowed_.size() - 3 : 0;
    bool found = allowed_.size() < 3;
    for (std::size_t i = first; i < allowed_.size(); ++i)
      found = found || (now == indices(allowed_[i].picture()) && colours() == colours_of(allowed_[i]));
    ASSERT_TRUE(found) << "a torn frame";
  }

  [[nodiscard]] Bytes displayed() const { return glass.displayed().indices; }
  [[nodiscard]] Bytes colours() const { return glass.displayed().rgb; }
  [[nodiscard]] Bytes indices(const Bytes& picture) const {
    const auto& c = glass.capabilities();
    const unsigned per_byte = 8U / static_cast<unsigned>(c.bits_per_pixel);
    const std::size_t row = hal::hid::row_bytes(c.width, c.bits_per_pixel);
    Bytes out;
    for (int y = 0; y < c.height; ++y)
      for (int x = 0; x < c.width; ++x) {
        const auto place = static_cast<unsigned>(x) % per_byte;
        const unsigned shift = (c.bit_order == hal::BitOrder::lsb_first ? place : per_byte - 1U - place) *
                               static_cast<unsigned>(c.bits_per_pixel);
        const unsigned byte =
            picture[static_cast<std::size_t>(y) * row + static_cast<std::size_t>(x) / per_byte];
        out.push_back(static_cast<std::uint8_t>(byte >> shift & ((1U << c.bits_per_pixel) - 1U)));
      }
    return out;
  }
  [[nodiscard]] Bytes colours_of(const Film& f) const {
    const auto& fixed = glass.capabilities().fixed_palette;
    Bytes out;
    for (const std::uint8_t index : indices(f.picture()))
      for (std::size_t i = 0; i < 3; ++i)
        out.push_back(f.palette().empty() ? fixed[index * 3U + i] : f.palette()[index * 3U + i]);
    return out;
  }

  VirtualClock clock;
  hal::sim::Panel glass;
  Buttons buttons;
  Bytes memory;
  Device device;
  Wire wire;
  Link link;
  std::optional<HidPanel> panel;
  std::optional<Film> film;

 private:
  HidPanelOptions options_;
  std::vector<Film> allowed_;
  std::uint64_t shown_ = 0;
};

const PanelSpec& scan_out() {
  static const PanelSpec spec = hal::sim::paletted(33, 20, 8);
  return spec;
}

TEST(HidLink, ShowsSixHundredFramesOneAVblank) {
  Show show(hal::sim::paletted(64, 48, 8));
  show.open();
  const std::uint32_t first = show.glass.vblank_count();
  show.run(600);
  EXPECT_EQ(show.panel->counters().frames, 600U);
  EXPECT_EQ(show.panel->counters().whole, 1U);
  EXPECT_EQ(show.link.counters().resent, 0U);
  // A new frame a VBLANK, none left out: the wire is fast enough for all but whole noise.
  EXPECT_LE(show.glass.vblank_count() - first, 602U);
}

/// Looks at the glass at each VBLANK.
class Watch final : public hal::sim::Observer {
 public:
  explicit Watch(Show& show) : show_(&show) { show.glass.attach(*this); }
  ~Watch() override { show_->glass.detach(*this); }
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;
  int vblanks = 0;

 private:
  void on_vblank(std::uint64_t, Nanoseconds) override {
    ++vblanks;
    show_->expect_a_frame();
  }
  Show* show_;
};

TEST(HidLink, NeverTearsAFrameForAProgramThatDoesNotWait) {
  for (const PanelSpec& spec : {scan_out(), write_panel(33, 20, 8, 1, 1)}) {
    Show show(spec);
    show.open();
    show.run(3);
    Watch watch(show);
    for (int i = 0; i < 100 && !HasFailure(); ++i) ASSERT_TRUE(show.rush().ok());
    ASSERT_TRUE(show.panel->wait_for_vblank().ok());
    show.expect_shown();
    EXPECT_GE(watch.vblanks, 99);
    EXPECT_EQ(show.link.counters().resent, 0U) << "a device that waits for its VBLANK has lost nothing";
  }
}

TEST(HidLink, FillsAGapBeforeItsPatienceEnds) {
  // A report is lost in the middle of a frame of noise; those behind it tell of the gap.
  Show show(hal::sim::paletted(64, 48, 8));
  std::uint64_t lost = ~std::uint64_t{0};
  show.wire.fate = [&lost](Direction d, std::uint64_t n) {
    return d == Direction::to_device && n == lost ? Fate::lost : Fate::arrives;
  };
  show.open();
  show.run(1);
  const auto buffer = show.panel->buffer(0);
  for (std::size_t i = 0; i < buffer.size(); ++i) buffer[i] = static_cast<std::uint8_t>(i * i / 3U);
  lost = show.wire.sent() + 25;
  const Nanoseconds begin = show.clock.now();
  ASSERT_TRUE(show.panel->show(0, {}).ok());
  EXPECT_LT(show.clock.now() - begin, Nanoseconds{20'000'000});
  EXPECT_GT(show.link.counters().resent, 0U);
  EXPECT_LE(show.link.counters().resent, 16U);
}

TEST(HidLink, SendsAllAgainToADeviceWhoseMemoryChanged) {
  Show show(scan_out());
  show.open();
  show.run(3);
  for (const int i : {0, 1}) show.glass.buffer(i)[77] ^= 0x40;
  // The same picture but for a byte elsewhere.
  const auto buffer = show.panel->buffer(0);
  std::copy(show.film->picture().begin(), show.film->picture().end(), buffer.begin());
  buffer[500] ^= 1;
  ASSERT_TRUE(show.panel->show(0, {}).ok());
  ASSERT_TRUE(show.panel->wait_for_vblank().ok());
  EXPECT_EQ(show.displayed(), Bytes(buffer.begin(), buffer.end()));
  EXPECT_EQ(show.panel->counters().rejected, 1U);
  EXPECT_EQ(show.panel->counters().whole, 2U);
}

TEST(HidLink, BelievesNoNumberThatWasNeverSent) {
  Show show(hal::sim::paletted(64, 48, 8));
  int told = 0;
  show.wire.forge = [&told](Bytes& report) {
    if (report[0] == static_cast<std::uint8_t>(hal::hid::ReportType::status) && ++told % 2 == 0)
      report[3] ^= 0x10;
  };
  show.wire.fate = [](Direction, std::uint64_t n) { return n % 30U == 29U ? Fate::lost : Fate::arrives; };
  show.open();
  show.run(60);
  EXPECT_EQ(show.panel->counters().rejected, 0U);
}

TEST(HidLink, BelievesNoVerdictOnAnotherFrame) {
  Show show(scan_out());
  show.open();
  show.run(2);
  // The device says "accepted", but of the frame before.
  show.wire.forge = [](Bytes& report) {
    if (report[0] == static_cast<std::uint8_t>(hal::hid::ReportType::status)) report[8] = 1;
  };
  EXPECT_EQ(show.frame().error(), Error::bus);
  show.wire.forge = nullptr;
  show.run(2);
}

TEST(HidLink, NeverHasMoreReportsOnTheWayThanTheDeviceAllows) {
  for (const int window : {1, 3, 16}) {
    Show show(scan_out(), {}, {.report_bytes = 64, .window = window});
    show.open();
    show.run(40);
    EXPECT_LE(show.wire.deepest(), static_cast<std::size_t>(window));
    EXPECT_EQ(show.wire.overflowed(), 0U);
    EXPECT_EQ(show.device.counters().overrun, 0U);
  }
}

TEST(HidLink, WorksWithEveryFormatAndLongReports) {
  for (const std::size_t report : {std::size_t{64}, std::size_t{100}, std::size_t{1024}})
    for (const int bits : {1, 2, 4, 8}) {
      Show show(hal::sim::paletted(37, 11, bits, 2, hal::BitOrder::lsb_first), {},
                {.report_bytes = report, .window = 8});
      show.open();
      show.run(20);
      EXPECT_EQ(show.panel->counters().rejected, 0U);
    }
}

TEST(HidLink, DrivesPanelsWithMemoryOfTheirOwn) {
  for (const int bits : {1, 4, 8}) {
    Show show(write_panel(40, 24, bits, 8, 8));
    show.open();
    show.run(60);
  }
}

TEST(HidLink, SendsAllAgainWhereColoursAreAppliedOnTheWay) {
  PanelSpec spec = write_panel(24, 16, 8, 1, 1);
  spec.capabilities.palette_on_write = true;
  Show show(spec);
  show.open();
  show.run(60);
}

TEST(HidLink, TellsFixedColours) {
  PanelSpec spec = hal::sim::paletted(16, 8, 8);
  spec.capabilities.palette_entries = 0;
  for (int i = 0; i < 768; ++i) spec.fixed_colours.push_back(static_cast<std::uint8_t>(i * 37));
  Show show(spec);
  show.open();
  const auto colours = show.panel->capabilities().fixed_palette;
  EXPECT_EQ(Bytes(colours.begin(), colours.end()), spec.fixed_colours);
  show.run(5);
}

TEST(HidLink, SurvivesTheLossOfAnySingleReport) {
  // Both directions, every report of the first frames.
  for (const Direction way : {Direction::to_device, Direction::to_host})
    for (std::uint64_t lost = 0; lost < 60 && !HasFailure(); ++lost) {
      Show show(scan_out());
      show.wire.fate = [=](Direction d, std::uint64_t n) {
        return d == way && n == lost ? Fate::lost : Fate::arrives;
      };
      show.open();
      show.run(5);
      EXPECT_EQ(show.panel->counters().rejected, 0U) << "lost " << lost;
    }
}

TEST(HidLink, SurvivesEveryFiftiethReportLost) {
  Show show(hal::sim::paletted(64, 48, 8));
  show.wire.fate = [](Direction, std::uint64_t n) { return n % 50U == 49U ? Fate::lost : Fate::arrives; };
  show.open();
  show.run(600);
  EXPECT_GT(show.link.counters().resent, 0U);
  EXPECT_EQ(show.panel->counters().rejected, 0U);
}

/// VBLANKs that 300 frames of eight reports take when one of 50 reports is lost, and what the link did.
struct Losses {
  std::uint32_t vblanks = 0;
  hal::hid::LinkCounters link;
};
Losses lose_one_of_fifty(Nanoseconds report_time, bool loses) {
  constexpr std::size_t frames = 300;
  Show show(hal::sim::paletted(32, 24, 8));
  show.wire.report_time = report_time;
  show.open();
  // The first one is sent whole.
  EXPECT_TRUE(show.panel->show(0, {}).ok());
  EXPECT_TRUE(show.panel->wait_for_vblank().ok());
  std::mt19937 random(5);
  show.wire.fate = [&](Direction, std::uint64_t) {
    return loses && random() % 50U == 0 ? Fate::lost : Fate::arrives;
  };
  const std::uint32_t before = show.glass.vblank_count();
  for (std::size_t n = 0; n < frames; ++n) {
    const auto buffer = show.panel->buffer(n % 2 == 0 ? 0 : 1);
    for (std::size_t i = 0; i < 600; i += 5) buffer[i] = static_cast<std::uint8_t>(n + i);
    EXPECT_TRUE(show.panel->show(n % 2 == 0 ? 0 : 1, {}).ok());
    while (show.panel->show_pending()) EXPECT_TRUE(show.panel->wait_for_vblank().ok());
  }
  return {show.glass.vblank_count() - before, show.link.counters()};
}

TEST(HidLink, LosesHardlyAVblankToLostReports) {
  // High speed, full speed with two reports a frame of the bus, and full speed: half of the time goes to the
  // bus.
  for (const Nanoseconds time : {Nanoseconds{100'000}, Nanoseconds{500'000}, Nanoseconds{1'000'000}}) {
    const Losses l = lose_one_of_fifty(time, true);
    EXPECT_LE(l.vblanks, 302U) << time;
    EXPECT_GT(l.link.resent, 50U);
    EXPECT_GT(l.link.prompts, 3U);
  }
}

TEST(HidLink, SendsNothingTwiceWhereNothingIsLost) {
  for (const Nanoseconds time : {Nanoseconds{20'000}, Nanoseconds{1'000'000}, Nanoseconds{8'000'000}}) {
    const Losses l = lose_one_of_fifty(time, false);
    EXPECT_EQ(l.link.resent, 0U) << time;
    EXPECT_EQ(l.link.prompts, 0U) << time;
  }
}

TEST(HidLink, AsksForAVblankThatItWasNotToldOf) {
  Show show(scan_out());
  bool lose = false;
  show.wire.fate = [&](Direction d, std::uint64_t) {
    return lose && d == Direction::to_host ? Fate::lost : Fate::arrives;
  };
  show.open();
  show.run(30);
  const std::uint32_t before = show.glass.vblank_count();
  // The next thing that the device says is that there was a VBLANK.
  lose = true;
  show.wire.answers = [&, told = 0](const Bytes&) mutable { lose = ++told == 1; };
  ASSERT_TRUE(show.panel->wait_for_vblank().ok());
  EXPECT_EQ(show.link.counters().prompts, 1U);
  EXPECT_EQ(show.glass.vblank_count() - before, 1U);
  EXPECT_EQ(show.panel->vblank_count(),
            show.device.counters().sessions == 1 ? show.glass.vblank_count() : 0U);
}

/// A clock that leaps by ten seconds at each question.
class LeapingClock final : public hal::Clock {
 public:
  explicit LeapingClock(VirtualClock& inner) : inner_(&inner) {}
  bool leaps = true;

 private:
  Nanoseconds do_now() noexcept override {
    if (leaps) ahead_ += 10'000'000'000;
    return inner_->now() + ahead_;
  }
  void do_wait_until(Nanoseconds time) noexcept override {
    if (time > ahead_) inner_->wait_until(time - ahead_);
  }
  VirtualClock* inner_;
  Nanoseconds ahead_ = 0;
};

TEST(HidLink, OpensASessionHoweverTheClockLeaps) {
  Show show(scan_out());
  show.wire.stalled_until = 60'000'000;  // the first HELLO is answered late
  LeapingClock clock(show.clock);
  Link link(show.wire, clock);
  EXPECT_TRUE(link.open().ok());
  HidPanel panel(link);
  EXPECT_TRUE(panel.show(0, {}).ok());
  EXPECT_TRUE(panel.wait_for_vblank().ok());
}

TEST(HidLink, GoesOnBeyondTheLastNumber) {
  Show show(hal::sim::paletted(8, 1, 8));
  show.open();
  // Empty reports of a frame, which lose one of 50.
  std::uint64_t lost = 0;
  show.wire.report_time = 1'000;
  show.wire.fate = [&](Direction, std::uint64_t n) {
    if (n % 997U != 996U) return Fate::arrives;
    ++lost;
    return Fate::lost;
  };
  for (int n = 0; n < 65'600; ++n) ASSERT_TRUE(show.link.transmit(hal::hid::ReportType::pixels, {}).ok());
  ASSERT_TRUE(show.link.settle().ok());
  EXPECT_EQ(show.device.counters().accepted, 65'600U);
  EXPECT_EQ(show.link.state().next, 65'600U - 65'536U);
  EXPECT_GT(lost, 60U);
  show.run(3);
}

TEST(HidLink, CountsFramesBeyondTheLastNumber) {
  PanelSpec spec = hal::sim::paletted(8, 1, 1);
  spec.capabilities.refresh_millihertz = 50'000'000;
  Show show(spec);
  show.wire.report_time = 5'000;
  show.open();
  for (int n = 0; n < 65'600; ++n) {
    show.panel->buffer(0)[0] = static_cast<std::uint8_t>(n & 0xFF);
    ASSERT_TRUE(show.panel->show(0, {}).ok()) << n;
  }
  ASSERT_TRUE(show.panel->wait_for_vblank().ok());
  EXPECT_EQ(show.device.shown(), 65'600 - 65'535) << "0 is no frame";
  EXPECT_EQ(show.panel->counters().frames, 65'600U);
  EXPECT_EQ(show.panel->counters().rejected, 0U);
}

TEST(HidLink, LetsGoOfTheKeysOfADeviceThatIsGone) {
  Show show(scan_out());
  show.open();
  HidInput input(show.link);
  show.buttons.held.press(Key::left);
  show.wire.idle(1'000'000);
  EXPECT_EQ(input.poll(), show.buttons.held);
  show.wire.pull();
  EXPECT_EQ(input.poll(), hal::Keys{});
}

TEST(HidLink, SurvivesAWireOnWhichEverythingGoesWrong) {
  for (std::uint32_t seed = 1; seed <= 12 && !HasFailure(); ++seed) {
    Show show(seed % 2 == 0 ? scan_out() : write_panel(33, 20, 8, 1, 1));
    std::mt19937 random(seed);
    show.wire.fate = [&random](Direction, std::uint64_t) {
      constexpr Fate fates[] = {Fate::lost, Fate::doubled, Fate::late};
      // Garbled ones are rare: USB has a checksum of its own.
      if (random() % 128U == 0) return Fate::garbled;
      return random() % 8U == 0 ? fates[random() % 3U] : Fate::arrives;
    };
    show.open();
    show.run(40);
    EXPECT_FALSE(HasFailure()) << "seed " << seed;
  }
}

TEST(HidLink, WaitsForADeviceThatStalls) {
  Show show(scan_out());
  show.open();
  for (int i = 0; i < 6; ++i) {
    show.wire.stalled_until = show.clock.now() + 300'000'000;
    show.run(1);
  }
  EXPECT_GT(show.link.counters().resent, 0U);
}

TEST(HidLink, GivesUpADeviceThatSaysNothing) {
  Show show(scan_out());
  show.open();
  show.run(2);
  show.wire.stalled_until = ~Nanoseconds{0};
  const Nanoseconds before = show.clock.now();
  EXPECT_EQ(show.frame().error(), Error::timeout);
  EXPECT_LT(show.clock.now() - before, 2U * show.link.patience());
  // And goes on when it talks again.
  show.wire.stalled_until = 0;
  show.run(5);
}

TEST(HidLink, FindsNothingWhereNothingAnswers) {
  Show show(scan_out());
  show.wire.stalled_until = ~Nanoseconds{0};
  EXPECT_EQ(show.link.open().error(), Error::timeout);
}

TEST(HidLink, SaysWhenTheDeviceIsGoneAndSendsAllWhenItIsBack) {
  Show show(scan_out());
  show.open();
  show.run(3);
  show.wire.unplug_after = show.wire.sent() + 4;
  hal::Status s;
  for (int i = 0; i < 10 && s.ok(); ++i) s = show.frame();
  EXPECT_EQ(s.error(), Error::disconnected);
  EXPECT_EQ(show.panel->wait_for_vblank().error(), Error::disconnected);
  EXPECT_FALSE(show.panel->show_pending());
  EXPECT_EQ(show.frame().error(), Error::disconnected);
  show.clock.advance(show.wire.unplugged_for);
  show.run(3);
  EXPECT_EQ(show.panel->counters().reconnects, 1U);
  EXPECT_EQ(show.panel->counters().whole, 2U);
}

TEST(HidLink, GoesOnByItselfWhereverTheCableIsPulled) {
  for (std::uint64_t at = 2; at < 80 && !HasFailure(); ++at) {
    Show show(scan_out(), {.replug_patience = 1'000'000'000});
    show.open();
    show.wire.unplug_after = show.wire.sent() + at;
    for (int i = 0; i < 60 && show.wire.unplugs() == 0 && !HasFailure(); ++i) show.run(1);
    show.run(2);
    EXPECT_EQ(show.wire.unplugs(), 1) << at;
  }
}

TEST(HidLink, ShowsThePictureAgainWhenTheCableIsPulledWhileNothingIsSent) {
  Show show(scan_out(), {.replug_patience = 1'000'000'000});
  show.open();
  show.run(3);
  show.wire.pull();
  ASSERT_TRUE(show.panel->wait_for_vblank().ok());
  EXPECT_EQ(show.panel->counters().whole, 2U);
  show.expect_shown();
  show.run(3);
}

TEST(HidLink, GivesUpADeviceThatKeepsGoingAway) {
  Show show(scan_out(), {.replug_patience = 1'000'000'000});
  show.open();
  show.run(3);
  // It takes the picture, and goes at the first VBLANK.
  show.wire.answers = [&](const Bytes& report) {
    const auto r = hal::hid::parse(report);
    ASSERT_TRUE(r);
    if (r->type == hal::hid::ReportType::status && hal::hid::decode_state(*r)->vblanks != 0 &&
        show.wire.unplugs() < 1000)
      show.wire.pull();
  };
  show.wire.pull();
  EXPECT_EQ(show.panel->wait_for_vblank().error(), Error::disconnected);
  EXPECT_LT(show.wire.unplugs(), 20);
  EXPECT_GE(show.panel->counters().whole, 5U);
}

TEST(HidLink, OpensAnotherSessionWithADeviceThatWasRestarted) {
  Show show(scan_out());
  show.open();
  show.run(3);
  show.device.unplugged();
  show.run(3);
  EXPECT_EQ(show.panel->counters().reconnects, 1U);
  EXPECT_EQ(show.device.counters().sessions, 2U);
}

TEST(HidLink, TakesNoSessionOfAnotherProgram) {
  Show show(scan_out());
  show.open();
  show.run(2);
  // The same nonce again, from a clock that says the same.
  VirtualClock same;
  Link second(show.wire, same);
  EXPECT_TRUE(second.open().ok());
  HidPanel other(second);
  EXPECT_TRUE(other.show(0, {}).ok());
  EXPECT_EQ(other.counters().rejected, 0U);
}

TEST(HidLink, TellsKeysAndVblanks) {
  Show show(scan_out());
  show.open();
  HidInput input(show.link);
  EXPECT_EQ(input.poll(), hal::Keys{});
  show.buttons.held.press(Key::left);
  show.buttons.held.press(Key::back);
  show.wire.idle(1'000'000);
  EXPECT_EQ(input.poll(), show.buttons.held);
  const std::uint32_t before = show.panel->vblank_count();
  for (std::uint32_t n = 1; n <= 5; ++n) {
    ASSERT_TRUE(show.panel->wait_for_vblank().ok());
    EXPECT_EQ(show.panel->vblank_count() - before, n);
  }
}

TEST(HidLink, LoadsColoursWithoutPixels) {
  Show show(scan_out());
  show.open();
  show.run(2);
  Bytes colours(768);
  for (std::size_t i = 0; i < colours.size(); ++i) colours[i] = static_cast<std::uint8_t>(i * 3U);
  const std::uint64_t before = show.wire.sent();
  ASSERT_TRUE(show.panel->load_palette(colours).ok());
  EXPECT_LE(show.wire.sent() - before, 15U);
  ASSERT_TRUE(show.panel->wait_for_vblank().ok());
  EXPECT_EQ(show.colours()[0], colours[std::size_t{show.displayed()[0]} * 3U]);
}

}  // namespace
