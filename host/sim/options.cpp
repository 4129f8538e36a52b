// SPDX-License-Identifier: MIT
#include <host/sim/options.hpp>

#include <CLI/CLI.hpp>

namespace host {

std::variant<Options, int> parse_command_line(int argc, const char* const* argv) {
  Options options;
  std::string late;
  std::string order;
  std::string beam;
  CLI::App app{
      "Runs a program of Intaglio on a simulated panel, or on a real one.\n"
      "Where there is a display it opens a window, else on a terminal it shows a preview until a key is\n"
      "pressed, else it records 120 frames. It leaves an animated PNG and says where.",
      "intaglio-sim"};
  app.add_option("program", options.program, "Program to run; --list names them");
  app.add_option("--panel", options.panel,
                 "Panel: a name (--list), WIDTHxHEIGHTxBITS as 320x240x8, or a real one (--list-panels)")
      ->capture_default_str();
  app.add_option("--frames", options.frames, "Frames to run (default: until you end it, or 120 unattended)")
      ->check(CLI::Range(std::uint32_t{1}, std::uint32_t{1'000'000'000}));
  app.add_option(
         "--fps", options.frames_per_second,
         "Frames a second: the nearest that is a refresh of the panel, or every second, third ... one")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--buffers", options.buffers,
                 "Frame buffers of a scan-out panel; with 3 a frame is drawn while one waits for its VBLANK")
      ->check(CLI::Range(1, 3));
  app.add_option("--late", late,
                 "A frame that comes too late is shown late, or dropped to keep the rhythm (default: show)")
      ->check(CLI::IsMember({"show", "drop"}));
  app.add_option("--order", order,
                 "With --buffers 3: every frame is shown, or the latest at each VBLANK (default: every)")
      ->check(CLI::IsMember({"every", "latest"}));
  app.add_option("--beam", beam,
                 "Frames go out behind the beam of a panel with memory of its own, or without a look at it "
                 "(default: chase on real panels with --te)")
      ->check(CLI::IsMember({"chase", "ignore"}));
  CLI::Option* const png = app.add_option("--png", options.png, "Write the last frame to this file");
  app.add_option(
         "--png-of", options.png_of,
         "Write this frame instead, counted from 0; this refresh with effects that are seen by refreshes")
      ->needs(png);
  app.add_option("--apng", options.animation,
                 "Write the animation to this file (default: PROGRAM.png in the working folder)");
  app.add_option(
      "--effects", options.effects,
      "What the panel does to a picture, as bus=10MHz,te,tearing,response=8ms,dead=12:7 (--list names them)");
  app.add_option("--trace", options.trace,
                 "Write what happened when to this file, for chrome://tracing or Perfetto");
  app.add_flag("--explain", options.explain, "Say why frames were torn, late or dropped");
  app.add_flag("--digest", options.digest, "Print a line `frame N crc32 HEX` a frame, and nothing else");
  CLI::Option* const window = app.add_flag("--window", options.window, "Show a window");
  app.add_flag("--terminal", options.terminal, "Show a preview on the terminal")->excludes(window);
  app.add_option("--scale", options.scale, "Window pixels a pixel (default: as suits the screen)")
      ->check(CLI::Range(1, 32));
  app.add_flag("--list", options.list, "Name the programs, panels and effects");
  app.add_flag("--list-panels", options.list_panels, "Name the real panels and buses of this machine");
  app.add_option("--report", options.report,
                 "Write what was counted on a real panel to this file, a line `KEY VALUE` each");
  add_attach_options(app, options.attach);
  try {
    app.parse(argc, argv);
    options.attach.panel = options.panel;
    using intaglio::present::Late;
    using intaglio::present::Order;
    if (!late.empty()) options.late = late == "drop" ? Late::drop : Late::show;
    if (!beam.empty()) options.chase = beam == "chase";
    if (!order.empty()) options.order = order == "latest" ? Order::latest : Order::every;
    if (options.program.empty() && !options.list && !options.list_panels)
      throw CLI::RequiredError("program (intaglio-sim --list names them)");
    if (options.terminal && options.digest)
      throw CLI::ValidationError("--terminal and --digest both need standard output");
    if (means_attached(options.attach)) {
      if (options.window || options.terminal || options.png || options.animation)
        throw CLI::ValidationError("--window, --terminal, --png and --apng are for simulated panels");
      if (!options.effects.empty() || options.trace || options.explain)
        throw CLI::ValidationError("--effects, --trace and --explain are for simulated panels");
      if (options.buffers || options.order)
        throw CLI::ValidationError("--buffers and --order are for simulated panels");
    } else if (options.report) {
      throw CLI::ValidationError("--report is for real panels");
    }
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  }
  return options;
}

}  // namespace host
