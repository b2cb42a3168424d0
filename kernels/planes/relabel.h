// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>

#include "kernels/planes/plane_segments.h"
#include "kernels/planes/region_growing.h"
#include "kernels/planes/run_neighbours.h"

namespace ilot {

struct RelabelParams {
  double epsilon = 0;           // units; a point takes a label only within epsilon of that plane
  std::int64_t max_gap = 0;     // units; neighbours farther away have no vote
  std::uint32_t min_votes = 2;  // fewest labelled neighbours in a plane for a point without a label to join it
  int max_rounds = 8;
  double lean = 0;  // units; borders move by about this distance in favour of the plane with more points: beams that
                    // meet both surfaces at an edge take points from the larger one
  enum class Border { bisector, nearest } border = Border::bisector;  // the rule of split_borders
};

// Gives points without a label the plane of some of their neighbours: the nearest plane within epsilon that has at
// least min_votes of the neighbours (ties: the smaller label). A round reads the labels of the round before, so the
// order of points does not matter. Returns how many points got a label. O(rounds x n k).
std::size_t assign_unlabelled(Points points, const NeighbourLists& neighbours, const RelabelParams& params,
                              PlaneSegments& segments);

// Corrects borders between planes. A labelled point that is also near the plane of a neighbour (within epsilon,
// min_votes neighbours) goes to the plane on whose side of the bisector it is. Of the two bisectors of two planes, the
// one that separates their points counts. The sides of the planes are read from those neighbours that are not within
// epsilon of both, so planes may cross and end anywhere. Where noise is small compared with the surfaces, the nearest
// plane alone would follow the noise. Where noise is so large that few neighbours are clearly outside of a plane,
// Border::nearest gives each point to the nearest plane instead. Rounds are as in assign_unlabelled, until nothing
// changes. Returns how many moves were made. O(rounds x n k).
std::size_t split_borders(Points points, const NeighbourLists& neighbours, const RelabelParams& params,
                          PlaneSegments& segments);

// Points near an edge that a plane took from its neighbour tilt it. So the function repeats four steps: it adopts
// strays, splits borders, fits the planes to their points again, and drops points beyond epsilon. It ends when no label
// changes or after max_rounds. Every labelled point is within epsilon of its plane as returned. Planes that end with
// fewer than min_points lose their points, and the numbers are closed up.
void relabel_until_stable(Points points, const NeighbourLists& neighbours, const RelabelParams& params,
                          std::uint32_t min_points, PlaneSegments& segments);

// The same where the runs of these neighbours are known.
void relabel_until_stable(Points points, const NeighbourLists& neighbours, const RunNeighbours& runs,
                          const RelabelParams& params, std::uint32_t min_points, PlaneSegments& segments);

// Relabels islands [Boltcheva et al. 2019, 3.2.2]. A point moves to the plane of most of its neighbours (the document:
// 12 of them) if it is within epsilon of that plane. A tie changes nothing. There is one round, on the labels before
// the call. Returns how many points moved.
std::size_t relabel_islands(Points points, const NeighbourLists& neighbours, const RelabelParams& params,
                            PlaneSegments& segments);

}  // namespace ilot
