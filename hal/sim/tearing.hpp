// SPDX-License-Identifier: MIT
//
// Sees torn pictures, as a viewer would: by what was on the glass, not by what the program was supposed to
// do.
//
// Rule: a refresh is whole if its lines and their palette are those of one presented frame (the bytes that
// its buffer and its palette held when it was presented). Any other refresh is torn, and the detector says at
// which line which two frames met. A part that belongs to no presented frame was drawn while it was being
// scanned. It catches a buffer swapped in mid-picture, drawing on the buffer on display, drawing on a frame
// already presented, and a palette loaded in mid-picture. Frames that look alike where they meet tear
// invisibly and aren't reported.
#pragma once

#include <hal/sim/observer.hpp>
#include <hal/sim/panel.hpp>

#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace hal::sim {

/// Two frames met in one refresh. `above` and `below`, as the beam goes, are their numbers (0: what was there
/// at the start); none: lines that belong to no presented frame.
struct Tear {
  enum class Kind : std::uint8_t {
    frames,   ///< Lines of different frames.
    drawing,  ///< Lines scanned while they were being drawn.
    palette,  ///< The same frame in different colours.
  };
  std::uint64_t refresh = 0;
  int line = 0;  ///< The first row of the later part; the first column where the beam goes by columns.
  std::optional<std::uint32_t> above;
  std::optional<std::uint32_t> below;
  Kind kind = Kind::frames;
  ScanDirection scan = ScanDirection::down;
  friend bool operator==(const Tear&, const Tear&) = default;
};

/// As in "refresh 12, line 97: frame 11 above, frame 12 below"; by columns "column 9: frame 11 on the left,
/// ...".
/// `first`: how the first frame is called, which the panel counts as 1.
[[nodiscard]] std::string to_text(const Tear& tear, std::uint32_t first = 1);

/// Watches a panel from its next whole refresh on. Must die before the panel.
class TearingDetector final : public Observer {
 public:
  explicit TearingDetector(Panel& panel);
  ~TearingDetector() override;
  TearingDetector(const TearingDetector&) = delete;
  TearingDetector& operator=(const TearingDetector&) = delete;

  /// Every tear so far. Refreshes that don't look like any frame presented so far are judged now; call it
  /// when the frame in work has been presented.
  [[nodiscard]] const std::vector<Tear>& tears();
  /// Refreshes that had a tear, and all that were seen whole or torn.
  [[nodiscard]] std::uint64_t torn_refreshes();
  [[nodiscard]] std::uint64_t refreshes() const { return refreshes_; }

 private:
  /// What a presented frame looks like.
  struct Version {
    std::uint32_t frame = 0;
    std::vector<std::uint8_t> pixels;  // As the beam fetches it, lines close together.
    std::vector<std::uint8_t> palette;
  };
  /// What one refresh looked like.
  struct Refresh {
    std::uint64_t number = 0;
    std::vector<std::uint8_t> pixels;
    std::vector<std::vector<std::uint8_t>> palettes;
    std::vector<std::size_t> palette_of_line;
  };

  void on_line(const ScannedLine& line) override;
  void on_vblank(std::uint64_t refresh, Nanoseconds time) override;
  void on_presented(const PresentedFrame& frame) override;
  void on_dropped(std::uint32_t frame, Nanoseconds time) override;

  [[nodiscard]] bool whole(const Refresh& refresh) const;
  [[nodiscard]] bool same_pixels(const Refresh& refresh, const Version& version, int line) const;
  [[nodiscard]] bool same(const Refresh& refresh, const Version& version, int line) const;
  void judge_waiting();
  void report(const Refresh& refresh);

  Panel* panel_;
  std::size_t line_bytes_;
  std::deque<Version> versions_;  // The latest last.
  std::optional<Refresh> current_;
  std::deque<Refresh> waiting_;  // Not whole yet: the frame they belong to may still be in work.
  std::vector<Tear> tears_;
  std::uint64_t refreshes_ = 0;
  std::uint64_t torn_refreshes_ = 0;
};

}  // namespace hal::sim
