// SPDX-License-Identifier: MIT
#include <hal/sim/effects/scan.hpp>
#include <hal/sim/tearing.hpp>

#include <algorithm>
#include <utility>

namespace hal::sim {

namespace {

// A refresh can show at most the frame on display, one waiting, and one in work; one more for good measure.
constexpr std::size_t versions_kept = 4;
// A program that draws very slowly on the buffer on display: its torn refreshes are judged before they pile
// up.
constexpr std::size_t most_waiting = 32;

}  // namespace

std::string to_text(const Tear& tear, std::uint32_t first) {
  const auto part = [first](std::optional<std::uint32_t> frame) -> std::string {
    if (!frame) return "an unfinished picture";
    return *frame == 0 ? "what was there at the start" : "frame " + std::to_string(*frame - 1U + first);
  };
  const bool columns = by_columns(tear.scan);
  const bool backwards = tear.scan == ScanDirection::up || tear.scan == ScanDirection::left;
  std::string text = "refresh " + std::to_string(tear.refresh) + (columns ? ", column " : ", line ") +
                     std::to_string(tear.line) + ": ";
  if (!tear.above && !tear.below)
    return "refresh " + std::to_string(tear.refresh) + ": an unfinished picture";
  if (tear.kind == Tear::Kind::palette) return text + "the palette of " + part(tear.above) + " changed";
  return text + part(backwards ? tear.below : tear.above) + (columns ? " on the left, " : " above, ") +
         part(backwards ? tear.above : tear.below) + (columns ? " on the right" : " below");
}

TearingDetector::TearingDetector(Panel& panel)
    : panel_(&panel), line_bytes_(static_cast<std::size_t>(line_bytes(panel.capabilities()))) {
  panel.attach(*this);
}

TearingDetector::~TearingDetector() { panel_->detach(*this); }

const std::vector<Tear>& TearingDetector::tears() {
  judge_waiting();
  return tears_;
}

std::uint64_t TearingDetector::torn_refreshes() {
  judge_waiting();
  return torn_refreshes_;
}

void TearingDetector::on_line(const ScannedLine& line) {
  if (line.line == 0) current_.emplace(Refresh{line.refresh, {}, {}, {}});
  if (!current_) return;  // Attached in the middle of a picture.
  Refresh& refresh = *current_;
  refresh.pixels.insert(refresh.pixels.end(), line.pixels.begin(), line.pixels.end());
  if (refresh.palettes.empty() || !std::ranges::equal(refresh.palettes.back(), line.palette))
    refresh.palettes.emplace_back(line.palette.begin(), line.palette.end());
  refresh.palette_of_line.push_back(refresh.palettes.size() - 1U);
}

void TearingDetector::on_vblank(std::uint64_t, Nanoseconds) {
  if (!current_) return;
  ++refreshes_;
  if (!whole(*current_)) waiting_.push_back(std::move(*current_));
  current_.reset();
  if (waiting_.size() > most_waiting) judge_waiting();
}

void TearingDetector::on_presented(const PresentedFrame& frame) {
  Version version{frame.number, {}, {frame.palette.begin(), frame.palette.end()}};
  const Capabilities& c = panel_->capabilities();
  std::vector<std::uint8_t> column;
  for (int i = 0; i < lines_of(c); ++i) {
    const auto line = line_pixels(c, frame.pixels, frame.stride, i, column);
    version.pixels.insert(version.pixels.end(), line.begin(), line.end());
  }
  versions_.push_back(std::move(version));
  judge_waiting();
  if (versions_.size() > versions_kept) versions_.pop_front();
}

void TearingDetector::on_dropped(std::uint32_t frame, Nanoseconds /*time*/) {
  // Nobody saw it, and many such in succession mustn't push out the one on display.
  std::erase_if(versions_, [frame](const Version& version) { return version.frame == frame; });
}

bool TearingDetector::whole(const Refresh& refresh) const {
  return refresh.palettes.size() == 1 && std::ranges::any_of(versions_, [&](const Version& version) {
           return refresh.palettes[0] == version.palette && refresh.pixels == version.pixels;
         });
}

bool TearingDetector::same_pixels(const Refresh& refresh, const Version& version, int line) const {
  const auto first = static_cast<std::ptrdiff_t>(line) * static_cast<std::ptrdiff_t>(line_bytes_);
  const auto end = first + static_cast<std::ptrdiff_t>(line_bytes_);
  return std::equal(refresh.pixels.begin() + first, refresh.pixels.begin() + end,
                    version.pixels.begin() + first);
}

bool TearingDetector::same(const Refresh& refresh, const Version& version, int line) const {
  return refresh.palettes[refresh.palette_of_line[static_cast<std::size_t>(line)]] == version.palette &&
         same_pixels(refresh, version, line);
}

void TearingDetector::judge_waiting() {
  for (const Refresh& refresh : std::exchange(waiting_, {}))
    if (!whole(refresh)) report(refresh);
}

void TearingDetector::report(const Refresh& refresh) {
  ++torn_refreshes_;
  using Versions = std::vector<const Version*>;
  // The versions that all lines since the last tear belong to; empty: lines that belong to none.
  const auto matching = [&](int line, const Versions& among) {
    Versions found;
    std::ranges::copy_if(among, std::back_inserter(found),
                         [&](const Version* version) { return same(refresh, *version, line); });
    return found;
  };
  const auto frame_of = [](const Versions& versions) {
    return versions.empty() ? std::nullopt : std::optional(versions.back()->frame);
  };
  const Capabilities& c = panel_->capabilities();
  Versions all;
  for (const Version& version : versions_) all.push_back(&version);

  Versions part = matching(0, all);
  bool unfinished = part.empty();
  const std::size_t reported = tears_.size();
  for (int line = 1; line < static_cast<int>(refresh.palette_of_line.size()); ++line) {
    const Versions next = matching(line, unfinished ? all : part);
    if (unfinished ? next.empty() : !next.empty()) {
      if (!unfinished) part = next;
      continue;
    }
    const Versions here = unfinished ? next : matching(line, all);
    Tear tear{refresh.number, place_of(c, line), frame_of(part), frame_of(here), Tear::Kind::frames, c.scan};
    const bool other_colours = std::ranges::any_of(
        part, [&](const Version* version) { return same_pixels(refresh, *version, line); });
    if (other_colours) {
      tear.kind = Tear::Kind::palette;
    } else if (part.empty() || here.empty()) {
      tear.kind = Tear::Kind::drawing;
    }
    tears_.push_back(tear);
    part = here;
    unfinished = here.empty();
  }
  // From the first line to the last one unfinished picture.
  if (tears_.size() == reported)
    tears_.push_back(
        {refresh.number, place_of(c, 0), std::nullopt, std::nullopt, Tear::Kind::drawing, c.scan});
}

}  // namespace hal::sim
