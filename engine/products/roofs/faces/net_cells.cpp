// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/faces/net_cells.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kernels/core/union_find.h"
#include "kernels/delaunay/rings.h"

namespace ilot {
namespace {

constexpr std::uint32_t kNoCell = 0xffffffffu;

// Edge e of the net has two halves: 2 e from its lesser vertex to the greater one, and 2 e + 1 back. Each half has a
// face on its left.
class Faces {
 public:
  explicit Faces(const LineNet& net) : net_(net) {
    find_spokes();
    trace();
    place_components();
    find_insides();
  }

  Partition inside() const {
    Partition p;
    p.vertices = net_.vertices;
    const std::vector<std::uint32_t> region = numbered(p.regions);
    for (std::uint32_t e = 0; e < net_.edges.size(); ++e) {
      const std::uint32_t left = region[face_[2 * e]], right = region[face_[2 * e + 1]];
      if (left != right) p.edges.push_back({net_.edges[e].from, net_.edges[e].to, left, right});
    }
    return p;
  }

 private:
  std::uint32_t start(std::uint32_t half) const {
    const NetEdge& e = net_.edges[half / 2];
    return half % 2 == 0 ? e.from : e.to;
  }
  std::uint32_t end(std::uint32_t half) const { return start(half ^ 1); }

  // Finds the halves that start at each vertex, counter-clockwise from the direction of +x.
  void find_spokes() {
    first_.assign(net_.vertices.size() + 1, 0);
    for (const NetEdge& e : net_.edges) ++first_[e.from], ++first_[e.to];
    for (std::uint32_t sum = 0; std::uint32_t & f : first_) sum = f += sum;
    spokes_.resize(2 * net_.edges.size());
    for (std::uint32_t h = 0; h < spokes_.size(); ++h) spokes_[--first_[start(h)]] = h;
    place_.resize(spokes_.size());
    for (std::uint32_t v = 0; v < net_.vertices.size(); ++v) {
      const auto at = [&](std::uint32_t i) { return spokes_.begin() + i; };
      std::sort(at(first_[v]), at(first_[v + 1]), [&](std::uint32_t a, std::uint32_t b) {
        return turns_before(net_.vertices[v], net_.vertices[end(a)], net_.vertices[end(b)]);
      });
      for (std::uint32_t i = first_[v]; i < first_[v + 1]; ++i) place_[spokes_[i]] = i;
    }
  }

  // The next half along the face on the left. Of the halves that leave the end, it is the last one before the way back,
  // counter-clockwise.
  std::uint32_t next(std::uint32_t half) const {
    const std::uint32_t v = end(half), i = place_[half ^ 1];
    return spokes_[i == first_[v] ? first_[v + 1] - 1 : i - 1];
  }

  // Traces the cycles of halves. A cycle that turns left goes around a face, any other around a component.
  void trace() {
    face_.assign(spokes_.size(), kNoCell);
    for (std::uint32_t h = 0; h < face_.size(); ++h) {
      if (face_[h] != kNoCell) continue;
      const auto cycle = static_cast<std::uint32_t>(around_component_.size());
      const Point2 o = net_.vertices[start(h)];
      __int128 area = 0;
      std::uint32_t at = h;
      do {
        face_[at] = cycle;
        area += orient2d(o, net_.vertices[start(at)], net_.vertices[end(at)]);
        at = next(at);
      } while (at != h);
      around_component_.push_back(area <= 0);
    }
  }

  // Finds the face around each component: it is the face below the component's least vertex. Components begin with
  // their least vertices, and the component below another one begins before it.
  void place_components() {
    std::vector<std::uint32_t> parents(net_.vertices.size());
    UnionFind components(parents);
    for (const NetEdge& e : net_.edges) components.unite(e.from, e.to);
    outside_ = static_cast<std::uint32_t>(around_component_.size());
    std::vector<std::uint32_t> stands_for(outside_ + 1);  // per cycle: the face that it bounds
    for (std::uint32_t c = 0; c <= outside_; ++c) stands_for[c] = c;
    for (std::uint32_t v = 0; v < net_.vertices.size(); ++v) {
      if (components.find(v) != v || first_[v] == first_[v + 1]) continue;
      const std::uint32_t below = edge_below(v, components);
      const std::uint32_t around = below == kNoCell ? outside_ : stands_for[face_[2 * below]];
      stands_for[cycle_around(v)] = around;
    }
    for (std::uint32_t& face : face_) face = stands_for[face];
  }

  // Returns the cycle around a component. It passes the component's least vertex, and there is only one.
  std::uint32_t cycle_around(std::uint32_t least) const {
    std::uint32_t i = first_[least];
    while (!around_component_[face_[spokes_[i]]]) ++i;
    return face_[spokes_[i]];
  }

  // Returns the nearest edge of another component straight below a vertex.
  std::uint32_t edge_below(std::uint32_t v, UnionFind& components) const {
    const Point2 p = net_.vertices[v];
    std::uint32_t nearest = kNoCell;
    double height = -INFINITY, slope = 0;
    for (std::uint32_t e = 0; e < net_.edges.size(); ++e) {
      const Point2 a = net_.vertices[net_.edges[e].from], b = net_.vertices[net_.edges[e].to];
      if (a.x > p.x) break;  // edges ascend
      if (b.x <= p.x || orient2d(a, b, p) <= 0 || components.same(net_.edges[e].from, v)) continue;
      const double rise = static_cast<double>(b.y - a.y) / static_cast<double>(b.x - a.x);
      const double y = a.y + rise * static_cast<double>(p.x - a.x);
      if (y < height || (y == height && rise <= slope)) continue;
      nearest = e;
      height = y;
      slope = rise;
    }
    return nearest;
  }

  void find_insides() {
    std::vector<std::vector<std::uint32_t>> halves(outside_ + 1);
    for (std::uint32_t h = 0; h < face_.size(); ++h) halves[face_[h]].push_back(h);
    inside_.assign(outside_ + 1, 0);
    std::vector<std::uint8_t> seen(outside_ + 1, 0);
    std::vector<std::uint32_t> stack{outside_};
    seen[outside_] = 1;
    while (!stack.empty()) {
      const std::uint32_t face = stack.back();
      stack.pop_back();
      for (const std::uint32_t h : halves[face]) {
        const std::uint32_t other = face_[h ^ 1];
        if (std::exchange(seen[other], 1) != 0) continue;
        inside_[other] = inside_[face] ^ static_cast<std::uint8_t>(net_.edges[h / 2].border);
        stack.push_back(other);
      }
    }
  }

  std::vector<std::uint32_t> numbered(std::uint32_t& regions) const {
    std::vector<std::uint32_t> region(outside_ + 1, kOutside);
    for (const std::uint32_t h : spokes_) {  // in the order of the vertices where they start
      const std::uint32_t face = face_[h];
      if (inside_[face] != 0 && region[face] == kOutside) region[face] = ++regions;
    }
    return region;
  }

  const LineNet& net_;
  std::vector<std::uint32_t> first_, spokes_;   // per vertex, and one more entry: where its spokes begin; the halves
  std::vector<std::uint32_t> place_;            // per half: its position among the spokes
  std::vector<std::uint32_t> face_;             // per half: the face on its left
  std::vector<std::uint8_t> around_component_;  // per cycle
  std::vector<std::uint8_t> inside_;            // per face
  std::uint32_t outside_ = 0;                   // the face far away
};

}  // namespace

Partition cells_inside(const LineNet& net) {
  Partition p = Faces(net).inside();
  tidy(p);
  return p;
}

}  // namespace ilot
