// SPDX-License-Identifier: MIT
//
// The window of a controller's display memory, and the address counter that runs through it.
#pragma once

namespace hal::mock {

struct AddressWindow {
  /// From `begin` to `end`, both inside.
  struct Axis {
    int begin = 0;
    int end = 0;
    int at = 0;
    [[nodiscard]] int size() const { return end - begin + 1; }
    /// True: it began anew.
    bool next() {
      if (++at <= end) return false;
      at = begin;
      return true;
    }
  };
  Axis column;
  Axis row;

  [[nodiscard]] int places() const { return column.size() * row.size(); }
  void restart() {
    column.at = column.begin;
    row.at = row.begin;
  }
  /// To the next place, along rows or down columns; after the last comes the first.
  void next(bool down = false) {
    if ((down ? row : column).next()) (down ? column : row).next();
  }
};

}  // namespace hal::mock
