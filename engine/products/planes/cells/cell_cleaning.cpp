// SPDX-License-Identifier: Apache-2.0
#include "engine/products/planes/cells/cell_cleaning.h"

#include <numeric>

#include "kernels/neighbours/knn.h"
#include "kernels/planes/cleaning.h"

namespace ilot {
namespace {

constexpr std::uint32_t kCleaningNeighbours = 16;

Kept by_neighbours(const NeighbourIndex& index, Cleaning cleaning) {
  std::vector<std::uint32_t> all(index.points.size), lists(index.points.size * kCleaningNeighbours);
  std::vector<std::int64_t> reach2(index.points.size);
  std::iota(all.begin(), all.end(), 0u);
  knn(index, all, {static_cast<int>(kCleaningNeighbours), kMaxSquaredReach}, lists, reach2);
  return cleaning == Cleaning::density ? density_filter(reach2)
                                       : isolation_filter({lists, kCleaningNeighbours}, reach2);
}

}  // namespace

std::vector<std::uint8_t> kept_points(const NeighbourIndex& index, Cleaning cleaning, const PlaneParams& params) {
  switch (cleaning) {
    case Cleaning::density:
    case Cleaning::isolation:
      return by_neighbours(index, cleaning);
    case Cleaning::distance:
      return distance_split(index.points, params.connectivity, params.min_points);
    case Cleaning::none:
      break;
  }
  return Kept(index.points.size, 1);
}

CellPoints only(const CellPoints& cell, const std::vector<std::uint8_t>& kept) {
  CellPoints part;
  for (std::size_t i = 0; i < cell.size; ++i) {
    if (kept[i] == 0) continue;
    part.add(cell.x[i], cell.y[i], cell.z[i]);
    part.normals.push_back(cell.normals[i]);
    part.core.push_back(cell.core[i]);
    if (!cell.colour_class.empty()) part.colour_class.push_back(cell.colour_class[i]);
  }
  part.pad();
  return part;
}

}  // namespace ilot
