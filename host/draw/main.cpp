// SPDX-License-Identifier: MIT
//
// intaglio-draw: pictures from a small language, for shell scripts and for tests in any language.
#include <host/attach/attach.hpp>
#include <host/attach/still.hpp>
#include <host/draw/program.hpp>
#include <host/failure.hpp>
#include <host/file.hpp>
#include <host/png.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstddef>
#include <cstdio>
#include <exception>
#include <string>
#include <utility>
#include <vector>

namespace {

using host::draw::Canvas;
using intaglio::linear::Size;

struct Outputs {
  std::string png;
  std::string pgm;
  std::string touched;
  bool ascii = false;
  bool digest = false;
  host::AttachOptions panel;
  bool hold = false;
};

/// A binary PGM of bytes as they are, with 255 as the largest, whatever the depth of the surface.
std::string encode_pgm(Size size, const std::vector<std::uint8_t>& bytes) {
  return fmt::format("P5\n{} {}\n255\n", size.width, size.height) + std::string(bytes.begin(), bytes.end());
}

/// One character a pixel: '.' for index 0, then 1..9, a..z, and '#' for all beyond 35.
std::string to_ascii(Size size, const std::vector<std::uint8_t>& indices) {
  constexpr std::string_view signs = ".123456789abcdefghijklmnopqrstuvwxyz";
  std::string out;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    out += indices[i] < signs.size() ? signs[indices[i]] : '#';
    if ((i + 1) % static_cast<std::size_t>(size.width) == 0) out += '\n';
  }
  return out;
}

void write_outputs(const Canvas& canvas, const Outputs& outputs) {
  const Size size = canvas.size();
  const std::vector<std::uint8_t> indices = canvas.indices();
  std::vector<std::pair<std::string, std::string>> files;
  if (!outputs.png.empty())
    files.emplace_back(outputs.png, host::encode_png({size.width, size.height, indices, canvas.palette()}));
  if (!outputs.pgm.empty()) files.emplace_back(outputs.pgm, encode_pgm(size, indices));
  if (!outputs.touched.empty()) files.emplace_back(outputs.touched, encode_pgm(size, canvas.touched()));
  for (const auto& [path, content] : files) host::write_file(path, content);
  std::string printed = canvas.printed();
  const bool shown =
      !files.empty() || !printed.empty() || outputs.ascii || outputs.digest || !outputs.panel.panel.empty();
  if (!shown) std::fputs("Drawn, and shown nowhere: --png FILE, --ascii or --panel NAME show it.\n", stderr);
  if (outputs.ascii) printed += to_ascii(size, indices);
  if (outputs.digest) printed += fmt::format("frame 0 crc32 {:08x}\n", canvas.digest());
  if (std::fwrite(printed.data(), 1, printed.size(), stdout) != printed.size() || std::fflush(stdout) != 0)
    throw host::Failure("writing to standard output failed");
  if (!outputs.panel.panel.empty())
    host::show_still_and_leave(outputs.panel, {size.width, size.height, indices, canvas.palette()},
                               outputs.hold);
}

int run(int argc, char** argv) {
  CLI::App app{"Draws a picture from commands, read from FILE or from standard input."};
  app.name("intaglio-draw");
  app.footer(std::string(host::draw::language_help()));
  std::string source = "-";
  Outputs outputs;
  app.add_option("FILE", source, "The commands; - is standard input")->capture_default_str();
  app.add_option("--png", outputs.png, "Write the picture in its colours");
  app.add_option("--pgm", outputs.pgm, "Write the indices as binary PGM (P5, maxval 255)");
  app.add_option("--touched", outputs.touched, "Write how often each pixel was written (P5, at most 255)");
  app.add_flag("--ascii", outputs.ascii, "Print one character a pixel: . for index 0, 1-9, a-z, # beyond 35");
  app.add_flag("--digest", outputs.digest, "Print `frame 0 crc32 XXXXXXXX`, as the simulator does");
  CLI::Option* const panel = app.add_option(
      "--panel", outputs.panel.panel,
      "Show the picture on a real panel and leave it there: a controller's name, or SCHEME:DEVICE");
  app.add_flag("--hold", outputs.hold, "Show it until the program is ended, then blank the panel")
      ->needs(panel);
  host::add_attach_options(app, outputs.panel);
  try {
    app.parse(argc, argv);
    if (outputs.panel.panel.empty() && host::means_attached(outputs.panel))
      throw CLI::RequiredError("--panel, which names the panel at these wires,");
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 1;
  }
  write_outputs(*host::draw::draw_program(host::read_file(source)), outputs);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
