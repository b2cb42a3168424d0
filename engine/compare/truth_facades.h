// SPDX-License-Identifier: Apache-2.0
// The facades of a scene as plans, to be drawn beside those that were found.
#pragma once
#include <optional>
#include <vector>

#include "engine/compare/truth.h"
#include "engine/model/facade.h"

namespace ilot {

// One for each facade that the truth's elements name, with that number: its elements and, first, the rectangle about
// the wall, which is the true plane that most corners of its openings lie on (without openings, of its elements; ties:
// the first). x runs from the wall's left end. Facades without such a plane are left out. Chords of arches get their
// arc.
std::vector<Facade> true_facades(const Truth& truth);

// The one that lies in the plane of a facade that was found (within 20 cm and 5 degrees, the nearest), with the number
// and the axes of that one, so that their drawings have one origin.
std::optional<Facade> truth_in_frame_of(const std::vector<Facade>& truth, const Facade& found);

}  // namespace ilot
