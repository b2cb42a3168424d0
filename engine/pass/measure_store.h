// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/pass/context.h"
#include "engine/store/store.h"
#include "ilot/cloud_info.h"

namespace ilot {

// Measures the points of a store as measure_cloud does those of a file: number, box, density and sampling step; classes
// and last returns where the store has them, otherwise no classes and all points as last returns. Strays are not in the
// store. One pass over the codes; the result does not depend on threads or blocks.
CloudMeasure measure_store(const Store& store, const PassContext& context);

}  // namespace ilot
