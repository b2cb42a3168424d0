// SPDX-License-Identifier: Apache-2.0
// Places the artefacts of a street: cars at the kerb, lampposts and furniture along it, people on the pavements.
#pragma once
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "kernels/geometry/box3.h"
#include "scan/scanners/pose.h"
#include "scan/streets/artefact.h"
#include "scan/streets/street_plan.h"

namespace ilot::scan {

struct StreetObject {
  std::uint32_t id = 0;  // from 1
  ArtefactClass artefact_class = ArtefactClass::other;
  std::string_view variant;
  Artefact shape;  // in its own frame
  Pose pose;       // street coordinates
  double heading_deg = 0;
  Box3<Vec3> box;  // box of the shape, pitched but not turned, relative to the base
  PlanBox plan;
  std::vector<std::uint32_t> touches;  // ids
};

// Returns the number of objects of each class for a number of blocks, by ArtefactClass: 67, 33, 198, 144 for 30 blocks.
std::array<std::uint64_t, 4> object_counts(std::uint64_t blocks);

// Objects that do not touch have at least this distance in metres between their boxes, and from trees.
constexpr double kClearance = 0.4;

// Places all objects. They are not sorted by class. Throws Error when the street has no room for one of them.
std::vector<StreetObject> place_objects(const Street& street);

}  // namespace ilot::scan
