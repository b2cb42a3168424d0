// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace ilot::render {

using Rgb = std::array<std::uint8_t, 3>;

struct Image {
  int width = 0, height = 0;
  std::vector<Rgb> pixels;  // row by row from the top
};

// Writes an 8-bit PNG. The file is written whole or not at all. Throws Error.
void write_png(const Image& image, const std::filesystem::path& path);

}  // namespace ilot::render
