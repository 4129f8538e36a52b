// SPDX-License-Identifier: MIT
#include <host/draw/sprite.hpp>
#include <host/png.hpp>
#include <intaglio/image/blit.hpp>
#include <intaglio/image/dither.hpp>
#include <intaglio/image/nearest.hpp>
#include <intaglio/image/rotate_rungs.hpp>
#include <intaglio/image/rotozoom.hpp>
#include <intaglio/image/scale.hpp>
#include <intaglio/image/scale_rungs.hpp>
#include <intaglio/image/three_shear.hpp>

#include <algorithm>
#include <span>
#include <unordered_map>

namespace host::draw {
namespace {

namespace image = intaglio::image;
using image::Indexed8;
using intaglio::Argument;
using intaglio::Error;
using intaglio::Result;
using intaglio::Status;
using Values = std::vector<std::uint8_t>;

/// Does it make values that the file hasn't?
bool mixes(SpriteMethod method) {
  return method == SpriteMethod::stretch_bilinear || method == SpriteMethod::stretch_box ||
         method == SpriteMethod::turn_bilinear;
}

Status show(const Sprite& sprite, const image::Picture<Indexed8>& source,
            const image::Surface<Indexed8>& target) {
  const linear::Point corner{sprite.area.x, sprite.area.y};
  switch (sprite.method) {
    case SpriteMethod::copy:
      return image::blit(target, corner, source);
    case SpriteMethod::stretch:
      return image::ScaleNearest{}(target, sprite.area, source);
    case SpriteMethod::stretch_bilinear:
      return image::ScaleBilinear8{}(target, sprite.area, source);
    case SpriteMethod::stretch_box:
      return image::ScaleBox{}(target, sprite.area, source);
    default:
      break;
  }
  // Only a corner in the domain can be given in sub-pixels.
  if (!linear::in_domain(corner)) return {Error::out_of_domain, Argument::position};
  const linear::Size size = source.size();
  const linear::SubPoint middle{linear::subpixel_one / 2 * (size.width - 1),
                                linear::subpixel_one / 2 * (size.height - 1)};
  const linear::SubPoint corner_place = linear::to_subpixel(corner);
  const linear::SubPoint position{corner_place.x + middle.x, corner_place.y + middle.y};
  const image::ThreeShear turn{position, middle, sprite.angle};
  if (sprite.method == SpriteMethod::shear) return image::RotateThreeShear{}(target, turn, source);
  if (sprite.method == SpriteMethod::turn_bilinear) return image::RotateBilinear{}(target, turn, source);
  using intaglio::number::Fixed;
  const auto scale =
      Fixed<16>::from_raw(sprite.scale * (Fixed<16>::from_int(1).raw() / linear::subpixel_one));
  return image::blit_rotozoom(target, {position, middle, sprite.angle, scale}, source);
}

template <class Rung>
Status dither_by(const image::Surface<Indexed8>& target, const image::Picture<Indexed8>& greys, int levels) {
  std::vector<std::int16_t> memory(static_cast<std::size_t>(Rung::memory(greys.size().width)));
  return image::blit_dithered<Rung>(target, {0, 0}, greys, levels, memory);
}

Status dither(const SpriteDither& by, const image::Surface<Indexed8>& target,
              const image::Picture<Indexed8>& greys) {
  switch (by.method) {
    case DitherMethod::bayer2:
      return dither_by<image::DitherOrdered2>(target, greys, by.levels);
    case DitherMethod::bayer4:
      return dither_by<image::DitherOrdered4>(target, greys, by.levels);
    case DitherMethod::bayer8:
      return dither_by<image::DitherOrdered8>(target, greys, by.levels);
    case DitherMethod::three_tap:
      return dither_by<image::DitherThreeTap>(target, greys, by.levels);
    case DitherMethod::four_tap:
      return dither_by<image::DitherFourTap>(target, greys, by.levels);
    case DitherMethod::serpentine:
      return dither_by<image::DitherSerpentine>(target, greys, by.levels);
    default:
      return dither_by<image::DitherNone>(target, greys, by.levels);
  }
}

/// What a sprite shows on a canvas: red, green, blue, opacity, row by row.
class Shown {
 public:
  Shown(const Sprite& sprite, linear::Size canvas) : sprite_(&sprite), canvas_(canvas) {}

  /// Draws the channels.
  Status draw() {
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      channels_[i].assign(static_cast<std::size_t>(canvas_.width) * static_cast<std::size_t>(canvas_.height),
                          0);
      const Values values = source(i);
      const auto from = image::Picture<Indexed8>::over(values, sprite_->picture->size);
      const auto target = image::Surface<Indexed8>::over(channels_[i], canvas_);
      if (!from.ok()) return from.status();
      if (!target.ok()) return target.status();
      if (const Status status = show(*sprite_, from.value(), target.value()); !status.ok()) return status;
    }
    return {};
  }
  /// The pixel of each index, below 0 where it is hidden.
  Result<std::vector<std::int16_t>> indices() const {
    return sprite_->dither ? dithered(*sprite_->dither) : nearest();
  }

 private:
  /// A channel as it is drawn: weighted by opacity where colours are mixed.
  [[nodiscard]] Values source(std::size_t channel) const {
    const auto& channels = sprite_->picture->channels;
    Values values = channels[channel];
    if (!mixes(sprite_->method) || channel == 3) return values;
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = static_cast<std::uint8_t>((values[i] * channels[3][i] + 127) / 255);
    return values;
  }
  [[nodiscard]] bool hidden(std::size_t pixel) const { return channels_[3][pixel] < 128; }
  [[nodiscard]] image::Rgb colour(std::size_t pixel) const {
    const int opacity = channels_[3][pixel];
    const auto value = [&](const Values& values) {
      const int drawn = values[pixel];
      return static_cast<std::uint8_t>(
          mixes(sprite_->method) ? std::min((drawn * 255 + opacity / 2) / opacity, 255) : drawn);
    };
    return {value(channels_[0]), value(channels_[1]), value(channels_[2])};
  }

  [[nodiscard]] std::vector<std::int16_t> nearest() const {
    std::vector<std::int16_t> indices(channels_[3].size(), -1);
    std::unordered_map<int, std::uint8_t> known;
    for (std::size_t i = 0; i < indices.size(); ++i) {
      if (hidden(i)) continue;
      const image::Rgb rgb = colour(i);
      const auto [entry, is_new] = known.try_emplace(rgb.r * 65536 + rgb.g * 256 + rgb.b);
      if (is_new) entry->second = image::nearest_entry(sprite_->palette, rgb);
      indices[i] = entry->second;
    }
    return indices;
  }
  [[nodiscard]] Result<std::vector<std::int16_t>> dithered(const SpriteDither& by) const {
    Values greys(channels_[3].size());
    for (std::size_t i = 0; i < greys.size(); ++i) {
      if (hidden(i)) continue;
      const image::Rgb rgb = colour(i);
      greys[i] = static_cast<std::uint8_t>((54 * rgb.r + 183 * rgb.g + 19 * rgb.b + 128) / 256);
    }
    Values levels(greys.size());
    const auto source = image::Picture<Indexed8>::over(greys, canvas_);
    const auto target = image::Surface<Indexed8>::over(levels, canvas_);
    if (!source.ok()) return source.status();
    if (!target.ok()) return target.status();
    const Status status = dither(by, target.value(), source.value());
    if (!status.ok()) return status;
    std::vector<std::int16_t> indices(levels.size(), -1);
    for (std::size_t i = 0; i < levels.size(); ++i)
      if (!hidden(i)) indices[i] = levels[i];
    return indices;
  }

  const Sprite* sprite_;
  linear::Size canvas_;
  std::array<Values, 4> channels_;
};

}  // namespace

std::shared_ptr<const SpritePicture> read_sprite(const std::string& path) {
  const RgbaPicture file = read_png(path);
  auto sprite = std::make_shared<SpritePicture>();
  sprite->size = {file.width, file.height};
  for (std::size_t i = 0; i < file.rgba.size(); ++i) sprite->channels[i % 4].push_back(file.rgba[i]);
  return sprite;
}

Result<SpriteImage> SpriteImage::create(const Sprite& sprite, linear::Size canvas) {
  Shown shown(sprite, canvas);
  if (const Status status = shown.draw(); !status.ok()) return status;
  auto indices = shown.indices();
  if (!indices.ok()) return indices.status();
  SpriteImage image;
  image.width_ = canvas.width;
  image.indices_ = std::move(indices.value());
  return image;
}

}  // namespace host::draw
