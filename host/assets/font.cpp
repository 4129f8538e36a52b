// SPDX-License-Identifier: MIT
//
// intaglio-assets font: a subset of a font as the tables of text::Font.
//
// FreeType reads bitmap fonts (PCF, gzipped or not) as they are and renders outlines in two colours with its
// own hinting. Each glyph's box is cut to its ink, equal boxes share their rows, and glyph 0 is a drawn
// replacement box as high as a capital and as wide as a digit.
#include <host/assets/charset.hpp>
#include <host/assets/commands.hpp>
#include <host/assets/table.hpp>
#include <host/failure.hpp>
#include <host/file.hpp>
#include <intaglio/text/font.hpp>

#include <fmt/format.h>

#include <ft2build.h>
#include FT_FREETYPE_H

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace host::assets {
namespace {

using intaglio::text::CodeRange;
using intaglio::text::Font;
using intaglio::text::Glyph;

/// A rendered glyph, cut to its ink; `top` counts rows above the base line.
struct Bitmap {
  int width = 0;
  int height = 0;
  int left = 0;
  int top = 0;
  int advance = 0;
  std::vector<std::uint8_t> rows;
};

struct Metrics {
  int line_height = 0;
  int ascent = 0;
};

class Face {
 public:
  Face(const std::string& path, int pixel_size) : path_(path) {
    (void)read_file(path);  // says why a file can't be opened; FreeType only says that it can't
    check(FT_Init_FreeType(&library_), "FreeType doesn't start");
    check(FT_New_Face(library_, path.c_str(), 0, &face_), "not a font that FreeType can read");
    check(FT_Select_Charmap(face_, FT_ENCODING_UNICODE), "has no Unicode character map");
    if (pixel_size == 0) {
      if (face_->num_fixed_sizes != 1)
        throw Failure(fmt::format("{}: not a bitmap font of one size; give --size", path));
      check(FT_Select_Size(face_, 0), "its bitmap size can't be selected");
    } else {
      check(FT_Set_Pixel_Sizes(face_, 0, static_cast<FT_UInt>(pixel_size)),
            fmt::format("has no size of {} pixels", pixel_size));
    }
  }
  Face(const Face&) = delete;
  Face& operator=(const Face&) = delete;
  ~Face() { close(); }

  [[nodiscard]] bool has(std::uint32_t code) const { return FT_Get_Char_Index(face_, code) != 0; }

  [[nodiscard]] Metrics metrics() const {
    const FT_Size_Metrics& m = face_->size->metrics;
    const int ascent = round_up(m.ascender);
    return {std::max(round_up(m.height), ascent + round_up(-m.descender)), ascent};
  }

  [[nodiscard]] Bitmap render(std::uint32_t code) {
    check(FT_Load_Char(face_, code, FT_LOAD_RENDER | FT_LOAD_TARGET_MONO),
          fmt::format("the glyph of U+{:04X} can't be loaded", code));
    const FT_GlyphSlot slot = face_->glyph;
    const FT_Bitmap& source = slot->bitmap;
    const int width = static_cast<int>(source.width);
    const int height = static_cast<int>(source.rows);
    // Damaged fonts have glyphs of a size, but without pixels.
    if (width > 0 && height > 0 && (source.pixel_mode != FT_PIXEL_MODE_MONO || source.buffer == nullptr))
      throw Failure(fmt::format("{}: the glyph of U+{:04X} isn't a bitmap of two colours", path_, code));
    const auto ink = [&](int x, int y) {
      return (source.buffer[y * source.pitch + x / 8] >> (7 - x % 8) & 1) != 0;
    };
    int left = width, right = 0, top = height, bottom = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        if (ink(x, y)) {
          left = std::min(left, x);
          right = std::max(right, x + 1);
          top = std::min(top, y);
          bottom = std::max(bottom, y + 1);
        }
    Bitmap cut;
    cut.advance = static_cast<int>((slot->advance.x + 32) >> 6);
    if (right == 0) return cut;
    cut.width = right - left;
    cut.height = bottom - top;
    cut.left = slot->bitmap_left + left;
    cut.top = slot->bitmap_top - top;
    const auto stride = static_cast<std::size_t>((cut.width + 7) / 8);
    cut.rows.resize(stride * static_cast<std::size_t>(cut.height));
    for (int y = 0; y < cut.height; ++y)
      for (int x = 0; x < cut.width; ++x)
        if (ink(left + x, top + y))
          cut.rows[static_cast<std::size_t>(y) * stride + static_cast<std::size_t>(x / 8)] |=
              static_cast<std::uint8_t>(0x80 >> (x % 8));
    return cut;
  }

 private:
  static int round_up(FT_Pos value) { return static_cast<int>((value + 63) >> 6); }

  void check(FT_Error error, const std::string& what) {
    if (error == 0) return;
    close();
    throw Failure(fmt::format("{}: {}", path_, what));
  }

  void close() {
    if (library_ != nullptr) FT_Done_FreeType(library_);  // takes its faces along
    library_ = nullptr;
  }

  std::string path_;
  FT_Library library_ = nullptr;
  FT_Face face_ = nullptr;
};

/// An outlined box on the base line: as high as a capital, as wide as a digit's ink can be.
Bitmap replacement_box(const std::map<std::uint32_t, Bitmap>& glyphs, const Metrics& metrics) {
  const auto like = [&](std::initializer_list<char> wanted) -> const Bitmap& {
    for (const char c : wanted)
      if (const auto found = glyphs.find(static_cast<unsigned char>(c)); found != glyphs.end())
        return found->second;
    return glyphs.rbegin()->second;
  };
  Bitmap box;
  box.advance = std::max(like({'0', 'n'}).advance, 3);
  box.height = std::clamp(like({'H', '0'}).height, 3, std::max(metrics.line_height, 3));
  box.width = box.advance - 1;
  box.top = box.height;
  const auto stride = static_cast<std::size_t>((box.width + 7) / 8);
  box.rows.resize(stride * static_cast<std::size_t>(box.height));
  for (int y = 0; y < box.height; ++y)
    for (int x = 0; x < box.width; ++x)
      if (x == 0 || x == box.width - 1 || y == 0 || y == box.height - 1)
        box.rows[static_cast<std::size_t>(y) * stride + static_cast<std::size_t>(x / 8)] |=
            static_cast<std::uint8_t>(0x80 >> (x % 8));
  return box;
}

/// The tables, growing; equal boxes share their rows.
struct Tables {
  std::vector<CodeRange> ranges;
  std::vector<Glyph> glyphs;
  std::vector<std::uint8_t> rows;
  std::map<std::vector<std::uint8_t>, std::size_t> offsets;

  void add(const Bitmap& bitmap, int ascent, const std::string& path) {
    const auto [shared, is_new] = offsets.try_emplace(bitmap.rows, rows.size());
    if (is_new) rows.insert(rows.end(), bitmap.rows.begin(), bitmap.rows.end());
    const int top = bitmap.height == 0 ? 0 : ascent - bitmap.top;
    const auto fits = [](int value, int low, int high) { return value >= low && value <= high; };
    if (!fits(bitmap.width, 0, 255) || !fits(bitmap.height, 0, 255) || !fits(bitmap.left, -128, 127) ||
        !fits(top, -128, 127) || !fits(bitmap.advance, 0, 255))
      throw Failure(
          fmt::format("{}: a glyph of {}x{} pixels is too large", path, bitmap.width, bitmap.height));
    if (shared->second > 65535 || glyphs.size() >= 65535)
      throw Failure(fmt::format("{}: the glyphs of this charset need more than 64 KiB", path));
    glyphs.push_back({static_cast<std::uint16_t>(shared->second), static_cast<std::uint8_t>(bitmap.width),
                      static_cast<std::uint8_t>(bitmap.height), static_cast<std::int8_t>(bitmap.left),
                      static_cast<std::int8_t>(top), static_cast<std::uint8_t>(bitmap.advance)});
  }

  void add_code(std::uint32_t code) {
    const auto glyph = static_cast<std::uint16_t>(glyphs.size());  // that of the next `add`
    if (ranges.empty() || ranges.back().first + ranges.back().count != code)
      ranges.push_back({code, 0, glyph});
    ++ranges.back().count;
  }
};

std::set<std::uint32_t> wanted_codes(const FontOptions& options) {
  std::set<std::uint32_t> codes = parse_charset(options.charset);
  codes.merge(code_points(options.literals));
  if (codes.empty()) throw Failure(fmt::format("{}: the charset is empty", options.heading.source));
  return codes;
}

std::map<std::uint32_t, Bitmap> render_all(const FontOptions& options, Face& face) {
  std::map<std::uint32_t, Bitmap> glyphs;
  std::string missing;
  for (const std::uint32_t code : wanted_codes(options)) {
    if (face.has(code)) {
      glyphs.emplace(code, face.render(code));
    } else {
      missing += fmt::format(" U+{:04X}", code);
    }
  }
  constexpr std::size_t enough = 80;
  if (missing.size() > enough) missing = missing.substr(0, missing.rfind(' ', enough)) + " …";
  if (!missing.empty()) throw Failure(fmt::format("{}: has no glyph for{}", options.heading.source, missing));
  return glyphs;
}

Metrics ink_metrics(const std::map<std::uint32_t, Bitmap>& glyphs) {
  int above = 0;
  int below = 0;
  for (const auto& [code, glyph] : glyphs) {
    above = std::max(above, glyph.top);
    below = std::max(below, glyph.height - glyph.top);
  }
  return {above + below, above};
}

}  // namespace

std::string font_header(const FontOptions& options) {
  const Heading& heading = options.heading;
  Face face(heading.source, options.pixel_size);
  const std::map<std::uint32_t, Bitmap> glyphs = render_all(options, face);
  const Metrics metrics = options.tight ? ink_metrics(glyphs) : face.metrics();

  Tables tables;
  tables.add(replacement_box(glyphs, metrics), metrics.ascent, heading.source);
  for (const auto& [code, bitmap] : glyphs) {
    tables.add_code(code);
    tables.add(bitmap, metrics.ascent, heading.source);
  }
  if (!Font::over({tables.ranges, tables.glyphs, tables.rows, metrics.line_height, metrics.ascent}).ok())
    throw Failure(
        fmt::format("{}: a line of {} pixels can't be a bitmap font", heading.source, metrics.line_height));

  const std::size_t bytes =
      tables.rows.size() + sizeof(Glyph) * tables.glyphs.size() + sizeof(CodeRange) * tables.ranges.size();
  std::string out = head_comment(
      heading, "font",
      fmt::format("{} glyphs, line height {}, {} bytes.", glyphs.size(), metrics.line_height, bytes));
  out += "#include <intaglio/text/font.hpp>\n\n#include <cstdint>\n\n";
  out += fmt::format("namespace {} {{\nnamespace {}_tables {{\n\n", heading.name_space, heading.name);
  out += array("std::uint8_t", "rows", tables.rows.size(),
               [&](std::size_t i) { return fmt::format("{:#04x}", tables.rows[i]); });
  out += "\n// offset, width, height, left, top, advance\n";
  out += array("::intaglio::text::Glyph", "glyphs", tables.glyphs.size(), [&](std::size_t i) {
    const Glyph& g = tables.glyphs[i];
    return fmt::format("{{{}, {}, {}, {}, {}, {}}}", g.offset, g.width, g.height, g.left, g.top, g.advance);
  });
  out += "\n// first code point, count, glyph\n";
  out += array("::intaglio::text::CodeRange", "ranges", tables.ranges.size(), [&](std::size_t i) {
    const CodeRange& r = tables.ranges[i];
    return fmt::format("{{{:#x}, {}, {}}}", r.first, r.count, r.glyph);
  });
  out += fmt::format(
      "\ninline constexpr ::intaglio::Result<::intaglio::text::Font> font =\n"
      "    ::intaglio::text::Font::over({{ranges, glyphs, rows, {}, {}}});\n"
      "static_assert(font.ok());\n\n"
      "}}  // namespace {}_tables\n\n"
      "/// {} glyphs, {} pixels from line to line.\n"
      "inline constexpr ::intaglio::text::Font {} = {}_tables::font.value();\n\n"
      "}}  // namespace {}\n",
      metrics.line_height, metrics.ascent, heading.name, glyphs.size(), metrics.line_height, heading.name,
      heading.name, heading.name_space);
  return out;
}

}  // namespace host::assets
