// SPDX-License-Identifier: Apache-2.0
#include "kernels/meshes/manifold.h"

#include <algorithm>
#include <unordered_set>

#include "kernels/core/union_find.h"

namespace ilot {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

std::uint64_t key(std::uint32_t from, std::uint32_t to) {
  return std::uint64_t{from} << 32 | to;
}

// Connected triangles around a corner. The first one comes in from `start`, the last one leaves for `end`.
struct Fan {
  std::uint32_t start, end;
};

struct Corner {
  std::vector<Fan> fans;
  bool closed = false;  // one fan all the way round
};

class Surface {
 public:
  explicit Surface(std::uint32_t vertices) : corners_(vertices) {}

  bool takes(const TriangleCorners& t) const {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return false;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = t[i], at = t[(i + 1) % 3], to = t[(i + 2) % 3];
      if (edges_.contains(key(from, at)) || !corner_takes(corners_[at], from, to)) return false;
    }
    return true;
  }

  void add(const TriangleCorners& t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = t[i], at = t[(i + 1) % 3], to = t[(i + 2) % 3];
      edges_.insert(key(from, at));
      add_wedge(corners_[at], from, to);
    }
  }

 private:
  static std::size_t ending(const Corner& corner, std::uint32_t with) {
    std::size_t i = 0;
    while (i < corner.fans.size() && corner.fans[i].end != with) ++i;
    return i;
  }

  static std::size_t starting(const Corner& corner, std::uint32_t with) {
    std::size_t i = 0;
    while (i < corner.fans.size() && corner.fans[i].start != with) ++i;
    return i;
  }

  static bool corner_takes(const Corner& corner, std::uint32_t from, std::uint32_t to) {
    if (corner.closed) return false;
    const std::size_t before = ending(corner, from);
    const bool closes = before < corner.fans.size() && before == starting(corner, to);
    return !closes || corner.fans.size() == 1;
  }

  static void add_wedge(Corner& corner, std::uint32_t from, std::uint32_t to) {
    const std::size_t before = ending(corner, from), after = starting(corner, to), none = corner.fans.size();
    if (before == none && after == none) {
      corner.fans.push_back({from, to});
    } else if (before == after) {
      corner.fans.clear();
      corner.closed = true;
    } else if (before == none) {
      corner.fans[after].start = from;
    } else if (after == none) {
      corner.fans[before].end = to;
    } else {
      corner.fans[before].end = corner.fans[after].end;
      corner.fans.erase(corner.fans.begin() + static_cast<std::ptrdiff_t>(after));
    }
  }

  std::vector<Corner> corners_;
  std::unordered_set<std::uint64_t> edges_;
};

}  // namespace

std::vector<TriangleFit> fit_triangles(std::span<const TriangleCorners> triangles, std::uint32_t vertices) {
  Surface surface(vertices);
  std::vector<TriangleFit> fits;
  fits.reserve(triangles.size());
  for (const TriangleCorners& t : triangles) {
    if (surface.takes(t)) {
      surface.add(t);
      fits.push_back(TriangleFit::fits);
    } else {
      fits.push_back(surface.takes({t[0], t[2], t[1]}) ? TriangleFit::reversed : TriangleFit::none);
    }
  }
  return fits;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> open_edges(std::span<const TriangleCorners> triangles) {
  std::vector<Edge> edges;
  for (const TriangleCorners& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) edges.push_back({t[i], t[(i + 1) % 3]});
  std::sort(edges.begin(), edges.end());
  std::vector<Edge> open;
  for (const auto& [from, to] : edges)
    if (!std::binary_search(edges.begin(), edges.end(), Edge{to, from})) open.push_back({from, to});
  return open;
}

std::uint32_t count_pieces(std::span<const TriangleCorners> triangles, std::uint32_t vertices) {
  std::vector<std::uint32_t> parents(vertices);
  UnionFind sets(parents);
  std::vector<bool> used(vertices);
  std::uint32_t pieces = 0;
  for (const TriangleCorners& t : triangles) {
    for (const std::uint32_t i : t) {
      pieces += used[i] ? 0 : 1;
      used[i] = true;
    }
    pieces -= (sets.unite(t[0], t[1]) ? 1 : 0) + (sets.unite(t[0], t[2]) ? 1 : 0);
  }
  return pieces;
}

int volume_sign(std::span<const TriangleCorners> triangles, std::span<const Index3> vertices) {
  if (triangles.empty()) return 0;
  const Index3 o = vertices[triangles[0][0]];
  __int128 sum = 0;
  for (const TriangleCorners& t : triangles) {
    const auto offset = [&](std::uint32_t i) {
      return Index3{vertices[i].x - o.x, vertices[i].y - o.y, vertices[i].z - o.z};
    };
    const Index3 a = offset(t[0]), b = offset(t[1]), c = offset(t[2]);
    sum += (static_cast<__int128>(b.y) * c.z - static_cast<__int128>(b.z) * c.y) * a.x +
           (static_cast<__int128>(b.z) * c.x - static_cast<__int128>(b.x) * c.z) * a.y +
           (static_cast<__int128>(b.x) * c.y - static_cast<__int128>(b.y) * c.x) * a.z;
  }
  return sum > 0 ? 1 : sum < 0 ? -1 : 0;
}

}  // namespace ilot
