// SPDX-License-Identifier: Apache-2.0
#include "kernels/meshes/predicates3.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace ilot {
namespace {

using Wide = __int128;

Index3 minus(Index3 a, Index3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

int sign(Wide v) {
  return v > 0 ? 1 : v < 0 ? -1 : 0;
}

Wide product(std::int64_t a, std::int64_t b) {
  return static_cast<Wide>(a) * b;
}

// Derived: the determinant of three vectors with components below 2^20 is below 6 * 2^60, within 64 bits.
bool is_short(Index3 v) {
  constexpr std::int64_t kShort = std::int64_t{1} << 20;
  const auto above_least = [](std::int64_t c) { return static_cast<std::uint64_t>(c + kShort); };
  return (above_least(v.x) | above_least(v.y) | above_least(v.z)) < 2 * kShort;
}

std::array<Wide, 3> area_vector(const IndexTriangle& t) {
  const Index3 u = minus(t.b, t.a), v = minus(t.c, t.a);
  return {product(u.y, v.z) - product(u.z, v.y), product(u.z, v.x) - product(u.x, v.z),
          product(u.x, v.y) - product(u.y, v.x)};
}

bool between(std::int64_t a, std::int64_t b, std::int64_t v) {
  return std::min(a, b) <= v && v <= std::max(a, b);
}

// Whether r, on the line through p and q, is on the closed segment.
bool on_segment(Index3 p, Index3 q, Index3 r) {
  return between(p.x, q.x, r.x) && between(p.y, q.y, r.y) && between(p.z, q.z, r.z);
}

bool in_triangle(Index3 p, const IndexTriangle& t, int axis) {
  const int s = orient2d_sign(t.a, t.b, p, axis), u = orient2d_sign(t.b, t.c, p, axis),
            v = orient2d_sign(t.c, t.a, p, axis);
  return (s >= 0 && u >= 0 && v >= 0) || (s <= 0 && u <= 0 && v <= 0);
}

// Whether closed segments of one plane meet. The plane is projected along `axis`.
bool segments_meet(Index3 p, Index3 q, Index3 r, Index3 s, int axis) {
  const int a = orient2d_sign(p, q, r, axis), b = orient2d_sign(p, q, s, axis);
  const int c = orient2d_sign(r, s, p, axis), d = orient2d_sign(r, s, q, axis);
  if (a * b < 0 && c * d < 0) return true;
  return (a == 0 && on_segment(p, q, r)) || (b == 0 && on_segment(p, q, s)) || (c == 0 && on_segment(r, s, p)) ||
         (d == 0 && on_segment(r, s, q));
}

bool flat_segment_meets(Index3 p, Index3 q, const IndexTriangle& t, int axis) {
  return in_triangle(p, t, axis) || in_triangle(q, t, axis) || segments_meet(p, q, t.a, t.b, axis) ||
         segments_meet(p, q, t.b, t.c, axis) || segments_meet(p, q, t.c, t.a, axis);
}

int side_of(const IndexTriangle& t, Index3 p) {
  return orient3d_sign(t.a, t.b, t.c, p);
}

// Whether the closed segment meets the closed triangle. `above` and `below` are the sides of its ends.
bool segment_meets(Index3 p, Index3 q, const IndexTriangle& t, int above, int below) {
  if (above * below > 0) return false;
  if (above == 0 && below == 0) return flat_segment_meets(p, q, t, widest_axis(t));
  const int a = orient3d_sign(p, q, t.a, t.b), b = orient3d_sign(p, q, t.b, t.c);
  if (a * b < 0) return false;
  const int c = orient3d_sign(p, q, t.c, t.a);
  return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}

// Whether a side of s meets t.
bool any_side_meets(const IndexTriangle& s, const IndexTriangle& t) {
  const int a = side_of(t, s.a), b = side_of(t, s.b), c = side_of(t, s.c);
  return segment_meets(s.a, s.b, t, a, b) || segment_meets(s.b, s.c, t, b, c) || segment_meets(s.c, s.a, t, c, a);
}

}  // namespace

int orient3d_sign(Index3 a, Index3 b, Index3 c, Index3 d) {
  const Index3 u = minus(b, a), v = minus(c, a), w = minus(d, a);
  if (is_short(u) && is_short(v) && is_short(w)) {
    const std::int64_t volume =
        (u.y * v.z - u.z * v.y) * w.x + (u.z * v.x - u.x * v.z) * w.y + (u.x * v.y - u.y * v.x) * w.z;
    return volume > 0 ? 1 : volume < 0 ? -1 : 0;
  }
  const std::array<Wide, 3> n = area_vector({a, b, c});
  return sign(n[0] * w.x + n[1] * w.y + n[2] * w.z);
}

int widest_axis(const IndexTriangle& t) {
  std::array<Wide, 3> n = area_vector(t);
  for (Wide& v : n) v = v < 0 ? -v : v;
  const int axis = n[2] >= n[0] && n[2] >= n[1] ? 2 : n[0] >= n[1] ? 0 : 1;
  return n[static_cast<std::size_t>(axis)] == 0 ? -1 : axis;
}

int orient2d_sign(Index3 a, Index3 b, Index3 c, int axis) {
  const Index3 u = minus(b, a), v = minus(c, a);
  if (axis == 2) return sign(product(u.x, v.y) - product(u.y, v.x));
  if (axis == 0) return sign(product(u.y, v.z) - product(u.z, v.y));
  return sign(product(u.z, v.x) - product(u.x, v.z));
}

bool segment_meets_triangle(Index3 p, Index3 q, const IndexTriangle& t) {
  return segment_meets(p, q, t, side_of(t, p), side_of(t, q));
}

bool triangles_meet(const IndexTriangle& s, const IndexTriangle& t) {
  return any_side_meets(s, t) || any_side_meets(t, s);
}

}  // namespace ilot
