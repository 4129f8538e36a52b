// SPDX-License-Identifier: MIT
//
// A picture as text: each character cell shows two pixels, one above the other, as an upper half block in
// 24-bit colours.
#pragma once

#include <host/sim/rgb_picture.hpp>

#include <string>

namespace host {

/// The picture shrunk by the least whole factor that makes it fit in columns x rows character cells; each
/// pixel is the mean of those it stands for. columns and rows >= 1.
[[nodiscard]] RgbPicture shrink_to_fit(const RgbPicture& picture, int columns, int rows);

/// Escape sequences that draw the picture from the cursor's row on, one line of text a pair of pixel rows. An
/// odd last row has black below.
[[nodiscard]] std::string half_blocks(const RgbPicture& picture);

}  // namespace host
