// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/solids/roof_solid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "kernels/core/union_find.h"
#include "kernels/delaunay/rings.h"

namespace ilot {
namespace {

// Choice: keeps walls above the tolerance of validators, 1 mm, by far.
constexpr double kLeastHeight = 0.1;  // metres; least height of the lowest eave over the floor
// Derived: 20 times the tolerance of validators, 1 mm.
constexpr double kCorner = 20;  // millimetres; size of the corners that separate pinched faces
// Derived: the comment on the line.
constexpr double kLeastStep = 0.002;  // metres between vertices at one place: two steps on any grid of millimetres
// Derived: a tenth of the step of outlines.
constexpr double kHeightGrid = 1e4;  // steps a metre

// A spoke of a vertex: an edge seen from it, with the region on the left of the outward direction.
struct Spoke {
  std::uint32_t edge = 0, to = 0;
  std::uint32_t left = kOutside;
};

class Solid {
 public:
  Solid(Partition faces, std::span<const RoofPlane> planes, double ground, double same_height)
      : p_(std::move(faces)), planes_(planes), floor_(ground), same_height_(same_height) {
    lower_floor();
  }

  RoofSolid raise() {
    find_spokes();
    split_crossings();
    tidy(p_);
    find_spokes();
    part_pinches();
    tidy(p_);
    find_spokes();
    number_vertices();
    add_roofs();
    add_floor();
    add_walls();
    solid_.floor = floor_;
    return std::move(solid_);
  }

 private:
  double height(std::uint32_t region, Point2 at) const {
    return region == kOutside ? floor_ : planes_[region - 1].at(at.x / 1000.0, at.y / 1000.0);
  }

  void lower_floor() {
    for (const PartitionEdge& e : p_.edges)
      for (const std::uint32_t v : {e.from, e.to})
        for (const std::uint32_t r : {e.left, e.right})
          if (r != kOutside) floor_ = std::min(floor_, height(r, p_.vertices[v]) - kLeastHeight);
  }

  // Above 0: the left face is higher. 0: the faces have the same height.
  int order_at(const PartitionEdge& e, std::uint32_t v) const {
    const std::vector<double> groups = heights_around(v);
    const std::size_t left = nearest(groups, height(e.left, p_.vertices[v]));
    const std::size_t right = nearest(groups, height(e.right, p_.vertices[v]));
    return left == right ? 0 : left > right ? 1 : -1;
  }

  void split_crossings() {
    const std::size_t edges = p_.edges.size();
    for (std::size_t i = 0; i < edges; ++i) {
      const PartitionEdge e = p_.edges[i];
      if (order_at(e, e.from) * order_at(e, e.to) >= 0) continue;
      const Point2 a = p_.vertices[e.from], b = p_.vertices[e.to];
      const double ga = height(e.left, a) - height(e.right, a), gb = height(e.left, b) - height(e.right, b);
      const double t = ga / (ga - gb);
      const Point2 at = lattice_point({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}, 1);
      if (at == a || at == b) continue;
      const auto middle = static_cast<std::uint32_t>(p_.vertices.size());
      p_.vertices.push_back(at);
      p_.edges[i].to = middle;
      p_.edges.push_back({middle, e.to, e.left, e.right});
    }
  }

  void find_spokes() {
    spokes_.assign(p_.vertices.size(), {});
    for (std::uint32_t i = 0; i < p_.edges.size(); ++i) {
      const PartitionEdge& e = p_.edges[i];
      spokes_[e.from].push_back({i, e.to, e.left});
      spokes_[e.to].push_back({i, e.from, e.right});
    }
    for (std::uint32_t v = 0; v < spokes_.size(); ++v)
      std::sort(spokes_[v].begin(), spokes_[v].end(), [&](const Spoke& a, const Spoke& b) {
        return turns_before(p_.vertices[v], p_.vertices[a.to], p_.vertices[b.to]);
      });
  }

  // The heights of the faces around a vertex, ascending, one value for those that agree.
  std::vector<double> heights_around(std::uint32_t v) const {
    std::vector<double> all;
    for (const Spoke& s : spokes_[v]) all.push_back(height(s.left, p_.vertices[v]));
    std::sort(all.begin(), all.end());
    std::vector<double> groups;
    for (std::size_t first = 0; first < all.size();) {
      std::size_t last = first;
      while (last + 1 < all.size() && all[last + 1] - all[first] <= same_height_) ++last;
      const double z = (all[first] + all[last]) / 2;
      if (!groups.empty() && z - groups.back() < kLeastStep) {
        groups.back() = (groups.back() + z) / 2;
      } else {
        groups.push_back(z);
      }
      first = last + 1;
    }
    return groups;
  }

  static std::size_t nearest(const std::vector<double>& groups, double z) {
    const auto at = std::lower_bound(groups.begin(), groups.end(), z);
    if (at == groups.begin()) return 0;
    if (at == groups.end()) return groups.size() - 1;
    const auto i = static_cast<std::size_t>(at - groups.begin());
    return z - groups[i - 1] <= groups[i] - z ? i - 1 : i;
  }

  // Returns true where faces above some height and faces below it alternate around the vertex.
  bool pinched(std::uint32_t v) const {
    if (spokes_[v].size() < 4) return false;
    const std::vector<double> groups = heights_around(v);
    std::vector<std::size_t> level;
    for (const Spoke& s : spokes_[v]) level.push_back(nearest(groups, height(s.left, p_.vertices[v])));
    for (std::size_t g = 0; g + 1 < groups.size(); ++g) {
      int rises = 0;
      for (std::size_t i = 0; i < level.size(); ++i) rises += level[i] <= g && level[(i + 1) % level.size()] > g;
      if (rises > 1) return true;
    }
    return false;
  }

  void part_pinches() {
    const auto vertices = static_cast<std::uint32_t>(p_.vertices.size());
    for (std::uint32_t v = 0; v < vertices; ++v)
      if (pinched(v)) part_pinch(v);
  }

  std::uint32_t lowest_around(std::uint32_t v) const {
    std::uint32_t lowest = spokes_[v][0].left;
    for (const Spoke& s : spokes_[v])
      if (std::pair(height(s.left, p_.vertices[v]), s.left) < std::pair(height(lowest, p_.vertices[v]), lowest))
        lowest = s.left;
    return lowest;
  }

  // Resolves a pinched vertex. Every spoke is cut short of the vertex; the polygon of its new ends belongs to the
  // lowest face.
  void part_pinch(std::uint32_t v) {
    const std::vector<Spoke>& spokes = spokes_[v];
    const std::uint32_t lowest = lowest_around(v);
    const Point2 o = p_.vertices[v];
    double length = kCorner / 0.4;
    const auto other_end = [&](const Spoke& s) {
      return p_.edges[s.edge].from == v ? p_.edges[s.edge].to : p_.edges[s.edge].from;
    };
    for (const Spoke& s : spokes)
      length = std::min(length, std::sqrt(static_cast<double>(squared_distance(o, p_.vertices[other_end(s)]))));
    std::vector<Point2> ends;
    for (const Spoke& s : spokes) {
      const Point2 to = p_.vertices[other_end(s)];
      const double share = 0.4 * length / std::sqrt(static_cast<double>(squared_distance(o, to)));
      ends.push_back(lattice_point({o.x + share * (to.x - o.x), o.y + share * (to.y - o.y)}, 1));
    }
    for (std::size_t i = 0; i < ends.size(); ++i)
      if (ends[i] == o || ends[i] == ends[(i + 1) % ends.size()]) return;  // too narrow to cut
    const auto first = static_cast<std::uint32_t>(p_.vertices.size());
    p_.vertices.insert(p_.vertices.end(), ends.begin(), ends.end());
    for (std::uint32_t i = 0; i < spokes.size(); ++i) {
      PartitionEdge& e = p_.edges[spokes[i].edge];
      (e.from == v ? e.from : e.to) = first + i;
      const std::uint32_t next = first + (i + 1) % static_cast<std::uint32_t>(spokes.size());
      if (spokes[i].left != lowest) p_.edges.push_back({first + i, next, lowest, spokes[i].left});
    }
  }

  void number_vertices() {
    heights_.resize(p_.vertices.size());
    first_.resize(p_.vertices.size());
    for (std::uint32_t v = 0; v < p_.vertices.size(); ++v) {
      heights_[v] = heights_around(v);
      first_[v] = static_cast<std::uint32_t>(solid_.vertices.size());
      for (const double z : heights_[v])
        solid_.vertices.push_back(
            {p_.vertices[v].x / 1000.0, p_.vertices[v].y / 1000.0, std::round(z * kHeightGrid) / kHeightGrid});
    }
  }

  // The vertex of the solid where a face passes a vertex of the partition.
  std::uint32_t vertex(std::uint32_t v, std::uint32_t region) const {
    return first_[v] + static_cast<std::uint32_t>(nearest(heights_[v], height(region, p_.vertices[v])));
  }

  void add_roofs() {
    std::vector<BoundaryEdge> edges;
    for (const PartitionEdge& e : p_.edges) {
      if (e.left != kOutside) edges.push_back({e.from, e.to, e.left});
      if (e.right != kOutside) edges.push_back({e.to, e.from, e.right});
    }
    std::vector<BoundaryEdge> sorted = edges;
    std::sort(sorted.begin(), sorted.end(), [](const BoundaryEdge& a, const BoundaryEdge& b) {
      return std::tie(a.from, a.to) < std::tie(b.from, b.to);
    });
    const auto region_left_of = [&](std::uint32_t from, std::uint32_t to) {
      return std::lower_bound(sorted.begin(), sorted.end(), std::pair(from, to),
                              [](const BoundaryEdge& e, std::pair<std::uint32_t, std::uint32_t> ends) {
                                return std::pair(e.from, e.to) < ends;
                              })
          ->region;
    };
    const Polygons polygons = assemble_rings(edges, p_.vertices);
    std::vector<BuildingSurface> roofs(polygons.count);
    for (const Ring& ring : polygons.rings) {
      BuildingSurface& surface = roofs[ring.polygon];
      const auto at = [&](std::uint32_t i) { return polygons.vertices[ring.first + i % ring.count]; };
      surface.plane_id = region_left_of(at(0), at(1));
      std::vector<std::uint32_t> corners;
      for (std::uint32_t i = 0; i < ring.count; ++i) corners.push_back(vertex(at(i), surface.plane_id));
      surface.rings.push_back(std::move(corners));
    }
    std::stable_sort(roofs.begin(), roofs.end(),
                     [](const BuildingSurface& a, const BuildingSurface& b) { return a.plane_id < b.plane_id; });
    solid_.surfaces = std::move(roofs);
  }

  void add_floor() {
    std::vector<std::uint32_t> parents(p_.regions + 1);
    UnionFind parts(parents);
    for (const PartitionEdge& e : p_.edges)
      if (e.left != kOutside && e.right != kOutside) parts.unite(e.left, e.right);
    std::vector<BoundaryEdge> edges;
    for (const PartitionEdge& e : p_.edges) {
      if (e.right == kOutside) edges.push_back({e.from, e.to, parts.find(e.left)});
      if (e.left == kOutside) edges.push_back({e.to, e.from, parts.find(e.right)});
    }
    const Polygons polygons = assemble_rings(edges, p_.vertices);
    std::vector<BuildingSurface> floors(polygons.count);
    for (const Ring& ring : polygons.rings) {
      std::vector<std::uint32_t> corners;
      for (std::uint32_t i = ring.count; i-- > 0;)
        corners.push_back(vertex(polygons.vertices[ring.first + i], kOutside));
      floors[ring.polygon].kind = SurfaceKind::ground;
      floors[ring.polygon].rings.push_back(std::move(corners));
    }
    solid_.surfaces.insert(solid_.surfaces.end(), floors.begin(), floors.end());
  }

  void add_walls() {
    for (const PartitionEdge& e : p_.edges) {
      const std::uint32_t from_left = vertex(e.from, e.left), from_right = vertex(e.from, e.right);
      const std::uint32_t to_left = vertex(e.to, e.left), to_right = vertex(e.to, e.right);
      // Vertices at one place ascend with height.
      if (from_left > from_right || to_left > to_right) add_wall(from_right, from_left, to_right, to_left);
      if (from_left < from_right || to_left < to_right) add_wall(to_left, to_right, from_left, from_right);
    }
  }

  // Adds a wall as seen from outside: along the lower border, up, back along the upper one and down, through all
  // vertices on the way.
  void add_wall(std::uint32_t from_low, std::uint32_t from_high, std::uint32_t to_low, std::uint32_t to_high) {
    BuildingSurface wall;
    wall.kind = SurfaceKind::wall;
    std::vector<std::uint32_t> ring{from_low};
    for (std::uint32_t i = to_low; i <= to_high; ++i) ring.push_back(i);
    for (std::uint32_t i = from_high; i > from_low; --i) ring.push_back(i);
    wall.rings.push_back(std::move(ring));
    solid_.surfaces.push_back(std::move(wall));
  }

  Partition p_;
  std::span<const RoofPlane> planes_;
  double floor_, same_height_;
  std::vector<std::vector<Spoke>> spokes_;    // per vertex, counter-clockwise
  std::vector<std::vector<double>> heights_;  // per vertex, ascending
  std::vector<std::uint32_t> first_;          // per vertex: its lowest vertex in the solid
  RoofSolid solid_;
};

}  // namespace

RoofSolid extrude_roof(Partition faces, std::span<const RoofPlane> planes, double ground, double same_height) {
  return Solid(std::move(faces), planes, ground, same_height).raise();
}

}  // namespace ilot
