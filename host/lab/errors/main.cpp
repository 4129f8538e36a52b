// SPDX-License-Identifier: MIT
//
// The command line of a family's program: what there is, how far off a rung is, and one input again.
#include <host/lab/errors/report.hpp>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <exception>

namespace {

using host::lab::FamilyReport;
using host::lab::RungReport;
using nlohmann::ordered_json;

std::string name_of(lab::number::Unit unit) {
  using enum lab::number::Unit;
  switch (unit) {
    case lsb:
      return "lsb";
    case lsb_q15:
      return "lsb of 2^-15";
    case lsb_q16:
      return "lsb of 2^-16";
    case pixel:
      return "pixels";
    case value:
      return "of the value";
    case ppm_of_value:
      return "ppm of the value";
    case wrong_pixel:
      return "wrong pixels";
    case wrong_ppm:
      return "wrong pixels per million";
    case coverage_level:
      return "levels of 255";
    case palette_level:
      return "palette levels";
    case cie76:
      return "CIE76";
    case angle_step:
      return "1/65536 turn";
  }
  throw std::runtime_error("a unit without a name");
}

ordered_json description(const FamilyReport& family) {
  ordered_json json{
      {"name", family.name}, {"title", family.title}, {"per", family.per}, {"default", family.default_rung}};
  for (const auto& load : family.loads) {
    json["loads"].push_back({{"name", load.name}, {"calls", load.calls}, {"units", load.units}});
  }
  for (const auto& rung : family.rungs) {
    ordered_json bounds;
    for (std::size_t load = 0; load < rung.bounds.size(); ++load) {
      if (rung.takes[load])
        bounds.push_back(rung.bounds[load].thousandths / 1000.0);
      else
        bounds.push_back(nullptr);
    }
    json["rungs"].push_back({{"name", rung.name},
                             {"slack", rung.slack},
                             {"domain", rung.domain},
                             {"unit", name_of(rung.bounds[0].unit)},
                             {"bounds", bounds}});
  }
  return json;
}

const RungReport& rung_called(const FamilyReport& family, const std::string& name) {
  for (const auto& rung : family.rungs) {
    if (rung.name == name) return rung;
  }
  throw std::runtime_error("no rung '" + name + "'");
}

int load_called(const FamilyReport& family, const std::string& name) {
  for (std::size_t i = 0; i < family.loads.size(); ++i) {
    if (family.loads[i].name == name) return static_cast<int>(i);
  }
  throw std::runtime_error("no load '" + name + "'");
}

ordered_json measured(const FamilyReport& family, const std::string& rung, const std::string& load,
                      bool full) {
  const auto found = rung_called(family, rung).measure(load_called(family, load), host::lab::Effort(full));
  return {{"worst", static_cast<double>(found.worst)},
          {"mean", static_cast<double>(found.mean)},
          {"worst_input", found.worst_input},
          {"points", found.points},
          {"how", found.how}};
}

/// Writes the canvas as a grey picture (PGM), the highest index white; nothing if nothing was drawn.
void write_canvas(const std::string& path) {
  const auto picture = lab::canvas();
  const auto size = picture.bounds();
  std::string levels;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) levels += static_cast<char>(picture.get(x, y));
  }
  const auto by_value = [](char a, char b) {
    return static_cast<unsigned char>(a) < static_cast<unsigned char>(b);
  };
  const int highest = static_cast<unsigned char>(*std::max_element(levels.begin(), levels.end(), by_value));
  if (highest == 0) return;
  for (char& level : levels) level = static_cast<char>(static_cast<unsigned char>(level) * 255 / highest);
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) throw std::runtime_error("can't write " + path);
  std::fprintf(file, "P5 %d %d 255\n", size.width, size.height);
  const bool written = std::fwrite(levels.data(), 1, levels.size(), file) == levels.size();
  if (std::fclose(file) != 0 || !written) throw std::runtime_error("can't write " + path);
}

}  // namespace

int main(int argc, char** argv) try {
  CLI::App app("Errors of one family of rungs; intaglio-lab calls this and writes the tables");
  app.require_subcommand(1);
  std::string rung;
  std::string load;
  std::string input;
  std::string file;
  bool full = false;

  const auto* list = app.add_subcommand("list", "Describes the family, as JSON");
  auto* measure = app.add_subcommand("measure", "Searches for the worst error of a rung under a load");
  auto* replay = app.add_subcommand("replay", "The error at one input, as a search has printed it");
  auto* picture =
      app.add_subcommand("picture", "What a rung draws under a load, as PGM; no file if it draws nothing");
  for (auto* command : {measure, replay, picture}) {
    command->add_option("rung", rung)->required();
    command->add_option("load", load)->required();
  }
  measure->add_flag("--full", full, "All points that the project promises, not only a sample");
  replay->add_option("input", input, "Integers, in one argument")->required();
  picture->add_option("file", file)->required();
  CLI11_PARSE(app, argc, argv);

  const FamilyReport family = host::lab::family_report();
  if (*list) {
    std::puts(description(family).dump(1).c_str());
  } else if (*measure) {
    std::puts(measured(family, rung, load, full).dump(1).c_str());
  } else if (*picture) {
    rung_called(family, rung).draw(load_called(family, load));
    write_canvas(file);
  } else {
    std::printf("%.12Lg\n", rung_called(family, rung).replay(load_called(family, load), input));
  }
  return 0;
} catch (const std::exception& e) {
  std::fprintf(stderr, "lab-errors: %s\n", e.what());
  return 1;
}
