// SPDX-License-Identifier: Apache-2.0
// Tests small sets of points of all difficult kinds. The triangulation must be sound and Delaunay. It must equal brute
// force where there are few points. It must equal that of another library, except for ties, where one was built in
// (-DILOT_BENCH_PEERS=ON).
// Usage: delaunay_fuzz COUNT [FIRST]     COUNT sets, the first of key FIRST [0]; exit 1 at the first fault
#include <cstdio>
#include <cstdlib>
#include <map>
#include <numeric>

#include "kernels/core/union_find.h"
#include "kernels/delaunay/constrained.h"
#include "kernels/delaunay/topology.h"
#include "tests/oracles/delaunay_peer.h"

namespace {

using namespace ilot;
using test::PlacedTriangle;

// Returns for each circle the corners of the connected triangles on it. These sets do not depend on how ties are
// decided.
std::vector<std::vector<Point2>> circles_of(const std::vector<PlacedTriangle>& triangles) {
  std::vector<std::uint32_t> parent(triangles.size());
  UnionFind joined(parent);
  std::map<std::pair<Point2, Point2>, std::pair<std::uint32_t, Point2>> edges;  // triangle on the left, its apex
  for (std::uint32_t i = 0; i < triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& t = triangles[i];
      const Point2 a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
      edges[{a, b}] = {i, c};
      const auto other = edges.find({b, a});
      if (other != edges.end() && in_circle_sign(a, b, c, other->second.second) == 0)
        joined.unite(i, other->second.first);
    }
  std::map<std::uint32_t, std::vector<Point2>> corners;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    auto& c = corners[joined.find(i)];
    c.insert(c.end(), triangles[i].begin(), triangles[i].end());
  }
  std::vector<std::vector<Point2>> circles;
  for (auto& [id, c] : corners) {
    std::sort(c.begin(), c.end());
    c.erase(std::unique(c.begin(), c.end()), c.end());
    circles.push_back(std::move(c));
  }
  std::sort(circles.begin(), circles.end());
  return circles;
}

const char* fault_with_segments(Triangulation t, const test::PlaneSet& set, std::uint64_t key) {
  if (t.corner.empty()) return nullptr;
  Rng rng(key, 1);
  std::vector<VertexPair> segments;
  for (int i = 0; i < 3; ++i) {
    const VertexPair s{t.corner[rng.below(t.corner.size())], t.corner[rng.below(t.corner.size())]};
    if (s.first != s.second) segments.push_back(s);
  }
  insert_segments(t, set.points, segments);
  return check_topology(t, set.points) == TopologyFault::kNone ? nullptr : "topology with segments";
}

const char* fault_of(const test::PlaneSet& set, std::uint64_t key) {
  const Triangulation t = delaunay(set.points);
  if (check_topology(t, set.points) != TopologyFault::kNone) return "topology";
  if (!is_delaunay(t, set.points)) return "a point in a circle";
  const auto triangles = test::placed_triangles(t, set.points);
  if (set.points.size() <= 12 && triangles != test::empty_circle_triangles(set.points)) return "brute force";
  if (const auto peer = test::peer_triangles(set.points); peer && circles_of(triangles) != circles_of(*peer))
    return "the other library";
  return fault_with_segments(t, set, key);
}

}  // namespace

int main(int argc, char** argv) {
  const std::uint64_t count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 10000;
  const std::uint64_t first = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 0;
  std::uint64_t done = 0;
  for (std::uint64_t key = first; done < count; ++key) {
    const auto n = static_cast<std::uint32_t>(Rng(key, 2).below(key % 4 == 0 ? 60 : 13));
    for (const test::PlaneSet& set : test::plane_sets(n, key)) {
      if (const char* fault = fault_of(set, key)) {
        std::fprintf(stderr, "delaunay_fuzz: %s, key %llu, %u points: %s\n", set.name.c_str(),
                     static_cast<unsigned long long>(key), n, fault);
        for (const Point2 p : set.points) std::fprintf(stderr, "%d %d\n", p.x, p.y);
        return 1;
      }
      ++done;
    }
  }
  std::printf("%llu sets, no fault\n", static_cast<unsigned long long>(done));
}
