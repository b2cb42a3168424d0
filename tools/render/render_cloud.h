// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <filesystem>
#include <optional>
#include <string>

#include "tools/render/canvas.h"

namespace ilot::render {

struct RenderOptions {
  std::string by = "class";  // see colouring()
  View view;
  int size = 1600;                              // pixels of the longer side
  std::optional<std::array<double, 4>> bounds;  // x0, y0, x1, y1 in world coordinates, closed
};

// Draws a cloud orthographically. It reads the cloud twice from front to back, so memory is that of the picture. Throws
// Error when no point is within the bounds.
Image render_cloud(const std::filesystem::path& path, const RenderOptions& options);

}  // namespace ilot::render
