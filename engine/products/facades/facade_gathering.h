// SPDX-License-Identifier: Apache-2.0
// A facade's points out of the store, wherever they lie.
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

// Where the outline of a plane is among all of them.
struct OutlineNumber {
  std::uint32_t plane = 0, number = 0;
  friend auto operator<=>(const OutlineNumber&, const OutlineNumber&) = default;
};
std::vector<OutlineNumber> numbers_of(std::span<const Outline> outlines);

// What all facades of a run share. The store has the column "plane".
struct FacadeWork {
  const Store& store;
  std::span<const std::uint32_t> final_id;          // per joined plane + 1
  std::span<const Vec3> stations;                   // CRS units
  std::span<const FacadeStation> steps;             // of these, their positions left out
  std::span<const Outline> outlines = {};           // of planes
  std::vector<OutlineNumber> outline_numbers = {};  // of these, ascending: numbers_of()
  bool recorded = false;                            // the store has the column "station" of these
  double beside = 2.5, before = 2.5, behind = 4;    // metres around the wall that points are taken from: a thing goes
                                                    // as far beyond the wall's ends as it may stand out
  double metres_per_unit = 1;
};

// Places in the axes of a wall, metres. Of lattice points whole numbers are subtracted first, so that national grids
// cost no digits.
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

// Farthest that points of the wall lie from it, metres.
double epsilon_of(const WallGroup& wall);

// Around the wall's slab, in lattice units.
IndexBox box_around(const FacadeWork& work, const WallGroup& wall);

// Points that gathering the wall will read, at most.
std::uint64_t points_to_read(const FacadeWork& work, const WallGroup& wall);

// What a facade is found from: the site, without points, and these. Refers to work.
struct GatheredFacade {
  FacadeSite site;
  FacadePointSource points;  // in global order, so that nothing depends on blocks
};
GatheredFacade gather_facade(const FacadeWork& work, const WallGroup& wall);

// Of the points in the box around the wall those in another box, in CRS units, piece by piece and as often as they are
// asked for, in the colours of the column "colour"; without it black. Several threads at once. Refers to work.
PointSource points_around(const FacadeWork& work, const WallGroup& wall);

}  // namespace ilot
