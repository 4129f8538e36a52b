// SPDX-License-Identifier: MIT
//
// Sends the bands of a picture where the beam won't meet them, on a panel that has one memory and tells when
// its VBLANK begins.
//
// Rule: a picture is aimed at the first refresh, not before it is due, for which its first band still keeps
// its window (`picture_window`); every band waits until its own window opens. So refreshes before the one
// aimed at show the old picture, it and those after the new one, unless a band comes too late (drawing or bus
// took longer than was said): that is counted, for by then nothing can help. VBLANKs that the source didn't
// tell (a line that dropped out) are reckoned from those it did: refresh numbers are whole refresh times
// between signals, so they go on, too. A signal that the source says was before the last one, or is to come,
// is none.
// Bit budget: times of the clock are below 2^62 ns (146 years); a picture is aimed at most 2^31 refreshes of
// 2^30 ns ahead, so sums stay below 2^63.
#pragma once

#include <hal/vblank.hpp>
#include <intaglio/present/beam_race.hpp>
#include <intaglio/present/pacer.hpp>

namespace intaglio::present {

class BeamChaser {
 public:
  /// The source tells times of this clock.
  BeamChaser(hal::Clock& clock, hal::VblankSource& vblanks, const BeamTiming& timing) noexcept
      : clock_(&clock), vblanks_(&vblanks), timing_(timing) {}

  /// Says how pictures are sent.
  /// Errors: table (out of range: not `BeamTiming::valid`).
  [[nodiscard]] Status prepare(const BandSizes& sizes, Travel travel) noexcept;

  /// False if the bus (or the drawing) is too slow for any picture to keep its windows. It is sent anyway,
  /// right behind the beam, and counted as torn.
  [[nodiscard]] bool tear_free() const noexcept { return picture_.open(); }

  /// Chooses the refresh that shows the picture whose first band is ready now; at the earliest the one that
  /// `pacer` says is due. Answers its number, which counts the VBLANKs before it. Errors: device.
  [[nodiscard]] Result<std::uint32_t> aim(const Pacer& pacer) noexcept;
  /// Returns when the band of lines first .. end - 1 may be sent.
  void before_write(int first, int end) noexcept;
  /// Says that the band that `before_write` was called for is out.
  void after_write() noexcept;
  /// Says that the picture is complete.
  void complete() noexcept;

  /// The refresh that `aim` chose last.
  [[nodiscard]] std::uint32_t aimed_at() const noexcept { return aimed_at_; }
  /// Pictures of which some refresh showed a part, because drawing or bus took longer than was said. (A bus
  /// that is faster may overtake the beam, which isn't seen.)
  [[nodiscard]] std::uint32_t torn() const noexcept { return torn_; }

 private:
  /// Takes over the latest signal, if there is a new one.
  [[nodiscard]] Status synchronise() noexcept;
  /// A time relative to the VBLANK before refresh `aimed_at_` on the clock.
  [[nodiscard]] std::int64_t on_clock(std::int64_t time) const noexcept;
  [[nodiscard]] std::int64_t now() const noexcept { return static_cast<std::int64_t>(clock_->now()); }

  hal::Clock* clock_;
  hal::VblankSource* vblanks_;
  BeamTiming timing_;
  Travel travel_ = Travel::along;
  StartWindow picture_{};
  std::int64_t signal_ = 0;     // When the VBLANK was that the last signal told,
  std::uint32_t number_ = 0;    // and the number of the refresh after it.
  std::uint32_t aimed_at_ = 0;  // Modulo 2^32, as all numbers of refreshes.
  std::int64_t must_be_out_ = 0;
  std::uint32_t torn_ = 0;
  bool synchronised_ = false;
  bool too_late_ = false;
};

}  // namespace intaglio::present
