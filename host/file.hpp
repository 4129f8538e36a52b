// SPDX-License-Identifier: MIT
//
// Whole files in and out. Failures name the file and say why.
#pragma once

#include <string>
#include <string_view>

namespace host {

/// The bytes of a file, or of standard input for "-". Throws Failure.
std::string read_file(const std::string& path);

/// Writes a file through a temporary one beside it, so that `path` is whole or untouched. A path that exists
/// and is no regular file (/dev/stdout, a pipe) is written directly. Throws Failure.
void write_file(const std::string& path, std::string_view content);

}  // namespace host
