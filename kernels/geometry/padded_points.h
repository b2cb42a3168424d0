// SPDX-License-Identifier: Apache-2.0
// Arrays that own the data that Points and OrientedPoints view.
#pragma once
#include <cstddef>
#include <vector>

#include "kernels/core/types.h"

namespace ilot {

// Number of elements behind the last point that kernels may read. It is at least the number that Points requires.
inline constexpr std::size_t kPointPadding = 16;

// Offsets from an anchor that the owner knows. Points are appended with add(). After the last one, pad() makes the
// arrays readable as Points requires. Structures with further columns per point derive from it.
struct PaddedPoints {
  std::vector<float> x, y, z;
  std::size_t size = 0;

  void reserve(std::size_t points) {
    for (auto* v : {&x, &y, &z}) v->reserve(points + kPointPadding);
  }
  void add(float px, float py, float pz) {
    x.push_back(px);
    y.push_back(py);
    z.push_back(pz);
    ++size;
  }
  void pad() {
    for (auto* v : {&x, &y, &z}) v->resize(size + kPointPadding, 0.0f);
  }
  // Sets the number of points, puts all of them at the anchor, and pads.
  void reset(std::size_t points) {
    size = points;
    for (auto* v : {&x, &y, &z}) v->assign(size + kPointPadding, 0.0f);
  }
  Points points() const { return {x.data(), y.data(), z.data(), size}; }
};

// The same with a normal for each point.
struct PaddedOrientedPoints : PaddedPoints {
  std::vector<float> nx, ny, nz;

  void reserve(std::size_t points) {
    PaddedPoints::reserve(points);
    for (auto* v : {&nx, &ny, &nz}) v->reserve(points + kPointPadding);
  }
  // Appends point i of `from`, which has normals.
  void add_from(const OrientedPoints& from, std::size_t i) {
    add(from.points.x[i], from.points.y[i], from.points.z[i]);
    nx.push_back(from.nx[i]);
    ny.push_back(from.ny[i]);
    nz.push_back(from.nz[i]);
  }
  void pad() {
    PaddedPoints::pad();
    for (auto* v : {&nx, &ny, &nz}) v->resize(size + kPointPadding, 0.0f);
  }
  void reset(std::size_t points) {
    PaddedPoints::reset(points);
    for (auto* v : {&nx, &ny, &nz}) v->assign(size + kPointPadding, 0.0f);
  }
  OrientedPoints oriented() const { return {points(), nx.data(), ny.data(), nz.data()}; }
  Vec3 position(std::size_t i) const { return {x[i], y[i], z[i]}; }
  Vec3 normal(std::size_t i) const { return {nx[i], ny[i], nz[i]}; }
};

}  // namespace ilot
