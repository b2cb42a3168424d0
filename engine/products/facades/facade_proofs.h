// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>

#include "engine/model/outline.h"
#include "engine/pass/context.h"
#include "engine/products/facades/elements/facade_model.h"
#include "engine/products/facades/facade_gathering.h"

namespace ilot {

// Compares each edge and face of the facades with the points of the store. Where stations are known, it also uses the
// lines of sight: past the outlines of all planes and past the elements of all facades. `walls` and `found` are
// parallel lists. The points are read once more, in strips of walls and in parallel. Needs a few MB per thread and
// about 30 bytes per corner of the outlines.
void prove_facades(const FacadeWork& work, std::span<const WallGroup> walls, std::span<const Outline> outlines,
                   std::vector<FoundFacade>& found, const PassContext& context);

// A side of an opening or of the outline along which no point lies at all was not seen, whatever the rays farther off
// let expect: its edges become `occluded`. The chords of a head are one side. Its place is not known better than
// `reach`, the metres within which points would lie along it. The same is done with recesses and what stands out.
// Where points lie along half of only one of their sides or of none, and along less than half of all sides together,
// they are `completed`.
void mark_bare_sides(FoundFacade& found, double reach);

}  // namespace ilot
