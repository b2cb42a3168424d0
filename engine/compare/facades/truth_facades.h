// SPDX-License-Identifier: Apache-2.0
// The true facades of a scene as plans, which are drawn beside those that were found.
#pragma once
#include <optional>
#include <vector>

#include "engine/compare/truth.h"
#include "engine/model/facade.h"

namespace ilot {

// Returns one facade, with the same number, for each facade that the truth's elements name. It has the elements and,
// first, the rectangle around the wall. The wall is the true plane that contains most corners of the facade's openings
// (without openings: of its elements; ties: the first). x runs from the wall's left end. Facades without such a plane
// are left out. Chords of arches get their arc.
std::vector<Facade> true_facades(const Truth& truth);

// Returns the true facade that lies in the plane of a found facade (within 20 cm and 5 degrees, the nearest), with the
// number and the axes of the found one, so that their drawings have one origin.
std::optional<Facade> truth_in_frame_of(const std::vector<Facade>& truth, const Facade& found);

}  // namespace ilot
