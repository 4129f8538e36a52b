// SPDX-License-Identifier: MIT
//
// The readers of the asset compiler: fonts, pictures, polygons and lists of characters. A file is a table, or
// an error that names it.
#include <host/assets/charset.hpp>
#include <host/assets/commands.hpp>
#include <host/failure.hpp>
#include <host/png.hpp>
#include <tests/fuzz/input.hpp>

#include <algorithm>
#include <stdexcept>
#include <sys/mman.h>
#include <unistd.h>
#include <vector>
#include <zlib.h>

namespace fuzz {
namespace {

/// A file in memory that has a name.
class File {
 public:
  explicit File(std::string_view content) : descriptor_(memfd_create("input", 0)) {
    if (descriptor_ < 0 ||
        write(descriptor_, content.data(), content.size()) != static_cast<ssize_t>(content.size()))
      throw std::runtime_error("no memory for a file");
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() { close(descriptor_); }
  [[nodiscard]] std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

/// Calls what may throw a Failure that names the file (or the option, `charset`).
template <class Make>
void attempt(const std::string& path, Make make) {
  try {
    const std::string header = make();
    require(header.find("#pragma once") != std::string::npos, "a header that isn't one");
  } catch (const host::Failure& failure) {
    const std::string_view what = failure.what();
    require(what.starts_with(path) || what.starts_with("char") || what.starts_with("libimagequant"),
            "an error that doesn't name the file");
  }
}

/// A PNG whose chunks have the right check sums; else nothing gets further than those.
std::string mended_png(std::string_view bytes) {
  std::string png(bytes);
  const auto byte = [&](std::size_t i) {
    return static_cast<std::size_t>(static_cast<unsigned char>(png[i]));
  };
  for (std::size_t at = 8; at + 12 <= png.size();) {
    const std::size_t length = byte(at) << 24U | byte(at + 1) << 16U | byte(at + 2) << 8U | byte(at + 3);
    if (length > png.size() - at - 12) break;
    const auto sum =
        crc32(0, reinterpret_cast<const Bytef*>(png.data() + at + 4), static_cast<uInt>(length + 4));
    for (std::size_t i = 0; i < 4; ++i)
      png[at + 8 + length + i] = static_cast<char>(static_cast<unsigned char>(sum >> (24U - 8U * i) & 255U));
    at += 12 + length;
  }
  return png;
}

host::assets::ImageOptions image_options(Input& in) {
  host::assets::ImageOptions options;
  options.heading = {{}, "author", "MIT", "picture", "pictures"};
  options.bits = 1 << in.choice(4);
  const int colours = in.choice(258);
  options.colours = colours < 2 ? 0 : colours;
  options.lsb_first = in.choice(2) == 1;
  options.dither = in.choice(2);
  return options;
}

void image(Input& in) {
  auto options = image_options(in);
  const File file(mended_png(in.rest_as_text()));
  // A picture of few bytes may have many pixels: those are a test of memory.
  try {
    const auto picture = host::read_png(file.path());
    if (picture.rgba.size() > std::size_t{1} << 16U) return;
  } catch (const host::Failure&) {
  }
  options.heading.source = file.path();
  attempt(file.path(), [&] { return image_header(options); });
}

/// What was written as a PNG is read as it was.
void round_trip(Input& in) {
  auto options = image_options(in);
  host::IndexedPicture picture;
  picture.width = 1 + in.choice(20);
  picture.height = 1 + in.choice(20);
  const int entries = 1 + in.choice(256);
  for (int i = 0; i < 3 * entries; ++i) picture.palette_rgb.push_back(static_cast<std::uint8_t>(in.byte()));
  for (int i = 0; i < picture.width * picture.height; ++i)
    picture.indices.push_back(static_cast<std::uint8_t>(in.choice(entries)));
  const File file(host::encode_png(picture));
  const auto read = host::read_png(file.path());
  require(read.width == picture.width && read.height == picture.height, "a PNG of another size");
  for (std::size_t i = 0; i < picture.indices.size(); ++i)
    for (std::size_t c = 0; c < 4; ++c)
      require(read.rgba[4 * i + c] == (c < 3 ? picture.palette_rgb[picture.indices[i] * 3U + c] : 255),
              "a PNG of other colours");
  options.heading.source = file.path();
  attempt(file.path(), [&] { return image_header(options); });
}

void polygons(Input& in) {
  host::assets::PolygonOptions options;
  options.heading = {{}, {}, {}, "land", "polygons"};
  options.scale = in.byte() + 1;
  options.y_down = in.choice(2) == 0;
  const File file(in.rest_as_text());
  options.heading.source = file.path();
  attempt(file.path(), [&] { return polygon_header(options); });
}

void font(Input& in) {
  host::assets::FontOptions options;
  options.heading = {{}, {}, {}, "face", "fonts"};
  options.pixel_size = in.choice(2) == 0 ? 0 : 4 + in.choice(40);
  options.tight = in.choice(2) == 0;
  options.charset = in.choice(2) == 0 ? "0x41" : "0x20-0x22,48";
  const File file(in.rest_as_text());
  options.heading.source = file.path();
  attempt(file.path(), [&] { return font_header(options); });
}

void charset(Input& in) {
  const std::string_view list = in.rest_as_text();
  try {
    const auto codes = host::assets::parse_charset(list);
    require(codes.empty() || *codes.rbegin() <= 0x10FFFF, "a code point that doesn't exist");
  } catch (const host::Failure& failure) {
    require(std::string_view(failure.what()).starts_with("charset: "),
            "an error that doesn't name the option");
  }
  try {
    (void)host::assets::code_points(list);
  } catch (const host::Failure& failure) {
    require(std::string_view(failure.what()).starts_with("chars: "), "an error that doesn't name the option");
  }
}

}  // namespace

void run(Input in) {
  switch (in.choice(5)) {
    case 0:
      return image(in);
    case 1:
      return round_trip(in);
    case 2:
      return polygons(in);
    case 3:
      return font(in);
    default:
      return charset(in);
  }
}

}  // namespace fuzz
