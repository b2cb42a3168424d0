// SPDX-License-Identifier: Apache-2.0
#include "engine/model/face_heights.h"

#include <algorithm>
#include <cmath>

namespace ilot {
namespace {

// A flat face as seen from above. Where it is cut at a height, the cut is one straight line.
class CutFace {
 public:
  CutFace(const Building& building, const BuildingSurface& surface) : building_(building), surface_(surface) {
    for (const auto& ring : surface.rings)
      for (const std::uint32_t v : ring) heights_.push_back(building.vertices[v].z);
    std::sort(heights_.begin(), heights_.end());
    heights_.erase(std::unique(heights_.begin(), heights_.end()), heights_.end());
  }

  const std::vector<double>& heights() const { return heights_; }  // of the corners, ascending

  // Twice the area in plan of the part that lies at or below z, with the sign of the ring. The edges along the cut need
  // no term, because the sum is taken about a point on the cut.
  double doubled_area_below(double z) const {
    Vec3 about = building_.vertices[surface_.rings[0][0]];
    for_each_edge([&](Vec3 a, Vec3 b) {
      if ((a.z <= z) != (b.z <= z)) about = at_height(a, b, z);
    });
    double sum = 0;
    for_each_edge([&](Vec3 a, Vec3 b) {
      if (a.z > z && b.z > z) return;
      if (a.z > z) a = at_height(a, b, z);
      if (b.z > z) b = at_height(a, b, z);
      sum += (a.x - about.x) * (b.y - about.y) - (a.y - about.y) * (b.x - about.x);
    });
    return sum;
  }

  // The height that a share of the area does not exceed. Between the heights of two corners the area below is a
  // quadratic function of the height, which three values give.
  double height_of(double share) const {
    const double wanted = share * doubled_area_below(heights_.back());
    std::size_t low = 0, high = heights_.size() - 1;
    while (high - low > 1) {
      const std::size_t middle = (low + high) / 2;
      (doubled_area_below(heights_[middle]) < wanted ? low : high) = middle;
    }
    const double z0 = heights_[low], z1 = heights_[high];
    const double f0 = doubled_area_below(z0), f1 = doubled_area_below((z0 + z1) / 2), f2 = doubled_area_below(z1);
    const double a = 2 * (f0 - 2 * f1 + f2), b = f2 - f0 - a, c = f0 - wanted;  // a t^2 + b t + c = 0, t from 0 to 1
    const double root = std::sqrt(std::max(0.0, b * b - 4 * a * c));
    // The area grows with t, so this is the root where it rises; the form also holds for a near 0.
    const double below = b + root;
    const double t = below > 0 ? -2 * c / below : 0;
    return z0 + std::clamp(t, 0.0, 1.0) * (z1 - z0);
  }

 private:
  static Vec3 at_height(Vec3 a, Vec3 b, double z) { return a + ((z - a.z) / (b.z - a.z)) * (b - a); }

  template <class Use>
  void for_each_edge(const Use& use) const {
    for (const auto& ring : surface_.rings)
      for (std::size_t i = 0; i < ring.size(); ++i)
        use(building_.vertices[ring[i]], building_.vertices[ring[(i + 1) % ring.size()]]);
  }

  const Building& building_;
  const BuildingSurface& surface_;
  std::vector<double> heights_;
};

}  // namespace

FaceHeights face_heights(const Building& building, const BuildingSurface& surface) {
  if (surface.rings.empty() || surface.rings[0].empty()) return {};
  const CutFace face(building, surface);
  const double min = face.heights().front(), max = face.heights().back();
  if (!(max > min)) return {min, min, min, max};
  if (!(face.doubled_area_below(max) > 0)) return {min, min, min, max};
  return {min, face.height_of(0.5), face.height_of(0.7), max};
}

}  // namespace ilot
