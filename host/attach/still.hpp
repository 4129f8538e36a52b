// SPDX-License-Identifier: MIT
//
// One picture on a panel.
#pragma once

#include <host/attach/attach.hpp>
#include <host/png.hpp>

namespace host {

/// Shows the picture in the panel's top left corner, the rest in its index 0. The picture's colours are
/// loaded where the panel can take them all, else each becomes the nearest that the panel has. Returns when
/// it is shown. Throws Failure if the picture is larger than the panel, or on a fault of the panel.
void show_still(AttachedPanel& attached, const IndexedPicture& picture);

/// Shows it and either keeps showing it until the user ends the program (`hold`), or leaves it on the panel
/// behind. Throws Failure, also if this panel shows nothing once the program has ended.
void show_still_and_leave(const AttachOptions& options, const IndexedPicture& picture, bool hold);

}  // namespace host
