// SPDX-License-Identifier: MIT
//
// One output line: data/command select, reset, chip select.
#pragma once

#include <hal/status.hpp>

namespace hal {

class OutputPin {
 public:
  OutputPin(const OutputPin&) = delete;
  OutputPin& operator=(const OutputPin&) = delete;

  /// Drives the line: true is the electrical high level.
  Status set(bool high) noexcept { return do_set(high); }

 protected:
  constexpr OutputPin() noexcept = default;
  ~OutputPin() = default;

 private:
  virtual Status do_set(bool high) noexcept = 0;
};

}  // namespace hal
