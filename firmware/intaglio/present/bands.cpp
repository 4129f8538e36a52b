// SPDX-License-Identifier: MIT
#include <intaglio/present/bands.hpp>

namespace intaglio::present {

int band_rows(const hal::Capabilities& panel, int stride, std::size_t memory) noexcept {
  const std::size_t fitting = memory / static_cast<std::size_t>(stride);
  if (fitting >= static_cast<std::size_t>(panel.height)) return panel.height;
  const int rows = static_cast<int>(fitting);
  return rows - rows % panel.y_alignment;
}

}  // namespace intaglio::present
