// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>

#include "kernels/planes/plane_segments.h"
#include "kernels/planes/region_growing.h"

namespace ilot {

struct RelabelParams {
  double epsilon = 0;           // units; a point takes a label only within epsilon of that plane
  std::int64_t max_gap = 0;     // units; neighbours farther away have no vote
  std::uint32_t min_votes = 2;  // labelled neighbours that a point without a label needs for a plane
  int max_rounds = 8;
  double lean = 0;  // units; borders move by about so much in favour of the plane with more points: beams that meet
                    // both surfaces at an edge pull points off the larger one
  enum class Border { bisector, nearest } border = Border::bisector;  // how split_borders decides
};

// Gives points without a label one of their neighbours' planes: the nearest among those with at least min_votes
// neighbours that lie within epsilon (ties: the smaller label). Rounds look at the labels of the round before, so the
// order of points does not matter. Returns how many points got a label. O(rounds x n k).
std::size_t assign_unlabelled(Points points, const NeighbourLists& neighbours, const RelabelParams& params,
                              PlaneSegments& segments);

// Borders: a labelled point near a neighbour's plane too (within epsilon, min_votes neighbours) goes to the side of the
// bisector on which it lies. Of the two bisectors of two planes the one counts that parts their points: which side each
// plane's points lie on is read from those neighbours that are not within epsilon of both, so planes may cross and end
// anywhere. Where noise is small beside the surfaces, nearness alone would follow it; where it is so large that few
// neighbours are clearly beyond a plane, Border::nearest gives each point to the nearest plane instead. Rounds as in
// assign_unlabelled, until nothing moves. Returns how many moves were made. O(rounds x n k).
std::size_t split_borders(Points points, const NeighbourLists& neighbours, const RelabelParams& params,
                          PlaneSegments& segments);

// Points near an edge that a plane took from its neighbour tilt it. So: strays adopted, borders parted, planes fitted
// anew to what they have, points beyond epsilon let go, until no label changes or after max_rounds; every labelled
// point lies within epsilon of its plane as returned. Planes that end with fewer than min_points lose them, numbers
// close up.
void relabel_until_stable(Points points, const NeighbourLists& neighbours, const RelabelParams& params,
                          std::uint32_t min_points, PlaneSegments& segments);

// Islands [Boltcheva et al. 2019, 3.2.2]: a point moves to the plane that most of its neighbours have (the document: 12
// of them), if it lies within epsilon of it; a tie changes nothing. One round, on the labels as they were. Returns how
// many points moved.
std::size_t relabel_islands(Points points, const NeighbourLists& neighbours, const RelabelParams& params,
                            PlaneSegments& segments);

}  // namespace ilot
