// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>

#include "engine/columns/point_roles.h"
#include "engine/pass/context.h"
#include "engine/report/progress.h"
#include "engine/settings/settings.h"

namespace ilot {

// Writes the role of each point: as the cloud classifies it, or, where the cloud has no class for buildings, found by
// shape. Returns the numbers of found roles, and nullopt where those of the cloud are used. `by_shape` is the decision
// that was taken for a larger cloud of which this store has a part; without it the store decides.
std::optional<RoleCounts> make_roof_roles(const Store& store, const Settings& settings, const PassContext& context,
                                          Progress& progress, std::optional<bool> by_shape = {});

// Why roles were found by shape, with their numbers.
std::string found_by_shape(const RoleCounts& found);

// How far around a point others may change its found role, in metres: the windows of the ground, the mask of buildings
// and the neighbours of normals.
double reach_of_found_roles(const Settings& settings);

}  // namespace ilot
