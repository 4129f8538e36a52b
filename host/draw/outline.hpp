// SPDX-License-Identifier: MIT
//
// Primitives as polygons, for what draws polygons only.
//
// Rule: a shape of whole pixels reaches half a pixel beyond the centres of its outermost pixels, and an
// outline is a pixel wide. Curves become polygons with so many corners on them that no side is further than
// 1/512 pixel inside the curve, and corners are rounded to 1/256.
#pragma once

#include <host/draw/canvas.hpp>
#include <intaglio/status.hpp>

#include <optional>

namespace host::draw {

/// The polygon that a primitive is; none if it isn't one. `status` says what is wrong with the primitive, as
/// the library does.
std::optional<Polygon> outline_of(const Primitive& primitive, intaglio::Status& status);

}  // namespace host::draw
