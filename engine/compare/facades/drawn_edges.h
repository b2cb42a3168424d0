// SPDX-License-Identifier: Apache-2.0
// Judges the drawn edges of openings: how much of all true edges was drawn at its place, and whether the errors that
// are stated for drawn edges hold.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/compare/facades/openings.h"
#include "engine/compare/truth.h"
#include "engine/model/facade.h"

namespace ilot {

constexpr std::array<double, 3> kEdgeLimitsM{0.01, 0.02, 0.05};

// The drawn edges of one status, of openings that have a partner.
struct StatedErrors {
  DrawnStatus status = DrawnStatus::seen;
  std::uint64_t edges = 0;
  std::uint64_t within = 0;                       // edges whose true error is at most the stated one
  double median_stated_m = 0, median_true_m = 0;  // 0 without edges
};

struct DrawnEdges {
  double true_m = 0;                                   // length of the edges of all true openings
  std::array<double, kEdgeLimitsM.size()> within_m{};  // of it, with a drawn edge closer than the limit
  std::array<StatedErrors, 2> stated;                  // of edges that were seen, and of edges that were completed

  // The share of the length of all true edges that is drawn within kEdgeLimitsM[limit]. Openings that were not found
  // count as wrong. 0 without true edges.
  double share(std::size_t limit) const;
};

// True rings are sampled every centimetre. A sample is drawn when an edge of the partner that is not occluded is within
// the limit. The true error of a drawn edge is the mean distance of its samples from the true ring. Edges without a
// stated error (0) and elements without edges are not judged by it. All pairs are of the same `truth`. O(samples
// edges).
DrawnEdges evaluate_drawn_edges(std::span<const TrueOpening> truth, std::span<const OpeningPair> pairs,
                                double metres_per_unit = 1);

}  // namespace ilot
