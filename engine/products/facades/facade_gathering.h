// SPDX-License-Identifier: Apache-2.0
// Reads the points of a facade from the store, wherever they are.
#pragma once
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/deliverables/layers/facade_image.h"
#include "engine/model/outline.h"
#include "engine/products/facades/facade_site.h"
#include "engine/products/facades/rays/ray_samples.h"
#include "engine/products/facades/walls/wall_groups.h"
#include "engine/store/store.h"
#include "kernels/geometry/box3.h"

namespace ilot {

// The number of the outline of a plane in the list of all outlines.
struct OutlineNumber {
  std::uint32_t plane = 0, number = 0;
  friend auto operator<=>(const OutlineNumber&, const OutlineNumber&) = default;
};
std::vector<OutlineNumber> numbers_of(std::span<const Outline> outlines);

// What all facades of a run share. The store must have the column "plane".
struct FacadeWork {
  const Store& store;
  std::span<const std::uint32_t> final_id;          // per joined plane + 1
  std::span<const Vec3> stations;                   // CRS units
  std::span<const FacadeStation> steps;             // of these stations; the positions are not set
  std::span<const Outline> outlines = {};           // outlines of planes
  std::vector<OutlineNumber> outline_numbers = {};  // of these outlines, ascending; see numbers_of()
  bool recorded = false;                            // whether the store has the column "station" for these stations
  double beside = 2.5, before = 2.5, behind = 4;  // metres around the wall from which points are taken: an element may
                                                  // extend beyond the ends of the wall as far as it may stand out
  double metres_per_unit = 1;
};

// Places in the axes of a wall, in metres. For lattice points, integers are subtracted first, so that the large
// coordinates of national grids cost no digits.
class LatticeAxes {
 public:
  LatticeAxes(const FacadeWork& work, const WallGroup& wall);
  Vec3 of(Index3 p) const {
    const Vec3 d{static_cast<double>(p.x - anchor_.x) + rest_.x, static_cast<double>(p.y - anchor_.y) + rest_.y,
                 static_cast<double>(p.z - anchor_.z) + rest_.z};
    return {dot(d, axes_.right) * metres_, dot(d, axes_.up) * metres_, dot(d, axes_.out) * metres_};
  }
  Vec3 of_place(Vec3 place) const;  // CRS units

 private:
  FacadeAxes axes_;
  double metres_per_unit_, metres_;
  Index3 anchor_;
  Vec3 rest_;
};

// The greatest distance of points of the wall from it, in metres.
double epsilon_of(const WallGroup& wall);

// The box around the slab of the wall, in lattice units.
IndexBox box_around(const FacadeWork& work, const WallGroup& wall);

// The greatest number of points that are read to gather the wall.
std::uint64_t points_to_read(const FacadeWork& work, const WallGroup& wall);

// The input of the search for a facade: the site, without points, and the points. Refers to `work`.
struct GatheredFacade {
  FacadeSite site;
  FacadePointSource points;  // in global order, so that the result does not depend on blocks
  FarPointSource far;        // in global order too
};
GatheredFacade gather_facade(const FacadeWork& work, const WallGroup& wall);

// Gives the points of the box around the wall that are also in a second box, in CRS units, piece by piece and as often
// as they are asked for. Their colours are those of the column "colour", or black without this column. Several threads
// may use it at once. Refers to `work`.
PointSource points_around(const FacadeWork& work, const WallGroup& wall);

}  // namespace ilot
