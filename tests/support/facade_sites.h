// SPDX-License-Identifier: Apache-2.0
// Walls made of rectangles in the planes of the axes, scanned from a station by exact rays.
#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "engine/products/facades/facade_site.h"
#include "kernels/core/rng.h"

namespace ilot::test {

// A rectangle on which `axis` (0 u, 1 v, 2 w) has the value `at`. low and high bound the two other axes, in their
// order.
struct Sheet {
  int axis = 2;
  double at = 0, low_a = 0, high_a = 0, low_b = 0, high_b = 0;
  std::uint32_t plane = 0;
};

struct ScannedWall {
  double width = 6, height = 4;
  std::vector<Sheet> sheets;

  // Adds the wall with holes: the sheets of the grid into which the sides of the holes cut it, all of plane 1.
  void wall(const std::vector<Sheet>& holes) {
    std::vector<double> us{0, width}, vs{0, height};
    for (const Sheet& h : holes) us.insert(us.end(), {h.low_a, h.high_a}), vs.insert(vs.end(), {h.low_b, h.high_b});
    std::sort(us.begin(), us.end());
    std::sort(vs.begin(), vs.end());
    for (std::size_t i = 0; i + 1 < us.size(); ++i)
      for (std::size_t k = 0; k + 1 < vs.size(); ++k) {
        const double u = (us[i] + us[i + 1]) / 2, v = (vs[k] + vs[k + 1]) / 2;
        bool hole = us[i + 1] <= us[i] || vs[k + 1] <= vs[k];
        for (const Sheet& h : holes) hole |= u > h.low_a && u < h.high_a && v > h.low_b && v < h.high_b;
        if (!hole) sheets.push_back({2, 0, us[i], us[i + 1], vs[k], vs[k + 1], 1});
      }
    for (const Sheet& h : holes) window(h);
  }
  // Adds reveals and a pane behind them. The depth is that of the hole, else 25 cm. A hole 2 cm deep is a joint between
  // stones.
  void window(const Sheet& h) {
    const double back = h.at < 0 ? h.at : -0.25;
    sheets.push_back({2, back, h.low_a, h.high_a, h.low_b, h.high_b, 0});
    for (const double u : {h.low_a, h.high_a}) sheets.push_back({0, u, h.low_b, h.high_b, back, 0, 0});
    for (const double v : {h.low_b, h.high_b}) sheets.push_back({1, v, h.low_a, h.high_a, back, 0, 0});
  }
  // Adds a block before the wall. Its front is of plane `plane`.
  void block(double u0, double u1, double v0, double v1, double out, std::uint32_t plane) {
    sheets.push_back({2, out, u0, u1, v0, v1, plane});
    for (const double u : {u0, u1}) sheets.push_back({0, u, v0, v1, 0, out, 0});
    for (const double v : {v0, v1}) sheets.push_back({1, v, u0, u1, 0, out, 0});
  }
};

// Scans the wall with rays in steps of `step` (tangents) and a range noise of 2 mm. Sheets of plane `hidden` stop rays
// and give no point. They stand for objects in the street that an office removes.
inline FacadeSite scan_wall(const ScannedWall& wall, Vec3 eye, double step, std::uint32_t hidden = 999,
                            double noise = 0.002) {
  FacadeSite site;
  site.axes = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
  site.width = wall.width;
  site.height = wall.height;
  site.noise = noise;
  site.epsilon = 3.5 * noise;
  site.wall = {1};
  site.stations = {{eye, step, step}};
  Rng rng(17);
  std::uint64_t on_wall = 0;
  const double far = eye.z;
  for (double a = (-0.2 - eye.x) / far; a < (wall.width + 0.2 - eye.x) / far; a += step)
    for (double b = (-0.2 - eye.y) / far; b < (wall.height + 0.2 - eye.y) / far; b += step) {
      const double along[3] = {a, b, -1}, from[3] = {eye.x, eye.y, eye.z};
      double nearest = INFINITY;
      std::uint32_t plane = 0;
      for (const Sheet& s : wall.sheets) {
        if (along[s.axis] == 0) continue;
        const double t = (s.at - from[s.axis]) / along[s.axis];
        const int first = s.axis == 0 ? 1 : 0, second = s.axis == 2 ? 1 : 2;
        const double p = from[first] + t * along[first], q = from[second] + t * along[second];
        if (t <= 0 || t >= nearest || p < s.low_a || p > s.high_a || q < s.low_b || q > s.high_b) continue;
        nearest = t;
        plane = s.plane;
      }
      if (nearest == INFINITY || plane == hidden) continue;
      const double length = std::sqrt(a * a + b * b + 1);
      const double t = nearest + noise * (rng.uniform() + rng.uniform() + rng.uniform() - 1.5) * 2 / length;
      site.points.push_back(
          {static_cast<float>(eye.x + t * a), static_cast<float>(eye.y + t * b), static_cast<float>(eye.z - t), plane});
      on_wall += plane == 1;
    }
  site.step = std::sqrt(wall.width * wall.height / static_cast<double>(on_wall));
  return site;
}

// Joins two scans of one wall.
inline FacadeSite joined(FacadeSite site, const FacadeSite& other) {
  site.points.insert(site.points.end(), other.points.begin(), other.points.end());
  site.stations.insert(site.stations.end(), other.stations.begin(), other.stations.end());
  site.step = 1 / std::sqrt(1 / (site.step * site.step) + 1 / (other.step * other.step));
  return site;
}

// Scans a wall from the left. Rays that cross the wall where it is open continue to a pane 25 cm behind it.
inline FacadeSite scan_wall_open_where(const std::function<bool(double, double)>& open) {
  constexpr Vec3 kEye{-2, 1.2, 7};
  ScannedWall wall;
  wall.wall({});
  FacadeSite site = scan_wall(wall, kEye, 0.0025);
  for (FacadePoint& p : site.points) {
    if (!open(p.u, p.v)) continue;
    const double on = (kEye.z + 0.25) / kEye.z;
    p = {static_cast<float>(kEye.x + (p.u - kEye.x) * on), static_cast<float>(kEye.y + (p.v - kEye.y) * on), -0.25F, 0};
  }
  return site;
}

}  // namespace ilot::test
