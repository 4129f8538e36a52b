// SPDX-License-Identifier: MIT
//
// intaglio-assets polygons: the polygons of a GeoJSON file (RFC 7946) as rings of integers.
//
// A coordinate becomes the integer nearest to coordinate * scale (halves away from zero). The vertex that
// closes a ring and vertices that round to the one before are left out, and so are rings of fewer than three
// vertices that remain. Geometries other than polygons are passed over.
#include <host/assets/commands.hpp>
#include <host/assets/table.hpp>
#include <host/failure.hpp>
#include <host/file.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace host::assets {
namespace {

using nlohmann::json;

struct Vertex {
  std::int64_t x = 0;
  std::int64_t y = 0;
  bool operator==(const Vertex&) const = default;
};

struct Rings {
  std::vector<Vertex> vertices;
  std::vector<std::size_t> ring_lengths;
  std::vector<std::size_t> polygon_rings;
  std::size_t dropped = 0;
};

class Reader {
 public:
  explicit Reader(const PolygonOptions& options) : options_(options) {}

  Rings read() {
    const std::string text = read_file(options_.heading.source);
    const json document = json::parse(text, nullptr, false);
    if (document.is_discarded()) fail("is not JSON");
    if (!document.is_object() || !document.contains("type")) fail("is JSON but not GeoJSON");
    geometry_or_feature(document);
    if (rings_.vertices.empty()) fail("has no polygon with three vertices or more at this scale");
    return std::move(rings_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw Failure(options_.heading.source + ": " + what);
  }

  const json& member(const json& object, const char* name) const {
    const auto found = object.find(name);
    if (found == object.end()) fail(fmt::format("not GeoJSON: an object lacks \"{}\"", name));
    return *found;
  }

  const json& list(const json& value, const char* what) const {
    if (!value.is_array()) fail(fmt::format("not GeoJSON: {} is not a list", what));
    return value;
  }

  void geometry_or_feature(const json& object, int depth = 0) {
    constexpr int deepest = 64;
    if (depth > deepest) fail("collections are nested too deeply");
    if (object.is_null()) return;  // a feature without geometry
    if (!object.is_object()) fail("not GeoJSON: a geometry is not an object");
    const json& type = member(object, "type");
    if (type == "FeatureCollection") {
      for (const json& feature : list(member(object, "features"), "\"features\""))
        geometry_or_feature(feature, depth + 1);
    } else if (type == "GeometryCollection") {
      for (const json& part : list(member(object, "geometries"), "\"geometries\""))
        geometry_or_feature(part, depth + 1);
    } else if (type == "Feature") {
      geometry_or_feature(member(object, "geometry"), depth + 1);
    } else if (type == "Polygon") {
      polygon(member(object, "coordinates"));
    } else if (type == "MultiPolygon") {
      for (const json& part : list(member(object, "coordinates"), "a MultiPolygon")) polygon(part);
    }
  }

  void polygon(const json& value) {
    std::size_t count = 0;
    for (const json& part : list(value, "a polygon")) count += ring(part) ? 1U : 0U;
    if (count > 0) rings_.polygon_rings.push_back(count);
  }

  bool ring(const json& value) {
    std::vector<Vertex> vertices;
    for (const json& position : list(value, "a ring")) {
      if (!position.is_array() || position.size() < 2 || !position[0].is_number() || !position[1].is_number())
        fail("not GeoJSON: a position is not a list of two numbers");
      const Vertex vertex{scaled(position[0].get<double>()),
                          scaled(options_.y_down ? -position[1].get<double>() : position[1].get<double>())};
      if (vertices.empty() || !(vertices.back() == vertex)) vertices.push_back(vertex);
    }
    while (vertices.size() > 1 && vertices.back() == vertices.front()) vertices.pop_back();
    if (vertices.size() < 3) {
      ++rings_.dropped;
      return false;
    }
    rings_.vertices.insert(rings_.vertices.end(), vertices.begin(), vertices.end());
    rings_.ring_lengths.push_back(vertices.size());
    return true;
  }

  std::int64_t scaled(double value) const {
    const double product = std::round(value * options_.scale);
    constexpr double limit = 1 << 28U;  // the domain of sub-pixel coordinates
    if (!(std::fabs(product) <= limit))
      fail(fmt::format("coordinate {} leaves the range of 2^28 at this scale", value));
    return static_cast<std::int64_t>(product);
  }

  const PolygonOptions& options_;
  Rings rings_;
};

}  // namespace

std::string polygon_header(const PolygonOptions& options) {
  const Heading& heading = options.heading;
  const Rings rings = Reader(options).read();
  Vertex lowest = rings.vertices.front();
  Vertex highest = lowest;
  for (const Vertex& v : rings.vertices) {
    lowest = {std::min(lowest.x, v.x), std::min(lowest.y, v.y)};
    highest = {std::max(highest.x, v.x), std::max(highest.y, v.y)};
  }
  constexpr std::int64_t short_limit = std::numeric_limits<std::int16_t>::max();
  const bool is_short = -lowest.x <= short_limit && -lowest.y <= short_limit && highest.x <= short_limit &&
                        highest.y <= short_limit;
  const auto pair = [](const Vertex& v) { return fmt::format("{{{}, {}}}", v.x, v.y); };

  std::string out = head_comment(
      heading, "polygons",
      fmt::format("{} polygons, {} rings, {} vertices; {} units in a unit of the source, y grows {}.\n"
                  "{} rings too small for this scale are left out.",
                  rings.polygon_rings.size(), rings.ring_lengths.size(), rings.vertices.size(), options.scale,
                  options.y_down ? "downwards" : "upwards", rings.dropped));
  out += "#include <cstdint>\n\n";
  out += fmt::format("namespace {}::{} {{\n\n", heading.name_space, heading.name);
  out += fmt::format("struct Vertex {{\n  {0} x;\n  {0} y;\n}};\n\n",
                     is_short ? "std::int16_t" : "std::int32_t");
  out += fmt::format("inline constexpr Vertex lowest{};\ninline constexpr Vertex highest{};\n\n",
                     pair(lowest), pair(highest));
  out += "/// Rings of each polygon: its border, then its holes.\n";
  out += array("int", "polygon_rings", rings.polygon_rings.size(),
               [&](std::size_t i) { return fmt::format("{}", rings.polygon_rings[i]); });
  out += "\n/// Vertices of each ring; the last is joined to the first.\n";
  out += array("int", "ring_lengths", rings.ring_lengths.size(),
               [&](std::size_t i) { return fmt::format("{}", rings.ring_lengths[i]); });
  out += '\n';
  out += array("Vertex", "vertices", rings.vertices.size(),
               [&](std::size_t i) { return pair(rings.vertices[i]); });
  out += fmt::format("\n}}  // namespace {}::{}\n", heading.name_space, heading.name);
  return out;
}

}  // namespace host::assets
