// SPDX-License-Identifier: Apache-2.0
// What the products of a plan need of its tasks and its merge. Each building is made whole by the task of its area.
// For all other products, and for labelled clouds of roofs, the tasks do what depends on points near by, and leave the
// points; the merge makes one store of them and goes on with the functions of a run.
#pragma once
#include <string>
#include <vector>

#include "engine/scale/make_plan.h"
#include "engine/scale/plan.h"

namespace ilot {

// Throws Error with ExitCode::usage where a plan cannot promise the bytes of one run.
void check_products(const PlanOptions& options);

bool makes_roofs(const Plan& plan);

// Whether parts have points: where anything but the models of roofs is made.
bool carries_points(const Plan& plan);

// Whether parts have what labels of roofs need: the role of each point, and the labels that buildings give.
bool carries_roof_labels(const Plan& plan);

// Whether the tasks search planes in cells, and with which settings.
bool searches_planes(const Plan& plan);
Settings settings_of_cells(const Plan& plan);

// Whether parts have the class codes of points: streets read them in the merge. Roofs read them in the tasks alone.
bool carries_class_codes(const Plan& plan);

// Whether a product reads the colours of points and an input has them.
bool reads_colours(const Plan& plan);

// Whether the part of this area has the colours of points, and whether it has their stations. Where an input has one
// station the plan knows it, so that its points need none.
bool carries_colours(const Plan& plan, const PlanArea& area);
bool carries_stations(const Plan& plan, const PlanArea& area);

// The bytes that the part of this area has for each point, about.
std::uint64_t part_bytes_of_point(const Plan& plan, const PlanArea& area);

// The microseconds of one processor that a task needs for each point, beside reading.
double microseconds_of_point(const Plan& plan);

// What the plan is of, for people: "planes, facades", or "12 buildings, streets".
std::string what_is_made(const Plan& plan);

}  // namespace ilot
