// SPDX-License-Identifier: MIT
#include <host/failure.hpp>
#include <host/file.hpp>
#include <host/png.hpp>

#include <algorithm>
#include <cstddef>
#include <png.h>

namespace host {
namespace {

/// libpng's picture state, freed on every way out.
struct PngImage {
  png_image image{};
  PngImage() { image.version = PNG_IMAGE_VERSION; }
  PngImage(const PngImage&) = delete;
  PngImage& operator=(const PngImage&) = delete;
  ~PngImage() { png_image_free(&image); }
};

}  // namespace

std::string encode_png(const IndexedPicture& picture) {
  const auto entries = picture.palette_rgb.size() / 3;
  const auto pixels = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
  if (picture.width < 1 || picture.height < 1 || picture.indices.size() != pixels || entries < 1 ||
      entries > 256 || *std::max_element(picture.indices.begin(), picture.indices.end()) >= entries)
    throw Failure("a picture without pixels, or with an index that has no colour, can't be a PNG");
  PngImage png;
  png.image.width = static_cast<png_uint_32>(picture.width);
  png.image.height = static_cast<png_uint_32>(picture.height);
  png.image.format = PNG_FORMAT_RGB_COLORMAP;
  png.image.colormap_entries = static_cast<png_uint_32>(entries);
  png_alloc_size_t size = 0;
  std::string bytes;
  // Asked for the size first, then for the bytes.
  for (int pass = 0; pass < 2; ++pass) {
    if (png_image_write_to_memory(&png.image, pass == 0 ? nullptr : bytes.data(), &size, 0,
                                  picture.indices.data(), 0, picture.palette_rgb.data()) == 0)
      throw Failure(std::string("PNG: ") + png.image.message);
    bytes.resize(size);
  }
  return bytes;
}

RgbaPicture read_png(const std::string& path) {
  const std::string bytes = read_file(path);
  PngImage png;
  if (png_image_begin_read_from_memory(&png.image, bytes.data(), bytes.size()) == 0)
    throw Failure(path + ": not a PNG that can be read (" + png.image.message + ")");
  constexpr std::size_t most_pixels = std::size_t{1} << 26U;
  if (std::size_t{png.image.width} * png.image.height > most_pixels)
    throw Failure(path + ": has more than 2^26 pixels");
  png.image.format = PNG_FORMAT_RGBA;
  RgbaPicture picture{static_cast<int>(png.image.width), static_cast<int>(png.image.height), {}};
  picture.rgba.resize(PNG_IMAGE_SIZE(png.image));
  if (png_image_finish_read(&png.image, nullptr, picture.rgba.data(), 0, nullptr) == 0)
    throw Failure(path + ": damaged PNG (" + png.image.message + ")");
  return picture;
}

}  // namespace host
