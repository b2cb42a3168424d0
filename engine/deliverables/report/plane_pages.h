// SPDX-License-Identifier: Apache-2.0
// The sections of planes and streets.
#pragma once
#include <string>
#include <vector>

#include "engine/deliverables/report/result_folder.h"
#include "engine/deliverables/report/scene_points.h"
#include "engine/model/segment.h"
#include "engine/model/street.h"

namespace ilot {

// What the report says of all planes, and the largest of them one by one.
struct PlanesOfReport {
  std::uint64_t planes = 0;
  std::vector<double> rms_m, confidence, area_m2;  // of all planes
  std::vector<Segment> shown;                      // the planes of largest area, by id
};

// Reads planes.csv line by line. Memory: 24 bytes a plane, and twice those that are shown.
PlanesOfReport planes_of_report(const ResultFolder& result, std::size_t most_shown);

std::string planes_section(const PlanesOfReport& planes, const SampledPoints& sample);
std::string streets_section(const StreetPlan& plan, double metres_per_unit);

}  // namespace ilot
