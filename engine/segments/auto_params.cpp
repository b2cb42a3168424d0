// SPDX-License-Identifier: Apache-2.0
#include "engine/segments/auto_params.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "kernels/core/moments.h"
#include "kernels/neighbours/knn.h"

namespace ilot {
namespace {

constexpr int kNeighbours = 16;
constexpr std::uint32_t kQueries = 512;
constexpr double kPi = 3.141592653589793;

struct Rule {
  double steps;         // of connectivity
  double area_m2;       // of the smallest plane
  double fewest, most;  // points of the smallest plane
};
constexpr Rule kFromTheAir{4, 1.2, 12, 200}, kFromTheGround{6, 0.005, 30, 200};

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  const auto at = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(at), values.end());
  return values[at];
}

}  // namespace

Sampling measure_sampling(const NeighbourIndex& index) {
  const auto n = static_cast<std::uint32_t>(index.points.size);
  if (n < kNeighbours) return {};
  std::vector<std::uint32_t> queries;
  for (std::uint32_t i = 0; i < n; i += std::max<std::uint32_t>(1, n / kQueries)) queries.push_back(i);
  std::vector<std::uint32_t> neighbours(queries.size() * kNeighbours);
  std::vector<std::int64_t> reach2(queries.size());
  knn(index, queries, {kNeighbours, kMaxSquaredReach}, neighbours, reach2);
  std::vector<double> steps, noises;
  for (std::size_t q = 0; q < queries.size(); ++q) {
    if (reach2[q] < 0) continue;
    // k points on a disc of radius r: each has pi r^2 / k for itself.
    steps.push_back(std::sqrt(kPi * static_cast<double>(reach2[q]) / kNeighbours));
    const Moments m = moments_of(index.points, std::span(neighbours).subspan(q * kNeighbours, kNeighbours));
    const double least = std::max(0.0, smallest_eigen(covariance(m)).value);
    noises.push_back(std::sqrt(least * kNeighbours / (kNeighbours - 3)));
  }
  // The flat third of the neighbourhoods; its 30% quantile lies a tenth below the median of pure noise.
  return {quantile(std::move(steps), 0.5), quantile(std::move(noises), 0.3) / 0.9};
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
  constexpr double kNoiseFactor = 3.5, kLeastUnits = 3, kLeastSteps = 0.25, kMostMetres = 0.5;
  constexpr double kMostAngle = 25, kLeastAngle = 10, kNoisy = 0.3;
  constexpr double kLeastReach = 4, kMostReach = 0x1p20;  // what euclidean_clusters can do with a cell
  const Rule& rule = from == SeenFrom::air ? kFromTheAir : kFromTheGround;
  PlaneParams p;
  const double surface = std::max(kNoiseFactor * sampling.noise, kLeastSteps * sampling.step);
  p.epsilon = settings.epsilon ? *settings.epsilon / unit_metres
                               : std::max(kLeastUnits, std::min(surface, kMostMetres / unit_metres));
  const double crowded = from == SeenFrom::air ? kLeastSteps * sampling.step / p.epsilon : 1;
  p.normal_angle = settings.normal_angle.value_or(std::clamp(crowded * crowded * kMostAngle, kLeastAngle, kMostAngle));
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
