// SPDX-License-Identifier: Apache-2.0
// A scanned scene with its truth, in the form that kernels use: integer units from its lowest corner, in Morton order.
#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

#include "engine/compare/labels/confusion.h"
#include "kernels/plane_methods/colour_classes.h"
#include "kernels/planes/plane_score.h"
#include "kernels/planes/region_growing.h"
#include "kernels/shapes/shape.h"

namespace ilot::bench {

struct TrueShape {
  std::uint32_t id = 0;
  Shape shape;        // in units, in the frame of the points
  double length = 0;  // units, of cylinders and cones
  std::uint64_t points = 0;
};

struct Scene {
  double unit_metres = 0.001;
  std::vector<float> x, y, z, nx, ny, nz;
  std::vector<PackedNormal> normals;
  std::vector<std::uint8_t> red, green, blue;  // empty without colour
  std::vector<std::uint16_t> intensity;
  std::vector<std::uint32_t> true_class, true_plane;
  std::vector<std::uint32_t> dropped_class;  // of points that cleaning removed [Marchand 2018, II.1]
  ClassNames classes;
  std::vector<TrueShape> shapes;
  std::vector<std::uint32_t> near;  // kNear neighbours per point
  double step = 0, noise = 0;       // units, measured
  double normal_seconds = 0, neighbour_seconds = 0;
  static constexpr int kNear = 13;

  std::size_t size() const { return true_class.size(); }
  Points points() const { return {x.data(), y.data(), z.data(), size()}; }
  OrientedPoints oriented() const { return {points(), nx.data(), ny.data(), nz.data()}; }
  NeighbourLists neighbours() const { return {near, kNear}; }
  PointColours colours() const { return {red, green, blue, intensity}; }
};

enum class Cleaning { kNone, kMixedPixels };

// Reads FILE and its truth (NAME.truth.json). Cleans the cloud if stations are known. Estimates normals from k
// neighbours. Throws when the cloud or the truth is missing.
Scene load_scene(const std::filesystem::path& file, int k, Cleaning cleaning);

}  // namespace ilot::bench
