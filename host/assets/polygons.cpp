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

/// One polygon's part of the lists, and its bounding box.
struct Polygon {
  std::size_t first_vertex = 0;
  std::size_t vertex_count = 0;
  std::size_t first_contour = 0;
  std::size_t contour_count = 0;
  Vertex lowest{};
  Vertex highest{};
};

struct Rings {
  std::vector<Vertex> vertices;
  std::vector<std::size_t> contour_lengths;
  std::vector<Polygon> polygons;
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
    Polygon added{.first_vertex = rings_.vertices.size(), .first_contour = rings_.contour_lengths.size()};
    for (const json& part : list(value, "a polygon")) ring(part);
    added.vertex_count = rings_.vertices.size() - added.first_vertex;
    added.contour_count = rings_.contour_lengths.size() - added.first_contour;
    if (added.vertex_count == 0) return;
    added.lowest = added.highest = rings_.vertices[added.first_vertex];
    for (std::size_t i = 0; i < added.vertex_count; ++i) {
      const Vertex v = rings_.vertices[added.first_vertex + i];
      added.lowest = {std::min(added.lowest.x, v.x), std::min(added.lowest.y, v.y)};
      added.highest = {std::max(added.highest.x, v.x), std::max(added.highest.y, v.y)};
    }
    rings_.polygons.push_back(added);
  }

  void ring(const json& value) {
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
      return;
    }
    rings_.vertices.insert(rings_.vertices.end(), vertices.begin(), vertices.end());
    rings_.contour_lengths.push_back(vertices.size());
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
  std::size_t largest = 0;
  for (const Polygon& p : rings.polygons) {
    lowest = {std::min(lowest.x, p.lowest.x), std::min(lowest.y, p.lowest.y)};
    highest = {std::max(highest.x, p.highest.x), std::max(highest.y, p.highest.y)};
    largest = std::max(largest, p.vertex_count);
  }
  constexpr std::int64_t short_limit = std::numeric_limits<std::int16_t>::max();
  const bool is_short = -lowest.x <= short_limit && -lowest.y <= short_limit && highest.x <= short_limit &&
                        highest.y <= short_limit;
  const auto pair = [](const Vertex& v) { return fmt::format("{{{}, {}}}", v.x, v.y); };

  std::string out = head_comment(
      heading, "polygons",
      fmt::format("{} polygons, {} contours, {} vertices; {} units in a unit of the source, y grows {}.\n"
                  "{} contours too small for this scale are left out.",
                  rings.polygons.size(), rings.contour_lengths.size(), rings.vertices.size(), options.scale,
                  options.y_down ? "downwards" : "upwards", rings.dropped));
  out += "#include <cstdint>\n\n";
  out += fmt::format("namespace {}::{} {{\n\n", heading.name_space, heading.name);
  out += fmt::format("struct Vertex {{\n  {0} x;\n  {0} y;\n}};\n\n",
                     is_short ? "std::int16_t" : "std::int32_t");
  out +=
      "/// One polygon: where its vertices and contours (its border, then its holes) stand, and its bounding "
      "box.\n"
      "struct Polygon {\n"
      "  std::int32_t first_vertex, vertex_count, first_contour, contour_count;\n"
      "  std::int32_t min_x, min_y, max_x, max_y;\n"
      "};\n\n";
  out += fmt::format("inline constexpr Vertex lowest{};\ninline constexpr Vertex highest{};\n", pair(lowest),
                     pair(highest));
  out += fmt::format(
      "/// Vertices of the polygon that has most.\ninline constexpr int largest_polygon = {};\n\n", largest);
  out += array("Polygon", "polygons", rings.polygons.size(), [&](std::size_t i) {
    const Polygon& p = rings.polygons[i];
    return fmt::format("{{{}, {}, {}, {}, {}, {}, {}, {}}}", p.first_vertex, p.vertex_count, p.first_contour,
                       p.contour_count, p.lowest.x, p.lowest.y, p.highest.x, p.highest.y);
  });
  out += "\n/// Vertices of each contour; the last is joined to the first.\n";
  out += array("int", "contour_lengths", rings.contour_lengths.size(),
               [&](std::size_t i) { return fmt::format("{}", rings.contour_lengths[i]); });
  out += '\n';
  out += array("Vertex", "vertices", rings.vertices.size(),
               [&](std::size_t i) { return pair(rings.vertices[i]); });
  out += fmt::format("\n}}  // namespace {}::{}\n", heading.name_space, heading.name);
  return out;
}

}  // namespace host::assets
