// SPDX-License-Identifier: Apache-2.0
// The surfaces that a facade's plan describes, in the axes of its wall, so that they can be judged.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "engine/model/facade.h"
#include "kernels/outlines/banded_region.h"

namespace ilot {

// `front` is parallel to the wall: the wall itself, the face of a sill, or the fill of an opening. The other names give
// the position around it: of an opening, `left` is its left reveal.
enum class FaceName : std::uint8_t { front, bottom, right, top, left };
inline constexpr std::array<const char*, 5> kFaceNames{"front", "bottom", "right", "top", "left"};

// A flat polygon in metres from the facade's origin: along the wall, up and out.
struct SurfaceFace {
  std::uint32_t element = 0;  // its number in the list of elements
  FaceName name = FaceName::front;
  std::vector<Vec3> corners;  // the last corner is not repeated
  Vec3 visible;               // unit vector to the side from which the face is seen
};

// The corners of an element's ring in those axes.
std::vector<Vec3> local_ring(const Facade& facade, const FacadeElement& element, double metres_per_unit);

// Returns the surfaces in the order of the elements. An element with a depth has the faces that stand off the wall, one
// without a depth (a stone of the wall) has its front, and an irregularity has its triangles. Openings without depth,
// occluded elements and the outline have no surface.
std::vector<SurfaceFace> facade_surfaces(const Facade& facade, double metres_per_unit);

// The wall itself: the region inside of its outline and outside of all drawn openings.
struct WallSurface {
  static constexpr std::uint32_t kNone = 0xffffffffu;
  std::uint32_t element = kNone;  // the outline's number; kNone: the facade has no wall
  std::vector<std::vector<FlatPoint>> rings;
  BandedRegion region;
};
WallSurface wall_surface(const Facade& facade, double metres_per_unit);

}  // namespace ilot
