// SPDX-License-Identifier: Apache-2.0
// Integer point sets for oracles. Each kind tests a different difficulty. All are Morton sorted and padded as Points
// requires.
#pragma once
#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include "kernels/core/rng.h"
#include "kernels/core/types.h"
#include "kernels/geometry/padded_points.h"
#include "kernels/neighbours/morton.h"

namespace ilot::test {

inline std::vector<std::uint32_t> all_of(std::size_t n) {
  std::vector<std::uint32_t> indices(n);
  std::iota(indices.begin(), indices.end(), 0u);
  return indices;
}

struct PointSet : PaddedPoints {
  std::string name;
  Points view() const { return points(); }
};

inline PointSet make_set(std::string name, std::vector<Cell3> cells) {
  std::vector<std::uint64_t> codes;
  for (const Cell3& c : cells) codes.push_back(morton_code(c));
  std::sort(codes.begin(), codes.end());
  PointSet set;
  set.name = std::move(name);
  for (const std::uint64_t code : codes) {
    const Cell3 c = morton_cell(code);
    set.add(static_cast<float>(c.x), static_cast<float>(c.y), static_cast<float>(c.z));
  }
  set.pad();
  return set;
}

// Returns sets of n points each: uniform in a cube, a surface, an integer grid, a line, duplicates, clusters far apart.
inline std::vector<PointSet> point_sets(std::uint32_t n) {
  Rng rng(n);
  const auto draw = [&](std::uint32_t bound) { return static_cast<std::uint32_t>(rng.below(bound)); };
  std::vector<Cell3> cube, surface, grid, line, duplicates, clusters;
  for (std::uint32_t i = 0; i < n; ++i) {
    cube.push_back({draw(1000), draw(1000), draw(1000)});
    const std::uint32_t u = draw(20000), v = draw(20000);
    surface.push_back({u, v, 3000 + u / 4 + draw(20)});
    grid.push_back({i % 16 * 10, i / 16 % 16 * 10, i / 256 * 10});
    line.push_back({i * 7, i * 7, i * 7});
    duplicates.push_back({draw(3), draw(3), draw(2)});
    const std::uint32_t home = draw(4) * 500000;
    clusters.push_back({home + draw(50), home + draw(50), draw(50)});
  }
  return {make_set("cube", cube), make_set("surface", surface),       make_set("grid", grid),
          make_set("line", line), make_set("duplicates", duplicates), make_set("clusters", clusters)};
}

}  // namespace ilot::test
