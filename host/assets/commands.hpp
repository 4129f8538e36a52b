// SPDX-License-Identifier: MIT
//
// The commands of intaglio-assets. Each returns the whole header, or throws host::Failure whose text names
// the input file and what is wrong with it; nothing is written before everything is known to be good.
#pragma once

#include <cstdint>
#include <string>

namespace host::assets {

/// What every generated header says about itself.
struct Heading {
  std::string source;      ///< The input file.
  std::string credit;      ///< Author and licence of the source, as the user gave them; may be empty.
  std::string spdx;        ///< SPDX identifier that the header opens with; may be empty.
  std::string name;        ///< Identifier of the table.
  std::string name_space;  ///< Namespace it stands in.
};

struct FontOptions {
  Heading heading;
  int pixel_size = 0;    ///< Of an outline font; 0: the only size of a bitmap font.
  std::string charset;   ///< "0x20-0x7E,0xA0-0xFF"
  std::string literals;  ///< More characters, as UTF-8 text.
  bool tight = false;    ///< The line is as high as the ink of the set, not as the font says.
};

struct ImageOptions {
  Heading heading;
  int colours = 0;         ///< Palette entries, 2..2^bits.
  int bits = 8;            ///< Bits a pixel: 1, 2, 4, 8.
  bool lsb_first = false;  ///< The low end of a byte is its leftmost pixel.
  double dither = 0;       ///< 0: none .. 1: full Floyd-Steinberg.
  bool ordered = false;    ///< By Bayer's matrix instead.
};

struct PolygonOptions {
  Heading heading;
  double scale = 1;    ///< Units of the table in a unit of the file.
  bool y_down = true;  ///< Negates y, since latitudes grow upwards.
};

std::string font_header(const FontOptions& options);
std::string image_header(const ImageOptions& options);
std::string polygon_header(const PolygonOptions& options);

}  // namespace host::assets
