// SPDX-License-Identifier: MIT
//
// Frames on a write panel: one buffer in the program's memory, of which the changed rectangles are sent.
//
// Rule: after a successful `present` the panel's own memory equals the buffer wherever the program drew and
// said so. What couldn't be sent (a bus fault) is owed and goes out with the next frame, so nothing is lost;
// the first frame is always sent whole, for what a panel holds at power-on is unknown.
// Where the panel applies colours as pixels are written, new colours mean that all is sent again; whoever
// brings colours is taken to bring new ones.
// A frame that is due is sent at once, wherever the beam is: when the program keeps its pace that is at the
// beginning of a VBLANK, otherwise (and with the first frame) in the middle of a refresh, which then shows a
// part of it. Holding it back until the next VBLANK would cost a panel without a VBLANK signal its rate, and
// tear anyway where the bus is slower than the beam.
// With a beam chaser nothing tears: a frame goes out in bands of whole lines behind the beam, those left out
// on which nothing changed. The buffer keeps its picture from frame to frame, so a program need only draw
// what changes.
#pragma once

#include <intaglio/present/band_cut.hpp>
#include <intaglio/present/beam_chaser.hpp>
#include <intaglio/present/dirty_list.hpp>
#include <intaglio/present/frame.hpp>
#include <intaglio/present/pacer.hpp>
#include <intaglio/present/panel_port.hpp>
#include <intaglio/present/screen_info.hpp>

namespace intaglio::present {

/// Lines of the bands that go behind a beam. They must be short beside the lead where it goes against the
/// writes; a write has a price, too.
inline constexpr int chased_lines = 16;

/// The part of a frame writer that doesn't depend on the pixel format.
class WriteControl {
 public:
  /// `pixels_per_byte`: rectangles also begin at whole bytes of the buffer.
  WriteControl(hal::Panel& panel, const Pace& pace, int pixels_per_byte, BeamChaser* chaser) noexcept;
  /// Errors: table (`BeamChaser::prepare`).
  [[nodiscard]] Status prepare() noexcept;

  /// Adds changed rectangles to what is owed. Errors: rectangle (out of domain); then none is added.
  [[nodiscard]] Status owe(std::span<const linear::Rect> dirty) noexcept;
  void owe_all() noexcept { owed_.add_all(); }
  /// Waits until the frame is due, loads the palette and sends what is owed from `buffer`; or drops the
  /// frame, and goes on owing. Errors: device.
  [[nodiscard]] Status send(std::span<const std::uint8_t> buffer, int stride, int bits_per_pixel,
                            std::span<const std::uint8_t> palette) noexcept;

  [[nodiscard]] hal::Panel& panel() const noexcept { return *panel_; }
  [[nodiscard]] const Pacer& pacer() const noexcept { return pacer_; }

 private:
  /// Loads colours, if there are any, and owes what they change.
  [[nodiscard]] hal::Status load(std::span<const std::uint8_t> palette) noexcept;
  /// Sends the bands on which something is owed behind the beam.
  [[nodiscard]] hal::Status chase(std::span<const std::uint8_t> buffer, int stride,
                                  int bits_per_pixel) noexcept;
  [[nodiscard]] hal::Status send_now(std::span<const std::uint8_t> buffer, int stride,
                                     int bits_per_pixel) noexcept;
  [[nodiscard]] hal::Status write(const linear::Rect& rect, std::span<const std::uint8_t> buffer, int stride,
                                  int bits_per_pixel) noexcept;

  hal::Panel* panel_;
  BeamChaser* chaser_;
  Pacer pacer_;
  BandCut cut_{};
  int pixels_per_byte_;
  DirtyList owed_;
};

/// Frames of format `F` on a write panel. Lives as long as any of its frames.
template <image::PixelFormat F>
class FrameWriter : public FrameLender {
 public:
  using Format = F;

  /// Bytes of memory that a panel of this size needs.
  [[nodiscard]] static constexpr int memory_for(linear::Size size) noexcept {
    return F::row_bytes(size.width) * size.height;
  }

  /// Draws in `memory` (whole rows, close together) frames at this pace, in VBLANKs or ticks of the panel's
  /// frame clock. Whether that can be done says `status`.
  FrameWriter(hal::Panel& panel, std::span<std::uint8_t> memory, const Pace& pace = {}) noexcept
      : FrameWriter(panel, memory, nullptr, pace) {}
  /// The same behind the beam. The chaser outlives the writer and serves it alone; its lines are rows, or
  /// columns of a panel that is scanned sideways, and its `draw_line` is 0: all is drawn before.
  FrameWriter(hal::Panel& panel, std::span<std::uint8_t> memory, BeamChaser& chaser,
              const Pace& pace = {}) noexcept
      : FrameWriter(panel, memory, &chaser, pace) {}

  /// Errors: panel (mismatched: other pixel format; unsupported: a scan-out panel), count (`Pacer::check`),
  /// buffer (too small: `needed()` bytes), table (`BeamChaser::prepare`).
  [[nodiscard]] Status status() const noexcept { return status_; }
  [[nodiscard]] ScreenInfo info() const noexcept { return screen_info(control_.panel().capabilities()); }

  /// The next frame; it holds the picture of the last. Errors: `status`; busy frame, if the last one is still
  /// held.
  [[nodiscard]] Result<Frame<F>> begin() noexcept {
    if (!status_.ok()) return status_;
    if (lent()) return Status{Error::busy, Argument::frame};
    return lend<F>(surface_);
  }

  /// Sends the whole frame when it is due, with these colours (3 bytes an entry; empty: the colours stay),
  /// and returns when it is out. A frame that comes too late may be dropped instead: then the next sends its
  /// changes, too. (One that brings colours to a panel which shows new colours at once isn't.) After an error
  /// of an argument the frame is still the caller's. Errors: frame (empty; mismatched: another screen's),
  /// palette (`check_palette`), device.
  [[nodiscard]] Status present(Frame<F>&& frame, std::span<const std::uint8_t> palette = {}) noexcept {
    if (const Status s = check(frame, palette); !s.ok()) return s;
    control_.owe_all();
    return send(std::move(frame), palette);
  }
  /// The same, but sends only these rectangles, cut to the frame and widened to the panel's alignment.
  /// Errors: also rectangle (out of domain).
  [[nodiscard]] Status present(Frame<F>&& frame, std::span<const std::uint8_t> palette,
                               std::span<const linear::Rect> dirty) noexcept {
    if (const Status s = check(frame, palette); !s.ok()) return s;
    if (const Status s = control_.owe(dirty); !s.ok()) return s;
    return send(std::move(frame), palette);
  }

  /// Does nothing: a frame is on display when `present` returns.
  [[nodiscard]] Status wait_until_shown() noexcept { return {}; }

  /// Frames that were sent later than `interval` VBLANKs after the one before.
  [[nodiscard]] std::uint32_t missed_deadlines() const noexcept { return control_.pacer().missed(); }
  /// What became of the frames so far.
  [[nodiscard]] const FrameCounts& counts() const noexcept { return control_.pacer().counts(); }

 private:
  FrameWriter(hal::Panel& panel, std::span<std::uint8_t> memory, BeamChaser* chaser,
              const Pace& pace) noexcept
      : control_(panel, pace, F::pixels_per_byte, chaser), memory_(memory) {
    const hal::Capabilities& c = panel.capabilities();
    const Result<image::Surface<F>> surface = image::Surface<F>::over(memory, {c.width, c.height});
    surface_ = surface.value();
    status_ = c.buffers != 0 ? Status{Error::unsupported, Argument::panel} : check_format<F>(c);
    if (status_.ok()) status_ = Pacer::check(pace);
    if (status_.ok()) status_ = surface.status();
    if (status_.ok()) status_ = control_.prepare();
  }

  Status check(const Frame<F>& frame, std::span<const std::uint8_t> palette) const noexcept {
    if (const Status s = check_own(frame); !s.ok()) return s;
    return check_palette(control_.panel().capabilities(), palette);
  }
  Status send(Frame<F>&& frame, std::span<const std::uint8_t> palette) noexcept {
    const Frame<F> taken(std::move(frame));
    return control_.send(memory_, surface_.stride(), F::bits, palette);
  }

  WriteControl control_;
  std::span<std::uint8_t> memory_;
  image::Surface<F> surface_{};
  Status status_;
};

}  // namespace intaglio::present
