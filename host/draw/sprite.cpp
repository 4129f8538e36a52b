// SPDX-License-Identifier: MIT
#include <host/draw/sprite.hpp>
#include <host/png.hpp>
#include <intaglio/image/blit.hpp>
#include <intaglio/image/nearest.hpp>
#include <intaglio/image/rotozoom.hpp>
#include <intaglio/image/scale.hpp>
#include <intaglio/image/three_shear.hpp>

namespace host::draw {
namespace {

namespace image = intaglio::image;
using image::Indexed1;
using image::Indexed8;
using intaglio::Argument;
using intaglio::Error;
using intaglio::Result;
using intaglio::Status;

Status show(const Sprite& sprite, const image::Surface<Indexed8>& target) {
  const SpritePicture& picture = *sprite.picture;
  const auto source = image::Picture<Indexed8>::over(picture.indices, picture.size);
  const auto mask = image::Picture<Indexed1>::over(picture.mask, picture.size);
  if (!source.ok()) return source.status();
  if (!mask.ok()) return mask.status();
  const image::Masked rule{mask.value()};
  const linear::Point corner{sprite.area.x, sprite.area.y};
  if (sprite.method == SpriteMethod::copy) return image::blit(target, corner, source.value(), rule);
  if (sprite.method == SpriteMethod::stretch)
    return image::blit_scaled(target, sprite.area, source.value(), rule);
  // Only a corner in the domain can be given in sub-pixels.
  if (!linear::in_domain(corner)) return {Error::out_of_domain, Argument::position};
  const linear::SubPoint middle{linear::subpixel_one / 2 * (picture.size.width - 1),
                                linear::subpixel_one / 2 * (picture.size.height - 1)};
  const linear::SubPoint corner_place = linear::to_subpixel(corner);
  const linear::SubPoint position{corner_place.x + middle.x, corner_place.y + middle.y};
  if (sprite.method == SpriteMethod::shear)
    return image::blit_three_shear(target, {position, middle, sprite.angle}, source.value(), rule);
  using intaglio::number::Fixed;
  const auto scale =
      Fixed<16>::from_raw(sprite.scale * (Fixed<16>::from_int(1).raw() / linear::subpixel_one));
  return image::blit_rotozoom(target, {position, middle, sprite.angle, scale}, source.value(), rule);
}

}  // namespace

std::shared_ptr<const SpritePicture> read_sprite(const std::string& path,
                                                 std::span<const std::uint8_t> palette) {
  const RgbaPicture file = read_png(path);
  auto sprite = std::make_shared<SpritePicture>();
  sprite->size = {file.width, file.height};
  const auto width = static_cast<std::size_t>(file.width);
  const std::size_t mask_stride = (width + 7) / 8;
  sprite->mask.resize(mask_stride * static_cast<std::size_t>(file.height));
  const std::span<const std::uint8_t> rgba(file.rgba);
  for (std::size_t pixel = 0; 4 * pixel < rgba.size(); ++pixel) {
    const auto rgb = rgba.subspan(4 * pixel, 3);
    sprite->indices.push_back(image::nearest_entry(palette, {rgb[0], rgb[1], rgb[2]}));
    const std::size_t column = pixel % width;
    if (rgba[4 * pixel + 3] >= 128)
      sprite->mask[pixel / width * mask_stride + column / 8] |= static_cast<std::uint8_t>(128U >> column % 8);
  }
  return sprite;
}

Result<SpriteImage> SpriteImage::create(const Sprite& sprite, linear::Size canvas) {
  SpriteImage image;
  image.width_ = canvas.width;
  const auto pixels = static_cast<std::size_t>(canvas.width) * static_cast<std::size_t>(canvas.height);
  image.on_zeros_.assign(pixels, 0);
  image.on_ones_.assign(pixels, 255);
  for (auto* const ground : {&image.on_zeros_, &image.on_ones_}) {
    const auto target = image::Surface<Indexed8>::over(*ground, canvas);
    if (!target.ok()) return target.status();
    const Status status = show(sprite, target.value());
    if (!status.ok()) return status;
  }
  return image;
}

}  // namespace host::draw
