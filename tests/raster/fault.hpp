// SPDX-License-Identifier: MIT
//
// What is wrong with a drawing, in words.
#pragma once

#include <intaglio/status.hpp>
#include <tests/oracle/recording_sink.hpp>

#include <string>

namespace tests {

/// Empty if a call that answered `status` drew each pixel of the sink's window for which belongs(x, y) once,
/// and no other. Else it begins with what name() says was drawn.
template <class Name, class Belongs>
std::string fault(intaglio::Status status, const oracle::RecordingSink& sink, Name name, Belongs belongs) {
  const std::string wrong = status.ok() ? sink.fault(belongs) : "refused";
  return wrong.empty() ? "" : name() + ": " + wrong;
}

}  // namespace tests
