// SPDX-License-Identifier: MIT
//
// intaglio-assets: fonts, images and polygons as C++ tables for freestanding programs.
#include <host/assets/commands.hpp>
#include <host/assets/table.hpp>
#include <host/file.hpp>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <string>

namespace {

using host::assets::Heading;

/// The options that all commands have.
void add_common(CLI::App& command, Heading& heading, std::string& output) {
  command.add_option("file", heading.source, "Input file")->required();
  command.add_option("--name", heading.name, "Name of the table in the header")->required();
  command.add_option("--namespace", heading.name_space, "Namespace of the header")->capture_default_str();
  command.add_option("--spdx", heading.spdx, "SPDX licence identifier that the header opens with");
  command.add_option("--credit", heading.credit, "Author, source and licence, for the header's head comment");
  command.add_option("-o,--output", output, "Header to write")->required();
}

/// Makes the header and, if that went well, writes it.
template <class Options>
void compile(const Options& options, const std::string& output, std::string (*make)(const Options&)) {
  host::assets::check_identifier("--name", options.heading.name);
  host::assets::check_identifier("--namespace", options.heading.name_space, true);
  host::write_file(output, make(options));
}

int run(int argc, char** argv) {
  CLI::App app{
      "Compiles fonts, images and polygons to C++ tables that need no run-time library.\n"
      "Whatever is wrong with the input is said on stderr, nothing is written, and the exit code is 1."};
  app.name("intaglio-assets");
  app.require_subcommand(1);
  std::string output;

  host::assets::FontOptions font;
  font.heading.name_space = "intaglio::fonts";
  CLI::App& font_command = *app.add_subcommand(
      "font", "A subset of a bitmap font (PCF, BDF) or outline font (TrueType, OpenType) as text::Font");
  add_common(font_command, font.heading, output);
  auto* const size = font_command.add_option("--size", font.pixel_size, "Pixels an em, for outline fonts")
                         ->check(CLI::Range(4, 200));
  bool fixed = false;
  font_command.add_flag("--fixed", fixed, "Take the one size of a bitmap font (the default)")->excludes(size);
  font_command.add_option("--charset", font.charset,
                          "Code points, for example 0x20-0x7E,0xA0-0xFF,U+2190-2193");
  font_command.add_option("--chars", font.literals, "Further characters, as UTF-8 text");
  font_command.add_flag("--tight", font.tight, "Lines as high as the ink of the set (for digits of gauges)");

  host::assets::ImageOptions image;
  image.heading.name_space = "intaglio::images";
  CLI::App& image_command = *app.add_subcommand("image", "A PNG as an indexed picture and its palette");
  add_common(image_command, image.heading, output);
  image_command.add_option("--bits", image.bits, "Bits a pixel")
      ->check(CLI::IsMember({1, 2, 4, 8}))
      ->capture_default_str();
  image_command
      .add_option("--colours,--colors", image.colours, "Palette entries at most; 2 to the bits if not given")
      ->check(CLI::Range(2, 256));
  std::string order = "msb";
  image_command.add_option("--order", order, "Which end of a byte is its leftmost pixel: msb or lsb")
      ->check(CLI::IsMember({"msb", "lsb"}))
      ->capture_default_str();
  std::string dither = "0";
  image_command
      .add_option(
          "--dither", dither,
          "If the picture has too many colours: ordered (by a matrix), diffusion, or how much of that, "
          "0 (none) to 1")
      ->check(CLI::IsMember({"ordered", "diffusion"}) | CLI::Range(0.0, 1.0))
      ->capture_default_str();

  host::assets::PolygonOptions polygons;
  polygons.heading.name_space = "intaglio::polygons";
  CLI::App& polygon_command =
      *app.add_subcommand("polygons", "The polygons of a GeoJSON file as rings of integers");
  add_common(polygon_command, polygons.heading, output);
  polygon_command.add_option("--scale", polygons.scale, "Units of the table in a unit (degree) of the file")
      ->required()
      ->check(CLI::PositiveNumber);
  bool y_up = false;
  polygon_command.add_flag("--y-up", y_up, "Keep the sign of y; else y grows downwards, as on a screen");

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 1;
  }
  image.lsb_first = order == "lsb";
  image.ordered = dither == "ordered";
  if (!image.ordered) image.dither = dither == "diffusion" ? 1 : std::stod(dither);
  polygons.y_down = !y_up;
  if (font_command.parsed()) compile(font, output, host::assets::font_header);
  if (image_command.parsed()) compile(image, output, host::assets::image_header);
  if (polygon_command.parsed()) compile(polygons, output, host::assets::polygon_header);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "intaglio-assets: %s\n", error.what());
    return 1;
  }
}
