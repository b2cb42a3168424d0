// SPDX-License-Identifier: Apache-2.0
// The labels that products give to the rows of the inputs: sorted by input row in each block, and read back in
// stretches.
#pragma once
#include <cstdint>
#include <vector>

#include "engine/pass/context.h"
#include "engine/products/facades/facade_labels.h"
#include "engine/products/planes/join/join_pass.h"
#include "engine/products/roofs/roof_labels.h"
#include "engine/products/streets/street_labels.h"
#include "engine/store/store.h"
#include "kernels/neighbours/normals.h"

namespace ilot {

// Which products ran: each has columns in the store and extra bytes in the clouds.
struct LabelParams {
  std::vector<std::uint32_t> final_id;          // per joined plane + 1: the id that is written, 0 = none; [0] = 0
  std::vector<JoinedPlane> planes;              // by final id - 1; residuals are measured to these planes
  bool write_normals = false;                   // only together with planes
  bool with_planes = true;                      // columns "plane" and "boundary"
  bool with_roofs = false;                      // column "roof"
  bool with_streets = false;                    // column "street"
  bool with_facades = false;                    // column "facade"
  std::vector<std::uint32_t> final_shape = {};  // per joined shape + 1: the id that is written; empty = no "shape"
};

// Sorts the labels of each block by input order ("rows", "roof_rows"...), so that the labels of a stretch of an input
// are found with few reads.
void rows_pass(const Store& store, const LabelParams& params, const PassContext& context);

// The labels of one point from the planes.
struct PlaneLabel {
  std::uint32_t plane = 0, shape = 0;
  PackedNormal normal;
  std::uint8_t boundary = 0;
};

// The labels of one input row from the products; nullptr: the product did not run.
struct RowLabels {
  const PlaneLabel* plane = nullptr;
  const RoofLabel* roof = nullptr;
  const StreetLabel* street = nullptr;
  const FacadeLabel* facade = nullptr;

  // The label of a building has priority, then that of a facade, then that of the street.
  PointLabel label() const {
    if (roof != nullptr && roof->unit != 0) return roof->label;
    if (facade != nullptr && facade->facade != 0) return facade->label;
    if (street != nullptr && street->label != PointLabel::none) return street->label;
    return roof == nullptr ? PointLabel::none : roof->label;
  }
  bool is_labelled() const {
    return (plane != nullptr && (plane->plane != 0 || plane->shape != 0)) || (roof != nullptr && roof->unit != 0) ||
           (street != nullptr && street->object != 0) || label() != PointLabel::none;
  }
};

// Labels of consecutive rows of a file, or of the points of a block; the vectors of a product that did not run are
// empty.
struct StretchLabels {
  std::vector<PlaneLabel> planes;
  std::vector<RoofLabel> roofs;
  std::vector<StreetLabel> streets;
  std::vector<FacadeLabel> facades;

  RowLabels row(std::size_t i) const {
    return {planes.empty() ? nullptr : &planes[i], roofs.empty() ? nullptr : &roofs[i],
            streets.empty() ? nullptr : &streets[i], facades.empty() ? nullptr : &facades[i]};
  }
};

// The rows of one block in input order; every 1,024th order is kept in memory.
struct BlockRows {
  std::vector<InputOrder> samples;
  InputOrder last = 0;
  std::uint32_t points = 0;
};

// The rows of all blocks, after rows_pass.
std::vector<BlockRows> sample_rows(const Store& store);

// Gives the labels of the input rows [first, first + count). Needs few reads for each block that contains one of them.
StretchLabels collect_labels(const Store& store, const std::vector<BlockRows>& blocks, InputOrder first,
                             std::size_t count, const LabelParams& params);

// The number of points that have a label; no rows are sorted for it.
std::uint64_t count_labelled(const Store& store, const LabelParams& params, const PassContext& context);

}  // namespace ilot
