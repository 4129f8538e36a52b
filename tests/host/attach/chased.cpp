// SPDX-License-Identifier: MIT
//
// Frames on their way to a TFT over lines of GPIO, while its beam reads its memory: all of it in virtual
// time.
#include <hal/mock/strict_dcs.hpp>
#include <host/attach/attach.hpp>
#include <host/sim/options.hpp>
#include <host/sim/simulation.hpp>
#include <intaglio/present/beam_chaser.hpp>
#include <tests/hal/linux/fake_gpio.hpp>
#include <tests/hal/linux/spi_decoder.hpp>
#include <tests/host/run_tool.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace {

using fake_gpio::kernel;
using hal::Nanoseconds;
using hal::mock::Pattern;
using host::AttachOptions;
using testing::AllOf;
using testing::HasSubstr;

constexpr int width = 8;
constexpr int height = 96;
constexpr int row_offset = 10;
// Not quite the 60 Hz that the controller is said to have.
constexpr Nanoseconds scan_line = 49'000;
constexpr int blank_lines = 24;
constexpr Nanoseconds refresh = scan_line * (blank_lines + 320);
constexpr Nanoseconds first_vblank = 3'000'000;

AttachOptions options_of(int rotate) {
  AttachOptions options;
  options.panel = "st7789";
  options.bitbang = "SCK,MOSI,CS";
  options.data_command = "DC";
  options.te = "TE";
  options.size = std::to_string(width) + 'x' + std::to_string(height);
  options.offset = "3," + std::to_string(row_offset);
  options.rotate = rotate;
  return options;
}

/// What a beam saw of a controller's memory.
class Beam final : private hal::sim::VirtualClock::Listener {
 public:
  explicit Beam(const hal::mock::StrictSt7789& model) : model_(&model), seen_(Pattern::blank(width, height)) {
    kernel().clock.attach(*this);
  }
  ~Beam() override { kernel().clock.detach(*this); }
  Beam(const Beam&) = delete;
  Beam& operator=(const Beam&) = delete;

  /// What is in memory now is a whole frame.
  void mark_frame() { frames_.push_back(model_->memory().pixels); }
  /// Refreshes that don't look like any frame. Those before the first frame don't count.
  [[nodiscard]] int torn() const {
    return static_cast<int>(std::ranges::count_if(refreshes_, [this](const std::vector<int>& picture) {
      return std::ranges::find(frames_, picture) == frames_.end();
    }));
  }
  [[nodiscard]] std::size_t refreshes() const { return refreshes_.size(); }
  /// Frames that some refresh showed, but for the first, which is what was there before.
  [[nodiscard]] std::size_t seen() const {
    const auto shown = [this](const std::vector<int>& frame) {
      return std::ranges::find(refreshes_, frame) != refreshes_.end();
    };
    return static_cast<std::size_t>(std::count_if(frames_.begin() + 1, frames_.end(), shown));
  }

 private:
  void before_time_moves(Nanoseconds time) override {
    // The left half of a row at the beginning of its time, the right half at the end.
    for (;;) {
      const Nanoseconds begin =
          vblank_ + (blank_lines + row_offset + static_cast<Nanoseconds>(row_)) * scan_line;
      if ((half_ == 0 ? begin : begin + scan_line - 1U) > time) return;
      const Pattern now = model_->memory();
      for (int x = half_ * width / 2; x < (half_ + 1) * width / 2; ++x) seen_.at(x, row_) = now.at(x, row_);
      half_ = 1 - half_;
      if (half_ == 1 || ++row_ < height) continue;
      row_ = 0;
      vblank_ += refresh;
      if (!frames_.empty()) refreshes_.push_back(seen_.pixels);
    }
  }

  const hal::mock::StrictSt7789* model_;
  Pattern seen_;
  Nanoseconds vblank_ = first_vblank;
  int row_ = 0;
  int half_ = 0;
  std::vector<std::vector<int>> frames_;
  std::vector<std::vector<int>> refreshes_;
};

class Chased : public testing::Test {
 protected:
  Chased() {
    fake_gpio::reset();
    fake_gpio::Chip chip{"display", std::vector<fake_gpio::Line>(8)};
    const char* const names[] = {"TE", "DC", "RST", "SCK", "MOSI", "CS"};
    for (std::size_t i = 0; i < std::size(names); ++i) chip.lines[i].name = names[i];
    kernel().chips["/dev/gpiochip0"] = chip;
    std::mt19937 random(60'703);
    // The kernel is told a little late, by and by.
    for (unsigned n = 0; n < 1'000; ++n)
      kernel().edges.push_back(first_vblank + n * refresh + random() % 60'000U);
    model_.emplace(kernel().clock, hal::mock::DcsGlass{.width = width,
                                                       .height = height,
                                                       .column_offset = 3,
                                                       .row_offset = row_offset,
                                                       .inverted = true});
    beam_.emplace(*model_);
  }
  ~Chased() override {
    beam_.reset();
    kernel().on_set = [](const fake_gpio::Chip&) {};
    kernel().on_edges_read = [] {};
    EXPECT_EQ(kernel().held, 0) << "lines are still held";
  }

  /// A row of the glass takes so many times as long on the bus as the beam takes for it.
  void set_bus(int percent) {
    constexpr unsigned sets = width * 16 * 2;
    const Nanoseconds step = scan_line * static_cast<unsigned>(percent) / 100U / sets;
    const fake_gpio::SpiLines lines{.clock = 3, .data = 4, .select = 5, .data_command = 1};
    kernel().on_set = [step, decoder = fake_gpio::SpiDecoder(lines, model_->spi(), model_->data_command())](
                          const fake_gpio::Chip& chip) mutable {
      kernel().clock.advance(step);
      decoder(chip);
    };
  }

  struct Outcome {
    bool chased = false;
    int torn = 0;
    std::uint32_t counted = 0;  ///< By the chaser.
    std::size_t seen = 0;
    intaglio::present::FrameCounts counts{};
    std::string notices;
  };
  Outcome run(const AttachOptions& options, bool chase, std::uint32_t frames) {
    const auto attached = host::attach(options);
    std::optional<intaglio::present::BeamChaser> chaser;
    if (chase)
      if (const auto beam = attached->beam()) chaser.emplace(*beam->clock, *beam->vblanks, beam->timing);
    Outcome outcome;
    std::mt19937 random(60'704);
    beam_->mark_frame();
    const host::RunOptions run{.frames = frames,
                               .on_frame =
                                   [&](std::uint32_t, std::uint32_t) {
                                     beam_->mark_frame();
                                     return true;
                                   },
                               .on_draw =
                                   [&](std::uint32_t, bool begins) {
                                     if (begins) kernel().clock.advance(random() % 9'000'000U);
                                   },
                               .chaser = chaser ? &*chaser : nullptr};
    EXPECT_TRUE(host::find_program("testcard")->run(attached->panel(), run, outcome.counts).ok());
    // The last frame is to be seen, too.
    kernel().clock.advance(2U * refresh);
    outcome.chased = chaser.has_value();
    outcome.torn = beam_->torn();
    outcome.counted = chaser ? chaser->torn() : 0U;
    outcome.seen = beam_->seen();
    outcome.notices = attached->notices();
    return outcome;
  }

  std::optional<hal::mock::StrictSt7789> model_;
  std::optional<Beam> beam_;
};

TEST_F(Chased, ABusSlowerThanTheBeamTearsNoPicture) {
  set_bus(150);
  const Outcome outcome = run(options_of(0), true, 12);
  EXPECT_TRUE(outcome.chased);
  EXPECT_EQ(outcome.torn, 0);
  EXPECT_EQ(outcome.counted, 0U);
  EXPECT_EQ(outcome.seen, 12U);
  EXPECT_EQ(outcome.counts, (intaglio::present::FrameCounts{12, 0, 0, 0}));
  EXPECT_EQ(outcome.notices, "");
}

TEST_F(Chased, ElseTheSameBusTearsThem) {
  set_bus(150);
  const Outcome outcome = run(options_of(0), false, 12);
  EXPECT_GT(outcome.torn, 5);
}

TEST_F(Chased, TurnedPicturesAreNotTornEither) {
  for (const int rotate : {90, 180, 270}) {
    SCOPED_TRACE(rotate);
    beam_.reset();
    model_.emplace(kernel().clock, hal::mock::DcsGlass{.width = width,
                                                       .height = height,
                                                       .column_offset = 3,
                                                       .row_offset = row_offset,
                                                       .inverted = true});
    set_bus(60);
    beam_.emplace(*model_);
    const Outcome outcome = run(options_of(rotate), true, 5);
    EXPECT_EQ(outcome.torn, 0);
    EXPECT_EQ(outcome.counted, 0U);
    EXPECT_EQ(outcome.seen, 5U);
    EXPECT_EQ(outcome.notices, "");
  }
}

TEST_F(Chased, ABusThatIsTooSlowIsSaidAndCounted) {
  set_bus(800);
  const Outcome outcome = run(options_of(0), true, 5);
  EXPECT_GT(outcome.torn, 0);
  EXPECT_EQ(outcome.counted, 5U);
  EXPECT_THAT(outcome.notices, AllOf(HasSubstr("st7789: the bus takes"), HasSubstr("would do")));
}

TEST_F(Chased, ALineThatTellsNothingIsNoBeam) {
  kernel().edges.clear();
  set_bus(50);
  const Outcome outcome = run(options_of(0), true, 3);
  EXPECT_FALSE(outcome.chased);
  EXPECT_THAT(outcome.notices, HasSubstr("is silent"));
}

/// What `--report` says of a run of the program.
std::string reported(host::Options options) {
  const test_host::Folder folder;
  const std::string file = folder / "report";
  options.program = "testcard";
  options.report = file;
  options.digest = true;
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  host::run_on_real_panel(options);
  static_cast<void>(testing::internal::GetCapturedStdout());
  static_cast<void>(testing::internal::GetCapturedStderr());
  return test_host::read(file);
}

TEST_F(Chased, AProgramKeepsTimeWithTheTeLine) {
  set_bus(150);
  host::Options options;
  options.attach = options_of(0);
  options.frames = 60;
  EXPECT_THAT(reported(options),
              AllOf(HasSubstr("frames 60\nvblanks 59\nlate_frames 0\nskipped_vblanks 0\nearly_frames 0\n"
                              "dropped_frames 0\ntorn_frames 0\nte_silences 0\n"),
                    HasSubstr("refresh_ns 168"), HasSubstr("bus_line_ns 7")));
}

std::uint32_t value(const std::string& report, const std::string& key) {
  std::istringstream lines(report);
  std::string word;
  std::uint32_t number = 0;
  while (lines >> word >> number)
    if (word == key) return number;
  ADD_FAILURE() << "no " << key << " in " << report;
  return 0;
}

TEST_F(Chased, EveryFrameIsInMemoryAtOneReadingOfEdges) {
  set_bus(50);
  std::vector<std::vector<int>> seen;
  kernel().on_edges_read = [&] {
    if (!model_->on()) return;
    std::vector<int> picture = model_->memory().pixels;
    if (seen.empty() || seen.back() != picture) seen.push_back(std::move(picture));
  };
  host::Options options;
  options.attach = options_of(0);
  options.frames = 20;
  static_cast<void>(reported(options));
  seen.push_back(model_->memory().pixels);
  EXPECT_EQ(seen.size(), 21U) << "the dark before, and each frame once";
}

TEST_F(Chased, LateFramesAreShownOrDroppedAsTheUserAsks) {
  set_bus(400);  // A picture takes more than a refresh.
  host::Options options;
  options.attach = options_of(0);
  options.frames = 9;
  for (const bool chase : {true, false}) {
    SCOPED_TRACE(chase);
    options.chase = chase;
    options.late = intaglio::present::Late::show;
    const std::string shown = reported(options);
    EXPECT_EQ(value(shown, "frames"), 9U);
    EXPECT_GT(value(shown, "late_frames"), 0U);
    EXPECT_EQ(value(shown, "vblanks"), 8U + value(shown, "skipped_vblanks"));
    EXPECT_EQ(value(shown, "dropped_frames"), 0U);
    EXPECT_EQ(value(shown, "early_frames"), 0U);
    options.late = intaglio::present::Late::drop;
    const std::string dropped = reported(options);
    EXPECT_GT(value(dropped, "dropped_frames"), 0U);
    EXPECT_EQ(value(dropped, "frames") + value(dropped, "dropped_frames"), 9U);
    EXPECT_EQ(value(dropped, "late_frames"), 0U);
    EXPECT_EQ(value(dropped, "vblanks"), value(dropped, "frames") - 1U + value(dropped, "skipped_vblanks"));
    EXPECT_EQ(value(dropped, "early_frames"), 0U);
  }
}

}  // namespace
