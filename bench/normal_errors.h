// SPDX-License-Identifier: Apache-2.0
// Our normals of a whole cloud, and their angles to the normals of another library.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "bench/town.h"
#include "kernels/core/radix_sort.h"
#include "kernels/neighbours/knn.h"
#include "kernels/neighbours/normals.h"

namespace ilot::bench {

// The time includes the index.
inline std::vector<PackedNormal> all_normals(Points p, int k) {
  const NeighbourIndex index = build_neighbour_index(p);
  const auto queries = all_of(p.size);
  std::vector<PackedNormal> out(p.size);
  std::vector<std::int64_t> reach2(p.size);
  in_grains(p.size, [&](std::size_t begin, std::size_t end) {
    normals(index, std::span(queries).subspan(begin, end - begin), {k, kMaxSquaredReach},
            std::span(out).subspan(begin, end - begin), std::span(reach2).subspan(begin, end - begin));
  });
  return out;
}

// The time includes the sorting by Morton code, as points in any order need it.
inline std::vector<PackedNormal> all_normals_unsorted(const Surface& s, int k) {
  std::vector<std::uint64_t> codes(s.size);
  for (std::size_t i = 0; i < s.size; ++i)
    codes[i] = morton_code(
        {static_cast<std::uint32_t>(s.x[i]), static_cast<std::uint32_t>(s.y[i]), static_cast<std::uint32_t>(s.z[i])});
  const std::vector<std::uint32_t> order = sorted_order(codes);
  Surface sorted = s;
  for (std::size_t i = 0; i < s.size; ++i) {
    sorted.x[i] = s.x[order[i]];
    sorted.y[i] = s.y[order[i]];
    sorted.z[i] = s.z[order[i]];
  }
  return all_normals(sorted.view(), k);
}

struct NormalErrors {
  double median = 0, p99 = 0;  // degrees
};
constexpr double kSameNormal = 1e-4 * 180 / 3.141592653589793;  // 1e-4 rad

// normal(i) returns their normal, of any length and sign. Points for which we have no normal are left out.
template <class Normal>
NormalErrors normal_errors(const std::vector<PackedNormal>& ours, const Normal& normal) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const Vec3 u{static_cast<double>(ours[i].x), static_cast<double>(ours[i].y), static_cast<double>(ours[i].z)};
    const Vec3 v = normal(i);
    if (dot(u, u) == 0) continue;
    errors.push_back(std::atan2(norm(cross(u, v)), std::abs(dot(u, v))) * 180 / 3.141592653589793);
  }
  std::sort(errors.begin(), errors.end());
  return {errors[errors.size() / 2], errors[errors.size() / 100 * 99]};
}

}  // namespace ilot::bench
