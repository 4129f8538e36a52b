// SPDX-License-Identifier: MIT
//
// A fuzz target without a fuzzer, for any compiler: runs every file of the folders named, and files by name.
#include <host/file.hpp>
#include <tests/fuzz/input.hpp>

#include <exception>
#include <filesystem>
#include <string>
#include <vector>

namespace {

void replay(const std::string& path) {
  const std::string bytes = host::read_file(path);
  // Exactly as much memory as there are bytes, so that a sanitizer sees whoever reads beyond.
  const std::vector<std::uint8_t> exact(bytes.begin(), bytes.end());
  std::fprintf(stderr, "%s\n", path.c_str());
  fuzz::run(fuzz::Input(exact));
}

}  // namespace

int main(int argc, char** argv) {
  try {
    int files = 0;
    for (int i = 1; i < argc; ++i) {
      if (!std::filesystem::is_directory(argv[i])) {
        replay(argv[i]);
        ++files;
        continue;
      }
      for (const auto& entry : std::filesystem::directory_iterator(argv[i])) {
        replay(entry.path().string());
        ++files;
      }
    }
    std::printf("%d inputs\n", files);
    return files > 0 ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
