// SPDX-License-Identifier: Apache-2.0
#include "kernels/neighbours/hough_normals.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <vector>

#include "kernels/core/portable_math.h"
#include "kernels/core/rng.h"
#include "kernels/neighbours/hough_normals_body.h"
#include "kernels/neighbours/knn.h"

namespace ilot {
namespace {

// The frames of the accumulator, as quaternions. Any rotations work that are far from each other's symmetries.
// Derived: see above: any rotations work that are no symmetries of each other.
constexpr double kFrames[simd::kHoughRotations][4]{
    {1, 0, 0, 0}, {9, 2, 1, 1}, {8, -1, 3, 2}, {7, 1, -2, 3}, {8, 3, 2, -2}};

std::vector<float> rotations() {
  std::vector<float> rows;
  for (const auto& [w, x, y, z] : kFrames) {
    const double s = 2 / (w * w + x * x + y * y + z * z);
    const double m[9]{1 - s * (y * y + z * z), s * (x * y - w * z),     s * (x * z + w * y),
                      s * (x * y + w * z),     1 - s * (x * x + z * z), s * (y * z - w * x),
                      s * (x * z - w * y),     s * (y * z + w * x),     1 - s * (x * x + y * y)};
    for (const double v : m) rows.push_back(static_cast<float>(v));
  }
  return rows;
}

// Returns the number of triplets to draw. By Hoeffding's inequality the shares of all bins are then within
// max_deviation with this confidence.
double triplets_needed(const HoughNormalsParams& params) {
  // Derived: three faces of a cube with 8 x 8 bins each.
  constexpr double kBins = 3 * 8 * 8;
  return natural_log(2 * kBins / (1 - params.confidence)) / (2 * params.max_deviation * params.max_deviation);
}

// Returns pairs of offsets round a ring of k, no two of which give the same triplets, in a fixed random order. There
// are as many as that number of triplets needs, or all.
std::vector<std::uint32_t> ring_offsets(std::size_t k, double triplets) {
  const std::size_t rounds = std::min(static_cast<std::size_t>(triplets / static_cast<double>(k)) + 1,
                                      simd::kHoughVotes / ((k + 15) / 16 * 16));
  std::vector<std::array<std::uint32_t, 2>> pairs;
  const auto size = static_cast<std::uint32_t>(k);
  for (std::uint32_t a = 1; a + 1 < size; ++a)
    for (std::uint32_t b = a + 1; b < size; ++b) {
      using Gaps = std::array<std::uint32_t, 3>;
      const std::uint32_t p = a, q = b - a, r = size - b;
      if (Gaps{p, q, r} <= std::min(Gaps{q, r, p}, Gaps{r, p, q})) pairs.push_back({a, b});
    }
  Rng rng(k);
  for (std::size_t i = pairs.size(); i > 1; --i) std::swap(pairs[i - 1], pairs[rng.below(i)]);
  std::vector<std::uint32_t> offsets;
  for (std::size_t i = 0; i < std::min(rounds, pairs.size()); ++i)
    offsets.insert(offsets.end(), pairs[i].begin(), pairs[i].end());
  return offsets;
}

// Computes directions from full lists of k neighbours, three numbers per query, all zero where there is none.
void directions(const Points& p, std::span<const std::uint32_t> queries, std::span<const std::uint32_t> neighbours,
                const std::vector<std::uint32_t>& offsets, const std::vector<float>& frames, std::span<double> out) {
  const auto count = static_cast<std::uint32_t>(queries.size());
  const int k = static_cast<int>(neighbours.size() / queries.size());
  simd::kHoughNormals.best().hough_directions({p.x, p.y, p.z, queries.data(), count, neighbours.data(), k,
                                               offsets.data(), static_cast<std::uint32_t>(offsets.size() / 2),
                                               frames.data(), out.data()});
}

// Replaces the direction and keeps the curvature of the principal components. A missing normal stays missing.
void put_direction(const double* v, PackedNormal& out) {
  const bool none = (out.x == 0 && out.y == 0 && out.z == 0) || (v[0] == 0 && v[1] == 0 && v[2] == 0);
  const std::uint16_t curvature = out.curvature;
  out = none ? PackedNormal{} : pack_normal({v[0], v[1], v[2]}, 0);
  if (!none) out.curvature = curvature;
}

}  // namespace

void hough_normals(const NeighbourIndex& index, std::span<const std::uint32_t> queries,
                   const HoughNormalsParams& params, std::span<PackedNormal> out, std::span<std::int64_t> reach2) {
  assert(out.size() == queries.size() && reach2.size() == queries.size());
  assert(params.k >= 3 && params.k <= kMaxNeighbours);
  constexpr std::size_t kBatch = 256;
  const std::size_t k = static_cast<std::size_t>(params.k);
  const std::vector<float> frames = rotations();
  const std::vector<std::uint32_t> offsets = ring_offsets(k, triplets_needed(params));
  std::vector<std::uint32_t> neighbours(kBatch * k);
  std::vector<double> found(3 * kBatch);
  for (std::size_t begin = 0; begin < queries.size(); begin += kBatch) {
    const std::size_t count = std::min(kBatch, queries.size() - begin);
    const auto batch = queries.subspan(begin, count);
    const auto lists = std::span(neighbours).first(count * k);
    const auto batch_reach2 = reach2.subspan(begin, count);
    const auto batch_out = out.subspan(begin, count);
    knn(index, batch, {params.k, params.max_d2}, lists, batch_reach2);
    normals_of_neighbours(index.points, batch, params.k, lists, batch_reach2, batch_out);
    for (std::size_t i = 0; i < count;) {
      std::size_t full = i;
      while (full < count && batch_reach2[full] >= 0) ++full;
      if (full > i) {
        directions(index.points, batch.subspan(i, full - i), lists.subspan(i * k, (full - i) * k), offsets, frames,
                   std::span(found).subspan(3 * i));
      }
      for (i = full; i < count && batch_reach2[i] < 0; ++i) {
        const auto list = lists.subspan(i * k, k);
        const auto n = static_cast<std::size_t>(std::find(list.begin(), list.end(), kNoNeighbour) - list.begin());
        std::fill_n(&found[3 * i], 3, 0.0);
        if (n < 3) continue;
        directions(index.points, batch.subspan(i, 1), list.first(n), ring_offsets(n, triplets_needed(params)), frames,
                   std::span(found).subspan(3 * i));
      }
    }
    for (std::size_t i = 0; i < count; ++i) put_direction(&found[3 * i], batch_out[i]);
  }
}

}  // namespace ilot
