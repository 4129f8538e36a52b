// SPDX-License-Identifier: MIT
//
// Where the simulator's frames go to be looked at.
#pragma once

#include <host/sim/rgb_picture.hpp>

#include <memory>
#include <string>

namespace host {

class Viewer {
 public:
  Viewer() = default;
  Viewer(const Viewer&) = delete;
  Viewer& operator=(const Viewer&) = delete;
  virtual ~Viewer() = default;

  /// Shows one frame. False once the user has asked to end.
  [[nodiscard]] virtual bool show(const RgbPicture& picture) = 0;
};

/// True if this build has windows and a display is there to open them on.
[[nodiscard]] bool window_possible();
/// A window of the picture's size times `scale` (0: as large as suits the screen). Ends with Escape, Q or the
/// window's close button. Throws Failure if it can't be opened.
[[nodiscard]] std::unique_ptr<Viewer> open_window(const std::string& title, int width, int height, int scale);

/// True if standard output is a terminal.
[[nodiscard]] bool terminal_possible();
/// A preview on the terminal; ends with any key. Throws Failure if standard output is no terminal.
[[nodiscard]] std::unique_ptr<Viewer> open_terminal();

}  // namespace host
