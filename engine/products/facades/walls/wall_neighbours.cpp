// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/walls/wall_neighbours.h"

#include <cstdint>
#include <vector>

#include "engine/products/facades/walls/box_grid.h"

namespace ilot {
namespace {

// Choice: a cell has a few walls; time alone depends on it.
constexpr double kWallCell = 16;  // metres

FlatBox plan_of(const WallGroup& wall, double metres) {
  FlatBox box = FlatBox::none();
  const Vec3 end = wall.axes.origin + (wall.width / metres) * wall.axes.right;
  box.add({wall.axes.origin.x, wall.axes.origin.y}), box.add({end.x, end.y});
  return box;
}

}  // namespace

void for_each_near_wall(std::span<const WallGroup> walls, double reach, const WallParams& params,
                        const std::function<void(std::size_t, std::size_t)>& visit) {
  BoxGrid grid(kWallCell / params.metres_per_unit);
  std::vector<FlatBox> plans;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    plans.push_back(plan_of(walls[i], params.metres_per_unit).grown(params.relief_front / params.metres_per_unit));
    grid.add(static_cast<std::uint32_t>(i), plans[i]);
  }
  for (std::size_t i = 0; i < plans.size(); ++i)
    for (const std::uint32_t k : grid.near(plans[i].grown(reach / params.metres_per_unit)))
      if (k != i) visit(i, k);
}

}  // namespace ilot
