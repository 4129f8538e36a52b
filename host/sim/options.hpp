// SPDX-License-Identifier: MIT
//
// The command line of intaglio-sim.
#pragma once

#include <host/attach/attach.hpp>
#include <intaglio/present/pacer.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

namespace host {

struct Options {
  std::string program;
  std::string panel = "clcd";           ///< A name of the catalogue or WxHxBPP, or a real panel's.
  AttachOptions attach;                 ///< The real panel, with the name from `panel`.
  std::optional<std::uint32_t> frames;  ///< None: until the user ends it, or 120 where nobody looks.
  int frames_per_second = 60;           ///< 1..1000
  std::optional<int> buffers;           ///< 1..3 of a scan-out panel; none: those it has by itself.
  std::optional<intaglio::present::Late> late;
  std::optional<intaglio::present::Order> order;
  std::optional<bool> chase;             ///< Frames are sent behind the beam; none: as the panel suggests.
  std::optional<std::string> png;        ///< Where the last frame goes.
  std::optional<std::uint32_t> png_of;   ///< The frame or refresh that goes there instead.
  std::optional<std::string> animation;  ///< Where all frames go.
  std::string effects;                   ///< What the panel does to a picture; empty: it is ideal.
  std::optional<std::string> trace;      ///< Where the record of what happened when goes.
  bool explain = false;
  bool digest = false;
  bool window = false;
  bool terminal = false;
  int scale = 0;                      ///< Of the window, 1..32; 0: as suits the screen.
  std::optional<std::string> report;  ///< Where the counters of a run on a real panel go.
  bool list = false;
  bool list_panels = false;
};

/// The options, or the exit code of a program that has said what was wrong (or given the help it was asked
/// for).
[[nodiscard]] std::variant<Options, int> parse_command_line(int argc, const char* const* argv);

}  // namespace host
