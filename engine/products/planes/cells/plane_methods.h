// SPDX-License-Identifier: Apache-2.0
// All methods that find the planes of a cell, behind one function.
#pragma once
#include <cstdint>
#include <optional>
#include <span>

#include "engine/products/planes/cells/auto_params.h"
#include "engine/settings/settings.h"
#include "kernels/neighbours/normals.h"
#include "kernels/planes/plane_score.h"
#include "kernels/planes/plane_segments.h"
#include "kernels/shapes/shape_ransac.h"

namespace ilot {

// The points of a cell as input of the methods. Lengths are in lattice units; the index is over the same points.
struct PlaneSearch {
  OrientedPoints points;
  std::span<const PackedNormal> normals;  // the same normals, as they are stored
  const NeighbourIndex& index;
  PlaneParams params;
  SeenFrom from = SeenFrom::air;
  std::span<const std::uint32_t> colour_class;  // per point, 0 = none; empty without colours
  double probability = 0.99;
  std::uint64_t key = 0;  // key of the random draws
};

// Finds labels and planes with the method. Then the labels are improved (kernels/planes/relabel.h): points without a
// plane join one, borders are split between planes, and planes are fitted again until nothing changes. No labelled
// point is farther than epsilon from its plane.
PlaneSegments find_planes(PlaneMethod method, const PlaneSearch& search);

// Finds spheres, cylinders and cones with at least `min_points` points. They are searched for together with planes
// [Marchand 2018, II.2.1.1]. The points of planes have no label. Neither have the points of shapes so flat that the
// common edge of two planes explains them. Shapes are numbered from 1 in the order in which they were taken.
ShapeSegments find_curved(const PlaneSearch& search, std::uint32_t min_points);

// Whether a cell is searched for curved shapes. This is as asked in the settings. Otherwise it is true if the method is
// chosen automatically too and the smallest number of points of a shape covers at most a square metre at this sampling
// step (m). At a larger step, as from the air, corners of roofs look like cones. False for a step of 0, which means
// that no step is known.
bool wants_curved(const PlanesSettings& settings, double step_m);

// The bytes of memory that the method needs per point of a cell, in addition to the cell itself; the largest value
// where no method is chosen.
std::uint64_t bytes_per_point(std::optional<PlaneMethod> method);

// The method for a cell: the one asked for, otherwise the one that suits where the cell was seen from. From the ground
// it is shape_ransac: its samples are local at every scale, so it finds sills and bars beside a wall of a million
// points. From the air it is ransac, which finds the same roofs in less time (docs/methods.md).
PlaneMethod choose_method(const PlanesSettings& settings, SeenFrom from);

}  // namespace ilot
