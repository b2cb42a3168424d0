// SPDX-License-Identifier: Apache-2.0
// Density of points on planes, as measured and as the stations predict it [Lorraine thesis, 3.3].
#pragma once
#include <cstdint>
#include <functional>
#include <span>

#include "engine/model/density_map.h"
#include "engine/model/outline.h"
#include "engine/pass/context.h"
#include "engine/products/planes/join/join_pass.h"
#include "engine/store/store.h"
#include "kernels/delaunay/sampling_step.h"

namespace ilot {

// A plane that is asked for.
struct DensityRequest {
  Outline outline;
  std::uint64_t points = 0;
  double area = 0;  // of the outline, CRS units squared, above 0
};

struct DensityParams {
  std::span<const JoinedPlane> planes;  // by final id - 1
  std::span<const std::uint32_t> final_id;
  std::span<const Scanner> stations;  // in lattice units
};

// Gives a map for every request, in their order. Pixels are square, 1, 2 or 5 times a power of ten wide, the first
// width at which a pixel holds 100 points in the mean and the raster has at most 512 rows and columns. What of a pixel
// lies inside of the outline is measured with 16 places; the density is that of the inside. Predicted is the density at
// the middle of the pixel, the sum over all stations, as if nothing stood in their way. Reads the columns "codes" and
// "plane". Memory: eight maps and the points of a block a thread.
void density_pass(const Store& store, const DensityParams& params, std::span<const DensityRequest> requests,
                  const PassContext& context, const std::function<void(const DensityMap&)>& take);

}  // namespace ilot
