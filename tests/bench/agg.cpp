// SPDX-License-Identifier: MIT
//
// Anti-Grain Geometry on 8-bit grey. Without smoothing, lines, circles and ellipses go through its fast
// integer primitives (agg::renderer_primitives), all else through its scanline rasterizer with a threshold at
// half; with smoothing, all goes through the rasterizer. Its pixels have their corners at integers, so half a
// pixel is added, but for its ellipses, which count whole pixels.
#include <tests/bench/painter.hpp>

#include <agg_conv_stroke.h>
#include <agg_ellipse.h>
#include <agg_path_storage.h>
#include <agg_pixfmt_gray.h>
#include <agg_rasterizer_scanline_aa.h>
#include <agg_renderer_base.h>
#include <agg_renderer_primitives.h>
#include <agg_renderer_scanline.h>
#include <agg_rendering_buffer.h>
#include <agg_scanline_bin.h>
#include <agg_scanline_u.h>
#include <array>
#include <cstdint>

namespace bench {
namespace {

using Base = agg::renderer_base<agg::pixfmt_gray8>;

class Agg final : public Painter {
 public:
  explicit Agg(bool smooth) : smooth_(smooth) {
    if (!smooth) rasterizer_.gamma(agg::gamma_threshold(0.5));
    primitives_.line_color(white());
    primitives_.fill_color(white());
  }

  void clear() override { base_.clear(agg::gray8(0)); }
  bool draw(const Shape& shape) override {
    std::visit([&](const auto& s) { draw_one(s); }, shape);
    return true;
  }
  [[nodiscard]] int level(int x, int y) const override {
    return bytes_[static_cast<std::size_t>(y * width + x)];
  }

 private:
  /// The middle of a pixel, in 1/256: the primitives round down.
  static int middle(int pixel) { return pixel * 256 + 128; }
  static agg::gray8 white() { return agg::gray8(255); }

  template <class Source>
  void fill(Source& source) {
    rasterizer_.reset();
    rasterizer_.add_path(source);
    if (smooth_)
      agg::render_scanlines_aa_solid(rasterizer_, smooth_line_, base_, white());
    else
      agg::render_scanlines_bin_solid(rasterizer_, binary_line_, base_, white());
  }
  template <class Source>
  void stroke(Source& source, double across, agg::line_cap_e cap) {
    agg::conv_stroke<Source> stroke(source);
    stroke.width(across);
    stroke.line_cap(cap);
    rasterizer_.filling_rule(agg::fill_non_zero);
    fill(stroke);
  }
  void stroke(const intaglio::linear::Point& a, const intaglio::linear::Point& b, double across,
              agg::line_cap_e cap) {
    path_.remove_all();
    path_.move_to(a.x + 0.5, a.y + 0.5);
    path_.line_to(b.x + 0.5, b.y + 0.5);
    stroke(path_, across, cap);
  }

  void draw_one(const Line& l) {
    if (smooth_)
      stroke(l.a, l.b, 1, agg::square_cap);
    else
      primitives_.line(middle(l.a.x), middle(l.a.y), middle(l.b.x), middle(l.b.y), true);
  }
  void draw_one(const ThickLine& l) { stroke(l.a, l.b, l.across, agg::butt_cap); }
  void draw_one(const Circle& c) { draw_one(Ellipse{c.centre, c.radius, c.radius, c.filled}); }
  void draw_one(const Ellipse& e) {
    if (!smooth_) {
      if (e.filled)
        primitives_.solid_ellipse(e.centre.x, e.centre.y, e.x_radius, e.y_radius);
      else
        primitives_.ellipse(e.centre.x, e.centre.y, e.x_radius, e.y_radius);
      return;
    }
    const double more = e.filled ? 0.5 : 0;
    agg::ellipse ellipse(e.centre.x + 0.5, e.centre.y + 0.5, e.x_radius + more, e.y_radius + more);
    if (e.filled)
      fill(ellipse);
    else
      stroke(ellipse, 1, agg::butt_cap);
  }
  void draw_one(const Polygon& p) {
    path_.remove_all();
    for (const auto& v : p.vertices) {
      const double x = v.x / 256.0 + 0.5;
      const double y = v.y / 256.0 + 0.5;
      if (path_.total_vertices() == 0)
        path_.move_to(x, y);
      else
        path_.line_to(x, y);
    }
    path_.close_polygon();
    rasterizer_.filling_rule(p.even_odd ? agg::fill_even_odd : agg::fill_non_zero);
    fill(path_);
  }

  bool smooth_;
  std::array<std::uint8_t, std::size_t{width} * height> bytes_{};
  agg::rendering_buffer buffer_{bytes_.data(), width, height, width};
  agg::pixfmt_gray8 format_{buffer_};
  Base base_{format_};
  agg::renderer_primitives<Base> primitives_{base_};
  agg::rasterizer_scanline_aa<> rasterizer_;
  agg::scanline_u8 smooth_line_;
  agg::scanline_bin binary_line_;
  agg::path_storage path_;
};

}  // namespace

std::unique_ptr<Painter> make_agg(bool smooth) { return std::make_unique<Agg>(smooth); }

}  // namespace bench
