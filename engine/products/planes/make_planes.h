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
  std::vector<JoinedPlane> planes;                   // the same on the lattice
  std::vector<std::uint32_t> final_id;               // per joined plane + 1; [0] = 0
  std::vector<std::vector<NeighbourRange>> ranges;   // per block
  std::optional<std::vector<CurvedSegment>> curved;  // by id; nullopt where no cell was searched for them
  std::vector<std::uint32_t> final_shape;            // per joined shape + 1; [0] = 0; empty unless they are asked for
  LargestOutlines outlines;                          // by make_boundaries, as many as it holds
};

// Blocks to planes: colours where the inputs have them, normals, planes per cell, join over cells, labels. Adds its
// stages to the progress and the values that `auto` stood for to the record.
PlanesResult make_planes(const Store& store, const std::vector<std::unique_ptr<PointReader>>& inputs,
                         const Settings& settings, const PassContext& context, Progress& progress, RunRecord& record);

// The pairs of planes that touch, ascending, read from the store.
void each_plane_neighbours(const Store& store, const PlanesResult& planes, double metres_per_unit,
                           const std::function<void(const PlaneNeighbours&)>& take);

}  // namespace ilot
