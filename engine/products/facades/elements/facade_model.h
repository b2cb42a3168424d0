// SPDX-License-Identifier: Apache-2.0
// Makes the plan of a facade from its points.
#pragma once
#include "engine/model/facade.h"
#include "engine/products/facades/elements/element_kinds.h"
#include "engine/products/facades/elements/irregularities.h"
#include "engine/products/facades/elements/large_relief.h"
#include "engine/products/facades/elements/regular_facade.h"
#include "engine/products/facades/elements/relief.h"
#include "engine/products/facades/facade_site.h"
#include "engine/products/facades/openings/openings.h"
#include "engine/products/facades/walls/sparse_outline.h"
#include "engine/products/facades/walls/wall_outline.h"

namespace ilot {

struct FacadeParams {
  OpeningParams openings;
  ReliefParams relief;
  LargeReliefParams large;
  IrregularityParams irregular;
  StoneParams stones;
  ElementKindParams kinds;
  RegularParams regular;
  WallOutlineParams outline;
  bool regularise = true;
  std::size_t concurrency = 4;  // steps that run at once; the result does not depend on it, fewer need less memory
};

struct FoundFacade {
  Facade facade;  // the ids of its elements begin at 1, bottom up and left to right; facade.id stays 0
  std::uint64_t occluded_edges = 0;  // number of edges that are not drawn as seen
};

// The intermediate results of find_facade(). They help to find the step that went wrong.
struct FacadeSteps {
  OpeningSteps cells;
  std::vector<FoundRectangle> openings, relief, stones, large;  // results of the four searches
  std::vector<ElementCandidate> found, drawn;                   // before and after regularisation
  std::vector<Irregularity> irregular;
  std::vector<UnseenArea> unseen;
  WallOutline outline;
};

// What was found in the sparse parts of a wall, in the axes of the wall.
struct SparseFindings {
  std::vector<FoundRectangle> openings;
  std::vector<UnseenArea> unseen;
  std::vector<SparseColumn> columns;  // of the parts beside the wall; none where the wall goes on above it
  Box2 box;                           // the wall with these parts
  double step = 0;                    // metres between the points of the sparsest part; 0: the wall has no such part
};

// Whether an opening has more than half of its area, or of this box, in common with the box.
bool shares_area(const Box2& box, const std::vector<FoundRectangle>& openings);

// Finds the outline of the wall first, then its openings and relief. These get a kind, are brought into rows and
// families, and are completed where shadows hid them. The order of the points of the site does not change the result.
// Openings of sparse parts are added to those of the wall, and the outline then contains these parts. Fills `steps`
// where they are given. O(n log n).
FoundFacade find_facade(const RaySamples& samples, const FacadeParams& params = {}, FacadeSteps* steps = nullptr,
                        const SparseFindings& sparse = {});

// The largest memory that the rays and find_facade() need for a site with so many points.
std::uint64_t facade_bytes(const FacadeSite& site, std::uint64_t points, std::size_t concurrency);

inline FoundFacade find_facade(const FacadeSite& site, const FacadeParams& params = {}) {
  return find_facade(RaySamples(site), params);
}

}  // namespace ilot
