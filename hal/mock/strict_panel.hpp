// SPDX-License-Identifier: MIT
//
// A panel for unit tests that lets nothing pass: it reports, as failures of the running GoogleTest test,
// - a write or request that the border refuses (outside, misaligned, too short, bad palette);
// - bytes written outside a frame buffer or between its rows;
// - a pixel drawn twice in a frame, unless the test allows it;
// - a change of a frame that was already presented;
// - a frame that was replaced before it was ever displayed.
//
// Two ways to use it. Code that draws on surfaces or presents frames gets the panel itself:
//
//     hal::mock::StrictPanel panel(hal::mock::scan_out_panel(8, 3, 8));
//     intaglio::present::SwapChain<intaglio::image::Indexed8> chain(panel);
//     auto frame = chain.begin();
//     my_widget.draw(frame.value().surface());
//     ASSERT_TRUE(chain.present(std::move(frame).value()).ok());
//     panel.vblank();
//     panel.expect_picture({"..##....",
//                           ".#..#...",
//                           "..##...."});
//
// Code that draws through a span sink gets a recorder, which counts how often each pixel is drawn:
//
//     hal::mock::StrictPanel panel(hal::mock::write_panel(8, 3, 8));
//     auto pen = panel.recorder(1);
//     ASSERT_TRUE(intaglio::raster::draw_circle(pen, {3, 1}, 1).ok());
//     panel.expect_writes({"...#....", ...});  // each pixel of the circle once
#pragma once

#include <hal/mock/pattern.hpp>
#include <hal/panel.hpp>

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hal::mock {

/// A panel of any size that scans out `buffers` frame buffers and has a palette of 2^bits entries.
[[nodiscard]] Capabilities scan_out_panel(int width, int height, int bits_per_pixel, int buffers = 2);
/// A panel of any size with memory of its own and a palette of 2^bits entries.
[[nodiscard]] Capabilities write_panel(int width, int height, int bits_per_pixel, int x_alignment = 1,
                                       int y_alignment = 1);

/// What a test allows.
struct StrictRules {
  /// The same pixel may be drawn more than once in a frame.
  bool drawing_twice = false;
  /// `show` may replace a request that hasn't taken effect, so that a frame is never displayed.
  bool skipping_frames = false;
  /// Bytes between rows of a frame buffer, which no one may write.
  int row_padding = 5;
};

class StrictPanel;

/// The rectangle that a recorder takes: converts to any struct of x, y, width, height.
struct RecorderClip {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
  template <class R>
  constexpr operator R() const noexcept  // NOLINT(google-explicit-constructor)
      requires requires {
    R{0, 0, 0, 0};
  }
  { return R{x, y, width, height}; }
};

/// Draws spans on a strict panel and counts every pixel: a span sink. It offers neither cursor nor block, so
/// a primitive draws all it draws through `span`.
class Recorder {
 public:
  /// The pixels x_begin .. x_end-1 of row y. Fails outside the clip, on an empty or backward span, and on
  /// what `StrictPanel` forbids.
  void span(int y, int x_begin, int x_end);
  [[nodiscard]] RecorderClip clip() const { return clip_; }
  /// The same recorder, taking only pixels of this rectangle, cut to the panel.
  [[nodiscard]] Recorder clipped(int x, int y, int width, int height) const;

 private:
  friend class StrictPanel;
  Recorder(StrictPanel& panel, int buffer, int index, const RecorderClip& clip)
      : panel_(&panel), buffer_(buffer), index_(index), clip_(clip) {}

  StrictPanel* panel_;
  int buffer_;
  int index_;
  RecorderClip clip_;
};

class StrictPanel final : public Panel {
 public:
  explicit StrictPanel(const Capabilities& capabilities, const StrictRules& rules = {});
  /// Checks a last time.
  ~StrictPanel();

  /// Begins a VBLANK: what was asked for is displayed from now on.
  void vblank();
  /// Checks frame buffers now; done by itself at every call of the panel and at its end.
  void check();

  /// Draws with this index on a frame buffer (0 is a write panel's own memory).
  [[nodiscard]] Recorder recorder(int index, int buffer = 0);
  /// Begins a new frame for the count of writes. After `show` the next pixel drawn does it by itself.
  void forget_writes();

  /// What is on display.
  [[nodiscard]] Pattern displayed() const { return picture_of(displayed_); }
  /// What a frame buffer holds.
  [[nodiscard]] Pattern picture_of(int buffer) const;
  /// How often each pixel was written, by recorders and by `write`, since the frame began.
  [[nodiscard]] const Pattern& writes() const { return writes_; }
  /// The colours in effect: red, green, blue, three bytes an entry.
  [[nodiscard]] std::span<const std::uint8_t> palette() const { return palette_; }

  /// Fails, with the pictures side by side, if the display doesn't show this.
  void expect_picture(std::initializer_list<std::string_view> rows, const char* file = __builtin_FILE(),
                      int line = __builtin_LINE());
  /// The same for what a frame buffer holds.
  void expect_buffer(int buffer, std::initializer_list<std::string_view> rows,
                     const char* file = __builtin_FILE(), int line = __builtin_LINE());
  /// The same for how often each pixel was written.
  void expect_writes(std::initializer_list<std::string_view> rows, const char* file = __builtin_FILE(),
                     int line = __builtin_LINE());

  /// The next `show`, `write` or `load_palette` answers this and does nothing, as a faulty bus would.
  void fail_next(Status status) { fault_ = status; }

 private:
  friend class Recorder;
  /// A frame buffer between two guards, and what it looked like when it was presented.
  struct Buffer {
    std::vector<std::uint8_t> memory;
    std::optional<std::vector<std::uint8_t>> presented;
  };

  const Capabilities& do_capabilities() const noexcept override { return capabilities_; }
  std::span<std::uint8_t> do_buffer(int index) noexcept override;
  int do_buffer_stride() const noexcept override { return stride_; }
  Status do_show(int index, std::span<const std::uint8_t> palette) noexcept override;
  bool do_show_pending() noexcept override { return pending_.has_value(); }
  bool do_show_replaced() noexcept override { return replaced_; }
  int do_on_display() noexcept override { return displayed_; }
  Status do_write(const Rect& area, std::span<const std::uint8_t> pixels, int stride) noexcept override;
  Status do_load_palette(std::span<const std::uint8_t> palette) noexcept override;
  std::uint32_t do_vblank_count() noexcept override { return vblanks_; }
  Status do_wait_for_vblank() noexcept override;
  void do_refused(Status status) noexcept override;

  /// Writes pixel (x, y) and counts it; true if it was written before in this frame.
  bool draw(int buffer, int x, int y, int index);
  /// A new frame begins with the first pixel drawn after a frame was presented.
  void begin_drawing();
  [[nodiscard]] bool presented(int buffer) const {
    return buffers_[static_cast<std::size_t>(buffer)].presented.has_value();
  }
  void check_guards(int index);
  void check_presented(int index);
  [[nodiscard]] Status take_fault();
  [[nodiscard]] std::size_t pixel_bytes() const;
  [[nodiscard]] std::span<const std::uint8_t> rows_of(int buffer) const;
  [[nodiscard]] Pattern pattern_of(std::span<const std::uint8_t> rows) const;
  void compare(std::string_view what, std::initializer_list<std::string_view> rows, const Pattern& actual,
               const char* file, int line) const;

  Capabilities capabilities_;
  StrictRules rules_;
  int row_bytes_ = 0;
  int stride_ = 0;
  std::vector<Buffer> buffers_;
  std::vector<std::uint8_t> palette_;
  std::vector<std::uint8_t> pending_palette_;
  std::optional<int> pending_;
  bool replaced_ = false;  // The last request replaced one that waited.
  int displayed_ = 0;
  std::uint32_t vblanks_ = 0;
  Pattern writes_;
  bool frame_ended_ = false;
  Status fault_;
};

}  // namespace hal::mock
