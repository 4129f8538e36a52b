// SPDX-License-Identifier: MIT
//
// intaglio-assets image: a PNG as an indexed picture and its palette.
//
// A picture that has no more colours than allowed keeps them exactly, numbered in the order in which they
// first appear; others are reduced by libimagequant, and dithered by it or by ordered.hpp. Pixels less than
// half opaque become one more index, `transparent`, for blits with a colour key.
#include <host/assets/commands.hpp>
#include <host/assets/ordered.hpp>
#include <host/assets/table.hpp>
#include <host/failure.hpp>
#include <host/png.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <libimagequant.h>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace host::assets {
namespace {

struct Indexed {
  std::vector<std::uint8_t> indices;
  std::vector<Colour> palette;
  std::optional<std::size_t> transparent;
};

bool is_opaque(const RgbaPicture& picture, std::size_t pixel) { return picture.rgba[4 * pixel + 3] >= 128; }

Colour colour_at(const RgbaPicture& picture, std::size_t pixel) {
  return {picture.rgba[4 * pixel], picture.rgba[4 * pixel + 1], picture.rgba[4 * pixel + 2]};
}

/// The picture with its own colours, or nothing if there are more than `most`.
std::optional<Indexed> index_exactly(const RgbaPicture& picture, std::size_t pixels, std::size_t most) {
  Indexed out;
  out.indices.resize(pixels);
  std::map<Colour, std::uint8_t> known;
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    if (!is_opaque(picture, pixel)) continue;
    const Colour colour = colour_at(picture, pixel);
    auto found = known.find(colour);
    if (found == known.end()) {
      if (out.palette.size() == most) return std::nullopt;
      found = known.emplace(colour, static_cast<std::uint8_t>(out.palette.size())).first;
      out.palette.push_back(colour);
    }
    out.indices[pixel] = found->second;
  }
  return out;
}

void check(liq_error error) {
  if (error != LIQ_OK)
    throw Failure(fmt::format("libimagequant fails with code {}", static_cast<int>(error)));
}

template <class T>
using Owned = std::unique_ptr<T, void (*)(T*)>;

Indexed quantise(const RgbaPicture& picture, std::size_t pixels, std::size_t most,
                 const ImageOptions& options) {
  std::vector<std::uint8_t> opaque = picture.rgba;
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) opaque[4 * pixel + 3] = 255;
  const Owned<liq_attr> attributes(liq_attr_create(), liq_attr_destroy);
  check(liq_set_max_colors(attributes.get(), static_cast<int>(std::max<std::size_t>(most, 2))));
  const Owned<liq_image> image(
      liq_image_create_rgba(attributes.get(), opaque.data(), picture.width, picture.height, 0),
      liq_image_destroy);
  liq_result* raw = nullptr;
  check(liq_image_quantize(image.get(), attributes.get(), &raw));
  const Owned<liq_result> result(raw, liq_result_destroy);
  check(liq_set_dithering_level(result.get(), static_cast<float>(options.dither)));
  Indexed out;
  out.indices.resize(pixels);
  check(liq_write_remapped_image(result.get(), image.get(), out.indices.data(), out.indices.size()));
  const liq_palette* const palette = liq_get_palette(result.get());
  for (unsigned i = 0; i < palette->count; ++i)
    out.palette.push_back({palette->entries[i].r, palette->entries[i].g, palette->entries[i].b});
  if (options.ordered)
    out.indices = dither_ordered(picture.rgba, static_cast<std::size_t>(picture.width), out.palette);
  return out;
}

Indexed index_picture(const RgbaPicture& picture, const ImageOptions& options) {
  const auto pixels = picture.rgba.size() / 4;
  const std::size_t room = std::size_t{1} << static_cast<unsigned>(options.bits);
  std::size_t most = options.colours == 0 ? room : static_cast<std::size_t>(options.colours);
  if (most > room)
    throw Failure(
        fmt::format("{}: {} colours don't fit {} bits a pixel", options.heading.source, most, options.bits));
  bool holes = false;
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) holes = holes || !is_opaque(picture, pixel);
  if (holes) --most;
  std::optional<Indexed> exact = index_exactly(picture, pixels, most);
  if (!exact && most < 2)
    throw Failure(fmt::format("{}: more than one colour beside the transparent one needs more than 2 entries",
                              options.heading.source));
  Indexed out = exact ? *exact : quantise(picture, pixels, most, options);
  if (holes) {
    out.transparent = out.palette.size();
    out.palette.push_back({0, 0, 0});
    for (std::size_t pixel = 0; pixel < pixels; ++pixel)
      if (!is_opaque(picture, pixel)) out.indices[pixel] = static_cast<std::uint8_t>(*out.transparent);
  }
  return out;
}

/// Rows of packed pixels, each beginning at a byte.
std::vector<std::uint8_t> pack(const Indexed& picture, std::size_t width, std::size_t height, unsigned bits,
                               bool lsb_first) {
  const std::size_t per_byte = 8 / bits;
  const std::size_t stride = (width + per_byte - 1) / per_byte;
  std::vector<std::uint8_t> bytes(stride * height);
  for (std::size_t y = 0; y < height; ++y)
    for (std::size_t x = 0; x < width; ++x) {
      const std::size_t slot = lsb_first ? x % per_byte : per_byte - 1 - x % per_byte;
      bytes[y * stride + x / per_byte] |=
          static_cast<std::uint8_t>(picture.indices[y * width + x] << (slot * bits));
    }
  return bytes;
}

}  // namespace

std::string image_header(const ImageOptions& options) {
  const Heading& heading = options.heading;
  const RgbaPicture source = read_png(heading.source);
  const Indexed picture = index_picture(source, options);
  const std::vector<std::uint8_t> bytes =
      pack(picture, static_cast<std::size_t>(source.width), static_cast<std::size_t>(source.height),
           static_cast<unsigned>(options.bits), options.lsb_first);

  std::string out =
      head_comment(heading, "image",
                   fmt::format("{}x{} pixels of {} bits, {} colours, {} bytes.", source.width, source.height,
                               options.bits, picture.palette.size(), bytes.size()));
  out += "#include <intaglio/image/surface.hpp>\n\n#include <cstdint>\n\n";
  out += fmt::format("namespace {}::{} {{\n\n", heading.name_space, heading.name);
  out += fmt::format("using Format = ::intaglio::image::Indexed<{}, ::intaglio::image::BitOrder::{}>;\n\n",
                     options.bits, options.lsb_first ? "lsb_first" : "msb_first");
  out += "/// Red, green, blue of each index.\n";
  out += array("std::uint8_t", "palette", 3 * picture.palette.size(),
               [&](std::size_t i) { return fmt::format("{}", picture.palette[i / 3][i % 3]); });
  if (picture.transparent)
    out += fmt::format(
        "\n/// The index that shows what lies below.\ninline constexpr unsigned transparent = {};\n",
        *picture.transparent);
  out += '\n';
  out += array("std::uint8_t", "pixels", bytes.size(),
               [&](std::size_t i) { return fmt::format("{:#04x}", bytes[i]); });
  out += fmt::format(
      "\ninline constexpr ::intaglio::Result<::intaglio::image::Picture<Format>> view =\n"
      "    ::intaglio::image::Picture<Format>::over(pixels, {{{}, {}}});\n"
      "static_assert(view.ok());\n"
      "inline constexpr ::intaglio::image::Picture<Format> picture = view.value();\n\n"
      "}}  // namespace {}::{}\n",
      source.width, source.height, heading.name_space, heading.name);
  return out;
}

}  // namespace host::assets
