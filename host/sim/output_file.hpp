// SPDX-License-Identifier: MIT
//
// A file for what a run came to: opened before it, so that a path that can't be written is said at once, and
// not after an hour.
#pragma once

#include <host/failure.hpp>

#include <fstream>
#include <string>
#include <string_view>

namespace host {

class OutputFile {
 public:
  /// Throws Failure.
  explicit OutputFile(const std::string& path) : path_(path), file_(path, std::ios::trunc) { check(); }

  /// Writes all there is to say. Throws Failure.
  void write(std::string_view content) {
    file_ << content;
    file_.close();
    check();
  }

 private:
  void check() const {
    if (!file_) throw Failure("cannot write " + path_);
  }

  std::string path_;
  std::ofstream file_;
};

}  // namespace host
