// SPDX-License-Identifier: Apache-2.0
// COPC 1.0: a LAZ file whose chunks are the nodes of an octree, so that a box needs a few of them only.
#pragma once
#include <cstdint>

#include "engine/formats/rows_in_box.h"

namespace ilot {

// True when the file says that it is COPC; its hierarchy may still be damaged.
bool is_copc(const CloudInfo& info);

}  // namespace ilot
