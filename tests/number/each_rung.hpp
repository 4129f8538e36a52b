// SPDX-License-Identifier: MIT
//
// Tests that go over the rungs of a family.
#pragma once

#include <intaglio/number/bound.hpp>
#include <intaglio/number/type_name.hpp>

#include <string>

namespace tests {

/// Calls try_one.operator()<R>() for each rung.
template <class... R, class Try>
void for_each_rung(intaglio::number::Family<R...> /*rungs*/, Try try_one) {
  (try_one.template operator()<R>(), ...);
}

/// A rung's name.
template <class R>
[[nodiscard]] std::string name() {
  return std::string(intaglio::number::type_name<R>());
}

}  // namespace tests
