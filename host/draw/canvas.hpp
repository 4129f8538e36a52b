// SPDX-License-Identifier: MIT
//
// What the drawing language draws on: a surface of any of the four depths, whose every write is counted.
#pragma once

#include <host/draw/combination.hpp>
#include <host/draw/sprite.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/number/angle.hpp>
#include <intaglio/raster/flood.hpp>
#include <intaglio/raster/polygon.hpp>
#include <intaglio/raster/polygon_clip.hpp>
#include <intaglio/raster/round_rect.hpp>
#include <intaglio/raster/stroke.hpp>
#include <intaglio/status.hpp>
#include <intaglio/text/aligned_lines.hpp>
#include <intaglio/text/font.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace host::draw {

namespace linear = intaglio::linear;

// The primitives, with the library's own arguments.
struct Pixel {
  linear::Point at;
};
enum class LineMethod : std::uint8_t { exact, line1, line2, distance };
struct Line {
  linear::SubPoint from, to;  ///< Whole pixels, but for the exact method.
  LineMethod method{};
};
struct Dashes {
  int on = 0;
  int off = 0;
  linear::Point from, to;
};
enum class ThickLineMethod : std::uint8_t { across, minor };
struct ThickLine {
  linear::SubPoint from, to;
  int width = 0;  ///< in 1/256 pixel; whole pixels along the minor axis
  intaglio::raster::Cap cap{};
  ThickLineMethod method{};
};
struct Polyline {
  std::vector<linear::SubPoint> points;
  intaglio::raster::Stroke stroke;
};
struct Rectangle {
  linear::Rect area;
  bool filled = false;
};
struct Circle {
  linear::Point centre;
  int radius = 0;
  bool filled = false;
};
struct DiametricCircle {
  linear::Point top_left;
  int diameter = 0;
  bool filled = false;
};
struct Ellipse {
  linear::Point centre;
  int x_radius = 0;
  int y_radius = 0;
  bool filled = false;
};
struct Ring {
  linear::Point centre;
  int inner_radius = 0;
  int outer_radius = 0;
};
enum class SweptShape : std::uint8_t { arc, pie, chord };
struct Arc {
  linear::Point centre;
  int radius = 0;
  intaglio::number::Angle start;
  int sweep = 0;
  SweptShape shape{};
};
struct EllipseArc {
  linear::Point centre;
  int x_radius = 0;
  int y_radius = 0;
  intaglio::number::Angle start;
  int sweep = 0;
  SweptShape shape{};
};
struct RoundRectangle {
  linear::Rect area;
  intaglio::raster::CornerRadii radii;
  bool filled = false;
};
enum class TriangleMethod : std::uint8_t { walk, box, blocks };
struct Triangle {
  linear::SubPoint a, b, c;
  TriangleMethod method{};
};
enum class PolygonMethod : std::uint8_t { active, basic, critical };
struct Polygon {
  intaglio::raster::FillRule rule{};
  std::vector<linear::SubPoint> vertices;
  std::vector<int> contour_lengths;
  PolygonMethod method{};
};
struct Coverage {
  Polygon polygon;  ///< Needs 8 bits a pixel: the levels are the indices.
};
struct FloodFill {
  linear::Point seed;
  intaglio::raster::Connectivity connectivity{};
};
struct Text {
  const intaglio::text::Font* font = nullptr;
  linear::Point place;
  std::string utf8;
  intaglio::text::Alignment alignment{};
  intaglio::text::Baseline baseline{};
};
using Primitive = std::variant<Pixel, Line, Dashes, ThickLine, Polyline, Rectangle, Circle, DiametricCircle,
                               Ellipse, Ring, Arc, EllipseArc, RoundRectangle, Triangle, Polygon, Combination,
                               Coverage, FloodFill, Text, Sprite>;

/// The pixels of a polygon on a canvas, with the memory they lie in.
class PolygonWindow {
 public:
  /// Errors: as `PolygonClip::over`.
  static intaglio::Result<std::shared_ptr<const PolygonWindow>> create(const Polygon& polygon,
                                                                       linear::Size canvas);
  [[nodiscard]] const intaglio::raster::PolygonClip& clip() const { return clip_; }

 private:
  std::vector<intaglio::raster::RowSpan> spans_;
  intaglio::raster::PolygonClip clip_;
};

struct Smoothing;

/// How primitives are drawn.
struct Pen {
  unsigned index = 0;
  bool exclusive_or = false;
  linear::Rect clip{};                          ///< Where it draws.
  std::shared_ptr<const PolygonWindow> window;  ///< If there is one, only what is inside this, too.
  std::shared_ptr<const Smoothing> smoothing;   ///< If there is one, by coverage (smoothing.hpp).
};

class Canvas {
 public:
  /// A black canvas. Error: as `image::Surface::over`.
  static intaglio::Result<std::shared_ptr<Canvas>> create(linear::Size size, int bits);

  virtual ~Canvas() = default;
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  /// Throws Failure if the pen's smoothing can't draw it.
  [[nodiscard]] virtual intaglio::Status draw(const Primitive& primitive, const Pen& pen) = 0;
  /// One index a pixel, row by row.
  [[nodiscard]] virtual std::vector<std::uint8_t> indices() const = 0;
  /// The frame digest (`image/digest.hpp`) with the present palette.
  [[nodiscard]] virtual std::uint32_t digest() const = 0;

  [[nodiscard]] linear::Size size() const { return size_; }
  [[nodiscard]] unsigned max_index() const { return max_index_; }
  /// How often each pixel was written, row by row, saturated at 255.
  [[nodiscard]] const std::vector<std::uint8_t>& touched() const { return touched_; }
  /// RGBRGB…, one entry an index; a grey ramp from black to white at first.
  [[nodiscard]] std::vector<std::uint8_t>& palette() { return palette_; }
  [[nodiscard]] const std::vector<std::uint8_t>& palette() const { return palette_; }
  /// What commands had to say, in whole lines.
  [[nodiscard]] const std::string& printed() const { return printed_; }
  void print(std::string_view lines) { printed_ += lines; }

 protected:
  Canvas(linear::Size size, unsigned max_index);
  [[nodiscard]] std::vector<std::uint8_t>& touches() { return touched_; }

 private:
  linear::Size size_;
  unsigned max_index_;
  std::vector<std::uint8_t> touched_;
  std::vector<std::uint8_t> palette_;
  std::string printed_;
};

}  // namespace host::draw
