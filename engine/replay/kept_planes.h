// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>

#include "engine/products/planes/make_planes.h"
#include "engine/replay/kept_run.h"

namespace ilot {

// Returns the planes of a kept run. What its columns contain is not computed again; the rest is computed in the scratch
// store.
std::shared_ptr<PlanesResult> kept_planes(const KeptRun& run, Progress& progress);

}  // namespace ilot
