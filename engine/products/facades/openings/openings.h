// SPDX-License-Identifier: Apache-2.0
// Windows and doors: where rays go through the wall.
#pragma once
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "engine/products/facades/openings/located_edge.h"
#include "engine/products/facades/openings/wall_cells.h"
#include "engine/products/facades/rays/ray_samples.h"

namespace ilot {

struct OpeningParams {
  double least_size = 0.3;    // metres; narrower or lower holes are none
  double least_depth = 0.04;  // metres; what lies less far behind the wall is no opening
  double shadow = 0.5;        // metres; openings are joined across shadows of things up to this
};

// A circle that ends an opening above.
struct TopArc {
  Place2 centre;
  double radius = 0, rms = 0, error = 0;  // metres
  std::uint64_t points = 0;
};

struct FoundRectangle {
  std::array<LocatedEdge, 4> sides;   // as kSides
  double depth = 0, depth_error = 0;  // w of what fills it; negative behind the wall
  double width_error = INFINITY;      // where a family tells the size; else its sides' errors do
  double height_error = INFINITY;
  std::uint64_t points = 0;      // rays through it, or points on it
  std::uint32_t plane = 0;       // of what stands in front
  double fill = 1;               // share of its cells that hold such
  std::optional<TopArc> arc;     // its top side then is the crown
  std::array<double, 4> lean{};  // of its sides, as kSides: tangent; the side's place then is that of its middle
  std::optional<Box2> end;       // what it comes down to at its depth, where that is not its own rectangle
  double at(Side s) const { return sides[static_cast<std::size_t>(s)].at; }
  double lean_of(Side s) const { return lean[static_cast<std::size_t>(s)]; }
  bool leans() const { return lean != std::array<double, 4>{}; }
  double error(Side s) const { return sides[static_cast<std::size_t>(s)].error; }
  LocatedEdge& side(Side s) { return sides[static_cast<std::size_t>(s)]; }
  const LocatedEdge& side(Side s) const { return sides[static_cast<std::size_t>(s)]; }
  Box2 box() const { return {at(Side::left), at(Side::right), at(Side::bottom), at(Side::top)}; }
};

// Cells of the wall's plane where rays go through and no point of the wall lies, joined over cells that nothing was
// seen in; a region that the wall bounds on both sides and above is an opening. A shadow of something in the street has
// no ray through it and is none. Left to right within bottom up. Where `steps`
// are given they are filled. O(points).
std::vector<FoundRectangle> find_openings(const RaySamples& samples, const OpeningParams& params = {},
                                          OpeningSteps* steps = nullptr);

}  // namespace ilot
