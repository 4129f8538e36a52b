// SPDX-License-Identifier: MIT
//
// The entries of the list of programs, a source file each, for each is compiled for every pixel format.
#pragma once

#include <host/sim/program.hpp>

namespace host {

extern const Program gauges_program;
extern const Program map_program;
extern const Program primitives_program;
extern const Program testcard_program;

}  // namespace host
