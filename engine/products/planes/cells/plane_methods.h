// SPDX-License-Identifier: Apache-2.0
// Every way to find the planes of a cell, behind one call.
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

// The points of a cell as the methods see them. Lengths in lattice units, index over the same points.
struct PlaneSearch {
  OrientedPoints points;
  std::span<const PackedNormal> normals;  // the same, as they are stored
  const NeighbourIndex& index;
  PlaneParams params;
  SeenFrom from = SeenFrom::air;
  std::span<const std::uint32_t> colour_class;  // per point, 0 = none; empty without colours
  double probability = 0.99;
  std::uint64_t key = 0;  // of random draws
};

// Labels and planes by the method, then settled (kernels/planes/relabel.h): strays adopted, borders parted, planes
// fitted anew until nothing changes. No labelled point lies farther than epsilon from its plane.
PlaneSegments find_planes(PlaneMethod method, const PlaneSearch& search);

// Spheres, cylinders and cones with at least so many points, found among planes and these together [Marchand 2018,
// II.2.1.1]; the points of planes have no label, nor have those of shapes so flat that two planes' common edge explains
// them. Shapes are numbered from 1 in the order they were taken.
ShapeSegments find_curved(const PlaneSearch& search, std::uint32_t min_points);

// Whether a cell is searched for them: as asked; else where the method is chosen by itself too and the fewest points of
// a shape cover a square metre at most, at this sampling step (m). Wider apart, as from the air, corners of roofs pass
// for cones. False for a step of 0, which is none.
bool wants_curved(const PlanesSettings& settings, double step_m);

// Bytes of memory that the method takes for a point of a cell, beside the cell itself; the most where it is not chosen.
std::uint64_t bytes_per_point(std::optional<PlaneMethod> method);

// The method for a cell: the one asked for, else by where it was seen from. From the ground shape_ransac, whose samples
// are local at every scale and so find sills and bars beside a wall of a million points; from the air ransac, which
// finds the same roofs in less time (docs/methods.md).
PlaneMethod choose_method(const PlanesSettings& settings, SeenFrom from);

}  // namespace ilot
