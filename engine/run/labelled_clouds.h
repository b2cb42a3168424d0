// SPDX-License-Identifier: Apache-2.0
// Labels back to the clouds they came from: every input again, in its own order and with all its fields, ours behind.
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "engine/cloud/area.h"
#include "engine/formats/reader.h"
#include "engine/pass/context.h"
#include "engine/segments/join_pass.h"
#include "engine/store/store.h"

namespace ilot {

// Which products ran: each has its columns in the store and its extra bytes in the clouds.
struct LabelParams {
  std::vector<std::uint32_t> final_id;          // per joined plane + 1: the id that is written, 0 = none; [0] = 0
  std::vector<JoinedPlane> planes;              // by final id - 1: what residuals are measured to
  bool write_normals = false;                   // with planes only
  bool with_planes = true;                      // columns "plane" and "boundary"
  bool with_roofs = false;                      // column "roof"
  bool with_streets = false;                    // column "street"
  bool with_facades = false;                    // column "facade"
  std::vector<std::uint32_t> final_shape = {};  // per joined shape + 1: the id that is written; empty = no "shape"
};

// Sorts the labels of each block by input order ("rows", "roof_rows"...), so that a stretch of an input
// finds its own in a few reads.
void rows_pass(const Store& store, const LabelParams& params, const PassContext& context);

// Writes a compressed folder/NAME for every input; inputs of equal name get their folder's name in front. Returns the
// number of points with a plane, a unit, an object or a label.
std::uint64_t write_labelled_clouds(const Store& store, const std::vector<std::unique_ptr<PointReader>>& inputs,
                                    const LabelParams& params, const std::filesystem::path& folder,
                                    const PassContext& context);

// That number alone, with no cloud written and no rows sorted.
std::uint64_t count_labelled(const Store& store, const LabelParams& params, const PassContext& context);

}  // namespace ilot
