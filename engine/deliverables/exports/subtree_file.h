// SPDX-License-Identifier: Apache-2.0
// Subtrees of implicit tiling [OGC 22-025r4, 7.4 to 7.6]: which tiles of a quadtree there are, and what their squares
// do not say.
#pragma once
#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace ilot {

// Choice: 85 tiles a file, so that three files lead to a tile of a city of 100 km. More makes clients read tiles that
// they do not look at, fewer makes them wait for more files one after the other.
constexpr std::uint32_t kSubtreeLevels = 4;

struct SubtreeTile {
  std::uint32_t level = 0, x = 0, y = 0;  // from the root of the subtree
  bool has_content = false;
  std::array<double, 12> box{};  // as boundingVolume.box
  double geometric_error_m = 0;
};

struct Subtree {
  std::vector<SubtreeTile> tiles;
  std::vector<std::array<std::uint32_t, 2>> below;  // x, y of the roots of subtrees at level kSubtreeLevels
};

// The schema of tilesets with such subtrees: boxes and errors have the semantics TILE_BOUNDING_BOX and
// TILE_GEOMETRIC_ERROR, which hold in place of those that follow from the root.
nlohmann::ordered_json subtree_schema();

// Returns the file. The order of tiles is free.
std::string subtree_file(Subtree subtree);

}  // namespace ilot
