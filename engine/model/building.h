// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "kernels/core/types.h"

namespace ilot {

enum class SurfaceKind : std::uint8_t { roof, wall, ground };

// A flat face: the first ring is its outline, counter-clockwise seen from outside, the others are holes, clockwise.
// Rings are numbers of vertices and not closed.
struct BuildingSurface {
  SurfaceKind kind = SurfaceKind::roof;
  std::uint32_t plane_id = 0;  // 0 = none
  std::vector<std::vector<std::uint32_t>> rings;
};

using AttributeValue = std::variant<std::int64_t, double, std::string, bool>;

// A building as one closed solid. Coordinates in the CRS of the inputs.
struct Building {
  std::string id;  // unique within a model
  std::string lod = "2.2";
  std::vector<Vec3> vertices;
  std::vector<BuildingSurface> surfaces;
  std::vector<std::pair<std::string, AttributeValue>> attributes;
};

}  // namespace ilot
