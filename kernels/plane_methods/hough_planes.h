// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "kernels/planes/plane_score.h"
#include "kernels/planes/plane_segments.h"

namespace ilot {

// Directions of planes: the upper half of the sphere cut into cells of equal solid angle, bands of about `degrees` in
// height. Centres are unit vectors, z >= 0, band by band from the horizon up.
std::vector<Vec3> equal_angle_directions(double degrees);

struct HoughPlanesParams {
  double epsilon = 0;             // units; greatest distance of a labelled point from its plane
  double distance_step = 0;       // units; width of a cell in rho, at least 1 [2 epsilon]
  double degrees = 3;             // width of a cell in direction
  double min_vote_cos = 0;        // of the angle between a point's normal and the directions it votes for;
                                  // 0: every direction, as in the document
  double min_cos = 0;             // of the angle between the normals of a point and of its final plane
  std::int64_t connectivity = 1;  // units; a plane is the connected part of its points
  std::uint32_t min_points = 30;  // of a plane
};

// Planes by a 3D Hough transform [Marchand 2018, I.3.1.4] cos(phi)cos(theta)x + cos(phi)sin(theta)y + sin(phi)z + rho =
// 0: every point votes for all planes through it, or for those that agree with its normal. The cell with most votes
// (ties: the lower direction, then the lower rho) starts a plane: its voters' largest connected part, least squares,
// new consensus around it until nothing changes [Lorraine thesis, 2.2.2]. Its points' votes are taken back, exactly,
// and the next peak is sought, until no cell has a quarter of min_points votes. Cells of equal solid angle, since cells
// of equal steps in phi and theta crowd at the pole and split its votes. Votes are integers: any order of points gives
// the same planes. Where there are normals, points without one are none. O(n x directions voted for); 4 bytes a cell of
// the accumulator, whose rho axis is widened to at most 4,096 cells.
PlaneSegments hough_planes(const OrientedPoints& points, const HoughPlanesParams& params);

}  // namespace ilot
