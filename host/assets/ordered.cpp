// SPDX-License-Identifier: MIT
#include <host/assets/ordered.hpp>
#include <intaglio/image/bayer.hpp>

#include <algorithm>
#include <utility>

namespace host::assets {
namespace {

using Vector = std::array<int, 3>;

Vector vector(const Colour& colour) { return {colour[0], colour[1], colour[2]}; }
Vector difference(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
int dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
int light(const Colour& colour) { return colour[0] + colour[1] + colour[2]; }

constexpr int places = 64;

/// Two entries, and in how many places the second is shown.
struct Mixture {
  std::size_t dark;
  std::size_t bright;
  int share;
};

Mixture mixture(const Vector& colour, std::span<const Colour> palette) {
  const auto distance = [&](const Colour& entry) {
    const Vector off = difference(vector(entry), colour);
    return dot(off, off);
  };
  const auto nearest = static_cast<std::size_t>(
      std::min_element(palette.begin(), palette.end(),
                       [&](const Colour& a, const Colour& b) { return distance(a) < distance(b); }) -
      palette.begin());
  const Vector from = vector(palette[nearest]);
  const Vector wanted = difference(colour, from);
  Mixture best{nearest, nearest, 0};
  int least =
      places * places * dot(wanted, wanted);  // 64^2 * 3 * 255^2 at most, as all distances in the cube
  for (std::size_t i = 0; i < palette.size(); ++i) {
    const Vector way = difference(vector(palette[i]), from);
    const int length = dot(way, way);
    if (length == 0) continue;
    const int share = std::clamp((2 * places * dot(wanted, way) + length) / (2 * length), 0, places);
    int cost = share * (places - share) / 4 * length;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const int off = share * way[channel] - places * wanted[channel];
      cost += off * off;
    }
    if (cost >= least) continue;
    least = cost;
    best = {nearest, i, share};
  }
  if (light(palette[best.dark]) > light(palette[best.bright])) {
    std::swap(best.dark, best.bright);
    best.share = places - best.share;
  }
  return best;
}

}  // namespace

std::vector<std::uint8_t> dither_ordered(std::span<const std::uint8_t> rgba, std::size_t width,
                                         std::span<const Colour> palette) {
  std::vector<std::uint8_t> entries(rgba.size() / 4);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Mixture mixed = mixture({rgba[4 * i], rgba[4 * i + 1], rgba[4 * i + 2]}, palette);
    const auto place = static_cast<int>(
        intaglio::image::bayer_number(static_cast<unsigned>(i % width), static_cast<unsigned>(i / width), 3));
    entries[i] = static_cast<std::uint8_t>(place + mixed.share >= places ? mixed.bright : mixed.dark);
  }
  return entries;
}

}  // namespace host::assets
