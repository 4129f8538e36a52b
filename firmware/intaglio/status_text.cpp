// SPDX-License-Identifier: MIT
#include <intaglio/status_text.hpp>

namespace intaglio {

const char* to_text(Error error) noexcept {
  switch (error) {
    case Error::none:
      return "success";
    case Error::out_of_domain:
      return "out of domain";
    case Error::out_of_range:
      return "out of range";
    case Error::empty:
      return "empty";
    case Error::too_small:
      return "too small";
    case Error::too_large:
      return "too large";
    case Error::misaligned:
      return "misaligned";
    case Error::malformed:
      return "malformed";
    case Error::mismatched:
      return "mismatched";
    case Error::unsupported:
      return "unsupported";
    case Error::busy:
      return "busy";
    case Error::device:
      return "device failure";
  }
  return "unknown error";
}

const char* to_text(Argument argument) noexcept {
  switch (argument) {
    case Argument::none:
      return "nothing";
    case Argument::width:
      return "width";
    case Argument::height:
      return "height";
    case Argument::size:
      return "size";
    case Argument::stride:
      return "stride";
    case Argument::buffer:
      return "buffer";
    case Argument::point:
      return "point";
    case Argument::rectangle:
      return "rectangle";
    case Argument::radius:
      return "radius";
    case Argument::vertices:
      return "vertices";
    case Argument::contours:
      return "contours";
    case Argument::workspace:
      return "workspace";
    case Argument::palette:
      return "palette";
    case Argument::index:
      return "index";
    case Argument::colour:
      return "colour";
    case Argument::steps:
      return "steps";
    case Argument::table:
      return "table";
    case Argument::source:
      return "source";
    case Argument::position:
      return "position";
    case Argument::glyph:
      return "glyph";
    case Argument::font:
      return "font";
    case Argument::text:
      return "text";
    case Argument::angle:
      return "angle";
    case Argument::frame:
      return "frame";
    case Argument::panel:
      return "panel";
    case Argument::count:
      return "count";
    case Argument::rule:
      return "rule";
    case Argument::limit:
      return "limit";
    case Argument::mask:
      return "mask";
  }
  return "unknown argument";
}

}  // namespace intaglio
