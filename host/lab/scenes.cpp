// SPDX-License-Identifier: MIT
//
// What whole frames look like under each setting of a program's knobs.
//
// Rule: two frames are compared pixel by pixel, by the distance of their colours in L*a*b* (CIE 1976, D65) as
// the palettes of the frames say them. The reference is the same frame with every knob at its finest. Over
// all frames that are looked at: the mean of all pixels' distances, the largest one, and how many pixels
// differ.
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <firmware/lab/frames/digest.hpp>
#include <firmware/lab/frames/scene.hpp>
#include <fstream>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using lab::frames::Scene;
using lab::frames::Setting;
using nlohmann::ordered_json;

struct Lab {
  double l = 0, a = 0, b = 0;
};

double linear_of(std::uint8_t code) {
  const double c = code / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

Lab lab_of(std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
  const double r = linear_of(red);
  const double g = linear_of(green);
  const double b = linear_of(blue);
  const auto root = [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; };
  const double x = root((0.4124564 * r + 0.3575761 * g + 0.1804375 * b) / 0.95047);
  const double y = root(0.2126729 * r + 0.7151522 * g + 0.0721750 * b);
  const double z = root((0.0193339 * r + 0.1191920 * g + 0.9503041 * b) / 1.08883);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

double distance(const Lab& one, const Lab& other) {
  return std::hypot(one.l - other.l, one.a - other.a, one.b - other.b);
}

/// A frame as drawn.
struct Frame {
  std::vector<std::uint8_t> pixels;
  std::array<Lab, 256> colours{};
  std::vector<std::uint8_t> palette;
  std::uint32_t digest = 0;
};

Frame drawn(const Scene& scene, std::uint32_t number) {
  const intaglio::Status status = scene.draw(number);
  if (!status.ok()) throw std::runtime_error(std::string(scene.name) + " reports an error");
  Frame frame;
  const auto canvas = lab::frames::canvas();
  frame.pixels.assign(canvas.byte_at(0, 0),
                      canvas.byte_at(0, 0) + lab::frames::size.width * lab::frames::size.height);
  const auto palette = scene.palette();
  frame.palette.assign(palette.begin(), palette.end());
  frame.palette.resize(std::size_t{3} * 256);
  for (std::size_t i = 0; i < 256; ++i)
    frame.colours[i] = lab_of(frame.palette[3 * i], frame.palette[3 * i + 1], frame.palette[3 * i + 2]);
  frame.digest = lab::frames::digest(scene);
  return frame;
}

/// The frames of what the scene has begun with.
std::vector<Frame> all_frames(const Scene& scene) {
  std::vector<Frame> frames;
  frames.reserve(lab::frames::looked_at.size());
  for (const std::uint32_t number : lab::frames::looked_at) frames.push_back(drawn(scene, number));
  return frames;
}

std::vector<Frame> all_frames(const Scene& scene, int variant) {
  scene.start_variant(variant);
  return all_frames(scene);
}

/// How far frames are from those of the reference.
ordered_json difference(const std::vector<Frame>& frames, const std::vector<Frame>& finest) {
  double sum = 0;
  double worst = 0;
  std::int64_t differing = 0;
  std::int64_t count = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const bool same_colours = frames[i].palette == finest[i].palette;
    for (std::size_t p = 0; p < frames[i].pixels.size(); ++p) {
      ++count;
      if (same_colours && frames[i].pixels[p] == finest[i].pixels[p]) continue;
      const double d =
          distance(frames[i].colours[frames[i].pixels[p]], finest[i].colours[finest[i].pixels[p]]);
      sum += d;
      worst = std::max(worst, d);
      if (d > 0) ++differing;
    }
  }
  return {{"mean", sum / static_cast<double>(count)},
          {"worst", worst},
          {"wrong_ppm", 1e6 * static_cast<double>(differing) / static_cast<double>(count)}};
}

/// The setting of a variant.
Setting setting_of(const Scene& scene, int variant) {
  if (variant >= scene.fixed_count())
    return scene.settings.list[static_cast<std::size_t>(variant - scene.fixed_count())];
  Setting setting{};
  for (std::size_t k = 0; k < scene.knobs.size(); ++k)
    setting[k] = static_cast<std::uint8_t>(variant == 0 ? scene.knobs[k].standard : scene.knobs[k].finest);
  return setting;
}

ordered_json in_words(const Scene& scene, const Setting& setting) {
  ordered_json words = ordered_json::object();
  for (std::size_t k = 0; k < scene.knobs.size(); ++k)
    words[std::string(scene.knobs[k].name)] = scene.knobs[k].choices[setting[k]];
  return words;
}

/// All combinations of all choices; none without knobs.
std::vector<Setting> all_settings(const Scene& scene) {
  std::vector<Setting> settings;
  if (scene.knobs.empty()) return settings;
  std::vector<std::uint8_t> all(scene.knobs.size());
  std::iota(all.begin(), all.end(), std::uint8_t{0});
  Setting setting{};
  do settings.push_back(setting);
  while (lab::frames::next_combination(scene.knobs, all, setting));
  return settings;
}

ordered_json described(const Scene& scene) {
  const int finest_variant = scene.fixed_count() - 1;
  const std::vector<Frame> finest = all_frames(scene, finest_variant);
  ordered_json json{{"name", scene.name}, {"frames", lab::frames::looked_at}, {"fixed", scene.fixed_count()}};
  json["knobs"] = ordered_json::array();
  for (const auto& knob : scene.knobs)
    json["knobs"].push_back({{"name", knob.name},
                             {"choices", knob.choices},
                             {"standard", knob.choices[static_cast<std::size_t>(knob.standard)]},
                             {"finest", knob.choices[static_cast<std::size_t>(knob.finest)]},
                             {"explained", knob.explained}});
  json["parts"] = ordered_json::array();
  for (const auto& part : scene.parts) {
    ordered_json names = ordered_json::array();
    for (std::size_t i = 0; i < part.count; ++i) names.push_back(scene.knobs[part.knobs[i]].name);
    json["parts"].push_back(names);
  }
  json["variants"] = ordered_json::array();
  for (int variant = 0; variant < scene.variants(); ++variant) {
    const std::vector<Frame> frames = all_frames(scene, variant);
    ordered_json entry = difference(frames, finest);
    entry["setting"] = in_words(scene, setting_of(scene, variant));
    for (const Frame& frame : frames) entry["digests"].push_back(frame.digest);
    json["variants"].push_back(entry);
  }
  json["settings"] = ordered_json::array();
  for (const Setting& setting : all_settings(scene)) {
    scene.start(setting, 0);
    ordered_json entry = difference(all_frames(scene), finest);
    entry["setting"] = in_words(scene, setting);
    json["settings"].push_back(entry);
  }
  return json;
}

const Scene& scene_called(const std::string& name) {
  for (const Scene& scene : lab::frames::scenes())
    if (scene.name == name) return scene;
  throw std::runtime_error("no program '" + name + "'");
}

void write_picture(const Scene& scene, int variant, std::uint32_t number, const std::string& path) {
  if (variant < 0 || variant >= scene.variants()) throw std::runtime_error("no such variant");
  scene.start_variant(variant);
  const Frame frame = drawn(scene, number);
  std::ofstream file(path, std::ios::binary);
  file << "P6\n" << lab::frames::size.width << ' ' << lab::frames::size.height << "\n255\n";
  for (const std::uint8_t pixel : frame.pixels)
    for (std::size_t channel = 0; channel < 3; ++channel)
      file.put(static_cast<char>(frame.palette[std::size_t{3} * pixel + channel]));
  if (!file.flush()) throw std::runtime_error("can't write " + path);
}

}  // namespace

int main(int count, char** arguments) try {
  CLI::App program("What whole frames look like under each setting of a program's knobs");
  program.require_subcommand(1);
  std::string name;
  std::string path;
  int variant = 0;
  std::uint32_t number = 0;
  const CLI::App* const list =
      program.add_subcommand("list", "programs, knobs, and errors of all settings, as JSON");
  CLI::App* const picture = program.add_subcommand("picture", "one frame as a PPM");
  picture->add_option("program", name)->required();
  picture->add_option("variant", variant, "its number in `list`")->required();
  picture->add_option("frame", number)->required();
  picture->add_option("file", path)->required();
  CLI11_PARSE(program, count, arguments);
  if (list->parsed()) {
    ordered_json all = ordered_json::array();
    for (const Scene& scene : lab::frames::scenes()) all.push_back(described(scene));
    std::puts(all.dump(1).c_str());
  } else {
    write_picture(scene_called(name), variant, number, path);
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "lab-scenes: %s\n", error.what());
  return 1;
}
