// SPDX-License-Identifier: Apache-2.0
#include "kernels/neighbours/normals.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "kernels/core/eigen3.h"
#include "kernels/neighbours/knn.h"
#include "kernels/neighbours/normals_body.h"

namespace ilot {
namespace {

// Returns count^2 times the covariance. Every term is an integer below 2^53 while count times the widest offset is
// below 2^26.
Symmetric3 scaled_covariance(const Points& p, std::uint32_t query, std::span<const std::uint32_t> neighbours) {
  double sx = 0, sy = 0, sz = 0;
  Symmetric3 m;
  for (std::uint32_t j : neighbours) {
    const double dx = p.x[j] - p.x[query];
    const double dy = p.y[j] - p.y[query];
    const double dz = p.z[j] - p.z[query];
    sx += dx;
    sy += dy;
    sz += dz;
    m.xx += dx * dx;
    m.xy += dx * dy;
    m.xz += dx * dz;
    m.yy += dy * dy;
    m.yz += dy * dz;
    m.zz += dz * dz;
  }
  const double n = static_cast<double>(neighbours.size());
  return {n * m.xx - sx * sx, n * m.xy - sx * sy, n * m.xz - sx * sz,
          n * m.yy - sy * sy, n * m.yz - sy * sz, n * m.zz - sz * sz};
}

Vec3 pointing_up(Vec3 v) {
  const bool down = v.z < 0 || (v.z == 0 && (v.y < 0 || (v.y == 0 && v.x < 0)));
  return down ? -1.0 * v : v;
}

std::int16_t pack_component(double v) {
  return static_cast<std::int16_t>(std::nearbyint(v * 32767));
}

PackedNormal normal_of(const Points& p, std::uint32_t query, std::span<const std::uint32_t> neighbours) {
  if (neighbours.size() < 3) return {};
  const Symmetric3 covariance = scaled_covariance(p, query, neighbours);
  const SmallestEigen e = smallest_eigen(covariance);
  if (!e.unique) return {};
  const double trace = covariance.xx + covariance.yy + covariance.zz;
  return pack_normal(e.vector, std::clamp(3 * e.value / trace, 0.0, 1.0));
}

// Whether the neighbours suit the vector body: all are present, and squared offsets are below 2^24.
bool is_near(std::int64_t reach2) {
  return reach2 >= 0 && reach2 < (std::int64_t{1} << 24);
}

}  // namespace

PackedNormal pack_normal(Vec3 unit, double curvature) {
  const Vec3 n = pointing_up(unit);
  return {pack_component(n.x), pack_component(n.y), pack_component(n.z),
          static_cast<std::uint16_t>(std::nearbyint(curvature * 65535))};
}

void normals_of_neighbours(Points points, std::span<const std::uint32_t> queries, int k,
                           std::span<const std::uint32_t> neighbours, std::span<const std::int64_t> reach2,
                           std::span<PackedNormal> out) {
  static_assert(sizeof(PackedNormal) == 4 * sizeof(std::int16_t));
  const std::size_t stride = static_cast<std::size_t>(k);
  assert(neighbours.size() == queries.size() * stride && reach2.size() == queries.size());
  for (std::size_t i = 0; i < queries.size();) {
    std::size_t far = i;
    while (far < queries.size() && is_near(reach2[far])) ++far;
    simd::kNormals.best().neighbour_normals({points.x, points.y, points.z, &queries[i],
                                             static_cast<std::uint32_t>(far - i), &neighbours[i * stride], k,
                                             &out[i].x});
    for (i = far; i < queries.size() && !is_near(reach2[i]); ++i) {
      const auto list = neighbours.subspan(i * stride, stride);
      const auto end = std::find(list.begin(), list.end(), kNoNeighbour);
      out[i] = normal_of(points, queries[i], list.first(static_cast<std::size_t>(end - list.begin())));
    }
  }
}

void normals(const NeighbourIndex& index, std::span<const std::uint32_t> queries, const NormalsParams& params,
             std::span<PackedNormal> out, std::span<std::int64_t> reach2) {
  assert(out.size() == queries.size() && reach2.size() == queries.size());
  constexpr std::size_t kBatch = 256;  // neighbour lists of a batch stay in the cache
  std::vector<std::uint32_t> neighbours(kBatch * static_cast<std::size_t>(params.k));
  for (std::size_t begin = 0; begin < queries.size(); begin += kBatch) {
    const std::size_t count = std::min(kBatch, queries.size() - begin);
    const auto batch = queries.subspan(begin, count);
    const auto lists = std::span(neighbours).first(count * static_cast<std::size_t>(params.k));
    knn(index, batch, {params.k, params.max_d2}, lists, reach2.subspan(begin, count));
    normals_of_neighbours(index.points, batch, params.k, lists, reach2.subspan(begin, count),
                          out.subspan(begin, count));
  }
}

}  // namespace ilot
