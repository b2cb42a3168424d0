// SPDX-License-Identifier: Apache-2.0
// From a facade's points to its plan.
#pragma once
#include "engine/model/facade.h"
#include "engine/products/facades/elements/irregularities.h"
#include "engine/products/facades/elements/large_relief.h"
#include "engine/products/facades/elements/regular_facade.h"
#include "engine/products/facades/elements/relief.h"
#include "engine/products/facades/facade_site.h"
#include "engine/products/facades/openings/openings.h"
#include "engine/products/facades/walls/wall_outline.h"

namespace ilot {

struct FacadeParams {
  OpeningParams openings;
  ReliefParams relief;
  LargeReliefParams large;
  IrregularityParams irregular;
  RegularParams regular;
  WallOutlineParams outline;
  bool regularise = true;
  std::size_t concurrency = 4;  // steps that run at once: the same result, less memory for fewer
};

struct FoundFacade {
  Facade facade;                     // ids of its elements from 1, bottom up and left to right; facade.id is left at 0
  std::uint64_t occluded_edges = 0;  // that are not drawn as seen
};

// What was found on the way to a FoundFacade, for whoever looks for the step that went wrong.
struct FacadeSteps {
  OpeningSteps cells;
  std::vector<FoundRectangle> openings, relief, stones, large;  // as the four searches found them
  std::vector<ElementCandidate> found, drawn;                   // before and after regularisation
  std::vector<Irregularity> irregular;
  WallOutline outline;
};

// Openings and what stands out, named, brought into rows and families, completed where shadows hid them, and the wall's
// own outline first. The site's points in any order give the same. Where `steps` are given they are filled. O(n log n).
FoundFacade find_facade(const RaySamples& samples, const FacadeParams& params = {}, FacadeSteps* steps = nullptr);

// Memory of the rays and of find_facade() at most, for a site of so many points.
std::uint64_t facade_bytes(const FacadeSite& site, std::uint64_t points, std::size_t concurrency);

inline FoundFacade find_facade(const FacadeSite& site, const FacadeParams& params = {}) {
  return find_facade(RaySamples(site), params);
}

}  // namespace ilot
