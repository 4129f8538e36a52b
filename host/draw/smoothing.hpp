// SPDX-License-Identifier: MIT
//
// Antialiasing in the drawing language: the ways, and drawing a primitive by one of them.
#pragma once

#include <host/draw/canvas.hpp>
#include <intaglio/image/blend_table.hpp>
#include <intaglio/raster/mask_buffer.hpp>
#include <intaglio/raster/supersample.hpp>
#include <intaglio/status.hpp>

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace host::draw {

/// How coverage is found.
struct Smoothing {
  enum class Way { area, pitteway, samples, adaptive, stochastic, masks } way{};
  std::string name;
  intaglio::raster::Supersampling grid{};  ///< Of samples; adaptive and stochastic use the scale.
  intaglio::raster::MaskGrid masks{};
  intaglio::image::BlendSpace space = intaglio::image::BlendSpace::code;  ///< In which colours are mixed.
};

/// The way of that name. Throws Failure if there is none.
Smoothing parse_smoothing(std::string_view name);

/// A coverage sink whose kind is known at run time only.
class AnyCoverage {
 public:
  using Span = std::function<void(int y, int x_begin, int x_end, int coverage)>;
  AnyCoverage(const linear::Rect& clip, Span span) : clip_(clip), span_(std::move(span)) {}
  [[nodiscard]] const linear::Rect& clip() const { return clip_; }
  void span(int y, int x_begin, int x_end, int coverage) const { span_(y, x_begin, x_end, coverage); }

 private:
  linear::Rect clip_;
  Span span_;
};

/// False for what looks the same smooth: shapes of whole pixels along rows and columns, text, floods.
bool has_edges(const Primitive& primitive);

/// Hands over how much of each pixel a primitive covers. Throws Failure if the way can't draw it.
intaglio::Status draw_smooth(const AnyCoverage& sink, const Smoothing& smoothing, const Primitive& primitive);

}  // namespace host::draw
