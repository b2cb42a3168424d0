// SPDX-License-Identifier: Apache-2.0
// The surfaces that a facade's plan claims, in the axes of its wall, for judging them.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "engine/model/facade.h"
#include "kernels/outlines/banded_region.h"

namespace ilot {

// `front`: what is square to the street, the wall itself, the face of a sill, what fills an opening. The others by
// where they lie around it: of an opening `left` is its left reveal.
enum class FaceName : std::uint8_t { front, bottom, right, top, left };
inline constexpr std::array<const char*, 5> kFaceNames{"front", "bottom", "right", "top", "left"};

// A flat polygon: metres along the wall from the facade's origin, up and out.
struct SurfaceFace {
  std::uint32_t element = 0;  // its number in the list of elements
  FaceName name = FaceName::front;
  std::vector<Vec3> corners;  // the last not repeated
  Vec3 visible;               // of unit length, to the side that it is seen from
};

// Corners of an element's ring in those axes.
std::vector<Vec3> local_ring(const Facade& facade, const FacadeElement& element, double metres_per_unit);

// Of every element with a depth the faces that stand off the wall, of one without (a stone of the wall) its front, of
// irregularities the triangles. Openings of no depth, what is occluded and the outline have none. In the elements'
// order.
std::vector<SurfaceFace> facade_surfaces(const Facade& facade, double metres_per_unit);

// The wall itself: inside of its outline and of no opening that is drawn.
struct WallSurface {
  static constexpr std::uint32_t kNone = 0xffffffffu;
  std::uint32_t element = kNone;  // the outline's number; kNone: the facade has no wall
  std::vector<std::vector<FlatPoint>> rings;
  BandedRegion region;
};
WallSurface wall_surface(const Facade& facade, double metres_per_unit);

}  // namespace ilot
