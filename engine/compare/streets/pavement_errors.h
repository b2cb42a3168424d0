// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <vector>

#include "engine/compare/streets/error_sizes.h"
#include "engine/compare/streets/kerb_errors.h"
#include "engine/compare/truth.h"
#include "engine/model/street.h"

namespace ilot {

struct PavementResult {
  double true_m = 0;                 // metres of true kerb that was seen, whose pavement has an end within six metres
  double complete = 0;               // share of true_m with a stated width within a metre along the kerb
  std::uint64_t stated = 0;          // widths with an end
  std::uint64_t away = 0;            // of them those that do not begin at a true pavement
  std::uint64_t endless = 0;         // of them those where the true pavement has no end within six metres
  std::uint64_t built = 0;           // of the others those within 25 cm of the pavement as built
  ErrorSizes width, passable, road;  // passable: where nothing moves
  double near = 0;                   // share of the judged widths within 10 cm
  double within_stated = 0;  // share of the judged widths with a stated error within it; not a number without any
  double passable_near = 0;  // share of the judged passable widths within 10 cm
};

// Judges the widths of pavements. The true end is what ends the ground that is level with the pavement: the house
// behind it, or before that a fence, a wall or a hedge at the back of the pavement. The true passable width is the
// widest part of a strip of a metre of kerb that no object that stands reaches into, below 2.2 m.
PavementResult evaluate_pavements(const KerbSight& sight, const Truth& truth, std::span<const PavementWidth> found,
                                  double metres_per_unit);

}  // namespace ilot
