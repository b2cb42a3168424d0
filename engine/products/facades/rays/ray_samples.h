// SPDX-License-Identifier: Apache-2.0
// What each measured ray shows about the wall: it met the wall, went through it, or was stopped in front of it.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include "engine/products/facades/facade_site.h"
#include "engine/products/facades/rays/rays.h"

namespace ilot {

// The box is closed; metres in the axes of the wall.
struct Box2 {
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  double width() const { return u1 - u0; }
  double height() const { return v1 - v0; }
  bool contains(Place2 p) const { return p.u >= u0 && p.u <= u1 && p.v >= v0 && p.v <= v1; }
  Box2 grown(double by) const { return {u0 - by, u1 + by, v0 - by, v1 + by}; }
};

inline double area_of(const Box2& b) {
  return std::max(0.0, b.width()) * std::max(0.0, b.height());
}
inline double common_area(const Box2& a, const Box2& b) {
  return area_of({std::max(a.u0, b.u0), std::min(a.u1, b.u1), std::max(a.v0, b.v0), std::min(a.v1, b.v1)});
}

// The least box around the vertices of a ring, which must not be empty.
inline Box2 box_of(std::span<const Place2> ring) {
  Box2 box{ring[0].u, ring[0].u, ring[0].v, ring[0].v};
  for (const Place2& p : ring)
    box = {std::min(box.u0, p.u), std::max(box.u1, p.u), std::min(box.v0, p.v), std::max(box.v1, p.v)};
  return box;
}

enum class RayOutcome : std::uint8_t {
  solid,    // ends on the plane
  through,  // ends behind it: there is a hole
  before,   // ends in front of it: what is on the plane is not known
};

// Takes some points of a facade, with the numbers of their stations as in FacadeSite::from, or with no numbers.
using TakeFacadePoints = std::function<void(std::span<const FacadePoint>, std::span<const SiteStation>)>;
// Gives all points of a facade, piece by piece, in an order of its own.
using FacadePointSource = std::function<void(const TakeFacadePoints&)>;

// A box in the axes of the wall, in metres.
struct SpaceBox {
  Vec3 low, high;
};

// Gives the points in some boxes that are before the wall, each once, in an order of its own.
using FarPointSource = std::function<void(std::span<const SpaceBox>, const TakeFacadePoints&)>;

// Where rays are kept: in memory up to a number in each order, else in files of the folder. Without a folder all are in
// memory.
struct RayRoom {
  std::filesystem::path folder;
  std::uint64_t most_in_memory = std::uint64_t{1} << 13;
};

// The rays of the points of a facade, sorted by place. The ray of a point comes from its own station where the site
// knows it, or from the only station. If there are several stations, it comes from the nearest one whose ray does not
// go through a solid part of the wall. Without stations all rays are taken to be perpendicular to the wall; then an
// opening is seen only where there are points behind it. The room has 20 bytes per point for each of three orders: as
// given (only at the start; 40 in memory), by place, and by segment. About 5 MB of memory more are needed.
class RaySamples {
 public:
  // Uses the points of the site itself, in memory.
  explicit RaySamples(const FacadeSite& site);
  // Uses the points that the source gives; the site has no points of its own. Both must outlive the samples. `far`
  // gives points farther before the wall; without it nothing is known of them.
  RaySamples(const FacadeSite& site, const FacadePointSource& source, RayRoom room, FarPointSource far = {});

  // The bytes of memory for a point where all orders are in memory.
  static constexpr std::uint64_t kBytesInMemory = 4 * sizeof(Ray);

  const FacadeSite& site() const { return site_; }
  const std::filesystem::path& folder() const { return room_.folder; }
  bool oblique() const { return !site_.stations.empty(); }
  // Whether the station of some point was chosen among several.
  bool guessed() const { return guessed_; }
  // The number of points within epsilon of the wall.
  std::uint64_t points_on_wall() const { return points_on_wall_; }

  // The place where the ray crosses the plane w = depth.
  Place2 crossing(const Ray& ray, double depth) const;
  // The position from which the point was seen; nullptr where its ray is taken to be perpendicular to the wall.
  const Vec3* eye_of(const Ray& ray) const;
  RayOutcome met(const Ray& ray, double depth, double epsilon) const;
  // Whether the point is within epsilon of the wall, or on a segment of it: real walls are not quite flat.
  bool on_wall(const Ray& ray) const { return ray.part == kWall; }
  // Whether the point is on a segment along the wall and slightly behind it, as the backs of joints between stones are.
  bool in_joint(const Ray& ray) const { return ray.part == kBack; }

  // The rays that cross the wall in the box, and some around it, in a fixed order.
  Rays near(const Box2& box) const;
  // The rays whose points are in the box, and some others, in the same order.
  Rays at_places(const Box2& box) const;
  Rays all() const { return {sorted_, {{0, sorted_.size()}}}; }

  // Gives the points in some boxes before the wall. They are read from the store for each call.
  void far_points(std::span<const SpaceBox> boxes, const TakeFacadePoints& take) const {
    if (far_) far_(boxes, take);
  }

  // All rays a second time: segment by segment of the wall and along it, each in the order in which its rays were
  // given. run_of() gives where the rays of a segment are.
  const RayColumn& by_segment() const { return by_segment_; }
  RayRun run_of(std::uint32_t segment) const;

  // The distance in metres between neighbouring rays along u and along v at a place of the wall. It is that of the
  // station with the smallest distance; without stations, the mean distance of the points of the wall.
  Place2 step_at(Place2 place) const;

 private:
  enum Part : std::uint8_t { kNot, kWall, kBack };
  struct Bin {
    std::uint64_t first = 0;                                             // number of its first ray
    float u0 = INFINITY, u1 = -INFINITY, v0 = INFINITY, v1 = -INFINITY;  // extent of their points
  };

  void make(const FacadePointSource& source);
  RayColumn new_column() const { return RayColumn(room_.folder, room_.most_in_memory); }
  RayColumn taken(const FacadePointSource& source);
  void sort_by_place(const RayColumn& rays);
  void sort_by_segment(const RayColumn& rays);
  std::uint8_t part_of(const FacadePoint& p) const;
  std::size_t bin_of(Place2 place) const;

  const FacadeSite& site_;
  RayRoom room_;
  FarPointSource far_;
  bool guessed_ = false;
  std::uint64_t points_on_wall_ = 0;
  double bin_ = 0, u0_ = 0, v0_ = 0;  // metres
  std::int64_t columns_ = 0, rows_ = 0;
  std::vector<Bin> bins_;                // with one more at the end
  std::vector<std::uint32_t> segments_;  // ascending
  std::vector<RayRun> segment_runs_;
  RayColumn sorted_, by_segment_;
};

}  // namespace ilot
