// SPDX-License-Identifier: Apache-2.0
// Reads the whole contents of a file.
#pragma once
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace ilot::test {

inline std::string file_bytes(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace ilot::test
