// SPDX-License-Identifier: Apache-2.0
// Follows walls beyond their planes: planes end where a wall becomes oblique to the rays or far from the scanner, and
// its points too sparse.
#pragma once
#include <span>
#include <vector>

#include "engine/pass/context.h"
#include "engine/products/facades/elements/facade_model.h"
#include "engine/products/facades/facade_gathering.h"

namespace ilot {

// Finds the sparse parts of each wall (WallGroup::sparse), up to 12 m beside it and above it and not beyond the next
// wall. The points around all walls are read once, each wall on one thread. The store must have the column "plane".
void find_sparse_parts(const FacadeWork& work, std::span<WallGroup> walls, const WallParams& params,
                       const PassContext& context);

// A sparse part and what is around it within the wall, as a wall of its own.
WallGroup group_of_part(const WallGroup& wall, const SparsePart& part, double metres_per_unit);

// The memory that the search in the sparse parts of a wall needs, one after the other.
std::uint64_t bytes_of_sparse_parts(const FacadeWork& work, const WallGroup& wall);

// The openings and unseen areas of the sparse parts of a wall, in the axes of the wall.
SparseFindings sparse_findings(const FacadeWork& work, const WallGroup& wall, const OpeningParams& params);

// The box of a wall with its sparse parts becomes that of the wall.
void include_sparse_parts(WallGroup& wall, double metres_per_unit);

}  // namespace ilot
