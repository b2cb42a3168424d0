// SPDX-License-Identifier: Apache-2.0
// Parts of a facade that both layers and pictures show.
#pragma once
#include <span>
#include <vector>

#include "engine/replay/facade_replay.h"

namespace ilot {

const char* name_of(ElementKind kind);
const char* name_of(RayOutcome met);
const char* name_of_cell(std::uint8_t what);

// Returns the corners of a found rectangle in the axes of the wall; inclined sides stay inclined.
std::vector<Place2> ring_of(const FoundRectangle& rectangle);

// Returns the ring of an element in the axes of the wall, metres.
std::vector<Vec3> ring_on_wall(const FacadeReplay& replay, std::span<const Vec3> ring);

}  // namespace ilot
