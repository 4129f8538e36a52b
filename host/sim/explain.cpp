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

Span whole(const std::vector<Span>& spans) { return {spans.front().begin, spans.back().end}; }

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
    std::string paragraphs;
    std::size_t told = 0;
    std::size_t untold = 0;
    for (const FrameRecord& frame : timeline_.frames()) {
      if (frame.late > 0) ++late;
      if (frame.dropped) ++dropped;
      const auto torn = torn_.find(frame.number);
      if (frame.late == 0 && !frame.dropped && torn == torn_.end()) continue;
      if (told == most) {
        ++untold;
        continue;
      }
      ++told;
      if (frame.dropped) paragraphs += drop(frame);
      if (frame.late > 0) paragraphs += lateness(frame);
      if (torn != torn_.end()) paragraphs += tear(frame, torn->second);
    }
    std::string all = fmt::format("{} frames in {} of {}: {} torn, {} late, {} dropped.\n",
                                  timeline_.frames().size(), refreshes(timeline_.refreshes().size()),
                                  ms(panel_.frame_time()), torn_.size(), late, dropped);
    all += paragraphs;
    if (untold > 0) all += fmt::format("... and {} more.\n", untold);
    return all;
  }

 private:
  /// The later of the frames that met; where a part is unfinished, the one that was being made.
  [[nodiscard]] std::uint32_t frame_that_tore(const std::vector<const Tear*>& tears) const {
    std::uint32_t latest = 0;
    bool unfinished = false;
    for (const Tear* const tear : tears) {
      latest = std::max({latest, tear->above.value_or(0), tear->below.value_or(0)});
      unfinished = unfinished || !tear->above || !tear->below;
    }
    const auto frames = static_cast<std::uint32_t>(timeline_.frames().size());
    // The panel counts from 1, so the one after `latest` has that number here.
    const std::uint32_t next = latest == 0 ? 0 : latest - 1U;
    if (!unfinished || latest >= frames) return next;
    const RefreshRecord* const refresh = refresh_of(tears.front()->refresh);
    const FrameRecord& following = timeline_.frames()[latest];
    const bool begun = refresh != nullptr && first_touch(following) < refresh->scan.end;
    return begun ? latest : next;
  }
  /// When a frame first touched what is on display.
  [[nodiscard]] static Nanoseconds first_touch(const FrameRecord& frame) {
    if (!frame.transfers.empty()) return frame.transfers.front().begin;
    return frame.draw ? frame.draw->begin : ~Nanoseconds{0};
  }
  [[nodiscard]] const RefreshRecord* refresh_of(std::uint64_t number) const {
    const auto& all = timeline_.refreshes();
    const auto found = std::ranges::lower_bound(all, number, {}, &RefreshRecord::number);
    return found != all.end() && found->number == number ? &*found : nullptr;
  }

  [[nodiscard]] static std::string part(std::optional<std::uint32_t> frame) {
    if (!frame) return "a part of a picture";
    return *frame == 0 ? "the picture before the first" : fmt::format("frame {}", *frame - 1U);
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
    return fmt::format(
        "Frame {} was dropped: it was asked for, but {} later, before its VBLANK, another frame was.\n",
        frame.number, ms(frame.presented->length()));
  }

  [[nodiscard]] std::string lateness(const FrameRecord& frame) const {
    const Nanoseconds budget = timeline_.budget();
    std::string text =
        fmt::format("Frame {} was late by {}: due {} after the frame before, it came after {}. {} of {}.",
                    frame.number, refreshes(frame.late), ms(budget), ms(frame.time - frame.deadline->begin),
                    capital(made_of(frame)), ms(budget));
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
    } else if (frame.draw) {
      text += fmt::format(" It was begun {} after the frame before appeared.",
                          ms(frame.draw->begin - frame.deadline->begin));
    }
    return text + '\n';
  }

  [[nodiscard]] std::string tear(const FrameRecord& frame, const std::vector<std::uint64_t>& torn) const {
    std::string text;
    for (const std::uint64_t number : torn) {
      const std::vector<const Tear*>& tears = tears_of_.at(number);
      text += fmt::format("Frame {} tore in refresh {}, {} {}: {}. {}\n", frame.number, number,
                          hal::sim::by_columns(tears.front()->scan) ? "column" : "line", place(tears),
                          met(tears), cause(frame, number, *tears.front()));
    }
    return text;
  }
  /// Where; lines of which only a part had been sent stand between two tears.
  [[nodiscard]] static std::string place(const std::vector<const Tear*>& tears) {
    return tears.size() == 1 ? std::to_string(tears.front()->line)
                             : fmt::format("{} to {}", tears.front()->line, tears.back()->line);
  }
  [[nodiscard]] static std::string met(const std::vector<const Tear*>& tears) {
    if (tears.front()->kind == Tear::Kind::palette) return "the colours changed there";
    return fmt::format("the beam showed {} before, {} after", part(tears.front()->above),
                       part(tears.back()->below));
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
    std::string text =
        capital(made_of(frame)) + fmt::format(", a refresh takes {}. ", ms(panel_.frame_time()));
    if (bus.begin <= refresh.scan.begin) {
      text += fmt::format("Sending began {} before the refresh; ", ms(refresh.scan.begin - bus.begin));
      return text + (bus.end <= refresh.scan.begin ? "it was over by then." : "the beam overtook the bus.");
    }
    const Nanoseconds into = bus.begin - refresh.scan.begin;
    text += fmt::format("Sending began {} into the refresh, with the beam at line {}, and not in VBLANK",
                        ms(into), into / panel_.line_time());
    return text + (bus.length() == 0 ? "." : "; the bus ran behind the beam.");
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

std::string explain(const Timeline& timeline, const std::vector<Tear>& tears, std::size_t most) {
  return Report(timeline, tears).text(most);
}

}  // namespace host
