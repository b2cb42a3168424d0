// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>

#include "engine/model/outline.h"
#include "engine/pass/context.h"
#include "engine/products/facades/elements/facade_model.h"
#include "engine/products/facades/facade_gathering.h"

namespace ilot {

// What points and stations say for each edge and face of the facades, from the store's points and, where stations are
// known, lines of sight past the outlines of all planes and past all facades' elements. walls and found belong
// together. The points are read once more, in strips of walls in parallel: a few MB a thread, and some 30 bytes a
// corner of the outlines.
void prove_facades(const FacadeWork& work, std::span<const WallGroup> walls, std::span<const Outline> outlines,
                   std::vector<FoundFacade>& found, const PassContext& context);

}  // namespace ilot
