// SPDX-License-Identifier: Apache-2.0
#include "ilot/plane_search.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include "engine/api/lattice_points.h"
#include "engine/error.h"
#include "engine/products/planes/cells/plane_methods.h"
#include "kernels/core/rng.h"
#include "kernels/neighbours/knn.h"

namespace ilot {
namespace {

constexpr double kLeastEpsilon = 3;  // steps
constexpr std::size_t kLeastMeasured = 16;

void check(bool good, const char* sentence) {
  if (!good) throw Error(std::string("planes: ") + sentence, ExitCode::usage);
}

void check_options(const PlaneSearchOptions& o, std::size_t points) {
  check(!o.epsilon || *o.epsilon > 0, "epsilon must be above 0");
  check(!o.normal_angle_deg || (*o.normal_angle_deg >= 0 && *o.normal_angle_deg <= 90), "normal_angle_deg: 0 to 90");
  check(!o.min_points || *o.min_points >= 3, "min_points: at least 3");
  check(!o.connectivity || *o.connectivity > 0, "connectivity must be above 0");
  check(o.probability > 0 && o.probability < 1, "probability: between 0 and 1");
  check(o.normal_neighbours >= 3 && o.normal_neighbours <= kMaxNeighbours, "normal_neighbours: 3 to 64");
  check(o.metres_per_unit > 0, "metres_per_unit must be above 0");
  check(points >= kLeastMeasured || (o.epsilon && o.normal_angle_deg && o.min_points && o.connectivity),
        "so few points say nothing of epsilon, normal_angle_deg, min_points and connectivity: give all four");
}

// Given values in steps; epsilon less what rounding to the lattice may add to a distance.
PlaneParams params_of(const PlaneSearchOptions& o, const LatticePoints& lattice, const NeighbourIndex& index,
                      SeenFrom from) {
  PlaneParams params;
  if (lattice.given.size() >= kLeastMeasured)
    params = choose_plane_params({}, measure_sampling(index), from, lattice.step * o.metres_per_unit,
                                 static_cast<std::int64_t>(kLatticeSteps));
  if (o.epsilon) params.epsilon = *o.epsilon / lattice.step;
  check(params.epsilon >= kLeastEpsilon * (1 - 1e-9), "epsilon must be at least three steps of the lattice");
  if (o.normal_angle_deg) params.normal_angle = *o.normal_angle_deg;
  if (o.min_points) params.min_points = *o.min_points;
  if (o.connectivity)
    params.connectivity =
        static_cast<std::int64_t>(std::clamp(std::round(*o.connectivity / lattice.step), 1.0, 0x1p22));
  params.epsilon -= kMostRounding;
  return params;
}

// Of the places alone: neither their order nor that of the axes' steps shows.
std::uint64_t key_of(const LatticePoints& p, std::uint64_t seed) {
  std::uint64_t sum = seed;
  for (std::size_t i = 0; i < p.given.size(); ++i) {
    const auto whole = [](float v) { return static_cast<std::uint64_t>(static_cast<std::int64_t>(v) + (1 << 22)); };
    sum += mix64(mix64(whole(p.x[i]) << 32 | whole(p.y[i])) ^ whole(p.z[i]));
  }
  return mix64(sum);
}

Plane in_user_frame(const Plane& plane, const LatticePoints& lattice) {
  return {plane.n, plane.d * lattice.step - dot(plane.n, lattice.origin)};
}

// Labels by the number of their points, the most first; of as many the one with the first point.
PlaneSegments in_user_order(const PlaneSegments& found, const LatticePoints& lattice) {
  struct Entry {
    std::uint32_t points = 0, first = kNoNeighbour, plane = 0;
  };
  std::vector<Entry> entries(found.planes.size());
  for (std::uint32_t i = 0; i < entries.size(); ++i) entries[i].plane = i;
  PlaneSegments out;
  out.label.resize(lattice.given.size());
  for (std::size_t i = 0; i < lattice.given.size(); ++i) {
    if (found.label[i] == 0) continue;
    Entry& e = entries[found.label[i] - 1];
    ++e.points;
    e.first = std::min(e.first, lattice.given[i]);
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return a.points != b.points ? a.points > b.points : a.first < b.first;
  });
  std::vector<std::uint32_t> number(entries.size() + 1, 0);
  for (const Entry& e : entries) {
    if (e.points == 0) continue;
    out.planes.push_back(in_user_frame(found.planes[e.plane], lattice));
    number[e.plane + 1] = static_cast<std::uint32_t>(out.planes.size());
  }
  for (std::size_t i = 0; i < lattice.given.size(); ++i) out.label[lattice.given[i]] = number[found.label[i]];
  return out;
}

PlaneSearchResult search(const LatticePoints& lattice, const PlaneSearchOptions& options) {
  const NeighbourIndex index = build_neighbour_index(lattice.view());
  const std::vector<PackedNormal> normals = normals_of_all(index, {options.normal_neighbours, kMaxSquaredReach});
  std::vector<float> nx(lattice.x.size()), ny(nx.size()), nz(nx.size());
  for (std::size_t i = 0; i < normals.size(); ++i) {
    nx[i] = unpacked(normals[i].x);
    ny[i] = unpacked(normals[i].y);
    nz[i] = unpacked(normals[i].z);
  }
  const SeenFrom from = seen_from(normals);
  const PlaneParams params = params_of(options, lattice, index, from);
  const PlaneSegments found = find_planes(PlaneMethod::ransac, {{lattice.view(), nx.data(), ny.data(), nz.data()},
                                                                normals,
                                                                index,
                                                                params,
                                                                from,
                                                                {},
                                                                options.probability,
                                                                key_of(lattice, options.seed)});
  PlaneSearchResult result;
  result.segments = in_user_order(found, lattice);
  result.epsilon = options.epsilon.value_or((params.epsilon + kMostRounding) * lattice.step);
  result.normal_angle_deg = params.normal_angle;
  result.connectivity = static_cast<double>(params.connectivity) * lattice.step;
  result.step = lattice.step;
  result.min_points = params.min_points;
  return result;
}

}  // namespace

PlaneSearchResult find_planes(const PointArrays& points, const PlaneSearchOptions& options) {
  const LatticePoints lattice = lattice_points(points, options.step);  // refuses what are no points
  check_options(options, points.x.size());
  PlaneSearchResult result;
  on_threads(options.threads, [&] { result = search(lattice, options); });
  return result;
}

}  // namespace ilot
