// SPDX-License-Identifier: MIT
#include <host/draw/canvas.hpp>
#include <host/draw/counting_sink.hpp>
#include <host/draw/smoothing.hpp>
#include <host/failure.hpp>
#include <intaglio/image/digest.hpp>
#include <intaglio/image/surface.hpp>
#include <intaglio/raster/arc.hpp>
#include <intaglio/raster/blend_coverage.hpp>
#include <intaglio/raster/chord.hpp>
#include <intaglio/raster/circle.hpp>
#include <intaglio/raster/coverage.hpp>
#include <intaglio/raster/dash.hpp>
#include <intaglio/raster/disc.hpp>
#include <intaglio/raster/dithered_coverage.hpp>
#include <intaglio/raster/ellipse.hpp>
#include <intaglio/raster/ellipse_arc.hpp>
#include <intaglio/raster/flood.hpp>
#include <intaglio/raster/line_rungs.hpp>
#include <intaglio/raster/pixel.hpp>
#include <intaglio/raster/polygon_basic.hpp>
#include <intaglio/raster/polygon_critical.hpp>
#include <intaglio/raster/polyline.hpp>
#include <intaglio/raster/rectangle.hpp>
#include <intaglio/raster/ring.hpp>
#include <intaglio/raster/round_rect.hpp>
#include <intaglio/raster/solid.hpp>
#include <intaglio/raster/thick_line_rungs.hpp>
#include <intaglio/raster/triangle.hpp>
#include <intaglio/raster/triangle_box.hpp>
#include <intaglio/text/draw_aligned_text.hpp>

#include <cstddef>
#include <span>
#include <utility>

namespace host::draw {
namespace {

namespace image = intaglio::image;
namespace raster = intaglio::raster;
using intaglio::Argument;
using intaglio::Error;
using intaglio::Result;
using intaglio::Status;

/// Draws levels of coverage as indices, by the way of another sink.
template <image::PixelFormat F, class Sink>
struct Levels {
  const Sink& sink;
  const image::Surface<F>& surface;

  [[nodiscard]] const linear::Rect& clip() const { return sink.clip(); }
  void span(int y, int x_begin, int x_end, int coverage) const {
    sink.over(typename Sink::Counted(surface, static_cast<unsigned>(coverage))).span(y, x_begin, x_end);
  }
};

/// Stores what is drawn in a copy of the picture, too, of which nothing is hidden.
template <image::PixelFormat F, class Sink>
struct WithCopy {
  const Sink& sink;
  raster::Solid<F> copy;

  [[nodiscard]] const linear::Rect& clip() const { return sink.clip(); }
  void span(int y, int x_begin, int x_end) const {
    copy.span(y, x_begin, x_end);
    sink.span(y, x_begin, x_end);
  }
};

template <image::PixelFormat F, class Sink>
struct Drawer {
  const Sink& sink;
  const image::Surface<F>& surface;
  const Pen& pen;

  Status operator()(const Pixel& p) const { return raster::draw_pixel(sink, p.at); }
  Status operator()(const Line& l) const {
    const auto whole = [](linear::SubPoint p) {
      return linear::Point{p.x / linear::subpixel_one, p.y / linear::subpixel_one};
    };
    const linear::Point from = whole(l.from);
    const linear::Point to = whole(l.to);
    switch (l.method) {
      case LineMethod::line1:
        return raster::draw_line_by<raster::RoundedLine>(sink, from, to);
      case LineMethod::line2:
        return raster::draw_line_by<raster::SplitErrorLine>(sink, from, to);
      case LineMethod::distance:
        return raster::draw_line_by<raster::DistanceLine>(sink, from, to);
      default:
        return raster::draw_line(sink, l.from, l.to);
    }
  }
  Status operator()(const Dashes& d) const {
    return raster::draw_dashed_line(sink, d.from, d.to, d.on, d.off);
  }
  Status operator()(const ThickLine& l) const {
    if (l.method == ThickLineMethod::minor)
      return raster::draw_minor_thick_line(sink, l.from, l.to, l.width / linear::subpixel_one);
    return raster::draw_thick_line(sink, l.from, l.to, l.width, l.cap);
  }
  Status operator()(const Polyline& p) const {
    const auto needed = raster::polyline_workspace(p.points, p.stroke, sink.clip());
    if (!needed.ok()) return needed.status();
    std::vector<raster::StrokeEdge> workspace(needed.value());
    return raster::draw_polyline(sink, p.points, p.stroke, workspace);
  }
  Status operator()(const Rectangle& r) const {
    return r.filled ? raster::fill_rect(sink, r.area) : raster::draw_rect(sink, r.area);
  }
  Status operator()(const Circle& c) const {
    return c.filled ? raster::fill_disc(sink, c.centre, c.radius)
                    : raster::draw_circle(sink, c.centre, c.radius);
  }
  Status operator()(const DiametricCircle& c) const {
    return c.filled ? raster::fill_disc_in(sink, c.top_left, c.diameter)
                    : raster::draw_circle_in(sink, c.top_left, c.diameter);
  }
  Status operator()(const Ellipse& e) const {
    return e.filled ? raster::fill_ellipse(sink, e.centre, e.x_radius, e.y_radius)
                    : raster::draw_ellipse(sink, e.centre, e.x_radius, e.y_radius);
  }
  Status operator()(const Ring& r) const {
    return raster::fill_ring(sink, r.centre, r.inner_radius, r.outer_radius);
  }
  Status operator()(const Arc& a) const {
    if (a.shape == SweptShape::pie) return raster::fill_pie(sink, a.centre, a.radius, a.start, a.sweep);
    if (a.shape == SweptShape::chord) return raster::fill_chord(sink, a.centre, a.radius, a.start, a.sweep);
    return raster::draw_arc(sink, a.centre, a.radius, a.start, a.sweep);
  }
  Status operator()(const EllipseArc& a) const {
    switch (a.shape) {
      case SweptShape::pie:
        return raster::fill_ellipse_pie(sink, a.centre, a.x_radius, a.y_radius, a.start, a.sweep);
      case SweptShape::chord:
        return raster::fill_ellipse_chord(sink, a.centre, a.x_radius, a.y_radius, a.start, a.sweep);
      default:
        return raster::draw_ellipse_arc(sink, a.centre, a.x_radius, a.y_radius, a.start, a.sweep);
    }
  }
  Status operator()(const RoundRectangle& r) const {
    return r.filled ? raster::fill_round_rect(sink, r.area, r.radii)
                    : raster::draw_round_rect(sink, r.area, r.radii);
  }
  Status operator()(const Triangle& t) const {
    switch (t.method) {
      case TriangleMethod::box:
        return raster::fill_triangle_box(sink, t.a, t.b, t.c);
      case TriangleMethod::blocks:
        return raster::fill_triangle_blocks(sink, t.a, t.b, t.c);
      default:
        return raster::fill_triangle(sink, t.a, t.b, t.c);
    }
  }
  Status operator()(const Polygon& p) const {
    switch (p.method) {
      case PolygonMethod::basic: {
        std::vector<raster::PolygonCrossing> workspace(p.vertices.size());
        return raster::fill_polygon_basic(sink, p.rule, p.vertices, p.contour_lengths, workspace);
      }
      case PolygonMethod::critical: {
        std::vector<raster::PolygonChain> workspace(p.vertices.size());
        return raster::fill_polygon_critical(sink, p.rule, p.vertices, p.contour_lengths, workspace);
      }
      default: {
        std::vector<raster::PolygonEdge> workspace(p.vertices.size());
        return raster::fill_polygon(sink, p.rule, p.vertices, p.contour_lengths, workspace);
      }
    }
  }
  Status operator()(const Coverage& c) const {
    if (F::bits != 8) return {Error::unsupported, Argument::colour};
    const Polygon& p = c.polygon;
    std::vector<raster::CoverageCell> workspace(raster::coverage_cells(p.vertices.size(), sink.clip().width));
    return raster::fill_coverage(Levels<F, Sink>{sink, surface}, p.rule, p.vertices, p.contour_lengths,
                                 workspace);
  }
  Status operator()(const Combination& c) const { return fill_combination(sink, c); }
  Status operator()(const FloodFill& f) const {
    // All of the region has the seed's index, so exclusive-or gives it one other.
    const bool flips = pen.exclusive_or && raster::in_clip(surface.bounds(), f.seed);
    const unsigned fill = flips ? surface.get(f.seed.x, f.seed.y) ^ pen.index : pen.index;
    // It spreads where it may not draw, too, so it must find its way on a copy.
    std::vector<std::uint8_t> bytes(surface.byte_at(0, 0),
                                    surface.byte_at(0, 0) + surface.stride() * surface.size().height);
    const auto copy = image::Surface<F>::over(bytes, surface.size(), surface.stride());
    if (!copy.ok()) return copy.status();
    auto flood = raster::Flood<F>::interior(copy.value(), f.connectivity, f.seed, fill);
    if (!flood.ok()) return flood.status();
    const WithCopy<F, Sink> spreading{sink, {copy.value(), fill}};
    std::vector<raster::FloodSpan> workspace(64);
    for (;;) {
      const Status status = flood.value().run(spreading, workspace);
      if (status.error() != Error::too_small) return status;
      workspace.resize(2 * std::size_t{status.needed()});
    }
  }
  Status operator()(const Sprite& s) const {
    const Result<SpriteImage> shown = SpriteImage::create(s, surface.size());
    if (!shown.ok()) return shown.status();
    const linear::Rect clip = sink.clip();
    for (int y = clip.y; y < clip.bottom(); ++y)
      for (int x = clip.x; x < clip.right(); ++x)
        if (const int index = shown.value().index(x, y); index >= 0)
          sink.over(typename Sink::Counted(surface, static_cast<unsigned>(index))).span(y, x, x + 1);
    return {};
  }
  Status operator()(const Text& t) const {
    if (!linear::in_domain(t.place)) return {intaglio::Error::out_of_domain, intaglio::Argument::point};
    return intaglio::text::draw_aligned_text(sink, *t.font, {t.place.x, t.place.y}, t.alignment, t.baseline,
                                             t.utf8);
  }
};

/// Blends, and counts.
template <image::PixelFormat F>
struct CountedBlend {
  raster::BlendCoverage<F> blend;
  Touches touches;

  [[nodiscard]] const linear::Rect& clip() const { return blend.clip(); }
  void span(int y, int x_begin, int x_end, int coverage) const {
    for (int x = x_begin; x < x_end; ++x) touches.add(x, y);
    blend.span(y, x_begin, x_end, coverage);
  }
};

template <image::PixelFormat F>
class CanvasOf final : public Canvas {
 public:
  static Result<std::shared_ptr<Canvas>> create(linear::Size size) {
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(F::row_bytes(size.width)) *
                                    static_cast<std::size_t>(size.height));
    const auto surface = image::Surface<F>::over(bytes, size);
    if (!surface.ok()) return surface.status();
    return std::shared_ptr<Canvas>(new CanvasOf(std::move(bytes), surface.value()));
  }

  Status draw(const Primitive& primitive, const Pen& pen) override {
    const bool smooth = pen.smoothing && has_edges(primitive);
    if (smooth && F::bits != 1) return blend(primitive, pen);
    const Touches counts(touches(), size().width);
    const auto with = [&](const auto& sink) {
      const CountingSink counting(sink, counts, pen.window ? &pen.window->clip() : nullptr);
      if (smooth) return dither(primitive, *pen.smoothing, counting);
      return std::visit(Drawer<F, CountingSink<std::remove_cvref_t<decltype(sink)>>>{counting, surface_, pen},
                        primitive);
    };
    return pen.exclusive_or ? with(raster::Xor<F>(surface_, pen.index, pen.clip))
                            : with(raster::Solid<F>(surface_, pen.index, pen.clip));
  }

  std::vector<std::uint8_t> indices() const override {
    std::vector<std::uint8_t> all;
    all.reserve(touched().size());
    for (int y = 0; y < size().height; ++y)
      for (int x = 0; x < size().width; ++x) all.push_back(static_cast<std::uint8_t>(surface_.get(x, y)));
    return all;
  }

  std::uint32_t digest() const override { return image::digest(surface_, palette()); }

 private:
  CanvasOf(std::vector<std::uint8_t> bytes, const image::Surface<F>& surface)
      : Canvas(surface.size(), F::max_index), bytes_(std::move(bytes)), surface_(surface) {}

  /// Draws by coverage, where pixels are on or off.
  template <class Sink>
  static Status dither(const Primitive& primitive, const Smoothing& smoothing, const Sink& sink) {
    raster::DitheredCoverage<const Sink&> dithered(sink);
    return draw_smooth({sink.clip(), [&](int y, int x_begin, int x_end,
                                         int coverage) { dithered.span(y, x_begin, x_end, coverage); }},
                       smoothing, primitive);
  }

  /// Draws by coverage, in the palette's colours nearest to the mixtures.
  Status blend(const Primitive& primitive, const Pen& pen) {
    if (pen.exclusive_or) throw Failure("aa needs mode set, or 1 bit a pixel");
    const Touches counts(touches(), size().width);
    const auto sink = raster::BlendCoverage<F>::over(surface_, blend_table(pen), pen.clip);
    if (!sink.ok()) return sink.status();
    const CountedBlend<F> counted{sink.value(), counts};
    return draw_smooth(
        {counted.clip(),
         [&](int y, int x_begin, int x_end, int coverage) {
           need_row(coverage);
           if (pen.window)
             raster::PolygonClipped(counted, pen.window->clip()).span(y, x_begin, x_end, coverage);
           else
             counted.span(y, x_begin, x_end, coverage);
         }},
        *pen.smoothing, primitive);
  }

  /// The table of the pen's colour over the present palette. Its rows are made when they are needed.
  image::BlendTable blend_table(const Pen& pen) {
    constexpr int entries = F::max_index + 1;
    const int index = static_cast<int>(pen.index);
    if (table_.empty() || table_palette_ != palette() || table_index_ != index ||
        table_space_ != pen.smoothing->space) {
      table_.resize(image::BlendTable::bytes(entries, blend_steps));
      table_has_.assign(blend_steps, false);
      table_palette_ = palette();
      table_index_ = index;
      table_space_ = pen.smoothing->space;
    }
    return image::BlendTable::over(table_, entries, index, blend_steps).value();
  }
  void need_row(int step) {
    constexpr std::size_t entries = F::max_index + 1;
    if (step == 0 || step == blend_steps - 1 || table_has_[static_cast<std::size_t>(step)]) return;
    table_has_[static_cast<std::size_t>(step)] = true;
    image::make_blend_row(std::span(table_).subspan(static_cast<std::size_t>(step - 1) * entries), palette(),
                          table_index_, step, blend_steps, table_space_)
        .ignore();
  }

  static constexpr int blend_steps = 256;  // so that steps are levels

  std::vector<std::uint8_t> bytes_;  // moved here whole, so the surface's pointer stays good
  image::Surface<F> surface_;
  std::vector<std::uint8_t> table_;  // and what it was made for
  std::vector<bool> table_has_;
  std::vector<std::uint8_t> table_palette_;
  int table_index_ = 0;
  image::BlendSpace table_space_{};
};

}  // namespace

Result<std::shared_ptr<const PolygonWindow>> PolygonWindow::create(const Polygon& polygon,
                                                                   linear::Size canvas) {
  const auto window = std::make_shared<PolygonWindow>();
  std::vector<raster::PolygonEdge> edges(polygon.vertices.size());
  for (;;) {
    const auto made = raster::PolygonClip::over(polygon.rule, polygon.vertices, polygon.contour_lengths,
                                                {0, 0, canvas.width, canvas.height}, edges, window->spans_);
    window->clip_ = made.value();
    if (made.ok()) return std::shared_ptr<const PolygonWindow>(window);
    if (made.status().error() != Error::too_small) return made.status();
    window->spans_.resize(made.status().needed());
  }
}

Canvas::Canvas(linear::Size size, unsigned max_index)
    : size_(size),
      max_index_(max_index),
      touched_(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height)) {
  for (unsigned index = 0; index <= max_index; ++index)
    palette_.insert(palette_.end(), 3, static_cast<std::uint8_t>(index * 255 / max_index));
}

Result<std::shared_ptr<Canvas>> Canvas::create(linear::Size size, int bits) {
  constexpr std::int64_t most_pixels = std::int64_t{1} << 26U;
  if (size.width < 1 || size.height < 1) return Status{Error::empty, Argument::size};
  if (std::int64_t{size.width} * size.height > most_pixels) return Status{Error::too_large, Argument::size};
  switch (bits) {
    case 1:
      return CanvasOf<image::Indexed1>::create(size);
    case 2:
      return CanvasOf<image::Indexed2>::create(size);
    case 4:
      return CanvasOf<image::Indexed4>::create(size);
    case 8:
      return CanvasOf<image::Indexed8>::create(size);
    default:
      return Status{Error::unsupported, Argument::colour};
  }
}

}  // namespace host::draw
