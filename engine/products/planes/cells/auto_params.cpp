// SPDX-License-Identifier: Apache-2.0
#include "engine/products/planes/cells/auto_params.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "kernels/core/moments.h"
#include "kernels/core/quantile.h"
#include "kernels/neighbours/knn.h"

namespace ilot {
namespace {

constexpr std::uint32_t kQueries = 512;
constexpr double kPi = 3.141592653589793;

struct Rule {
  double steps;         // connectivity in steps
  double area_m2;       // area of the smallest plane
  double fewest, most;  // points of the smallest plane
};
constexpr Rule kFromTheAir{4, 1.2, 12, 200}, kFromTheGround{6, 0.005, 30, 200};

double quantile(std::vector<double> values, double share) {
  return values.empty() ? 0 : lower_quantile(values, share);
}

// The sampling from one in `every` points, with the neighbours of each.
Sampling sampling_of(Points points, std::span<const std::uint32_t> neighbours, std::span<const std::int64_t> reach2,
                     std::size_t every) {
  std::vector<double> steps, noises;
  for (std::size_t q = 0; q < reach2.size(); q += every) {
    if (reach2[q] < 0) continue;
    // There are k points on a disc of radius r, so each has an area of pi r^2 / k.
    steps.push_back(std::sqrt(kPi * static_cast<double>(reach2[q]) / kSamplingNeighbours));
    const Moments m = moments_of(points, neighbours.subspan(q * kSamplingNeighbours, kSamplingNeighbours));
    const double least = std::max(0.0, smallest_eigen(covariance(m)).value);
    noises.push_back(std::sqrt(least * kSamplingNeighbours / (kSamplingNeighbours - 3)));
  }
  // The flat third of the neighbourhoods is used. Its 30% quantile is a tenth below the median of pure noise.
  return {quantile(std::move(steps), 0.5), quantile(std::move(noises), 0.3) / 0.9};
}

}  // namespace

Sampling measure_sampling(const NeighbourIndex& index) {
  const auto n = static_cast<std::uint32_t>(index.points.size);
  if (n < kSamplingNeighbours) return {};
  std::vector<std::uint32_t> queries;
  for (std::uint32_t i = 0; i < n; i += std::max<std::uint32_t>(1, n / kQueries)) queries.push_back(i);
  std::vector<std::uint32_t> neighbours(queries.size() * kSamplingNeighbours);
  std::vector<std::int64_t> reach2(queries.size());
  knn(index, queries, {kSamplingNeighbours, kMaxSquaredReach}, neighbours, reach2);
  return sampling_of(index.points, neighbours, reach2, 1);
}

Sampling measure_sampling(Points points, std::span<const std::uint32_t> neighbours,
                          std::span<const std::int64_t> reach2) {
  const std::size_t n = points.size;
  return n < kSamplingNeighbours ? Sampling{}
                                 : sampling_of(points, neighbours, reach2, std::max<std::size_t>(1, n / kQueries));
}

SeenFrom seen_from(std::span<const PackedNormal> normals) {
  constexpr int kLevel = 9830;  // |z| of 17.5 degrees out of the horizontal, in units of PackedNormal
  std::size_t known = 0, level = 0;
  for (const PackedNormal& n : normals) {
    if (n.x == 0 && n.y == 0 && n.z == 0) continue;
    ++known;
    level += std::abs(n.z) < kLevel;
  }
  return 4 * level > known ? SeenFrom::ground : SeenFrom::air;
}

PlaneParams choose_plane_params(const PlanesSettings& settings, const Sampling& sampling, SeenFrom from,
                                double unit_metres, std::int64_t reach) {
  // Derived: 3.5 standard deviations contain 99.95 % of normal noise; then the rounding of the lattice, and a quarter
  // of the step. Choice: half a metre at most.
  constexpr double kNoiseFactor = 3.5, kLeastUnits = 3, kLeastSteps = 0.25, kMostMetres = 0.5;
  // Choice: noise bends normals of terrestrial scans by less; finely curved walls are split by it.
  constexpr double kMostAngle = 25, kLeastAngle = 10, kNoisy = 0.3;
  // Derived: the range of the kernel.
  constexpr double kLeastReach = 4, kMostReach = 0x1p20;  // the range that euclidean_clusters accepts for a cell
  const Rule& rule = from == SeenFrom::air ? kFromTheAir : kFromTheGround;
  PlaneParams p;
  const double surface = std::max(kNoiseFactor * sampling.noise, kLeastSteps * sampling.step);
  p.epsilon = settings.epsilon ? *settings.epsilon / unit_metres
                               : std::max(kLeastUnits, std::min(surface, kMostMetres / unit_metres));
  const double step_ratio = from == SeenFrom::air ? kLeastSteps * sampling.step / p.epsilon : 1;
  p.normal_angle =
      settings.normal_angle.value_or(std::clamp(step_ratio * step_ratio * kMostAngle, kLeastAngle, kMostAngle));
  const double connectivity = settings.connectivity ? *settings.connectivity / unit_metres
                                                    : std::min(rule.steps * sampling.step, static_cast<double>(reach));
  p.connectivity = static_cast<std::int64_t>(std::clamp(std::ceil(connectivity), kLeastReach, kMostReach));
  p.noisy = p.epsilon > kNoisy * sampling.step;
  const double step_m = std::max(sampling.step, 1.0) * unit_metres;
  const double points = std::clamp(std::ceil(rule.area_m2 / (step_m * step_m)), rule.fewest, rule.most);
  p.min_points =
      settings.min_points ? static_cast<std::uint32_t>(*settings.min_points) : static_cast<std::uint32_t>(points);
  return p;
}

}  // namespace ilot
