// SPDX-License-Identifier: Apache-2.0
#include "engine/geos_context.h"

namespace ilot {

GEOSContextHandle_t geos_context() {
  struct Holder {
    GEOSContextHandle_t handle = GEOS_init_r();
    ~Holder() { GEOS_finish_r(handle); }
  };
  thread_local const Holder holder;
  return holder.handle;
}

}  // namespace ilot
