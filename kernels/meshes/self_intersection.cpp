// SPDX-License-Identifier: Apache-2.0
#include "kernels/meshes/self_intersection.h"

#include <algorithm>

namespace ilot {
namespace {

struct BoxedTriangle {
  IndexBox box;
  std::uint32_t triangle;
};

IndexTriangle corners_of(const TriangleCorners& t, std::span<const Index3> vertices) {
  return {vertices[t[0]], vertices[t[1]], vertices[t[2]]};
}

// Turns the triangle so that its first corners are those shared with the other, and returns their number.
int turn_shared_first(TriangleCorners& t, const TriangleCorners& other) {
  const TriangleCorners given = t;
  int turned = 0;
  const auto take = [&](bool shared) {
    for (const std::uint32_t i : given)
      if ((i == other[0] || i == other[1] || i == other[2]) == shared) t[static_cast<std::size_t>(turned++)] = i;
    return turned;
  };
  const int shared = take(true);
  take(false);
  return shared;
}

// Whether two triangles with a common edge and the far corners c and d meet elsewhere.
bool folded(Index3 a, Index3 b, Index3 c, Index3 d) {
  if (orient3d_sign(a, b, c, d) != 0) return false;
  const int axis = widest_axis({a, b, c});
  return orient2d_sign(a, b, c, axis) == orient2d_sign(a, b, d, axis);
}

bool meet(TriangleCorners s, TriangleCorners t, std::span<const Index3> v) {
  const TriangleCorners first = s;
  const int shared = turn_shared_first(s, t);
  turn_shared_first(t, first);
  if (shared == 3) return true;
  if (shared == 2) return folded(v[s[0]], v[s[1]], v[s[2]], v[t[2]]);
  if (shared == 1)
    return segment_meets_triangle(v[s[1]], v[s[2]], corners_of(t, v)) ||
           segment_meets_triangle(v[t[1]], v[t[2]], corners_of(s, v));
  return triangles_meet(corners_of(s, v), corners_of(t, v));
}

std::vector<BoxedTriangle> boxes_along_x(std::span<const TriangleCorners> triangles, std::span<const Index3> vertices) {
  std::vector<BoxedTriangle> boxes;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const IndexTriangle t = corners_of(triangles[i], vertices);
    if (widest_axis(t) >= 0) boxes.push_back({box_of(t), i});
  }
  std::sort(boxes.begin(), boxes.end(), [](const BoxedTriangle& a, const BoxedTriangle& b) {
    return a.box.min.x != b.box.min.x ? a.box.min.x < b.box.min.x : a.triangle < b.triangle;
  });
  return boxes;
}

}  // namespace

std::vector<std::uint32_t> meeting_triangles(std::span<const TriangleCorners> triangles,
                                             std::span<const Index3> vertices) {
  const std::vector<BoxedTriangle> boxes = boxes_along_x(triangles, vertices);
  std::vector<std::uint32_t> found;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t k = i + 1; k < boxes.size() && boxes[k].box.min.x <= boxes[i].box.max.x; ++k) {
      if (!boxes[i].box.intersects(boxes[k].box)) continue;
      if (!meet(triangles[boxes[i].triangle], triangles[boxes[k].triangle], vertices)) continue;
      found.push_back(boxes[i].triangle);
      found.push_back(boxes[k].triangle);
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace ilot
