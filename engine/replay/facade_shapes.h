// SPDX-License-Identifier: Apache-2.0
// What both layers and pictures show of a facade.
#pragma once
#include <span>
#include <vector>

#include "engine/replay/facade_replay.h"

namespace ilot {

const char* name_of(ElementKind kind);
const char* name_of(RayOutcome met);
const char* name_of(DrawnStatus status);
const char* name_of_cell(std::uint8_t what);

// Corners of what was found, in the wall's axes; sides that lean do so.
std::vector<Place2> ring_of(const FoundRectangle& rectangle);

// The ring of an element in the wall's axes, metres.
std::vector<Vec3> ring_on_wall(const FacadeReplay& replay, std::span<const Vec3> ring);

}  // namespace ilot
