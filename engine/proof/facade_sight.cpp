// SPDX-License-Identifier: Apache-2.0
#include "engine/proof/facade_sight.h"

#include <algorithm>
#include <cmath>

#include "engine/proof/facade_surfaces.h"
#include "kernels/core/parallel.h"

namespace ilot {
namespace {

constexpr double kPerFace = 8;                               // places along the side of a square face
constexpr double kLeastSpacing = 0.02, kMostSpacing = 0.25;  // metres between places of a face
constexpr double kThousandth = 1000;

struct SightTally {
  std::uint64_t places = 0, hidden = 0;

  std::optional<double> share() const {
    if (places == 0) return std::nullopt;
    return std::round(kThousandth * static_cast<double>(hidden) / static_cast<double>(places)) / kThousandth;
  }
};

// One facade as seen from the stations.
class FacadeView {
 public:
  FacadeView(const Facade& facade, std::span<const Vec3> stations, const LineOfSight& faces,
             const FacadeSightParams& params)
      : facade_(facade), stations_(stations), faces_(faces), params_(params) {
    for (const Vec3& s : stations) {
      const Vec3 d = params.metres_per_unit * (s - facade.origin);
      eyes_.push_back({dot(d, facade.right), dot(d, facade.up), dot(d, facade.out)});
    }
  }

  // Returns true where a station sees a place, in the axes of the wall, on a surface that looks to `visible`.
  bool seen(Vec3 place, Vec3 visible) const {
    const Vec3 before = place + params_.margin_m * visible;
    for (std::size_t s = 0; s < eyes_.size(); ++s)
      if (dot(eyes_[s] - before, visible) > 0 && faces_.clear(stations_[s], outside(before))) return true;
    return false;
  }

  SightTally edge(Vec3 a, Vec3 b, Vec3 shift) const {
    SightTally tally;
    tally.places = static_cast<std::uint64_t>(std::clamp(std::ceil(norm(b - a) / params_.edge_spacing_m), 4.0, 64.0));
    for (std::uint64_t i = 0; i < tally.places; ++i) {
      const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(tally.places);
      tally.hidden += !seen(a + share * (b - a) + params_.margin_m * shift, {0, 0, 1});
    }
    return tally;
  }

  void add_face(const SurfaceFace& face, SightTally& tally) const {
    std::vector<FlatPoint> ring;
    const Vec3 origin = face.corners[0], along = face.corners[1] - origin;
    if (!(norm(along) > 0)) return;
    const Vec3 u = (1 / norm(along)) * along, v = cross(face.visible, u);
    for (const Vec3& p : face.corners) ring.push_back({dot(p - origin, u), dot(p - origin, v)});
    std::vector<FlatEdge> edges;
    add_ring(ring, edges);
    add_places(
        ring, BandedRegion(edges), face.visible, [&](FlatPoint p) { return origin + p.x * u + p.y * v; }, tally);
  }

  void add_wall(const WallSurface& wall, SightTally& tally) const {
    add_places(
        wall.rings[0], wall.region, {0, 0, 1},
        [](FlatPoint p) {
          return Vec3{p.x, p.y, 0};
        },
        tally);
  }

 private:
  Vec3 outside(Vec3 p) const {
    const double units = 1 / params_.metres_per_unit;
    return facade_.origin + units * (p.x * facade_.right + p.y * facade_.up + p.z * facade_.out);
  }

  // Adds the centres of a grid's cells over the ring's box that lie inside of the region.
  template <class Place>
  void add_places(const std::vector<FlatPoint>& ring, const BandedRegion& region, Vec3 visible, const Place& place,
                  SightTally& tally) const {
    FlatPoint low = ring[0], high = ring[0];
    for (const FlatPoint& p : ring) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const double width = high.x - low.x, height = high.y - low.y;
    const double spacing = std::clamp(std::sqrt(width * height) / kPerFace, kLeastSpacing, kMostSpacing);
    const auto columns = static_cast<int>(std::clamp(width / spacing, 1.0, 1000.0));
    const auto rows = static_cast<int>(std::clamp(height / spacing, 1.0, 1000.0));
    for (int r = 0; r < rows; ++r)
      for (int c = 0; c < columns; ++c) {
        const FlatPoint p{low.x + (c + 0.5) * width / columns, low.y + (r + 0.5) * height / rows};
        if (!region.contains(p)) continue;
        ++tally.places;
        tally.hidden += !seen(place(p), visible);
      }
  }

  const Facade& facade_;
  std::span<const Vec3> stations_;
  const LineOfSight& faces_;
  const FacadeSightParams& params_;
  std::vector<Vec3> eyes_;  // in the axes of the wall
};

// The direction in which the places along an edge are shifted. Beyond an outline other walls begin, so places inside
// the outline are tested. Where a body stands on the wall, places beside its edges there are tested.
double shift_sign(const FacadeElement& e, const std::vector<Vec3>& ring) {
  if (e.region == FacadeRegion::facade) return 1;
  double out = 0;
  for (const Vec3& p : ring) out += p.z / static_cast<double>(ring.size());
  return e.depth_m > 0 && out < e.depth_m / 2 ? -1 : 0;
}

void look_at_edges(const FacadeView& view, double metres, const Facade& facade, FacadeElement& e) {
  const std::vector<Vec3> ring = local_ring(facade, e, metres);
  const double shift = shift_sign(e, ring);
  for (std::size_t i = 0; i < e.edges.size() && i < ring.size(); ++i) {
    const Vec3 a = ring[i], b = ring[(i + 1) % ring.size()], way = b - a;
    const double length = std::sqrt(way.x * way.x + way.y * way.y);
    const Vec3 inwards = length > 0 ? (1 / length) * Vec3{-way.y, way.x, 0} : Vec3{};
    e.edges[i].occluded_share = view.edge(a, b, shift * inwards).share();
  }
}

}  // namespace

void measure_sight(std::span<const Vec3> stations, const LineOfSight& faces, const FacadeSightParams& params,
                   Facade& facade) {
  if (stations.empty()) return;
  const FacadeView view(facade, stations, faces, params);
  const std::vector<SurfaceFace> surfaces = facade_surfaces(facade, params.metres_per_unit);
  const WallSurface wall = wall_surface(facade, params.metres_per_unit);
  std::vector<std::size_t> first{0};  // index of each element's first surface
  for (std::uint32_t i = 0; i < facade.elements.size(); ++i) {
    std::size_t end = first.back();
    while (end < surfaces.size() && surfaces[end].element == i) ++end;
    first.push_back(end);
  }
  parallel_for(facade.elements.size(), [&](std::size_t i) {
    FacadeElement& e = facade.elements[i];
    look_at_edges(view, params.metres_per_unit, facade, e);
    for (FacadeFace& f : e.faces) {
      SightTally tally;
      for (std::size_t k = first[i]; k < first[i + 1]; ++k)
        if (f.name == kFaceNames[static_cast<std::size_t>(surfaces[k].name)]) view.add_face(surfaces[k], tally);
      if (i == wall.element) view.add_wall(wall, tally);
      f.occluded_share = tally.share();
    }
  });
}

}  // namespace ilot
