// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/screens.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "engine/products/facades/openings/wall_cells.h"
#include "engine/products/facades/same_wall.h"

namespace ilot {
namespace {

// Choice: scaffolds of 0.6 to 1.2 m stand 0.3 m before a wall; rooms, loggias and arcades are deeper.
constexpr double kFarthestBehind = 2;  // metres from a screen to the wall behind it
// Derived: more than half.
constexpr double kAlongScreen = 0.5;  // share of its length with the wall behind it
// Choice: openings take up to half of a front, and of what is seen through them little lies at one depth; an arcade
// below two storeys takes less than a third.
constexpr double kPassedShare = 1.0 / 3;  // share of the cells of a screen in which more rays met the wall behind it

}  // namespace

double depth_behind(const WallGroup& front, const WallGroup& wall, double metres_per_unit) {
  if (dot(front.axes.out, wall.axes.out) < kOneWallCosine) return 0;
  const auto place = [&](double u) {
    const Vec3 off = metres_per_unit * (wall.axes.origin - front.axes.origin) + u * wall.axes.right;
    return Place2{dot(off, front.axes.right), -dot(off, front.axes.out)};
  };
  const Place2 a = place(0), b = place(wall.width);
  const double from = std::max(0.0, std::min(a.u, b.u)), to = std::min(front.width, std::max(a.u, b.u));
  if (to - from <= kAlongScreen * front.width) return 0;
  // Where the middle of the common part is, since the two need not be quite parallel.
  const double depth = a.v + (b.v - a.v) * ((from + to) / 2 - a.u) / (b.u - a.u);
  return depth >= kOneWallDepth && depth <= kFarthestBehind ? depth : 0;
}

bool is_screen(const RaySamples& samples, double behind) {
  const WallCells cells = wall_grid(samples.site());
  std::vector<std::int32_t> more(cells.what.size(), 0);  // rays that met the front, less those that met the wall behind
  std::vector<bool> known(cells.what.size(), false);
  for (const Ray& ray : samples.all()) {
    const bool front = samples.on_wall(ray);
    if (!front && std::abs(static_cast<double>(ray.at.w) + behind) > kFlatRelief) continue;
    const Place2 p = samples.crossing(ray, 0);
    if (p.u < 0 || p.v < 0) continue;
    const auto c = static_cast<std::int64_t>(p.u / cells.cell), r = static_cast<std::int64_t>(p.v / cells.cell);
    if (c >= cells.columns || r >= cells.rows) continue;
    const auto i = static_cast<std::size_t>(r * cells.columns + c);
    more[i] += front ? 1 : -1;
    known[i] = true;
  }
  const auto passed = std::count_if(more.begin(), more.end(), [](std::int32_t n) { return n < 0; });
  return static_cast<double>(passed) > kPassedShare * static_cast<double>(std::count(known.begin(), known.end(), true));
}

std::vector<WallGroup> take_screens(const FacadeWork& work, const std::function<bool(const WallGroup&)>& wanted,
                                    std::vector<WallGroup>& walls) {
  std::vector<WallGroup> left, screens;
  for (const WallGroup& front : walls) {
    double behind = 0;
    if (wanted(front))
      for (const WallGroup& wall : walls) behind = std::max(behind, depth_behind(front, wall, work.metres_per_unit));
    bool screen = false;
    if (behind > 0) {
      const GatheredFacade gathered = gather_facade(work, front);
      screen = is_screen(RaySamples(gathered.site, gathered.points, {work.store.folder()}, gathered.far), behind);
    }
    (screen ? screens : left).push_back(front);
  }
  walls = std::move(left);
  return screens;
}

}  // namespace ilot
