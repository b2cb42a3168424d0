// SPDX-License-Identifier: Apache-2.0
#include "kernels/planes/region_growing.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "kernels/core/union_find.h"
#include "kernels/neighbours/knn.h"

namespace ilot {
namespace {

bool is_none(PackedNormal n) {
  return n.x == 0 && n.y == 0 && n.z == 0;
}

// Compares squares. The length of a packed normal is one only within rounding, and this must not widen the angle.
bool agree(PackedNormal a, PackedNormal b, double min_cos2) {
  const auto dot = [](PackedNormal u, PackedNormal v) {
    return static_cast<double>(std::int64_t{u.x} * v.x + std::int64_t{u.y} * v.y + std::int64_t{u.z} * v.z);
  };
  const double ab = dot(a, b);
  return ab * ab >= min_cos2 * (dot(a, a) * dot(b, b));
}

bool within(const Points& p, std::uint32_t i, std::uint32_t j, double max_d2) {
  const double dx = p.x[i] - p.x[j], dy = p.y[i] - p.y[j], dz = p.z[i] - p.z[j];
  return dx * dx + dy * dy + dz * dz <= max_d2;
}

// Joins i and j where `joined(i, j)` is true. It is only called with normals on both sides.
template <typename Joined>
Regions components(std::span<const PackedNormal> normals, const NeighbourLists& neighbours, std::uint32_t min_points,
                   const Joined& joined) {
  const auto n = static_cast<std::uint32_t>(normals.size());
  std::vector<std::uint32_t> parents(n);
  UnionFind sets(parents);
  for (std::uint32_t i = 0; i < n; ++i) {
    if (is_none(normals[i])) continue;
    for (const std::uint32_t j : neighbours.of(i)) {
      if (j == kNoNeighbour) break;
      if (j == i || is_none(normals[j]) || sets.find(i) == sets.find(j)) continue;
      if (joined(i, j)) sets.unite(i, j);
    }
  }
  std::vector<std::uint32_t> size(n, 0), seed(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t root = sets.find(i);
    if (size[root]++ == 0 || normals[i].curvature < normals[seed[root]].curvature) seed[root] = i;
  }
  Regions r;
  for (std::uint32_t i = 0; i < n; ++i)
    if (sets.find(i) == i && size[i] >= min_points && !is_none(normals[i])) r.seed.push_back(seed[i]);
  std::sort(r.seed.begin(), r.seed.end(), [&](std::uint32_t a, std::uint32_t b) {
    return normals[a].curvature != normals[b].curvature ? normals[a].curvature < normals[b].curvature : a < b;
  });
  r.count = static_cast<std::uint32_t>(r.seed.size());
  std::vector<std::uint32_t> number(n, 0);
  for (std::uint32_t s = 0; s < r.count; ++s) number[sets.find(r.seed[s])] = s + 1;
  r.id.resize(n);
  for (std::uint32_t i = 0; i < n; ++i) r.id[i] = number[sets.find(i)];
  return r;
}

Vec3 unit(PackedNormal n) {
  const Vec3 v{static_cast<double>(n.x), static_cast<double>(n.y), static_cast<double>(n.z)};
  return (1 / norm(v)) * v;
}

// The plane through the centroid of a point's neighbours, perpendicular to the point's normal.
struct LocalPlane {
  Vec3 normal;
  double offset = 0;  // of the point from the plane, along the normal
};

std::vector<LocalPlane> local_planes(const Points& p, std::span<const PackedNormal> normals,
                                     const NeighbourLists& neighbours) {
  std::vector<LocalPlane> planes(normals.size());
  for (std::uint32_t i = 0; i < normals.size(); ++i) {
    if (is_none(normals[i])) continue;
    planes[i].normal = unit(normals[i]);
    Vec3 sum;
    double count = 0;
    for (const std::uint32_t j : neighbours.of(i)) {
      if (j == kNoNeighbour) break;
      sum = sum + Vec3{p.x[j] - p.x[i], p.y[j] - p.y[i], p.z[j] - p.z[i]};
      ++count;
    }
    if (count > 0) planes[i].offset = -dot(planes[i].normal, sum) / count;
  }
  return planes;
}

}  // namespace

Regions grow_by_pairs(Points points, std::span<const PackedNormal> normals, const NeighbourLists& neighbours,
                      const PairGrowthParams& params) {
  assert(normals.size() == points.size && neighbours.indices.size() == points.size * neighbours.k);
  const std::vector<LocalPlane> local = local_planes(points, normals, neighbours);
  const double min_cos2 = params.min_cos * params.min_cos;
  const double max_d2 = static_cast<double>(params.max_gap) * static_cast<double>(params.max_gap);
  return components(normals, neighbours, params.min_points, [&](std::uint32_t i, std::uint32_t j) {
    if (!agree(normals[i], normals[j], min_cos2) || !within(points, i, j, max_d2)) return false;
    const Vec3 between{points.x[j] - points.x[i], points.y[j] - points.y[i], points.z[j] - points.z[i]};
    const LocalPlane &a = local[i], &b = local[j];
    const Vec3 r = between + (a.offset * a.normal - b.offset * b.normal);  // changes sign with the pair, bit for bit
    return std::max(std::abs(dot(r, a.normal)), std::abs(dot(r, b.normal))) <= params.max_offset;
  });
}

Regions grow_smooth(Points points, std::span<const PackedNormal> normals, const NeighbourLists& neighbours,
                    const SmoothGrowthParams& params) {
  assert(normals.size() == points.size && neighbours.indices.size() == points.size * neighbours.k);
  const double min_cos2 = params.min_cos * params.min_cos;
  const double max_d2 = static_cast<double>(params.max_gap) * static_cast<double>(params.max_gap);
  const double max_curvature = params.max_curvature * 3 * 65535;
  return components(normals, neighbours, params.min_points, [&](std::uint32_t i, std::uint32_t j) {
    return normals[i].curvature <= max_curvature && normals[j].curvature <= max_curvature &&
           agree(normals[i], normals[j], min_cos2) && within(points, i, j, max_d2);
  });
}

}  // namespace ilot
