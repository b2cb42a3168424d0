// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>

#include "engine/products/planes/make_planes.h"
#include "engine/replay/kept_run.h"

namespace ilot {

// The planes of a kept run: what its columns hold is not made again, the rest in the scratch store.
std::shared_ptr<PlanesResult> kept_planes(const KeptRun& run, Progress& progress);

}  // namespace ilot
