// SPDX-License-Identifier: Apache-2.0
// Judges from which side facades are drawn: a facade that looks into its building is mirrored.
#pragma once
#include <cstdint>
#include <span>

#include "engine/compare/truth.h"
#include "engine/model/facade.h"

namespace ilot {

struct FacadeSides {
  std::uint64_t judged = 0;    // drawn facades with true openings on them
  std::uint64_t mirrored = 0;  // of them, those that look against most of these openings
};

// True openings turn counter-clockwise for a viewer outside, so their rings give the true side. An opening lies on a
// facade when its first corner is within 0.5 m of the facade's plane and of the extent of its elements, and their
// directions differ by less than 25 degrees from parallel or opposite. O(facades openings).
FacadeSides evaluate_facade_sides(std::span<const TrueOpening> truth, std::span<const Facade> facades,
                                  double metres_per_unit = 1);

}  // namespace ilot
