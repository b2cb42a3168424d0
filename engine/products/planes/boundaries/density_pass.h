// SPDX-License-Identifier: Apache-2.0
// The density of points on planes, as measured and as predicted from the stations [Lorraine thesis, 3.3].
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

// A plane for which a map is asked.
struct DensityRequest {
  Outline outline;
  std::uint64_t points = 0;
  double area = 0;  // area of the outline in squared CRS units, above 0
};

struct DensityParams {
  std::span<const JoinedPlane> planes;  // by final id - 1
  std::span<const std::uint32_t> final_id;
  std::span<const Scanner> stations;  // in lattice units
};

// Gives a map for every request, in the order of the requests. Pixels are square, and their width is 1, 2 or 5 times a
// power of ten. It is the smallest such width at which a pixel contains 100 points on average and the raster has at
// most 512 rows and columns. The part of a pixel inside of the outline is measured with 16 places, and the density is
// that of this part. The predicted density is that at the middle of the pixel: the sum over all stations, without
// occlusion. Reads the columns "codes" and "plane". The memory is eight maps, and the points of one block per thread.
void density_pass(const Store& store, const DensityParams& params, std::span<const DensityRequest> requests,
                  const PassContext& context, const std::function<void(const DensityMap&)>& take);

}  // namespace ilot
