// SPDX-License-Identifier: Apache-2.0
// GEOS as the engine uses it.
#pragma once
#include <geos_c.h>

#include <memory>

namespace ilot {

// GEOS keeps its state in a context that one thread uses at a time. This returns the context of the calling thread.
GEOSContextHandle_t geos_context();

struct GeosDestroy {
  void operator()(GEOSGeometry* g) const { GEOSGeom_destroy_r(geos_context(), g); }
};
using GeosOwned = std::unique_ptr<GEOSGeometry, GeosDestroy>;

}  // namespace ilot
