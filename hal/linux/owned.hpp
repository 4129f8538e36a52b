// SPDX-License-Identifier: MIT
//
// Objects of libraries in C, each with its way to be given back.
#pragma once

#include <memory>

namespace hal::linux_io {

template <auto release>
struct Release {
  template <class T>
  void operator()(T* object) const noexcept {
    release(object);
  }
};
template <class T, auto release>
using Owned = std::unique_ptr<T, Release<release>>;

}  // namespace hal::linux_io
