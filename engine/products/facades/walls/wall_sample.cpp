// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/walls/wall_sample.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <tuple>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

// Derived: a cell of two steps holds a point wherever the wall was seen; finer cells than 5 cm show nothing of a
// window.
constexpr double kStepsOfCell = 2, kLeastCell = 0.05;  // steps; metres
// Derived: a bound of memory.
constexpr double kMostCells = 1 << 20;
// Choice: panes and reveals of 10 cm and more give cubes of their own.
constexpr double kVoxel = 0.1;  // metres; side of a cube that gives one point
constexpr std::size_t kMostKept = 1 << 16, kMostOff = 4096;
// Choice: what hides the foot of a wall is lower; doors are open down to the foot.
constexpr double kLowest = 0.4;  // metres above the foot
// Choice: reliefs thinner than this are roughness and noise of the wall.
constexpr double kLeastOff = 0.03;  // metres off the wall

struct Kept {
  std::uint64_t order = 0;  // by a hash of the cube
  std::array<float, 3> at{};
  friend bool operator<(const Kept& a, const Kept& b) { return std::tie(a.order, a.at) < std::tie(b.order, b.at); }
};

std::uint64_t cube_of(const FacadePoint& p) {
  const auto index = [](float v) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(static_cast<double>(v) / kVoxel))) &
           0x1fffff;
  };
  return index(p.u) << 42 | index(p.v) << 21 | index(p.w);
}

// Keeps the cubes that come first by their hash, and of each cube the first point by its coordinates.
class CubeSample {
 public:
  void add(const FacadePoint& p) {
    const Kept kept{mix64(cube_of(p)), {p.u, p.v, p.w}};
    if (kept.order > last_) return;
    kept_.push_back(kept);
    if (kept_.size() >= kMostKept) thin();
  }
  std::vector<Vec3> points() {
    thin();
    std::vector<Vec3> out;
    for (const Kept& k : kept_) out.push_back({k.at[0], k.at[1], k.at[2]});
    std::sort(out.begin(), out.end(), [](Vec3 a, Vec3 b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); });
    return out;
  }

 private:
  void thin() {
    std::sort(kept_.begin(), kept_.end());
    const auto same = [](const Kept& a, const Kept& b) { return a.order == b.order; };
    kept_.erase(std::unique(kept_.begin(), kept_.end(), same), kept_.end());
    if (kept_.size() <= kMostOff) return;
    kept_.resize(kMostOff);
    last_ = kept_.back().order;
  }
  std::vector<Kept> kept_;
  std::uint64_t last_ = ~std::uint64_t{0};
};

// Marks the cells whose four neighbours have points of the wall as well, and those between them and the foot.
void mark_solid(WallSample& s) {
  const std::vector<std::uint8_t> seen = s.wall;
  const auto at = [&](std::int64_t r, std::int64_t c) { return static_cast<std::size_t>(r * s.columns + c); };
  const auto low = static_cast<std::int64_t>(kLowest / s.cell) + 1;
  for (std::int64_t c = 1; c + 1 < s.columns; ++c) {
    std::int64_t lowest = s.rows;
    for (std::int64_t r = s.rows - 2; r > 0; --r) {
      if (seen[at(r, c)] == 0 || seen[at(r - 1, c)] == 0 || seen[at(r + 1, c)] == 0 || seen[at(r, c - 1)] == 0 ||
          seen[at(r, c + 1)] == 0)
        continue;
      s.wall[at(r, c)] = 2;
      lowest = r;
    }
    for (std::int64_t r = 0; lowest <= low && r < lowest; ++r) s.wall[at(r, c)] = 2;
  }
}

}  // namespace

WallSample sample_wall(const FacadeSite& site, const FacadePointSource& points) {
  WallSample s;
  s.width = site.width, s.height = site.height;
  s.cell = std::max({kLeastCell, kStepsOfCell * site.step, std::sqrt(site.width * site.height / kMostCells)});
  s.columns = static_cast<std::int64_t>(site.width / s.cell) + 1;
  s.rows = static_cast<std::int64_t>(site.height / s.cell) + 1;
  s.wall.assign(static_cast<std::size_t>(s.columns * s.rows), 0);
  const double least_off = std::max(kLeastOff, site.epsilon);
  CubeSample off;
  points([&](std::span<const FacadePoint> some, std::span<const SiteStation>) {
    for (const FacadePoint& p : some) {
      const bool of_wall = std::binary_search(site.wall.begin(), site.wall.end(), p.plane);
      if (!of_wall && std::abs(static_cast<double>(p.w)) > least_off) {
        off.add(p);
      } else if (p.u >= 0 && p.v >= 0) {
        const auto c = static_cast<std::int64_t>(static_cast<double>(p.u) / s.cell);
        const auto r = static_cast<std::int64_t>(static_cast<double>(p.v) / s.cell);
        if (c < s.columns && r < s.rows) s.wall[static_cast<std::size_t>(r * s.columns + c)] = 1;
      }
    }
  });
  mark_solid(s);
  s.off = off.points();
  return s;
}

}  // namespace ilot
