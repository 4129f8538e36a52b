// SPDX-License-Identifier: MIT
//
// cairo on an 8-bit alpha surface, its lightest. cairo's pixels have their corners at integers, so half a
// pixel is added everywhere; an outline is a stroke of width 1, a disc of radius r reaches r + 1/2 from its
// centre, as ours does along the axes.
#include <tests/bench/painter.hpp>

#include <cairo.h>

namespace bench {
namespace {

class Cairo final : public Painter {
 public:
  explicit Cairo(bool smooth)
      : surface_(cairo_image_surface_create(CAIRO_FORMAT_A8, width, height)),
        context_(cairo_create(surface_)) {
    cairo_set_antialias(context_, smooth ? CAIRO_ANTIALIAS_DEFAULT : CAIRO_ANTIALIAS_NONE);
    cairo_set_source_rgba(context_, 1, 1, 1, 1);
    cairo_set_line_width(context_, 1);
  }
  ~Cairo() override {
    cairo_destroy(context_);
    cairo_surface_destroy(surface_);
  }

  void clear() override {
    cairo_save(context_);
    cairo_set_operator(context_, CAIRO_OPERATOR_CLEAR);
    cairo_paint(context_);
    cairo_restore(context_);
  }
  bool draw(const Shape& shape) override {
    cairo_new_path(context_);
    std::visit([&](const auto& s) { draw_one(s); }, shape);
    return true;
  }
  void finish() override { cairo_surface_flush(surface_); }
  [[nodiscard]] int level(int x, int y) const override {
    return cairo_image_surface_get_data(surface_)[y * cairo_image_surface_get_stride(surface_) + x];
  }

 private:
  static constexpr double turn = 6.283185307179586;

  void path(const intaglio::linear::Point& a, const intaglio::linear::Point& b) {
    cairo_move_to(context_, a.x + 0.5, a.y + 0.5);
    cairo_line_to(context_, b.x + 0.5, b.y + 0.5);
  }
  void stroke_or_fill(bool filled) {
    if (filled)
      cairo_fill(context_);
    else
      cairo_stroke(context_);
  }

  void draw_one(const Line& l) {
    cairo_set_line_cap(context_, CAIRO_LINE_CAP_SQUARE);
    path(l.a, l.b);
    cairo_stroke(context_);
  }
  void draw_one(const ThickLine& l) {
    cairo_set_line_cap(context_, CAIRO_LINE_CAP_BUTT);
    cairo_set_line_width(context_, l.across);
    path(l.a, l.b);
    cairo_stroke(context_);
    cairo_set_line_width(context_, 1);
  }
  void draw_one(const Circle& c) {
    cairo_arc(context_, c.centre.x + 0.5, c.centre.y + 0.5, c.radius + (c.filled ? 0.5 : 0), 0, turn);
    stroke_or_fill(c.filled);
  }
  void draw_one(const Ellipse& e) {
    const double more = e.filled ? 0.5 : 0;
    cairo_save(context_);
    cairo_translate(context_, e.centre.x + 0.5, e.centre.y + 0.5);
    cairo_scale(context_, e.x_radius + more, e.y_radius + more);
    cairo_arc(context_, 0, 0, 1, 0, turn);
    cairo_restore(context_);  // so that the stroke isn't scaled
    stroke_or_fill(e.filled);
  }
  void draw_one(const Polygon& p) {
    for (const auto& v : p.vertices) cairo_line_to(context_, v.x / 256.0 + 0.5, v.y / 256.0 + 0.5);
    cairo_close_path(context_);
    cairo_set_fill_rule(context_, p.even_odd ? CAIRO_FILL_RULE_EVEN_ODD : CAIRO_FILL_RULE_WINDING);
    cairo_fill(context_);
  }

  cairo_surface_t* surface_;
  cairo_t* context_;
};

}  // namespace

std::unique_ptr<Painter> make_cairo(bool smooth) { return std::make_unique<Cairo>(smooth); }

}  // namespace bench
