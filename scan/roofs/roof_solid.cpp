// SPDX-License-Identifier: Apache-2.0
#include "scan/roofs/roof_solid.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "kernels/geometry/ring.h"
#include "scan/optics/face_merge.h"
#include "scan/unit.h"

namespace ilot::scan {
namespace {

// A plane of the solid, given by its integer coefficients. Planes are sorted in the order of faces: roof planes, walls
// (the half-plane on whose border they stand), the floor.
struct PlaneKey {
  RoofPart part = RoofPart::roof;
  Integer a = 0, b = 0, c = 0;
  friend auto operator<=>(const PlaneKey&, const PlaneKey&) = default;
};

Plane plane_of(const PlaneKey& key, Integer floor) {
  if (key.part == RoofPart::floor) return {{0, 0, -1}, kUnit * static_cast<double>(floor)};
  const double up = key.part == RoofPart::roof ? kSlopeUnit : 0;
  const Vec3 outward{-static_cast<double>(key.a), -static_cast<double>(key.b), up};
  const double length = norm(outward);
  return {(1 / length) * outward, -kUnit * static_cast<double>(key.c) / length};
}

class Builder {
 public:
  Builder(std::span<const RoofPiece> pieces, Integer floor) : pieces_(pieces), floor_(floor) {
    for (const RoofPiece& piece : pieces_)
      for (const Corner& corner : piece.outline) spots_.push_back(corner.at);
    split_edges();
    add_crossings();
    split_edges();
    find_levels();
  }

  RoofSolid build() {
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      add_roof_and_floor(p);
      for (std::size_t i = 0; i < rings_[p].size(); ++i) add_wall(p, i);
    }
    return merge();
  }

 private:
  struct Side {
    std::size_t spot;
    GridLine line;  // line of the side that leads from the spot to the next one
  };

  std::size_t number_of(const Spot& spot) const {
    return static_cast<std::size_t>(std::lower_bound(spots_.begin(), spots_.end(), spot) - spots_.begin());
  }

  // Finds the spots along the border of a piece: its corners, and those of its neighbours on its sides.
  void split_edges() {
    std::sort(spots_.begin(), spots_.end());
    spots_.erase(std::unique(spots_.begin(), spots_.end()), spots_.end());
    rings_.clear();
    left_of_.clear();
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      const Piece& outline = pieces_[p].outline;
      std::vector<Side> ring;
      for (std::size_t i = 0; i < outline.size(); ++i) {
        const std::size_t from = number_of(outline[i].at), to = number_of(outline[(i + 1) % outline.size()].at);
        for (std::size_t spot : spots_between(from, to, outline[i].edge)) ring.push_back({spot, outline[i].edge});
      }
      for (std::size_t i = 0; i < ring.size(); ++i) left_of_[{ring[i].spot, ring[(i + 1) % ring.size()].spot}] = p;
      rings_.push_back(std::move(ring));
    }
  }

  std::vector<std::size_t> spots_between(std::size_t from, std::size_t to, const GridLine& edge) const {
    const Vec3 start = place(from), way = place(to) - start;
    std::vector<std::pair<double, std::size_t>> along{{0, from}};
    for (std::size_t spot = 0; spot < spots_.size(); ++spot) {
      if (spot == from || spot == to || side(edge, spots_[spot]) != 0) continue;
      const double t = dot(place(spot) - start, way) / dot(way, way);
      if (t > 0 && t < 1) along.push_back({t, spot});
    }
    std::sort(along.begin(), along.end());
    std::vector<std::size_t> between;
    for (const auto& [t, spot] : along) between.push_back(spot);
    return between;
  }

  // Adds the spots where the roofs of adjacent pieces cross between the ends of their common border.
  void add_crossings() {
    std::vector<Spot> crossings;
    for (const auto& [way, piece] : left_of_) {
      const auto twin = left_of_.find({way.second, way.first});
      if (twin == left_of_.end() || twin->second < piece) continue;
      const RoofPlane &here = pieces_[piece].plane, &there = pieces_[twin->second].plane;
      const GridLine higher{here.a - there.a, here.b - there.b, here.c - there.c};
      const Spot &from = spots_[way.first], &to = spots_[way.second];
      if (side(higher, from) * side(higher, to) < 0) crossings.push_back(meet(border_through(piece, from, to), higher));
    }
    spots_.insert(spots_.end(), crossings.begin(), crossings.end());
  }

  const GridLine& border_through(std::size_t piece, const Spot& from, const Spot& to) const {
    return std::find_if(
               pieces_[piece].outline.begin(), pieces_[piece].outline.end(),
               [&](const Corner& corner) { return side(corner.edge, from) == 0 && side(corner.edge, to) == 0; })
        ->edge;
  }

  Vec3 place(std::size_t spot) const {
    const Spot& s = spots_[spot];
    return {static_cast<double>(s.u) / static_cast<double>(s.w), static_cast<double>(s.v) / static_cast<double>(s.w),
            0};
  }

  // Heights at a spot are integers in units of 1 / (kSlopeUnit w) millimetres.
  Integer roof_level(std::size_t piece, std::size_t spot) const {
    const RoofPlane& plane = pieces_[piece].plane;
    const Spot& s = spots_[spot];
    return plane.a * s.u + plane.b * s.v + plane.c * s.w;
  }
  Integer floor_level(std::size_t spot) const { return kSlopeUnit * spots_[spot].w * floor_; }

  // Returns the level of the piece on the other side of an edge. Outside the footprint it is the floor.
  Integer level_beyond(std::size_t from, std::size_t to, std::size_t at) const {
    const auto twin = left_of_.find({to, from});
    return twin == left_of_.end() ? floor_level(at) : roof_level(twin->second, at);
  }

  void find_levels() {
    levels_.resize(spots_.size());
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      for (std::size_t i = 0; i < rings_[p].size(); ++i) {
        const std::size_t from = rings_[p][i].spot, to = rings_[p][(i + 1) % rings_[p].size()].spot;
        levels_[from].insert(roof_level(p, from));
        levels_[from].insert(level_beyond(from, to, from));
        levels_[to].insert(level_beyond(from, to, to));
      }
    }
  }

  std::uint32_t vertex(std::size_t spot, Integer level) {
    const auto [entry, fresh] =
        vertex_numbers_.try_emplace({spot, level}, static_cast<std::uint32_t>(vertices_.size()));
    if (fresh) {
      const double z = static_cast<double>(level) / static_cast<double>(kSlopeUnit * spots_[spot].w);
      vertices_.push_back(kUnit * Vec3{place(spot).x, place(spot).y, z});
    }
    return entry->second;
  }

  void add_patch(const PlaneKey& key, std::vector<std::uint32_t> ring) { keyed_.push_back({key, std::move(ring)}); }

  void add_roof_and_floor(std::size_t piece) {
    std::vector<std::uint32_t> roof, floor;
    for (const Side& side : rings_[piece]) {
      roof.push_back(vertex(side.spot, roof_level(piece, side.spot)));
      floor.push_back(vertex(side.spot, floor_level(side.spot)));
    }
    std::reverse(floor.begin(), floor.end());
    const RoofPlane& plane = pieces_[piece].plane;
    add_patch({RoofPart::roof, plane.a, plane.b, plane.c}, std::move(roof));
    add_patch({RoofPart::floor, 0, 0, 0}, std::move(floor));
  }

  // Returns the levels in increasing order, with both ends.
  std::vector<Integer> levels_between(std::size_t spot, Integer low, Integer high) const {
    return {levels_[spot].lower_bound(low), levels_[spot].upper_bound(high)};
  }

  // Adds the wall between the piece and a lower neighbour. It has a vertex wherever another face ends on its upright
  // edges.
  void add_wall(std::size_t piece, std::size_t i) {
    const std::size_t from = rings_[piece][i].spot, to = rings_[piece][(i + 1) % rings_[piece].size()].spot;
    const Integer low_from = level_beyond(from, to, from), low_to = level_beyond(from, to, to);
    const Integer high_from = roof_level(piece, from), high_to = roof_level(piece, to);
    if (high_from <= low_from && high_to <= low_to) return;
    std::vector<std::uint32_t> ring{vertex(from, low_from)};
    for (Integer level : levels_between(to, low_to, high_to)) ring.push_back(vertex(to, level));
    const std::vector<Integer> up = levels_between(from, low_from, high_from);
    for (std::size_t level = up.size() - 1; level > 0; --level) ring.push_back(vertex(from, up[level]));
    const GridLine line = reduced(rings_[piece][i].line);
    add_patch({RoofPart::wall, line.a, line.b, line.c}, std::move(ring));
  }

  RoofSolid merge() {
    std::vector<PlaneKey> keys;
    for (const auto& [key, ring] : keyed_) keys.push_back(key);
    std::sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    std::vector<Plane> planes;
    for (const PlaneKey& key : keys) planes.push_back(plane_of(key, floor_));
    std::vector<Patch> patches;
    for (auto& [key, ring] : keyed_)
      patches.push_back({static_cast<std::uint32_t>(std::lower_bound(keys.begin(), keys.end(), key) - keys.begin()),
                         std::move(ring)});
    std::vector<MergedFace> merged = merge_patches(patches, vertices_, planes);
    drop_straight_vertices(merged, vertices_);

    RoofSolid solid;
    std::vector<std::uint32_t> number(vertices_.size(), std::numeric_limits<std::uint32_t>::max());
    for (MergedFace& face : merged) {
      for (auto& ring : face.rings)
        for (std::uint32_t& v : ring) {
          if (number[v] == std::numeric_limits<std::uint32_t>::max()) {
            number[v] = static_cast<std::uint32_t>(solid.vertices.size());
            solid.vertices.push_back(vertices_[v]);
          }
          v = number[v];
        }
      solid.faces.push_back({keys[face.plane].part, planes[face.plane], std::move(face.rings)});
    }
    return solid;
  }

  std::span<const RoofPiece> pieces_;
  Integer floor_;
  std::vector<Spot> spots_;
  std::vector<std::vector<Side>> rings_;                                // per piece
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> left_of_;  // piece left of a directed edge
  std::vector<std::set<Integer>> levels_;                               // per spot
  std::map<std::pair<std::size_t, Integer>, std::uint32_t> vertex_numbers_;
  std::vector<Vec3> vertices_;
  std::vector<std::pair<PlaneKey, std::vector<std::uint32_t>>> keyed_;
};

}  // namespace

RoofSolid build_solid(std::span<const RoofPiece> pieces, Integer floor) {
  return Builder(pieces, floor).build();
}

double face_area(const RoofSolid& solid, const RoofFace& face) {
  Vec3 sum{0, 0, 0};
  const Vec3 anchor = solid.vertices[face.rings[0][0]];
  for (const auto& ring : face.rings)
    for (std::size_t i = 0; i < ring.size(); ++i)
      sum = sum + cross(solid.vertices[ring[i]] - anchor, solid.vertices[ring[(i + 1) % ring.size()]] - anchor);
  return dot(sum, face.plane.n) / 2;
}

bool face_contains(const RoofSolid& solid, const RoofFace& face, Vec3 place) {
  bool inside = false;
  for (const auto& ring : face.rings) {
    std::vector<FlatPoint> flat;
    for (std::uint32_t v : ring) flat.push_back(flatten(solid.vertices[v], face.plane.n));
    if (contains_by_share(flat, flatten(place, face.plane.n))) inside = !inside;
  }
  return inside;
}

}  // namespace ilot::scan
