// SPDX-License-Identifier: Apache-2.0
// One reading of all points of a plan, without a store of them: what depends on all points is decided as the index of a
// run decides it, and where the points lie is counted.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "engine/pass/context.h"
#include "engine/pass/index.h"
#include "engine/scale/chunk_boxes.h"
#include "engine/scale/survey/point_map.h"
#include "ilot/cloud_info.h"

namespace ilot {

struct PointSurvey {
  InputLattice lattice;  // when finer than asked for, all else is empty: the inputs must be read again with it
  std::array<std::uint64_t, kRejections> rejected{};
  Index3 corner;
  Strays strays;
  std::uint64_t points = 0;  // without those that are rejected, which strays are too
  IndexBox box = IndexBox::none();
  std::size_t tiles = 0;  // of a store that would have all of them, and the strays
  std::array<std::uint64_t, 256> classes{};
  PointMap map{0};
  std::vector<ChunkBoxes> chunks;       // of each input
  std::optional<CloudMeasure> measure;  // none: the points are not where the inputs say that they are; measure_points()
};

// Reads each input once. The lattice, the strays, the corner and what is rejected are those of build_index with the
// same parameters; of these, those of areas, blocks and rows have no meaning here. No result depends on threads.
// Memory: 20 MiB and 64 bytes a row (64 MiB at most) for each part that is read at once, within the budget, and for the
// whole what PointSummary says. Where `params.classes` are none, the measure has none.
PointSurvey survey_points(const std::vector<std::unique_ptr<PointReader>>& inputs, const IndexParams& params,
                          const PassContext& context);

// Reads each input again and measures the points of the survey.
CloudMeasure measure_points(const std::vector<std::unique_ptr<PointReader>>& inputs, const IndexParams& params,
                            const PointSurvey& survey, const PassContext& context);

}  // namespace ilot
