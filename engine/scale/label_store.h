// SPDX-License-Identifier: Apache-2.0
// The labels of all points of a merge, kept for the tasks that write labelled clouds: PLAN/labels.
#pragma once
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "engine/pass/context.h"
#include "engine/products/planes/join/join_pass.h"
#include "engine/products/product_labels.h"
#include "engine/scale/plan.h"
#include "engine/store/store.h"

namespace ilot {

constexpr const char* kLabelsFolder = "labels";

// What labels of points refer to.
struct LabelledPlanes {
  std::vector<JoinedPlane> planes;  // by id - 1
  bool shapes = false;              // clouds have the field shape_id
};

// Sorts the labels of a store by input row, and removes from its folder what no label needs. `planes` is none where
// none were made.
void prepare_labels(const Store& store, std::span<const ProductLabels> labels,
                    const std::optional<LabelledPlanes>& planes, const PassContext& context);

// Turns such a folder into PLAN/labels, once the result that the labels belong to is there. Labels of an earlier merge
// are replaced.
void publish_labels(const std::filesystem::path& folder, const Plan& plan, const std::filesystem::path& plan_folder,
                    const std::string& result_hash);

// The labels of PLAN/labels near a box. Throws Error with ExitCode::usage where a merge has left none of this plan.
struct KeptLabels {
  Store store;
  std::vector<ProductLabels> labels;
  std::string result_hash;  // of the result of the merge that left them
};
KeptLabels open_labels(const Plan& plan, const std::filesystem::path& plan_folder, const IndexBox& box);

}  // namespace ilot
