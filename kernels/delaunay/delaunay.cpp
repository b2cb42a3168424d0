// SPDX-License-Identifier: Apache-2.0
#include "kernels/delaunay/delaunay.h"

#include <algorithm>
#include <bit>
#include <memory>

#include "kernels/core/parallel.h"
#include "kernels/delaunay/plane_order.h"

namespace ilot {
namespace {

// A directed edge seen from its origin. Edges 2i and 2i+1 are the two directions of one edge.
struct HalfEdge {
  std::uint32_t origin;  // kNoEdge: the slot is free
  std::uint32_t next;    // the next edge counter-clockwise around the origin
  std::uint32_t last;    // the next one clockwise
};

enum Side { kLeft, kBottom, kRight, kTop };

// The triangulation of a run of points. It has the vertex farthest towards each side, and the edge of the convex hull
// that leaves this vertex counter-clockwise, with all points on its left. The edge is kNoEdge when there is only one
// point. The run of k points owns the 3k edges from 6 * first on. Unused edges form a list through HalfEdge::next.
struct Part {
  std::uint32_t first = 0, count = 0;
  std::uint32_t extreme[4] = {};
  std::uint32_t hull[4] = {kNoEdge, kNoEdge, kNoEdge, kNoEdge};
  std::uint32_t free_head = kNoEdge, free_tail = kNoEdge;
};

struct Cut {
  std::uint32_t low;  // points on the low side
  int axis;           // 0: low is left of high, 1: low is below high
};

class Builder {
 public:
  Builder(const PlaneOrder& order, HalfEdge* edges)
      : points_(order.points.data()), codes_(order.codes.data()), edge_(edges) {}

  // Returns where the aligned cell of the points is halved.
  Cut cut_of(std::uint32_t first, std::uint32_t count) const {
    const std::uint64_t* begin = codes_ + first;
    const int bit = 63 - std::countl_zero(begin[0] ^ begin[count - 1]);
    const std::uint64_t bound = begin[count - 1] >> bit << bit;
    return {static_cast<std::uint32_t>(std::lower_bound(begin, begin + count, bound) - begin), bit & 1};
  }

  Part build(std::uint32_t first, std::uint32_t count) {
    if (count == 1) return single(first);
    if (count == 3 && orient2d(at(first), at(first + 1), at(first + 2)) != 0) return triple(first);
    const Cut cut = cut_of(first, count);
    return merge(build(first, cut.low), build(first + cut.low, count - cut.low), cut.axis);
  }

  Part merge(const Part& low, const Part& high, int axis) {
    Part all;
    all.first = low.first;
    all.count = low.count + high.count;
    all.free_head = low.free_head;
    all.free_tail = high.free_tail;
    edge_[low.free_tail].next = high.free_head;
    const std::uint32_t lower =
        lower_tangent(all, low, high, low.hull[axis == 0 ? kRight : kTop], high.hull[axis == 0 ? kLeft : kBottom]);
    const std::uint32_t upper = zip(all, lower) ^ 1;
    for (int side = 0; side < 4; ++side) {
      const Part& from = reaches_farther(low.extreme[side], high.extreme[side], side) ? low : high;
      const std::uint32_t v = from.extreme[side];
      all.extreme[side] = v;
      all.hull[side] = v == edge_[lower].origin ? lower : v == edge_[upper].origin ? upper : from.hull[side];
    }
    return all;
  }

 private:
  // Creates a part. `used` of its 3 * count edges are taken, and the others are free.
  Part new_part(std::uint32_t first, std::uint32_t count, std::uint32_t used) {
    Part part{first, count, {first, first, first, first}};
    part.free_head = 6 * first + 2 * used;
    part.free_tail = 6 * (first + count) - 2;
    for (std::uint32_t e = part.free_head; e <= part.free_tail; e += 2) {
      edge_[e] = {kNoEdge, e + 2, e};
      edge_[e + 1] = {kNoEdge, e, e};
    }
    return part;
  }

  Part single(std::uint32_t v) { return new_part(v, 1, 0); }

  Part triple(std::uint32_t a) {
    std::uint32_t b = a + 1, c = a + 2;
    if (orient2d(at(a), at(b), at(c)) < 0) std::swap(b, c);
    Part part = new_part(a, 3, 3);
    const std::uint32_t ab = 6 * a, bc = ab + 2, ca = ab + 4;
    const auto corner = [&](std::uint32_t v, std::uint32_t out, std::uint32_t in) {
      edge_[out] = {v, in ^ 1, in ^ 1};
      edge_[in ^ 1] = {v, out, out};
    };
    corner(a, ab, ca);
    corner(b, bc, ab);
    corner(c, ca, bc);
    for (int side = 0; side < 4; ++side) {
      std::uint32_t v = reaches_farther(b, a, side) ? b : a;
      if (reaches_farther(c, v, side)) v = c;
      part.extreme[side] = v;
      part.hull[side] = v == a ? ab : v == b ? bc : ca;
    }
    return part;
  }

  // Ties go to one end of the side, so that the extreme of points on a line is an end of the line.
  bool reaches_farther(std::uint32_t a, std::uint32_t b, int side) const {
    const Point2 p = at(a), q = at(b);
    if (side == kLeft) return p < q;
    if (side == kRight) return q < p;
    const bool below = p.y < q.y || (p.y == q.y && p.x < q.x);
    return (side == kBottom) == below;
  }

  Point2 at(std::uint32_t v) const { return points_[v]; }
  std::uint32_t target(std::uint32_t e) const { return edge_[e ^ 1].origin; }

  // Takes an edge out of the list of free ones. At each end it is alone; insert_before() puts it between its
  // neighbours. With the face on its left, the next edge of that face is edge_[e ^ 1].last, as `last` is clockwise:
  //
  //          c
  //          |\    edge_[e ^ 1].last
  //          | \   is to-c
  //     from -e-> to       e ^ 1 is the way back
  //
  std::uint32_t new_edge(Part& part, std::uint32_t from, std::uint32_t to) {
    const std::uint32_t e = part.free_head;
    part.free_head = edge_[e].next;
    edge_[e] = {from, e, e};
    edge_[e + 1] = {to, e + 1, e + 1};
    return e;
  }
  void insert_before(std::uint32_t e, std::uint32_t next) {
    const std::uint32_t last = edge_[next].last;
    edge_[last].next = e;
    edge_[next].last = e;
    edge_[e].next = next;
    edge_[e].last = last;
  }
  void unlink(std::uint32_t e) {
    const HalfEdge h = edge_[e];
    edge_[h.last].next = h.next;
    edge_[h.next].last = h.last;
    edge_[e].origin = kNoEdge;
  }
  void remove(Part& part, std::uint32_t e) {
    unlink(e);
    unlink(e ^ 1);
    const std::uint32_t slot = e & ~1u;
    edge_[slot].next = part.free_head;
    part.free_head = slot;
  }

  // Adds the edge between the parts, from low to high, that has both of them on its left. `right` is the hull edge of
  // the low part out of its vertex nearest to the high part. `left` is the hull edge of the high part out of its vertex
  // nearest to the low part. Both ends go along their hulls until
  // no point is to the right of a-b:
  //
  //     low  .       .  high
  //           \     /
  //            a - b
  //
  std::uint32_t lower_tangent(Part& all, const Part& low, const Part& high, std::uint32_t right, std::uint32_t left) {
    std::uint32_t a = right == kNoEdge ? low.first : edge_[right].origin;
    std::uint32_t b = left == kNoEdge ? high.first : edge_[left].origin;
    for (bool moved = true; moved;) {
      moved = false;
      while (right != kNoEdge) {
        const std::uint32_t back = edge_[right].last;
        if (orient2d(at(a), at(target(back)), at(b)) <= 0) break;
        right = back ^ 1;
        a = edge_[right].origin;
        moved = true;
      }
      while (left != kNoEdge && orient2d(at(b), at(target(left)), at(a)) < 0) {
        left = edge_[left ^ 1].next;
        b = edge_[left].origin;
        moved = true;
      }
    }
    const std::uint32_t base = new_edge(all, a, b);
    if (right != kNoEdge) insert_before(base, right);
    if (left != kNoEdge) insert_before(base ^ 1, left);
    return base;
  }

  // Returns the end of the next edge above a-b at its low end, or kNoEdge when there is none. Edges that the circle
  // test excludes are removed.
  std::uint32_t low_candidate(Part& all, std::uint32_t base, Point2 a, Point2 b) {
    std::uint32_t e = edge_[base].next;
    Point2 c = at(target(e));
    while (orient2d(a, b, c) > 0) {
      const std::uint32_t next = edge_[e].next;
      const Point2 d = at(target(next));
      if (next == base || !in_circle(a, b, c, d)) return e;
      remove(all, e);
      e = next;
      c = d;
    }
    return kNoEdge;
  }
  std::uint32_t high_candidate(Part& all, std::uint32_t base, Point2 a, Point2 b) {
    std::uint32_t e = edge_[base ^ 1].last;
    Point2 c = at(target(e));
    while (orient2d(a, b, c) > 0) {
      const std::uint32_t next = edge_[e].last;
      const Point2 d = at(target(next));
      if (next == (base ^ 1) || !in_circle(a, b, c, d)) return e;
      remove(all, e);
      e = next;
      c = d;
    }
    return kNoEdge;
  }

  // Goes from the lower tangent from edge to edge between the parts up to the upper tangent, which is returned. The
  // triangle above the base a-b has the candidate of one side as its third corner: the one whose circle with a and b
  // does not contain the other. Here d is taken, and a-d is the next base; c would make c-b the next one.
  //
  //     c       d             c       d
  //      \     /               \   . /
  //  low  \   /  high   -->     \.  /
  //        a-b                   a-b
  //
  std::uint32_t zip(Part& all, std::uint32_t base) {
    std::uint32_t a = edge_[base].origin, b = edge_[base ^ 1].origin;
    for (;;) {
      const std::uint32_t low = low_candidate(all, base, at(a), at(b));
      const std::uint32_t high = high_candidate(all, base, at(a), at(b));
      if (low == kNoEdge && high == kNoEdge) return base;
      if (low == kNoEdge || (high != kNoEdge && in_circle(at(a), at(b), at(target(low)), at(target(high))))) {
        b = target(high);
        const std::uint32_t e = new_edge(all, a, b);
        insert_before(e, edge_[base].next);
        insert_before(e ^ 1, high ^ 1);
        base = e;
      } else {
        a = target(low);
        const std::uint32_t e = new_edge(all, a, b);
        insert_before(e, edge_[low ^ 1].next);
        insert_before(e ^ 1, base ^ 1);
        base = e;
      }
    }
  }

  const Point2* points_;
  const std::uint64_t* codes_;
  HalfEdge* edge_;
};

// A cell with more points than one task processes, and its halves.
struct Node {
  std::uint32_t first = 0, count = 0;
  int axis = 0, height = 0;  // height 0: a task
  std::size_t low = 0, high = 0;
  Part part;
};

constexpr std::uint32_t kTaskPoints = std::uint32_t{1} << 15;

std::size_t divide(const Builder& builder, std::uint32_t first, std::uint32_t count, std::vector<Node>& nodes) {
  Node node;
  node.first = first;
  node.count = count;
  if (count > kTaskPoints) {
    const Cut cut = builder.cut_of(first, count);
    node.axis = cut.axis;
    node.low = divide(builder, first, cut.low, nodes);
    node.high = divide(builder, first + cut.low, count - cut.low, nodes);
    node.height = 1 + std::max(nodes[node.low].height, nodes[node.high].height);
  }
  nodes.push_back(node);
  return nodes.size() - 1;
}

Part build_in_parallel(Builder& builder, std::uint32_t count) {
  std::vector<Node> nodes;
  divide(builder, 0, count, nodes);
  std::vector<std::vector<std::size_t>> level(static_cast<std::size_t>(nodes.back().height) + 1);
  for (std::size_t i = 0; i < nodes.size(); ++i) level[static_cast<std::size_t>(nodes[i].height)].push_back(i);
  for (const auto& ids : level)
    parallel_for(ids.size(), [&](std::size_t k) {
      Node& node = nodes[ids[k]];
      node.part = node.height == 0 ? builder.build(node.first, node.count)
                                   : builder.merge(nodes[node.low].part, nodes[node.high].part, node.axis);
    });
  return nodes.back().part;
}

// Removes the outer sides of the hull's edges from the half-edges that bound triangles.
void leave_outside(HalfEdge* edge, std::uint32_t start) {
  std::uint32_t e = start;
  do {
    const std::uint32_t outer = e ^ 1;
    e = edge[outer].next;
    edge[outer].origin = kNoEdge;
    edge[outer].next = kNoEdge;
  } while (e != start);
}

constexpr std::size_t kChunk = std::size_t{1} << 17;  // half-edges a task

// Returns the smallest edge of each triangle, among the edges of one chunk. The code has no branches, because they
// would be mispredicted.
std::vector<std::uint32_t> smallest_edges(const HalfEdge* edge, std::size_t begin, std::size_t end) {
  std::vector<std::uint32_t> list(end - begin);
  std::size_t count = 0;
  for (std::size_t s = begin; s < end; ++s) {
    const auto e = static_cast<std::uint32_t>(s);
    const std::uint32_t f = edge[e ^ 1].last, g = edge[f ^ 1].last;
    list[count] = e;
    count += (edge[e].origin != kNoEdge) & (f > e) & (g > e);
  }
  list.resize(count);
  return list;
}

// Numbers the triangles by their smallest edges. Afterwards HalfEdge::next is the number of the edge in the result.
void collect_triangles(HalfEdge* edge, std::size_t slots, Triangulation& out) {
  const std::size_t chunks = (slots + kChunk - 1) / kChunk;
  std::vector<std::vector<std::uint32_t>> smallest(chunks);
  parallel_for(chunks, [&](std::size_t c) {
    smallest[c] = smallest_edges(edge, c * kChunk, std::min(slots, (c + 1) * kChunk));
  });
  std::vector<std::size_t> first(chunks + 1);
  for (std::size_t c = 0; c < chunks; ++c) first[c + 1] = first[c] + 3 * smallest[c].size();
  out.corner.resize(first[chunks]);
  out.twin.resize(first[chunks]);
  parallel_for(chunks, [&](std::size_t c) {
    std::size_t to = first[c];
    for (const std::uint32_t e : smallest[c]) {
      const std::uint32_t f = edge[e ^ 1].last, g = edge[f ^ 1].last;
      for (const std::uint32_t h : {e, f, g}) {
        edge[h].next = static_cast<std::uint32_t>(to);
        out.corner[to++] = edge[h].origin;
      }
    }
  });
  parallel_for(chunks, [&](std::size_t c) {
    for (std::size_t e = c * kChunk; e < std::min(slots, (c + 1) * kChunk); ++e)
      if (edge[e].origin != kNoEdge) out.twin[edge[e].next] = edge[e ^ 1].next;
  });
}

}  // namespace

Triangulation delaunay(const PlaneOrder& order) {
  Triangulation out;
  const auto n = static_cast<std::uint32_t>(order.points.size());
  if (n < 3) return out;
  const std::unique_ptr<HalfEdge[]> edges(new HalfEdge[6 * std::size_t{n}]);
  Builder builder(order, edges.get());
  leave_outside(edges.get(), build_in_parallel(builder, n).hull[kLeft]);
  collect_triangles(edges.get(), 6 * std::size_t{n}, out);
  return out;
}

Triangulation delaunay(std::span<const Point2> points) {
  PlaneOrder order = plane_order(points);
  Triangulation out = delaunay(order);
  out.duplicates = std::move(order.duplicates);
  parallel_for((out.corner.size() + kChunk - 1) / kChunk, [&](std::size_t c) {
    for (std::size_t e = c * kChunk; e < std::min(out.corner.size(), (c + 1) * kChunk); ++e)
      out.corner[e] = order.index[out.corner[e]];
  });
  return out;
}

}  // namespace ilot
