// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>

#include "engine/products/roofs/sites/site_plan.h"
#include "engine/scale/make_plan.h"
#include "engine/scale/plan.h"
#include "engine/scale/survey/survey_points.h"

namespace ilot {

// Cuts a plan, of which all else is known, into its areas: squares of whole cells where parts have points. Writes the
// sites of each to the folder of the plan where roofs are made. `step` is the lattice step in metres.
void cut_plan(const PlanOptions& options, double step, const PointSurvey& survey, std::span<const PlannedSite> sites,
              Plan& plan);

}  // namespace ilot
