// SPDX-License-Identifier: Apache-2.0
// Judges from the points around a wall on which side of it the scanner stood, when no station is known.
#pragma once
#include <array>

#include "engine/products/facades/walls/wall_sample.h"

namespace ilot {

// What would be seen if the street lay on the side to which the axis w points (index 0), and on the other (index 1).
// All are shares from 0 to 1.
struct SideEvidence {
  std::array<double, 2> ground{};   // of the length of its closed foot: level ground begins there on the street
  std::array<double, 2> beyond{};   // of its length: something rises above the top of the wall behind it, as roofs do
  std::array<double, 2> blocked{};  // of the points up to half a metre behind it: no ray from the best place for a
                                    // station reaches them without passing through the wall
  std::array<double, 2> behind{};   // of the points off the wall: those behind it
};

// O(cells of the sample + points of the sample x places for stations).
SideEvidence side_evidence(const WallSample& sample);

// The natural logarithm of the odds that the street is on the side of the axis w. A weighted sum of the logarithms of
// the ratios of the evidence (naive Bayes with learnt weights), and a constant where all lies on one side of the wall
// and none of it is ground. 0 where nothing was seen on either side.
double street_log_odds(const SideEvidence& evidence);

}  // namespace ilot
