// SPDX-License-Identifier: MIT
//
// The rules by which pictures are copied, each with what it makes of an index, for tests that try every rule
// between formats. What needn't know the formats is no template: there are many pairs of them.
#pragma once

#include <intaglio/image/blit.hpp>
#include <tests/image/formats.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>

namespace tests {

/// What is drawn for an index of the source; nothing where the target stays.
using IndexMap = std::function<std::optional<unsigned>(unsigned)>;

/// Calls try_rule(rule, map) for the rules that copy from G to F, with a random colour key and a random table
/// of indices that the target can hold: each rule between formats of one depth; between others those two of
/// which the rest are halves.
template <class F, class G, class Try>
void try_all_rules(oracle::Random& random, Try try_rule) {
  const auto key = static_cast<unsigned>(random.bits() % (G::max_index + 1U));
  std::array<std::uint8_t, G::max_index + 1> table{};
  for (std::uint8_t& entry : table) entry = static_cast<std::uint8_t>(random.bits() % (F::max_index + 1U));
  const std::uint8_t* const entries = table.data();
  if constexpr (F::bits == G::bits)
    try_rule(intaglio::image::Remap{table}, IndexMap([=](unsigned index) { return entries[index]; }));
  const IndexMap keyed = [=](unsigned index) {
    return index == key ? std::nullopt : std::optional<unsigned>(entries[index]);
  };
  try_rule(intaglio::image::KeyedRemap{key, table}, keyed);
  if constexpr (G::bits <= F::bits)
    try_rule(intaglio::image::Everything{}, IndexMap([](unsigned index) { return index; }));
  if constexpr (F::bits == G::bits) {
    const IndexMap all_but_key = [=](unsigned index) {
      return index == key ? std::nullopt : std::optional(index);
    };
    try_rule(intaglio::image::ColourKey{key}, all_but_key);
  }
}

/// True for the pairs of formats that are tried: those of one depth, of which one has a byte a pixel, or
/// which both begin with the highest bits. The others are made of the same parts.
template <class F, class G>
inline constexpr bool tried_pair = F::bits == G::bits || F::bits == 8 || G::bits == 8 ||
                                   (layout_of<F>.most_significant_first &&
                                    layout_of<G>.most_significant_first);

/// Calls try_pair.operator()<F, G>() for the formats G of the list.
template <class F, class... Sources, class Try>
void for_all_sources(testing::Types<Sources...> /*formats*/, Try try_pair) {
  const auto try_one = [&]<class G>() {
    if constexpr (tried_pair<F, G>) try_pair.template operator()<F, G>();
  };
  (try_one.template operator()<Sources>(), ...);
}

}  // namespace tests
