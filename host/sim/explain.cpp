// SPDX-License-Identifier: MIT
#include <hal/sim/effects/scan.hpp>
#include <host/sim/explain.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace host {

namespace {

using hal::Nanoseconds;
using hal::sim::Tear;

/// "16.67 ms", rounded to the nearest.
std::string ms(Nanoseconds time) {
  const Nanoseconds hundredths = (time + 5'000U) / 10'000U;
  return fmt::format("{}.{:02} ms", hundredths / 100U, hundredths % 100U);
}

std::string refreshes(std::uint64_t count) {
  return count == 1 ? "1 refresh" : fmt::format("{} refreshes", count);
}

const char* line_or_column(hal::ScanDirection scan) { return hal::sim::by_columns(scan) ? "column" : "line"; }

/// "lines 3 to 15", from line `from` on and before line `before`, or, as the beam goes, the other way.
std::string between(const char* line, int from, int before) {
  const auto [first, last] = std::minmax({from, from < before ? before - 1 : before + 1});
  return first == last ? fmt::format("{} {}", line, first) : fmt::format("{}s {} to {}", line, first, last);
}

Span whole(const std::vector<Span>& spans) { return {spans.front().begin, spans.back().end}; }

/// What is said of one frame, or of several in succession alike: lines, each to follow the frame's name.
struct Paragraph {
  std::uint32_t first;
  std::uint32_t last;
  std::string said;

  [[nodiscard]] std::string text() const {
    const std::string subject = first == last ? fmt::format("Frame {} ", first)
                                              : fmt::format("Each of frames {} to {} ", first, last);
    std::string text;
    for (std::size_t begin = 0; begin < said.size();) {
      const std::size_t end = said.find('\n', begin) + 1U;
      text += subject + said.substr(begin, end - begin);
      begin = end;
    }
    return text;
  }
};

/// A run, looked at frame by frame.
class Report {
 public:
  Report(const Timeline& timeline, const std::vector<Tear>& tears)
      : timeline_(timeline), panel_(timeline.panel()) {
    for (const Tear& tear : tears) tears_of_[tear.refresh].push_back(&tear);
    for (const auto& [refresh, of_refresh] : tears_of_) torn_[frame_that_tore(of_refresh)].push_back(refresh);
  }

  [[nodiscard]] std::string text(std::size_t most) const {
    std::size_t late = 0;
    std::size_t dropped = 0;
    std::vector<Paragraph> paragraphs;
    std::size_t untold = 0;
    for (const FrameRecord& frame : timeline_.frames()) {
      if (frame.late > 0) ++late;
      if (frame.dropped) ++dropped;
      const auto torn = torn_.find(frame.number);
      if (frame.late == 0 && !frame.dropped && torn == torn_.end()) continue;
      std::string said;
      if (frame.dropped) said += drop(frame);
      if (frame.late > 0) said += lateness(frame);
      if (torn != torn_.end()) said += tear(frame, torn->second);
      const bool again = !paragraphs.empty() && untold == 0 && paragraphs.back().last + 1U == frame.number &&
                         paragraphs.back().said == said;
      if (again) {
        paragraphs.back().last = frame.number;
      } else if (paragraphs.size() < most) {
        paragraphs.push_back({frame.number, frame.number, said});
      } else {
        ++untold;
      }
    }
    std::string all = fmt::format("{} frames in {} of {}: {} torn, {} late, {} dropped.\n",
                                  timeline_.frames().size(), refreshes(timeline_.refreshes().size()),
                                  ms(panel_.frame_time()), torn_.size(), late, dropped);
    if (timeline_.counts()) all += fmt::format("Frames: {}.\n", to_text(*timeline_.counts()));
    for (const Paragraph& paragraph : paragraphs) all += paragraph.text();
    if (untold > 0) all += fmt::format("... and {} more.\n", untold);
    return all;
  }

 private:
  /// The later of the frames that met; where a part is unfinished, the one that was being made. Frames may
  /// look alike where they met, so it is none that first touched what is on display after the refresh.
  [[nodiscard]] std::uint32_t frame_that_tore(const std::vector<const Tear*>& tears) const {
    std::uint32_t latest = 0;
    bool unfinished = false;
    for (const Tear* const tear : tears) {
      latest = std::max({latest, tear->above.value_or(0), tear->below.value_or(0)});
      unfinished = unfinished || !tear->above || !tear->below;
    }
    // The panel counts from 1, so the one after `latest` has that number here.
    std::uint32_t frame = unfinished || latest == 0 ? latest : latest - 1U;
    frame = std::min(frame, static_cast<std::uint32_t>(timeline_.frames().size()) - 1U);
    const RefreshRecord* const refresh = refresh_of(tears.front()->refresh);
    while (refresh != nullptr && frame > 0 && first_touch(timeline_.frames()[frame]) >= refresh->scan.end)
      --frame;
    return frame;
  }
  /// When a frame first touched what is on display.
  [[nodiscard]] static Nanoseconds first_touch(const FrameRecord& frame) {
    if (!frame.transfers.empty()) return frame.transfers.front().begin;
    if (frame.draw) return frame.draw->begin;
    return frame.presented ? frame.presented->begin : ~Nanoseconds{0};
  }
  [[nodiscard]] const RefreshRecord* refresh_of(std::uint64_t number) const {
    const auto& all = timeline_.refreshes();
    const auto found = std::ranges::lower_bound(all, number, {}, &RefreshRecord::number);
    return found != all.end() && found->number == number ? &*found : nullptr;
  }

  [[nodiscard]] static std::string part(std::optional<std::uint32_t> frame) {
    if (!frame) return "an unfinished picture";
    return *frame == 0 ? "what was there at the start" : fmt::format("frame {}", *frame - 1U);
  }

  [[nodiscard]] std::string made_of(const FrameRecord& frame) const {
    std::string text;
    if (frame.draw && frame.draw->length() > 0) text += "drawing took " + ms(frame.draw->length());
    if (!frame.transfers.empty() && whole(frame.transfers).length() > 0)
      text += fmt::format("{}sending {} bytes took {}", text.empty() ? "" : ", ", frame.bytes,
                          ms(whole(frame.transfers).length()));
    return text.empty() ? "drawing took no time" : text;
  }

  [[nodiscard]] std::string drop(const FrameRecord& frame) const {
    if (!frame.presented)
      return fmt::format("was dropped: due {} after the frame before, it was ready after {}. {}.\n",
                         ms(frame.deadline->length()), ms(frame.time - frame.deadline->begin),
                         capital(made_of(frame)));
    return fmt::format("was dropped: it was asked for, but {} later, before its VBLANK, another frame was.\n",
                       ms(frame.presented->length()));
  }

  [[nodiscard]] std::string lateness(const FrameRecord& frame) const {
    const Nanoseconds budget = timeline_.budget();
    std::string text = fmt::format("was late by {}: due {} after the frame before, it came after {}. {}.",
                                   refreshes(frame.late), ms(budget), ms(frame.time - frame.deadline->begin),
                                   capital(made_of(frame)));
    // On a write panel the time to send the frame before is gone, too.
    const FrameRecord* const before = frame.number > 0 ? &timeline_.frames()[frame.number - 1U] : nullptr;
    const Nanoseconds drawing = frame.draw ? frame.draw->length() : 0;
    const Nanoseconds sending =
        before != nullptr && !before->transfers.empty() ? whole(before->transfers).length() : 0;
    if (drawing >= budget) {
      text += " Drawing alone takes longer than a frame may.";
    } else if (sending >= budget) {
      text +=
          fmt::format(" The frame before kept the bus for {}, longer than a frame may take.", ms(sending));
    } else if (drawing + sending >= budget) {
      text += fmt::format(
          " Sending the frame before ({}) and drawing this one ({}) together take longer than a frame may.",
          ms(sending), ms(drawing));
    } else if (frame.draw && frame.draw->begin >= frame.deadline->begin) {
      text += fmt::format(" It was begun {} after the frame before {}.",
                          ms(frame.draw->begin - frame.deadline->begin),
                          before != nullptr && before->dropped ? "was due" : "appeared");
    }
    return text + '\n';
  }

  [[nodiscard]] std::string tear(const FrameRecord& frame, const std::vector<std::uint64_t>& torn) const {
    constexpr std::size_t most = 3;
    std::string text;
    for (std::size_t i = 0; i < std::min(torn.size(), most); ++i) {
      const std::vector<const Tear*>& tears = tears_of_.at(torn[i]);
      text += fmt::format("tore in refresh {}: {}. {}\n", torn[i], met(tears, frame),
                          cause(frame, torn[i], *tears.front()));
    }
    if (torn.size() > most)
      text += fmt::format("tore in {} more, the last of them refresh {}.\n", refreshes(torn.size() - most),
                          torn.back());
    return text;
  }
  /// Which frames met, and where, as the beam goes.
  [[nodiscard]] static std::string met(const std::vector<const Tear*>& tears, const FrameRecord& frame) {
    const char* const line = line_or_column(tears.front()->scan);
    const auto side = [&frame](std::optional<std::uint32_t> number) {
      return part(number ? std::optional(std::min(*number, frame.number + 1U)) : number);
    };
    if (!tears.front()->above && !tears.front()->below)
      return fmt::format("no {} was of one frame alone", line);
    // Where bus and beam run abreast, lines of both frames alternate, and some are half sent.
    if (!frame.transfers.empty() && tears.size() > 1 && tears.front()->above == tears.back()->below)
      return fmt::format("{}, but for {}", side(tears.front()->above),
                         between(line, tears.front()->line, tears.back()->line));
    if (!frame.transfers.empty() && tears.size() > 1)
      return fmt::format("{} up to {} {}, {} from {} on, both in between", side(tears.front()->above), line,
                         tears.front()->line, side(tears.back()->below), tears.back()->line);
    constexpr std::size_t most = 2;
    std::vector<std::string> places;
    for (const Tear* const tear : tears) {
      if (tear->kind == Tear::Kind::palette) {
        places.push_back(fmt::format("from {} {} on the colours were others", line, tear->line));
      } else {
        places.push_back(fmt::format("{} up to {} {}, from there on {}", side(tear->above), line, tear->line,
                                     side(tear->below)));
      }
    }
    const std::size_t more = places.size() > most ? places.size() - most : 0;
    places.resize(places.size() - more);
    const std::string text = fmt::format("{}", fmt::join(places, "; "));
    return more == 0 ? text : fmt::format("{}; and so on, {} more", text, more);
  }

  [[nodiscard]] std::string cause(const FrameRecord& frame, std::uint64_t number, const Tear& tear) const {
    const RefreshRecord* const refresh = refresh_of(number);
    if (refresh == nullptr) return {};
    if (!frame.transfers.empty()) return race(frame, *refresh);
    if (tear.kind == Tear::Kind::palette)
      return "Colours were loaded in the middle of the picture: nothing holds them back until VBLANK.";
    if (frame.appeared && frame.time > refresh->scan.begin && frame.time < refresh->scan.end)
      return fmt::format(
          "The buffer was swapped {} after the refresh began: nothing held the request back until VBLANK.",
          ms(frame.time - refresh->scan.begin));
    return fmt::format("It was drawn on the buffer on display while the beam ran: {}.", made_of(frame));
  }

  /// The race of a write panel's beam with its bus.
  [[nodiscard]] std::string race(const FrameRecord& frame, const RefreshRecord& refresh) const {
    const Span bus = whole(frame.transfers);
    const hal::Capabilities& c = panel_.capabilities();
    const bool abreast = c.scan == hal::ScanDirection::down;  // Pictures are sent row by row, downwards.
    std::string text =
        capital(made_of(frame)) + fmt::format(", a refresh takes {}. ", ms(panel_.frame_time()));
    if (bus.begin <= refresh.scan.begin) {
      text += bus.begin == refresh.scan.begin
                  ? "Sending began with the refresh; "
                  : fmt::format("Sending began {} before the refresh; ", ms(refresh.scan.begin - bus.begin));
      return text + (bus.end <= refresh.scan.begin ? "it was over by then."
                     : abreast                     ? "the beam overtook the bus."
                                                   : "the beam crossed the bus.");
    }
    const Nanoseconds into = bus.begin - refresh.scan.begin;
    const auto lines = static_cast<Nanoseconds>(hal::sim::lines_of(c));
    const auto line = static_cast<int>(
        std::min(into * lines / std::max(refresh.scan.length(), Nanoseconds{1}), lines - 1U));
    text += fmt::format("Sending began {} into the refresh, with the beam at {} {}, and not in VBLANK",
                        ms(into), line_or_column(c.scan), hal::sim::place_of(c, line));
    if (bus.length() == 0) return text + '.';
    return text + (abreast ? "; the bus overtook the beam." : "; the bus crossed the beam.");
  }

  [[nodiscard]] static std::string capital(std::string text) {
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
  }

  const Timeline& timeline_;
  const hal::sim::Panel& panel_;
  std::map<std::uint64_t, std::vector<const Tear*>> tears_of_;  // By refresh.
  std::map<std::uint32_t, std::vector<std::uint64_t>> torn_;    // Refreshes, by frame.
};

}  // namespace

std::string to_text(const intaglio::present::FrameCounts& counts) {
  return fmt::format("{} shown, {} of them late; {} dropped; {} showed the frame before again", counts.shown,
                     counts.late, counts.dropped, refreshes(counts.repeated));
}

std::string explain(const Timeline& timeline, const std::vector<Tear>& tears, std::size_t most) {
  const std::vector<Tear> of_frames = timeline.of_frames(tears);
  return Report(timeline, of_frames).text(most);
}

}  // namespace host
