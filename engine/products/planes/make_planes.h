// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "engine/formats/reader.h"
#include "engine/model/curved_segment.h"
#include "engine/model/largest_outlines.h"
#include "engine/model/segment.h"
#include "engine/pass/context.h"
#include "engine/products/planes/boundaries/boundaries_pass.h"
#include "engine/products/planes/join/join_pass.h"
#include "engine/report/progress.h"
#include "engine/report/run_record.h"
#include "engine/store/store.h"

namespace ilot {

struct PlanesResult {
  std::vector<Segment> segments;                     // by id
  std::vector<JoinedPlane> planes;                   // the same planes on the lattice
  std::vector<std::uint32_t> final_id;               // per joined plane + 1; [0] = 0
  std::vector<std::vector<NeighbourRange>> ranges;   // per block
  std::optional<std::vector<CurvedSegment>> curved;  // by id; nullopt: no cell was searched for curved shapes
  std::vector<std::uint32_t> final_shape;            // per joined shape + 1; [0] = 0; empty unless shapes are asked for
  LargestOutlines outlines;                          // from make_boundaries, as many as fit
};

// Finds the planes of the blocks in these steps: colours where the inputs have them, normals, planes per cell, join
// over cells, labels. Adds its stages to the progress. Adds the values that were used for `auto` to the record.
PlanesResult make_planes(const Store& store, const std::vector<std::unique_ptr<PointReader>>& inputs,
                         const Settings& settings, const PassContext& context, Progress& progress, RunRecord& record);

// Reads the pairs of planes that touch from the store, in ascending order.
void each_plane_neighbours(const Store& store, const PlanesResult& planes, double metres_per_unit,
                           const std::function<void(const PlaneNeighbours&)>& take);

}  // namespace ilot
