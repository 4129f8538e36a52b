// SPDX-License-Identifier: MIT
//
// UTF-8, fonts of any tables, and text drawn with them.
#include <intaglio/text/draw_aligned_text.hpp>
#include <intaglio/text/draw_text.hpp>
#include <intaglio/text/measure.hpp>
#include <intaglio/text/utf8.hpp>
#include <tests/fuzz/scene.hpp>
#include <tests/oracle/text.hpp>
#include <tests/oracle/utf8.hpp>
#include <tests/text/test_font.hpp>

#include <climits>

#include <array>
#include <optional>

namespace fuzz {
namespace {

using namespace intaglio::text;

struct Tables {
  std::vector<CodeRange> ranges;
  std::vector<Glyph> glyphs;
  std::vector<std::uint8_t> rows;
  int line_height = 0;
  int ascent = 0;

  /// Small tables that are mostly right.
  explicit Tables(Input& in) {
    line_height = in.byte();
    ascent = in.byte() % (line_height + 2);
    rows.resize(static_cast<std::size_t>(in.choice(64)));
    for (std::uint8_t& byte : rows) byte = static_cast<std::uint8_t>(in.byte());
    glyphs.resize(static_cast<std::size_t>(in.choice(6)));
    for (Glyph& glyph : glyphs) {
      glyph.offset = static_cast<std::uint16_t>(in.byte());
      glyph.width = static_cast<std::uint8_t>(in.byte() % 24);
      glyph.height = static_cast<std::uint8_t>(in.byte() % 12);
      glyph.left = static_cast<std::int8_t>(in.byte() - 128);
      glyph.top = static_cast<std::int8_t>(in.byte() - 128);
      glyph.advance = static_cast<std::uint8_t>(in.byte());
    }
    ranges.resize(static_cast<std::size_t>(in.choice(4)));
    std::uint32_t code = 0;
    for (CodeRange& range : ranges) {
      const int b = in.byte();
      range.first = b < 0xF0 ? code + static_cast<std::uint32_t>(b) : static_cast<std::uint32_t>(in.any());
      range.count = static_cast<std::uint16_t>(in.choice(6));
      range.glyph = static_cast<std::uint16_t>(in.choice(7));
      code = range.first + range.count;
    }
  }
};

void decode(std::string_view text) {
  std::vector<std::uint32_t> codes;
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t before = rest.size();
    codes.push_back(take_code_point(rest));
    require(rest.size() < before && rest.size() + 4 >= before, "take_code_point takes 1 to 4 bytes");
  }
  require(codes == oracle::utf8_by_definition().decode(text), "take_code_point: another text");
}

/// The sum of advances of the longest line, and the lines.
void measured(const Font& font, std::string_view text) {
  std::int64_t width = 0;
  std::int64_t line = 0;
  std::int64_t lines = 1;
  for (const std::uint32_t code : oracle::utf8_by_definition().decode(text)) {
    if (code == '\n') {
      ++lines;
      line = 0;
    } else {
      line += font.glyph(code).advance;
      width = std::max(width, line);
    }
  }
  const auto size = measure(font, text);
  require(size.width == width && size.height == lines * font.line_height(), "measure: another size");
}

}  // namespace

void run(Input in) {
  const Scene scene(in, 40, 24);
  const Point top_left = scene.point(in);
  const bool own = in.choice(2) == 0;
  // Before the text, which takes all that is left.
  const auto kind = static_cast<std::uint8_t>(in.byte());
  const std::array<std::uint8_t, 2> surface{kind, static_cast<std::uint8_t>(in.byte())};
  const Tables tables(in);
  const auto made =
      own ? Font::over({tables.ranges, tables.glyphs, tables.rows, tables.line_height, tables.ascent})
          : intaglio::Result<Font>(test_font::font);
  if (in.left() > 64) return;
  // Copied, so that a sanitizer sees whoever reads beyond.
  const auto bytes = in.rest_as_text();
  const std::vector<char> exact(bytes.begin(), bytes.end());
  const std::string_view text(exact.data(), exact.size());
  decode(text);
  if (!made.ok()) return;
  const Font& font = made.value();
  measured(font, text);
  Input choices(surface);
  const auto has_pixels_of = [&](const Drawn& whole, const oracle::Touches& expected) {
    for_pixels(scene.window, [&](int x, int y) {
      const auto found = expected.find({y, x});
      require(whole.sink.writes(x, y) == (found == expected.end() ? 0 : found->second),
              "text: not the pixels of the glyphs");
    });
  };
  const Rect& window = scene.window;
  const oracle::Window seen{window.x, window.y, window.right(), window.bottom()};
  const Drawn whole = check(
      scene, choices, [&](auto& sink) { return draw_text(sink, font, top_left, text); }, INT_MAX);
  if (whole.status.ok())
    has_pixels_of(whole, oracle::text_pixels(oracle::utf8_by_definition(), font.tables(), top_left.x,
                                             top_left.y, text, seen));

  const Rect box{top_left.x, top_left.y, scene.clip.width, scene.clip.height};
  const int across = kind % 3;
  const int down = kind / 3 % 4;
  const auto baseline = std::array{Baseline::top, Baseline::middle, Baseline::bottom,
                                   Baseline::alphabetic}[static_cast<std::size_t>(down)];
  const Drawn aligned = check(
      scene, choices,
      [&](auto& sink) {
        return draw_aligned_text(sink, font, box, static_cast<Alignment>(across), baseline, text);
      },
      INT_MAX);
  if (aligned.status.ok())
    has_pixels_of(aligned,
                  oracle::aligned_text_pixels(oracle::utf8_by_definition(), font.tables(), box.x, box.y,
                                              box.width, box.height, across,
                                              down < 3 ? std::optional(down) : std::nullopt, text, seen));
}

}  // namespace fuzz
