// SPDX-License-Identifier: Apache-2.0
// Arrays that own what Points and OrientedPoints are views of.
#pragma once
#include <cstddef>
#include <vector>

#include "kernels/core/types.h"

namespace ilot {

// Elements behind the last point that kernels may read: at least as many as Points asks for.
inline constexpr std::size_t kPointPadding = 16;

// Offsets from an anchor that the owner knows. Points are appended with add(); after the last one pad() makes the
// arrays readable as Points asks. Structures with further columns per point derive from it.
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
  // So many points at the anchor, padded.
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
  // The point at a position of others that have normals.
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
