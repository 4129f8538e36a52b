// SPDX-License-Identifier: MIT
#include <host/failure.hpp>
#include <host/file.hpp>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <system_error>

namespace host {
namespace {

void write_stream(const std::string& target, const std::string& name, std::string_view content) {
  std::ofstream file(target, std::ios::binary | std::ios::trunc);
  if (!file) throw Failure(name + ": " + std::strerror(errno));
  file.write(content.data(), static_cast<std::streamsize>(content.size()));
  file.close();
  if (!file) throw Failure(name + ": writing failed");
}

}  // namespace

std::string read_file(const std::string& path) {
  std::ostringstream content;
  if (path == "-") {
    content << std::cin.rdbuf();
    return content.str();
  }
  if (std::error_code error; std::filesystem::is_directory(path, error))
    throw Failure(path + ": is a directory");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw Failure(path + ": " + std::strerror(errno));
  content << file.rdbuf();
  if (file.bad()) throw Failure(path + ": can't be read");
  return content.str();
}

void write_file(const std::string& path, std::string_view content) {
  std::error_code error;
  const auto kind = std::filesystem::status(path, error).type();
  if (kind != std::filesystem::file_type::not_found && kind != std::filesystem::file_type::regular)
    return write_stream(path, path, content);
  const std::string partial = path + ".part";
  try {
    write_stream(partial, path, content);
  } catch (const Failure&) {
    std::filesystem::remove(partial, error);
    throw;
  }
  std::filesystem::rename(partial, path, error);
  if (!error) return;
  const std::string reason = error.message();
  std::filesystem::remove(partial, error);
  throw Failure(path + ": " + reason);
}

}  // namespace host
