// SPDX-License-Identifier: MIT
//
// The drawing language: one command a line, carried out as it is read.
#pragma once

#include <host/draw/canvas.hpp>

#include <memory>
#include <string_view>

namespace host::draw {

/// What `--help` says about the language.
std::string_view language_help();

/// Draws a program. Throws Failure whose text is "line N: …" and says what is wrong there.
std::shared_ptr<const Canvas> draw_program(std::string_view source);

}  // namespace host::draw
