// SPDX-License-Identifier: Apache-2.0
#include "engine/proof/model_residuals.h"

#include <algorithm>
#include <cmath>

#include "engine/visibility/closest_point.h"
#include "kernels/core/parallel.h"

namespace ilot {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kGrain = 4096;  // points that one task assigns

std::vector<Triangle3> judged_triangles(const PolygonModel& model, const ModelResidualParams& params,
                                        std::uint64_t& faces) {
  std::vector<Triangle3> triangles;
  const std::vector<bool> roofs = roof_faces(model, params.metres_per_unit);
  for (std::size_t i = 0; i < model.faces.size(); ++i) {
    if (params.faces == EvaluatedFaces::roofs && !roofs[i]) continue;
    append_triangles(model, model.faces[i], triangles);
    ++faces;
  }
  return triangles;
}

double root_mean_square(std::span<const double> sorted) {
  double sum = 0;
  for (const double d : sorted) sum += d * d;
  return sorted.empty() ? 0 : std::sqrt(sum / static_cast<double>(sorted.size()));
}

std::span<const double> nearest_part(std::span<const double> sorted, double share) {
  return sorted.first(static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size()))));
}

double near_share(std::span<const double> sorted, double near) {
  const auto end = std::upper_bound(sorted.begin(), sorted.end(), near);
  return sorted.empty() ? 0 : static_cast<double>(end - sorted.begin()) / static_cast<double>(sorted.size());
}

// The sorted distances in metres; empty when the building has no model.
std::vector<double> distances_of(std::span<const PolygonModel> models, const BuildingPoints& building,
                                 const ModelResidualParams& params, BuildingResidual& residual) {
  residual = {building.name, building.points.size(), 0, kInfinity, kInfinity, 0, kInfinity};
  if (building.model == kNoModel) return {};
  const ClosestPoint surface(judged_triangles(models[building.model], params, residual.faces));
  if (residual.faces == 0) return {};
  std::vector<double> distances;
  distances.reserve(building.points.size());
  for (const Vec3& p : building.points)
    distances.push_back(std::sqrt(surface.nearest(p).squared_distance) * params.metres_per_unit);
  std::sort(distances.begin(), distances.end());
  residual.rmse_m = root_mean_square(distances);
  residual.trimmed_rmse_m = root_mean_square(nearest_part(distances, params.kept_share));
  residual.near_share = near_share(distances, params.near_m);
  residual.largest_m = distances.back();
  return distances;
}

template <class Member>
Percentiles over_buildings(const std::vector<BuildingResidual>& buildings, Member member) {
  std::vector<double> values;
  for (const BuildingResidual& b : buildings) values.push_back(b.*member);
  return percentiles(std::move(values));
}

}  // namespace

Percentiles percentiles(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto at = [&](int percent) {
    const std::size_t rank = (values.size() * static_cast<std::size_t>(percent) + 99) / 100;
    return values[std::max<std::size_t>(rank, 1) - 1];
  };
  return {at(10), at(50), at(90), at(95), values.back()};
}

ModelResiduals evaluate_building_models(std::span<const PolygonModel> models, std::span<const BuildingPoints> buildings,
                                        const ModelResidualParams& params) {
  std::vector<const BuildingPoints*> seen;
  for (const BuildingPoints& building : buildings)
    if (!building.points.empty()) seen.push_back(&building);
  ModelResiduals result;
  result.buildings.resize(seen.size());
  std::vector<std::vector<double>> distances(seen.size());
  parallel_for(seen.size(),
               [&](std::size_t i) { distances[i] = distances_of(models, *seen[i], params, result.buildings[i]); });
  std::vector<double> all;
  for (const std::vector<double>& part : distances) all.insert(all.end(), part.begin(), part.end());
  std::sort(all.begin(), all.end());
  for (const BuildingResidual& b : result.buildings) result.missing += b.faces == 0;
  result.points = all.size();
  result.rmse_m = root_mean_square(all);
  result.trimmed_rmse_m = root_mean_square(nearest_part(all, params.kept_share));
  result.near_share = near_share(all, params.near_m);
  result.building_rmse_m = over_buildings(result.buildings, &BuildingResidual::rmse_m);
  result.building_trimmed_rmse_m = over_buildings(result.buildings, &BuildingResidual::trimmed_rmse_m);
  result.building_near_share = over_buildings(result.buildings, &BuildingResidual::near_share);
  return result;
}

std::vector<std::uint32_t> assign_by_plan(std::span<const PolygonModel> models, std::span<const Vec3> points,
                                          double margin) {
  std::vector<Triangle3> triangles;
  std::vector<std::uint32_t> owner;
  for (std::uint32_t m = 0; m < models.size(); ++m) {
    for (const PolygonFace& face : models[m].faces) append_triangles(models[m], face, triangles);
    owner.resize(triangles.size(), m);
  }
  for (Triangle3& t : triangles) t.a.z = t.b.z = t.c.z = 0;
  const ClosestPoint plan(std::move(triangles));
  std::vector<std::uint32_t> assigned(points.size(), kNoModel);
  parallel_for((points.size() + kGrain - 1) / kGrain, [&](std::size_t grain) {
    for (std::size_t i = grain * kGrain; i < std::min(points.size(), (grain + 1) * kGrain); ++i) {
      const SurfacePoint nearest = plan.nearest({points[i].x, points[i].y, 0}, margin);
      if (nearest.triangle != kNoTriangle) assigned[i] = owner[nearest.triangle];
    }
  });
  return assigned;
}

}  // namespace ilot
