// SPDX-License-Identifier: Apache-2.0
// Compares drawn openings with the true ones.
#pragma once
#include <cstdint>
#include <span>

#include "engine/compare/truth.h"
#include "engine/model/facade.h"

namespace ilot {

struct OpeningMatching {
  double least_iou = 0.5;  // least intersection over union of partners, inclusive
  double depth_m = 0.5;    // openings farther than this from the plane of the true one are not compared
  double metres_per_unit = 1;
};

struct OpeningResult {
  std::uint64_t truth = 0, found = 0, matched = 0;
  std::uint64_t invented = 0;  // found openings without a partner
  double iou_mean = 0;         // mean over the matched openings
  double ring_distance_m = 0;  // mean, over the matched openings, of the drawn ring's mean distance from the true edge
};

// Drawn openings are the elements of facades that are marked as openings and are not occluded. Rings are compared in
// the plane of the true one. Pairs are matched one to one in the order of their intersection over union (ties: the
// earlier true one, then the earlier found one). O(t f) box tests.
OpeningResult evaluate_openings(std::span<const TrueOpening> truth, std::span<const Facade> facades,
                                const OpeningMatching& params = {});

}  // namespace ilot
