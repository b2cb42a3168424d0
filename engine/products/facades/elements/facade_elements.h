// SPDX-License-Identifier: Apache-2.0
// What was found on a facade as elements of its plan, in the CRS.
#pragma once
#include "engine/model/facade.h"
#include "engine/products/facades/elements/irregularities.h"
#include "engine/products/facades/elements/regular_facade.h"
#include "engine/products/facades/walls/wall_outline.h"

namespace ilot {

// An opening, or what stands out or lies back: its ring with an edge a side (under an arc with one a chord of 5 degrees
// at most), its sizes and their errors, its body where its end is known.
FacadeElement element_of(const FacadeSite& site, const ElementCandidate& candidate);

// The wall itself within its outline.
FacadeElement wall_of(const RaySamples& samples, const WallOutline& outline);

// A bulge or a hollow: its outline in the wall, its surface as a mesh [Lorraine thesis, 4.2.2].
FacadeElement irregularity_of(const FacadeSite& site, const Irregularity& irregularity);

}  // namespace ilot
