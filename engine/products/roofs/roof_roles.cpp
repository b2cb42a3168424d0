// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/roof_roles.h"

#include "engine/columns/found_roles.h"
#include "engine/columns/normals_pass.h"
#include "engine/report/counted.h"

namespace ilot {

std::optional<RoleCounts> make_roof_roles(const Store& store, const Settings& settings, const PassContext& context,
                                          Progress& progress, std::optional<bool> by_shape) {
  auto roles = point_roles(settings.classes.building, settings.classes.ground);
  if (!settings.roofs.trust_classes) roles.fill(PointRole::unclassified);
  const RoleCounts given = write_roles(store, roles, context);
  if (!by_shape.value_or(count_of(given, PointRole::building) == 0)) return std::nullopt;
  progress.begin_stage("normals", store.points());
  normals_pass(store, settings.normals, context);
  progress.begin_stage("classes", store.points(), {store.points(), "points"});
  const AdvancedRoofs& advanced = settings.roofs.advanced;
  const RoleCounts found =
      find_roles(store, {advanced.ground_within, advanced.least_height, advanced.smoothness}, context);
  progress.end_stage();
  return found;
}

std::string found_by_shape(const RoleCounts& found) {
  return "no point of classes.building is used; found by shape: " + grouped(count_of(found, PointRole::ground)) +
         " points of the ground and " + grouped(count_of(found, PointRole::building)) + " of buildings";
}

double reach_of_found_roles(const Settings& settings) {
  return kFoundRolesReach + settings.normals.max_radius;
}

}  // namespace ilot
