// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/solids/planar_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace ilot {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// Choice: from so many of the largest triangles a piece is tried, because one of them may have a corner that is off.
constexpr std::size_t kSeeds = 8;

// The triangles of a face, and the one on the other side of each edge. Edge e of a triangle starts at its corner e.
struct Mesh {
  std::vector<TriangleCorners> triangles;
  std::vector<std::array<std::uint32_t, 3>> across;  // kNone at the border of the face
  std::vector<double> area;
};

Mesh mesh_of(const LatticeVertices& vertices, const FaceRings& rings) {
  Mesh mesh{triangulate_face(vertices, rings), {}, {}};
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> owner;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t e = 0; e < 3; ++e) owner[{mesh.triangles[t][e], mesh.triangles[t][(e + 1) % 3]}] = t;
  for (const TriangleCorners& c : mesh.triangles) {
    std::array<std::uint32_t, 3> across;
    for (std::size_t e = 0; e < 3; ++e) {
      const auto other = owner.find({c[(e + 1) % 3], c[e]});
      across[e] = other == owner.end() ? kNone : other->second;
    }
    mesh.across.push_back(across);
    const Index3 from = vertices.points[c[0]];
    mesh.area.push_back(norm(cross(offset(vertices, c[1], from), offset(vertices, c[2], from))) / 2);
  }
  return mesh;
}

// What a triangle is to the piece that grows.
enum class Place : std::uint8_t { free, elsewhere, inside, refused };

// Triangles whose union has one ring that passes no vertex twice, because each adds a corner that the piece did not
// have.
class Piece {
 public:
  Piece(const LatticeVertices& vertices, const Mesh& mesh, const std::vector<Place>& places, double most_bent)
      : vertices_(vertices), mesh_(mesh), places_(places), has_(vertices.points.size(), 0), most_bent_(most_bent) {}

  void grow(std::uint32_t seed) {
    add(seed);
    const TriangleCorners& c = mesh_.triangles[seed];
    corners_[0].assign(c.begin(), c.end());
    for (const std::uint32_t corner : c) has_[corner] = 1;
    plane_ = plane_of(vertices_, corners_);
    while (add_next()) {
    }
  }

  double area() const { return area_; }
  const std::vector<std::uint32_t>& triangles() const { return triangles_; }

  // From its lowest corner on, so that it does not depend on the seed.
  std::vector<std::uint32_t> ring() const {
    std::map<std::uint32_t, std::uint32_t> after;
    for (const std::uint32_t t : triangles_)
      for (std::size_t e = 0; e < 3; ++e)
        if (!inside(mesh_.across[t][e])) after[mesh_.triangles[t][e]] = mesh_.triangles[t][(e + 1) % 3];
    std::vector<std::uint32_t> ring{after.begin()->first};
    for (std::uint32_t v = after.begin()->second; v != ring[0]; v = after[v]) ring.push_back(v);
    return ring;
  }

 private:
  bool inside(std::uint32_t t) const { return t != kNone && places_[t] == Place::inside; }

  void add(std::uint32_t t) {
    places_[t] = Place::inside;
    triangles_.push_back(t);
    area_ += mesh_.area[t];
  }

  // Adds the free triangle beside the piece whose corner is nearest to its plane. Returns false when there is none.
  bool add_next() {
    std::uint32_t best = kNone, best_corner = kNone;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (places_[t] != Place::free) continue;
      const std::uint32_t corner = corner_across(t);
      if (corner == kNone || has_[corner] != 0) continue;
      const double away = std::abs(dot(plane_.n, offset(vertices_, corner, plane_.anchor) - plane_.centre));
      if (away < nearest) nearest = away, best = t, best_corner = corner;
    }
    if (best == kNone) return false;
    take_or_refuse(best, best_corner);
    return true;
  }

  // The corner of a triangle across an edge that it has in common with the piece; kNone when it has none.
  std::uint32_t corner_across(std::uint32_t t) const {
    for (std::size_t e = 0; e < 3; ++e)
      if (inside(mesh_.across[t][e])) return mesh_.triangles[t][(e + 2) % 3];
    return kNone;
  }

  void take_or_refuse(std::uint32_t t, std::uint32_t corner) {
    corners_[0].push_back(corner);
    const FacePlane plane = plane_of(vertices_, corners_);
    if (farthest_from(plane, vertices_, corners_) <= most_bent_) {
      plane_ = plane;
      has_[corner] = 1;
      add(t);
    } else {
      corners_[0].pop_back();
      places_[t] = Place::refused;
    }
  }

  const LatticeVertices& vertices_;
  const Mesh& mesh_;
  std::vector<Place> places_;      // of the triangles
  std::vector<std::uint8_t> has_;  // per vertex: 1 = a corner of the piece
  double most_bent_;
  FaceRings corners_{{}};  // in the order in which they came
  FacePlane plane_;
  std::vector<std::uint32_t> triangles_;
  double area_ = 0;
};

std::vector<std::uint32_t> largest_first(const Mesh& mesh) {
  std::vector<std::uint32_t> order(mesh.triangles.size());
  for (std::uint32_t t = 0; t < order.size(); ++t) order[t] = t;
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return mesh.area[a] > mesh.area[b]; });
  return order;
}

}  // namespace

std::vector<std::vector<std::uint32_t>> planar_pieces(const LatticeVertices& vertices, const FaceRings& rings,
                                                      double most_bent) {
  const Mesh mesh = mesh_of(vertices, rings);
  std::vector<std::uint32_t> seeds = largest_first(mesh);
  std::vector<Place> places(mesh.triangles.size(), Place::free);
  std::vector<std::vector<std::uint32_t>> pieces;
  while (!seeds.empty()) {
    std::optional<Piece> best;
    for (std::size_t i = 0; i < std::min(kSeeds, seeds.size()); ++i) {
      Piece piece(vertices, mesh, places, most_bent);
      piece.grow(seeds[i]);
      if (!best || piece.area() > best->area()) best.emplace(std::move(piece));
    }
    pieces.push_back(best->ring());
    for (const std::uint32_t t : best->triangles()) places[t] = Place::elsewhere;
    std::erase_if(seeds, [&](std::uint32_t t) { return places[t] != Place::free; });
  }
  return pieces;
}

}  // namespace ilot
