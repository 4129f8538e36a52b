// SPDX-License-Identifier: MIT
//
// How host programs fail: one exception whose text is the whole message. `main` prints it and exits 1.
#pragma once

#include <stdexcept>
#include <string>

namespace host {

class Failure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace host
