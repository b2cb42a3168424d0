// SPDX-License-Identifier: Apache-2.0
#include "engine/proof/facade_proof.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "kernels/geometry/closest.h"
#include "kernels/outlines/ear_clipping.h"

namespace ilot {
namespace {

constexpr double kBin = 0.25;                    // metres
constexpr double kMicrometres = 1e6;             // micrometres in a metre
constexpr std::uint64_t kBytesOfTriangle = 300;  // with Embree's tree; a facade of few takes 10 KB
constexpr double kDigits = 1e5;                  // figures are rounded to hundredths of a millimetre
constexpr std::uint32_t kNames = static_cast<std::uint32_t>(kFaceNames.size());

std::uint32_t key_of(std::uint32_t element, FaceName name) {
  return kNames * element + static_cast<std::uint32_t>(name);
}

// Adds the triangles of a face. A front is triangulated by its outline as seen from the street, which may be below an
// arch. Sides and triangles are convex.
void add_triangles(const SurfaceFace& face, std::vector<Triangle3>& triangles) {
  const std::vector<Vec3>& c = face.corners;
  if (face.name != FaceName::front || c.size() < 4) {
    for (std::size_t i = 1; i + 1 < c.size(); ++i) triangles.push_back({c[0], c[i], c[i + 1]});
    return;
  }
  std::vector<FlatPoint> flat;
  std::vector<std::uint32_t> ring;
  for (const Vec3& p : c) {
    ring.push_back(static_cast<std::uint32_t>(flat.size()));
    flat.push_back({p.x, p.y});
  }
  for (const auto& [i, j, k] : triangulate(flat, std::vector<std::vector<std::uint32_t>>{ring}))
    triangles.push_back({c[i], c[j], c[k]});
}

double rms_of(const ProofTally::Sum& sum) {
  if (sum.points == 0) return 0;
  const double rms = std::sqrt(static_cast<double>(sum.squares) / static_cast<double>(sum.points)) / kMicrometres;
  return std::round(rms * kDigits) / kDigits;
}

}  // namespace

void ProofTally::add(const ProofTally& other) {
  const auto sum = [](std::vector<Sum>& to, const std::vector<Sum>& from) {
    for (std::size_t i = 0; i < to.size(); ++i)
      to[i].points += from[i].points, to[i].squares += from[i].squares, to[i].stretches |= from[i].stretches;
  };
  sum(edges, other.edges);
  sum(faces, other.faces);
}

FacadeProof::FacadeProof(const Facade& facade, const FacadeProofParams& params)
    : params_(params), wall_(wall_surface(facade, params.metres_per_unit)), closest_({}) {
  const std::vector<SurfaceFace> surfaces = facade_surfaces(facade, params.metres_per_unit);
  if (wall_.element != WallSurface::kNone) faces_.push_back(key_of(wall_.element, FaceName::front));
  for (const SurfaceFace& f : surfaces) faces_.push_back(key_of(f.element, f.name));
  std::sort(faces_.begin(), faces_.end());
  faces_.erase(std::unique(faces_.begin(), faces_.end()), faces_.end());
  const auto number = [&](std::uint32_t element, FaceName name) {
    const auto at = std::lower_bound(faces_.begin(), faces_.end(), key_of(element, name));
    return static_cast<std::uint32_t>(at - faces_.begin());
  };
  std::vector<Triangle3> triangles;
  for (const SurfaceFace& f : surfaces) {  // before the wall: a point on both belongs to the element
    add_triangles(f, triangles);
    face_of_.resize(triangles.size(), number(f.element, f.name));
  }
  for (const std::vector<FlatPoint>& ring : wall_.rings)  // beyond its rim: distance to the rim
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const FlatPoint a = ring[i], b = ring[(i + 1) % ring.size()];
      triangles.push_back({{a.x, a.y, 0}, {b.x, b.y, 0}, {b.x, b.y, 0}});
      face_of_.push_back(number(wall_.element, FaceName::front));
    }
  closest_ = ClosestPoint(std::move(triangles));
  add_edges(facade);
  sort_edges();
}

void FacadeProof::add_edges(const Facade& facade) {
  for (std::uint32_t i = 0; i < facade.elements.size(); ++i) {
    const FacadeElement& e = facade.elements[i];
    const std::vector<Vec3> ring = local_ring(facade, e, params_.metres_per_unit);
    for (std::uint32_t k = 0; k < ring.size(); ++k) {
      const Vec3 a = ring[k], b = ring[(k + 1) % ring.size()];
      const double stretches = std::clamp(norm(b - a) / params_.edge_reach_m, 1.0, 64.0);
      edges_.push_back({i, k, a, b, e.region == FacadeRegion::facade, static_cast<int>(stretches)});
    }
  }
}

std::size_t FacadeProof::bin_of(double u, double v) const {
  const auto at = [](double p, std::int64_t count) {
    return static_cast<std::int64_t>(std::clamp(std::floor(p / kBin), 0.0, static_cast<double>(count - 1)));
  };
  return static_cast<std::size_t>(at(v - v0_, rows_) * columns_ + at(u - u0_, columns_));
}

void FacadeProof::sort_edges() {
  constexpr double kMostBins = 4e6;
  if (edges_.empty()) return;
  double u1 = -INFINITY, v1 = -INFINITY;
  u0_ = v0_ = INFINITY;
  for (const Edge& e : edges_) {
    u0_ = std::min({u0_, e.a.x, e.b.x}), u1 = std::max({u1, e.a.x, e.b.x});
    v0_ = std::min({v0_, e.a.y, e.b.y}), v1 = std::max({v1, e.a.y, e.b.y});
  }
  const double most = std::sqrt(kMostBins);
  columns_ = static_cast<std::int64_t>(std::min((u1 - u0_) / kBin, most)) + 1;
  rows_ = static_cast<std::int64_t>(std::min((v1 - v0_) / kBin, most)) + 1;
  near_ = lists_by_key(static_cast<std::size_t>(columns_ * rows_), edges_.size(),
                       [&](std::size_t i, const auto& take) { for_bins_near(edges_[i], take); });
}

// Calls take(bin) for the bins with points within reach of an edge, and perhaps a few more: the last bins of rows and
// columns may hold all that is beyond, where there are too many for the size of a wall.
template <class Take>
void FacadeProof::for_bins_near(const Edge& e, const Take& take) const {
  const double reach = params_.edge_reach_m, half = kBin / 2 + reach;
  const auto columns = static_cast<std::size_t>(columns_);
  const std::size_t low = bin_of(std::min(e.a.x, e.b.x) - reach, std::min(e.a.y, e.b.y) - reach);
  const std::size_t high = bin_of(std::max(e.a.x, e.b.x) + reach, std::max(e.a.y, e.b.y) + reach);
  const double nx = e.a.y - e.b.y, ny = e.b.x - e.a.x;  // across the edge
  const double widest = half * (std::abs(nx) + std::abs(ny)) * (1 + 1e-9) + 1e-9;
  for (std::size_t r = low / columns; r <= high / columns; ++r)
    for (std::size_t c = low % columns; c <= high % columns; ++c) {
      const double u = u0_ + (static_cast<double>(c) + 0.5) * kBin, v = v0_ + (static_cast<double>(r) + 0.5) * kBin;
      const bool last = c + 1 == columns || r + 1 == static_cast<std::size_t>(rows_);
      if (last || std::abs(nx * (u - e.a.x) + ny * (v - e.a.y)) <= widest) take(r * columns + c);
    }
}

std::span<const std::uint32_t> FacadeProof::edges_near(Vec3 p) const {
  return near_.of(bin_of(p.x, p.y));
}

std::uint64_t FacadeProof::bytes() const {
  return (near_.first.size() + near_.items.size()) * sizeof(std::uint32_t) + edges_.size() * sizeof(Edge) +
         face_of_.size() * kBytesOfTriangle;
}

ProofTally FacadeProof::no_points() const {
  ProofTally tally;
  tally.edges.resize(edges_.size());
  tally.faces.resize(faces_.size());
  return tally;
}

void FacadeProof::add_to_edges(Vec3 p, std::uint64_t squares, std::uint32_t element, ProofTally& tally) const {
  const double reach2 = params_.edge_reach_m * params_.edge_reach_m;
  for (const std::uint32_t i : edges_near(p)) {
    const Edge& e = edges_[i];
    if (element != wall_.element && element != e.element && !e.outline) continue;
    const Vec3 foot = closest_on_segment(p, e.a, e.b), gap = p - foot;
    if (dot(gap, gap) > reach2) continue;
    const double length = norm(e.b - e.a), along = length > 0 ? norm(foot - e.a) / length : 0;
    tally.edges[i].stretches |= std::uint64_t{1} << std::min(static_cast<int>(along * e.stretches), e.stretches - 1);
    ++tally.edges[i].points;
    tally.edges[i].squares += squares;
  }
}

void FacadeProof::add(std::span<const Vec3> points, ProofTally& tally) const {
  for (const Vec3& p : points) {
    double distance = INFINITY;
    std::uint32_t key = 0;
    std::size_t face = 0;
    if (std::abs(p.z) <= params_.reach_m && wall_.region.contains({p.x, p.y})) {
      distance = std::abs(p.z);
      key = key_of(wall_.element, FaceName::front);
      face = static_cast<std::size_t>(std::lower_bound(faces_.begin(), faces_.end(), key) - faces_.begin());
    }
    const SurfacePoint nearest = closest_.nearest(p, std::min(distance, params_.reach_m));
    if (nearest.triangle != kNoTriangle) {
      distance = std::sqrt(nearest.squared_distance);
      face = face_of_[nearest.triangle];
      key = faces_[face];
    }
    if (!(distance <= params_.reach_m)) continue;
    const auto whole = static_cast<std::uint64_t>(std::llround(distance * kMicrometres));
    ++tally.faces[face].points;
    tally.faces[face].squares += whole * whole;
    add_to_edges(p, whole * whole, key / kNames, tally);
  }
}

void FacadeProof::write(const ProofTally& tally, Facade& facade) const {
  for (FacadeElement& e : facade.elements) {
    e.faces.clear();
    if (e.region != FacadeRegion::facade || !e.edges.empty()) continue;
    for (std::size_t k = 0; k < e.ring.size(); ++k)
      e.edges.push_back({DrawnStatus::seen, 0, 0, k % 2 == 0 ? e.height_error_m : e.width_error_m, 0, {}, 0});
  }
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    FacadeElement& e = facade.elements[edges_[i].element];
    if (edges_[i].number >= e.edges.size()) continue;
    e.edges[edges_[i].number].points = tally.edges[i].points;
    e.edges[edges_[i].number].rms_m = rms_of(tally.edges[i]);
    const double covered = std::popcount(tally.edges[i].stretches) / static_cast<double>(edges_[i].stretches);
    e.edges[edges_[i].number].covered_share = std::round(1000 * covered) / 1000;
  }
  for (std::size_t i = 0; i < faces_.size(); ++i)
    facade.elements[faces_[i] / kNames].faces.push_back(
        {kFaceNames[faces_[i] % kNames], tally.faces[i].points, rms_of(tally.faces[i]), {}});
}

}  // namespace ilot
