// SPDX-License-Identifier: Apache-2.0
// Shared by tests of plane extraction: normals and neighbours of a set, shuffled copies, and properties of every valid
// answer.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "kernels/neighbours/knn.h"
#include "kernels/neighbours/normals.h"
#include "kernels/planes/plane_segments.h"
#include "kernels/planes/region_growing.h"
#include "tests/support/oriented_sets.h"

namespace ilot::test {

inline std::vector<PackedNormal> packed_normals(const OrientedSet& set) {
  std::vector<PackedNormal> packed(set.size);
  const auto pack = [](float v) { return static_cast<std::int16_t>(std::nearbyint(32767 * v)); };
  for (std::size_t i = 0; i < set.size; ++i) packed[i] = {pack(set.nx[i]), pack(set.ny[i]), pack(set.nz[i]), 0};
  return packed;
}

struct Neighbours {
  std::vector<std::uint32_t> indices;
  std::uint32_t k = 0;
  NeighbourLists lists() const { return {indices, k}; }
};

inline Neighbours neighbours_of(Points points, int k) {
  Neighbours n{std::vector<std::uint32_t>(points.size * static_cast<std::size_t>(k)), static_cast<std::uint32_t>(k)};
  std::vector<std::int64_t> reach2(points.size);
  knn(build_neighbour_index(points), all_of(points.size), {k, kMaxSquaredReach}, n.indices, reach2);
  return n;
}

inline std::vector<PackedNormal> estimated_normals(Points points, int k) {
  std::vector<PackedNormal> out(points.size);
  std::vector<std::int64_t> reach2(points.size);
  normals(build_neighbour_index(points), all_of(points.size), {k, kMaxSquaredReach}, out, reach2);
  return out;
}

// Returns the set with normals estimated from its points.
inline OrientedSet with_estimated_normals(OrientedSet set, int k) {
  const std::vector<PackedNormal> normals = estimated_normals(set.view().points, k);
  for (std::size_t i = 0; i < set.size; ++i) {
    const Vec3 n{static_cast<double>(normals[i].x), static_cast<double>(normals[i].y),
                 static_cast<double>(normals[i].z)};
    const double scale = dot(n, n) > 0 ? 1 / norm(n) : 0;
    set.nx[i] = static_cast<float>(scale * n.x);
    set.ny[i] = static_cast<float>(scale * n.y);
    set.nz[i] = static_cast<float>(scale * n.z);
  }
  return set;
}

// A shuffled copy of a set, and the position of each of its points in the set.
struct Shuffled {
  OrientedSet set;
  std::vector<std::uint32_t> from;  // for each point of the copy: its index in the original
};

inline Shuffled shuffled(const OrientedSet& set, std::uint64_t key) {
  Shuffled s{set, all_of(set.size)};
  Rng rng(key);
  for (std::size_t i = set.size; i > 1; --i) std::swap(s.from[i - 1], s.from[rng.below(i)]);
  for (std::size_t i = 0; i < set.size; ++i) {
    const std::size_t f = s.from[i];
    s.set.x[i] = set.x[f];
    s.set.y[i] = set.y[f];
    s.set.z[i] = set.z[f];
    s.set.nx[i] = set.nx[f];
    s.set.ny[i] = set.ny[f];
    s.set.nz[i] = set.nz[f];
  }
  return s;
}

// Renumbers labels by first appearance, so that equal partitions give equal labels. 0 stays 0.
inline std::vector<std::uint32_t> canonical(const std::vector<std::uint32_t>& label) {
  std::map<std::uint32_t, std::uint32_t> number{{0, 0}};
  std::vector<std::uint32_t> r;
  for (const std::uint32_t l : label) r.push_back(number.emplace(l, number.size()).first->second);
  return r;
}

// Returns the labels of a shuffled copy in the order of the original.
inline std::vector<std::uint32_t> in_original_order(const Shuffled& s, const std::vector<std::uint32_t>& label) {
  std::vector<std::uint32_t> r(label.size());
  for (std::size_t i = 0; i < label.size(); ++i) r[s.from[i]] = label[i];
  return r;
}

inline std::vector<std::size_t> label_sizes(const PlaneSegments& s) {
  std::vector<std::size_t> count(s.planes.size() + 1, 0);
  for (const std::uint32_t label : s.label) ++count[label];
  return count;
}

// Checks that labels refer to planes with a unit normal, that each has enough points, and that no labelled point is
// farther than epsilon.
inline void expect_sound(const OrientedSet& set, const PlaneSegments& s, double epsilon, std::uint32_t min_points) {
  ASSERT_EQ(s.label.size(), set.size);
  for (std::size_t i = 0; i < set.size; ++i) {
    ASSERT_LE(s.label[i], s.planes.size());
    if (s.label[i] == 0) continue;
    ASSERT_LE(std::abs(signed_distance(s.planes[s.label[i] - 1], set.position(i))), epsilon) << "point " << i;
  }
  const auto count = label_sizes(s);
  for (std::size_t p = 1; p < count.size(); ++p) {
    EXPECT_GE(count[p], min_points) << "plane " << p;
    EXPECT_NEAR(norm(s.planes[p - 1].n), 1, 1e-12);
  }
}

// Returns three faces of a box of 60 x 50 x 40 steps of 20, with noise and with isolated points around them.
inline OrientedSet box_corner(std::uint64_t key, double noise = 3, int lone = 500) {
  constexpr Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  OrientedSetBuilder b(key);
  const Vec3 o{2000, 2000, 2000};
  b.add(Patch{o, x, y, 60, 50, 20, noise});
  b.add(Patch{o, y, z, 50, 40, 20, noise});
  b.add(Patch{o, z, x, 40, 60, 20, noise});
  Rng rng(key + 1);
  for (int i = 0; i < lone; ++i) {
    const Vec3 n{rng.uniform() - 0.5, rng.uniform() - 0.5, rng.uniform() - 0.5};
    b.add(o + Vec3{1200 * rng.uniform(), 1000 * rng.uniform(), 800 * rng.uniform()}, (1 / norm(n)) * n);
  }
  return b.build();
}

}  // namespace ilot::test
