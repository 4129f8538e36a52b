// SPDX-License-Identifier: MIT
#include <intaglio/present/swap_control.hpp>

namespace intaglio::present {

template class GuardedSwapControl<SwapGuards>;

}  // namespace intaglio::present
