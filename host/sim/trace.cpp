// SPDX-License-Identifier: MIT
#include <host/sim/trace.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace host {

namespace {

enum class Track : std::uint8_t { draw, present, bus, scan_out, vblank, deadline };
constexpr std::array<std::string_view, 6> track_names{"draw",     "present", "bus",
                                                      "scan-out", "VBLANK",  "deadline"};

struct Event {
  hal::Nanoseconds time;
  hal::Nanoseconds length;
  std::string text;
};

class Events {
 public:
  /// `arguments` are members of a JSON object.
  void slice(Track track, const Span& span, const std::string& name, const std::string& arguments = {}) {
    add(span,
        fmt::format(R"("ph":"X","dur":{},{})", microseconds(span.length()), common(track, name, arguments)));
  }
  void instant(Track track, hal::Nanoseconds time, const std::string& name,
               const std::string& arguments = {}) {
    add({time, time}, R"("ph":"i","s":"t",)" + common(track, name, arguments));
  }

  /// In the order of their times; of two that begin together the longer one, which holds the other, comes
  /// first.
  std::vector<Event>& in_order() {
    std::ranges::stable_sort(events_, [](const Event& a, const Event& b) {
      return a.time != b.time ? a.time < b.time : a.length > b.length;
    });
    return events_;
  }

 private:
  static std::string microseconds(hal::Nanoseconds time) {
    return fmt::format("{}.{:03}", time / 1000U, time % 1000U);
  }
  static std::string common(Track track, const std::string& name, const std::string& arguments) {
    const auto number = static_cast<unsigned>(track);
    return fmt::format(R"("name":"{}","cat":"{}","pid":1,"tid":{},"args":{{{}}})", name, track_names[number],
                       number + 1U, arguments);
  }
  void add(const Span& span, const std::string& text) {
    events_.push_back(
        {span.begin, span.length(), fmt::format(R"({{"ts":{},{}}})", microseconds(span.begin), text)});
  }

  std::vector<Event> events_;
};

void add_frame(Events& events, const FrameRecord& frame) {
  const std::string number = std::to_string(frame.number);
  const std::string argument = R"("frame":)" + number;
  if (frame.draw) events.slice(Track::draw, *frame.draw, "draw " + number, argument);
  if (frame.presented) {
    events.slice(Track::present, *frame.presented, "present " + number, argument);
  }
  if (frame.dropped)
    events.instant(Track::present, frame.presented ? frame.presented->end : frame.time, "dropped " + number,
                   argument);
  if (frame.appeared) events.instant(Track::present, frame.time, "shown " + number, argument);
  for (const Span& transfer : frame.transfers) events.slice(Track::bus, transfer, "send " + number, argument);
  if (!frame.deadline) return;
  events.slice(Track::deadline, *frame.deadline, "frame " + number, argument);
  if (frame.late > 0)
    events.instant(Track::deadline, frame.time, "missed " + number,
                   fmt::format(R"({},"refreshes":{})", argument, frame.late));
}

}  // namespace

std::string trace(const Timeline& timeline, const std::vector<hal::sim::Tear>& requested) {
  const std::vector<hal::sim::Tear> tears = timeline.of_frames(requested);
  Events events;
  for (const FrameRecord& frame : timeline.frames()) add_frame(events, frame);
  for (const RefreshRecord& refresh : timeline.refreshes()) {
    const std::string argument = fmt::format(R"("refresh":{})", refresh.number);
    if (refresh.scan.length() > 0)
      events.slice(Track::scan_out, refresh.scan, fmt::format("refresh {}", refresh.number), argument);
    if (refresh.blanking.length() > 0) events.slice(Track::vblank, refresh.blanking, "VBLANK", argument);
    for (const hal::sim::Tear& tear : tears)
      if (tear.refresh == refresh.number)
        events.instant(
            Track::scan_out, refresh.scan.begin, "torn",
            fmt::format(R"({},"line":{},"what":"{}")", argument, tear.line, hal::sim::to_text(tear, 0)));
  }
  for (const hal::Nanoseconds edge : timeline.te_edges()) events.instant(Track::vblank, edge, "TE");
  if (const auto& counts = timeline.counts())
    events.instant(Track::present, timeline.now(), "counts",
                   fmt::format(R"("shown":{},"late":{},"dropped":{},"repeated":{})", counts->shown,
                               counts->late, counts->dropped, counts->repeated));

  std::string text = R"({"displayTimeUnit":"ms","traceEvents":[)"
                     "\n";
  text += fmt::format(R"({{"ph":"M","name":"process_name","pid":1,"tid":0,"args":{{"name":"{}"}}}})",
                      timeline.panel().spec().name);
  for (std::size_t i = 0; i < track_names.size(); ++i)
    text += fmt::format(
        ",\n"
        R"({{"ph":"M","name":"thread_name","pid":1,"tid":{},"args":{{"name":"{}"}}}})",
        i + 1U, track_names[i]);
  for (const Event& event : events.in_order()) text += ",\n" + event.text;
  return text + "\n]}\n";
}

}  // namespace host
