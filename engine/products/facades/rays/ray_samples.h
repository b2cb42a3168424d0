// SPDX-License-Identifier: Apache-2.0
// What each measured ray tells of the wall: where it met it, went through it, or was stopped before it.
#pragma once
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

// Closed, metres in the wall's axes.
struct Box2 {
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  double width() const { return u1 - u0; }
  double height() const { return v1 - v0; }
  bool contains(Place2 p) const { return p.u >= u0 && p.u <= u1 && p.v >= v0 && p.v <= v1; }
  Box2 grown(double by) const { return {u0 - by, u1 + by, v0 - by, v1 + by}; }
};

enum class RayOutcome : std::uint8_t {
  solid,    // ends on the plane
  through,  // ends behind it: there is a hole
  before,   // ends in front of it: what is there is not known
};

// Takes some of a facade's points: their stations' numbers as FacadeSite::from, or none of them.
using TakeFacadePoints = std::function<void(std::span<const FacadePoint>, std::span<const SiteStation>)>;
// Gives all points of a facade, piece by piece and in an order of their own.
using FacadePointSource = std::function<void(const TakeFacadePoints&)>;

// The rays of a facade's points, sorted by place. A point's ray comes from its own station where the site tells it, or
// from the one station there is; of several from the nearest whose ray does not go through the wall where it is seen to
// be solid. Without stations rays are taken to be square to the wall: an opening then is seen only as far as what lies
// behind it. 20 bytes a point for each of three orders (as given, by place, by segment; the first only at the start):
// in files of the folder but for the smallest facades, in memory without one. Beside them some 5 MB.
class RaySamples {
 public:
  // Of the site's own points, in memory.
  explicit RaySamples(const FacadeSite& site);
  // Of points that the source gives; the site has none itself. Both must outlive the samples.
  RaySamples(const FacadeSite& site, const FacadePointSource& source, const std::filesystem::path& folder);

  const FacadeSite& site() const { return site_; }
  const std::filesystem::path& folder() const { return folder_; }
  bool oblique() const { return !site_.stations.empty(); }
  // Whether some point's station was guessed among several.
  bool guessed() const { return guessed_; }
  // Points within epsilon of the wall.
  std::uint64_t points_on_wall() const { return points_on_wall_; }

  // Where the ray crosses the plane w = depth.
  Place2 crossing(const Ray& ray, double depth) const;
  // Where it was seen from; nothing where its ray is taken to be square to the wall.
  const Vec3* eye_of(const Ray& ray) const;
  RayOutcome met(const Ray& ray, double depth, double epsilon) const;
  // Within epsilon of the wall, or on a segment of it: real walls are not quite flat.
  bool on_wall(const Ray& ray) const { return ray.part == kWall; }
  // On a segment along the wall and little behind it, as the backs of joints between stones are.
  bool in_joint(const Ray& ray) const { return ray.part == kBack; }

  // Rays that cross the wall in the box, and more around it: in a fixed order.
  Rays near(const Box2& box) const;
  // Those whose points are in the box, and others: in the same order.
  Rays at_places(const Box2& box) const;
  Rays all() const { return {sorted_, {{0, sorted_.size()}}}; }

  // All rays once more, those of each segment of the wall and along it one after the other in the order they were
  // given, and where those of a segment are.
  const RayColumn& by_segment() const { return by_segment_; }
  RayRun run_of(std::uint32_t segment) const;

  // Metres between neighbouring rays along u and along v at a place of the wall: of the station with the finest, else
  // as the wall's points lie in the mean.
  Place2 step_at(Place2 place) const;

 private:
  enum Part : std::uint8_t { kNot, kWall, kBack };
  struct Bin {
    std::uint64_t first = 0;                                             // ray
    float u0 = INFINITY, u1 = -INFINITY, v0 = INFINITY, v1 = -INFINITY;  // of their points
  };

  void make(const FacadePointSource& source);
  RayColumn taken(const FacadePointSource& source);
  void sort_by_place(const RayColumn& rays);
  void sort_by_segment(const RayColumn& rays);
  std::uint8_t part_of(const FacadePoint& p) const;
  std::size_t bin_of(Place2 place) const;

  const FacadeSite& site_;
  std::filesystem::path folder_;
  bool guessed_ = false;
  std::uint64_t points_on_wall_ = 0;
  double bin_ = 0, u0_ = 0, v0_ = 0;  // metres
  std::int64_t columns_ = 0, rows_ = 0;
  std::vector<Bin> bins_;                // and one more
  std::vector<std::uint32_t> segments_;  // ascending
  std::vector<RayRun> segment_runs_;
  RayColumn sorted_, by_segment_;
};

}  // namespace ilot
