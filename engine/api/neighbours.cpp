// SPDX-License-Identifier: Apache-2.0
#include "ilot/neighbours.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <string>
#include <tuple>

#include "engine/api/lattice_points.h"
#include "engine/error.h"
#include "kernels/core/parallel.h"
#include "kernels/neighbours/knn.h"

namespace ilot {
namespace {

static_assert(kNoPoint == kNoNeighbour);

void check_count(const NeighbourOptions& options, int least) {
  if (options.count < least || options.count > kMaxNeighbours)
    throw Error("count: " + std::to_string(least) + " to " + std::to_string(kMaxNeighbours) + " neighbours",
                ExitCode::usage);
  if (!(options.max_distance >= 0)) throw Error("max_distance: at least 0", ExitCode::usage);
}

// The farthest that a neighbour may be, on the lattice.
std::int64_t squared_reach(const NeighbourOptions& options, double step) {
  const double reach = std::round(options.max_distance / step);
  if (options.max_distance == 0 || reach * reach >= static_cast<double>(kMaxSquaredReach)) return kMaxSquaredReach;
  return static_cast<std::int64_t>(reach * reach);
}

double distance_between(const PointArrays& p, std::uint32_t i, std::uint32_t j) {
  return norm({p.x[i] - p.x[j], p.y[i] - p.y[j], p.z[i] - p.z[j]});
}

// The neighbours of one point, as the kernel found them, into its row: the nearest first.
void put_row(const PointArrays& points, const LatticePoints& lattice, std::uint32_t query,
             std::span<const std::uint32_t> found, NeighbourTable& table) {
  const std::uint32_t self = lattice.given[query];
  struct Near {
    double distance;
    bool other;
    std::uint32_t index;
  };
  std::vector<Near> row;
  for (const std::uint32_t at : found) {
    if (at == kNoNeighbour) break;
    const std::uint32_t index = lattice.given[at];
    row.push_back({distance_between(points, self, index), index != self, index});
  }
  std::sort(row.begin(), row.end(), [](const Near& a, const Near& b) {
    return std::tie(a.distance, a.other, a.index) < std::tie(b.distance, b.other, b.index);
  });
  const std::size_t first = std::size_t{self} * static_cast<std::size_t>(table.count);
  for (std::size_t i = 0; i < row.size(); ++i) {
    table.index[first + i] = row[i].index;
    table.distance[first + i] = static_cast<float>(row[i].distance);
  }
}

}  // namespace

NeighbourTable nearest_neighbours(const PointArrays& points, const NeighbourOptions& options) {
  check_count(options, 1);
  const LatticePoints lattice = lattice_points(points, options.step);
  const auto k = static_cast<std::size_t>(options.count);
  NeighbourTable table{options.count, {}, {}};
  table.index.assign(points.x.size() * k, kNoPoint);
  table.distance.assign(points.x.size() * k, std::numeric_limits<float>::infinity());
  const KnnParams params{options.count, squared_reach(options, lattice.step)};
  on_threads(options.threads, [&] {
    const NeighbourIndex index = build_neighbour_index(lattice.view());
    parallel_for((lattice.given.size() + kBatch - 1) / kBatch, [&](std::size_t batch) {
      const std::size_t first = batch * kBatch, count = std::min(kBatch, lattice.given.size() - first);
      std::vector<std::uint32_t> queries(count), found(count * k);
      std::vector<std::int64_t> reach2(count);
      std::iota(queries.begin(), queries.end(), static_cast<std::uint32_t>(first));
      knn(index, queries, params, found, reach2);
      for (std::size_t i = 0; i < count; ++i)
        put_row(points, lattice, queries[i], std::span(found).subspan(i * k, k), table);
    });
  });
  return table;
}

NormalArrays estimate_normals(const PointArrays& points, const NeighbourOptions& options) {
  check_count(options, 3);
  const LatticePoints lattice = lattice_points(points, options.step);
  std::vector<PackedNormal> packed;
  on_threads(options.threads, [&] {
    packed =
        normals_of_all(build_neighbour_index(lattice.view()), {options.count, squared_reach(options, lattice.step)});
  });
  NormalArrays out;
  for (auto* v : {&out.x, &out.y, &out.z, &out.curvature}) v->resize(packed.size());
  for (std::size_t i = 0; i < packed.size(); ++i) {
    const std::uint32_t at = lattice.given[i];
    out.x[at] = unpacked(packed[i].x);
    out.y[at] = unpacked(packed[i].y);
    out.z[at] = unpacked(packed[i].z);
    out.curvature[at] = static_cast<float>(packed[i].curvature) / (3.0f * 65535.0f);
  }
  return out;
}

}  // namespace ilot
