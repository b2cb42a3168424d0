// SPDX-License-Identifier: Apache-2.0
// Compares drawn openings with the true ones.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engine/compare/truth.h"
#include "engine/model/facade.h"
#include "kernels/geometry/flat.h"

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

// A true opening and the drawn one that is its partner, in the plane of the true one.
struct OpeningPair {
  std::size_t truth = 0;  // index into the true openings
  const FacadeElement* found = nullptr;
  double iou = 0, distance_m = 0;                // of the areas; mean distance of the drawn ring from the true edge
  std::vector<FlatPoint> true_ring, drawn_ring;  // in the units of the coordinates
};

// Returns the partners, in the order in which they are matched. Drawn openings are the elements of facades that are
// marked as openings and are not occluded. Rings are compared in the plane of the true one. Pairs are matched one to
// one in the order of their intersection over union (ties: the earlier true one, then the earlier found one). The pairs
// point into `facades`. O(t f) box tests.
std::vector<OpeningPair> match_openings(std::span<const TrueOpening> truth, std::span<const Facade> facades,
                                        const OpeningMatching& params = {});

// Sums up the partners of match_openings().
OpeningResult evaluate_openings(std::span<const TrueOpening> truth, std::span<const Facade> facades,
                                const OpeningMatching& params = {});

}  // namespace ilot
