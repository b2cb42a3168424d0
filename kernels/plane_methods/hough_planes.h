// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "kernels/planes/plane_score.h"
#include "kernels/planes/plane_segments.h"

namespace ilot {

// Returns the directions of planes: the upper half of the sphere is divided into cells of equal solid angle, in bands
// of about `degrees` in height. The centres are unit vectors with z >= 0, band by band from the horizon up.
std::vector<Vec3> equal_angle_directions(double degrees);

struct HoughPlanesParams {
  double epsilon = 0;        // units; greatest distance of a labelled point from its plane
  double distance_step = 0;  // units; width of a cell in rho, at least 1 [2 epsilon]
  double degrees = 3;        // width of a cell in direction
  double min_vote_cos = 0;   // of the angle between the normal of a point and the directions for which it votes; 0:
                             // every direction, as in the document
  double min_cos = 0;        // of the angle between the normals of a point and of its final plane
  std::int64_t connectivity = 1;  // units; a plane is the connected part of its points
  std::uint32_t min_points = 30;  // fewest points of a plane
};

// Finds planes by a 3D Hough transform [Marchand 2018, I.3.1.4] cos(phi)cos(theta)x + cos(phi)sin(theta)y + sin(phi)z +
// rho = 0. Every point votes for all planes through it, or for those that agree with its normal. The cell with most
// votes (ties: the lower direction, then the lower rho) starts a plane. The plane is fitted to the largest connected
// component of the voters by least squares, and the consensus set is found again until nothing changes [Lorraine
// thesis, 2.2.2]. The votes of its points are subtracted exactly, and the next peak is sought, until no cell has a
// quarter of min_points votes.
// Cells have equal solid angles, because cells of equal steps in phi and theta are too dense at the pole and split its
// votes. Votes are integers, so the planes do not depend on the order of points. Where there are normals, points
// without a normal are in no plane. O(n x directions voted for). The accumulator takes 4 bytes per cell. Its cells are
// widened in rho so that the rho axis has at most 4,096 of them.
PlaneSegments hough_planes(const OrientedPoints& points, const HoughPlanesParams& params);

}  // namespace ilot
