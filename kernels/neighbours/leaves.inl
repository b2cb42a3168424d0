// SPDX-License-Identifier: Apache-2.0
// The code that the searches share: the sweep of the box hierarchy, and the points near a group of queries.

namespace {

struct Cloud {
  const float *x, *y, *z;
  std::uint32_t size;
  const float* const* boxes;  // per level
  int levels;
};

constexpr std::int64_t kExactInFloat = std::int64_t{1} << 24;

// Returns a bound that the float32 squared distance never exceeds when the true one is at most d2. Returns -1 when d2
// is negative.
inline float inflate(std::int64_t d2) { return d2 < 0 ? -1.0f : static_cast<float>(d2) * 1.000002f + 1.0f; }

// Queries from begin on that are in one leaf are answered together.
inline std::uint32_t end_of_group(const std::uint32_t* queries, std::uint32_t begin, std::uint32_t count) {
  std::uint32_t end = begin + 1;
  while (end < count && end - begin < 8 && queries[end] / 8 == queries[begin] / 8) ++end;
  return end;
}

// The closed box of some queries, with each bound in all lanes.
struct QueryBox {
  F8 low[3], high[3];
};

inline QueryBox box_around(const Cloud& a, const std::uint32_t* queries, std::uint32_t count) {
  float low[3] = {a.x[queries[0]], a.y[queries[0]], a.z[queries[0]]};
  float high[3] = {low[0], low[1], low[2]};
  for (std::uint32_t i = 1; i < count; ++i) {
    const float v[3] = {a.x[queries[i]], a.y[queries[i]], a.z[queries[i]]};
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = v[axis] < low[axis] ? v[axis] : low[axis];
      high[axis] = v[axis] > high[axis] ? v[axis] : high[axis];
    }
  }
  return {{splat(low[0]), splat(low[1]), splat(low[2])}, {splat(high[0]), splat(high[1]), splat(high[2])}};
}

// Returns the squared distances between the box and eight boxes. They are exact up to 2^24, and never below it when the
// true value is above.
inline F8 gap2(const QueryBox& box, F8 x0, F8 y0, F8 z0, F8 x1, F8 y1, F8 z1) {
  const F8 zero = splat(0.0f);
  const F8 dx = max8(max8(x0 - box.high[0], box.low[0] - x1), zero);
  const F8 dy = max8(max8(y0 - box.high[1], box.low[1] - y1), zero);
  const F8 dz = max8(max8(z0 - box.high[2], box.low[2] - z1), zero);
  return dx * dx + dy * dy + dz * dz;
}

inline std::uint32_t near_children(const float* node, const QueryBox& box, float bound) {
  return mask_le(gap2(box, load8(node), load8(node + 8), load8(node + 16), load8(node + 24), load8(node + 32),
                      load8(node + 40)),
                 splat(bound));
}

// Calls visit(leaf) for the leaves within the squared distance `bound` of the box, in index order. visit returns the
// bound for the leaves after it. A negative one ends the sweep.
template <class Visit>
inline void visit_leaves(const Cloud& a, const QueryBox& box, float bound, Visit visit) {
  struct Pending {
    std::uint32_t node;
    std::uint32_t children;  // mask still to visit
  };
  Pending stack[16];
  int level = a.levels - 1;
  stack[level] = {0, near_children(a.boxes[level], box, bound)};
  while (level < a.levels && bound >= 0) {
    Pending& top = stack[level];
    if (top.children == 0) {
      ++level;
      continue;
    }
    const std::uint32_t child = top.node * 8 + static_cast<std::uint32_t>(__builtin_ctz(top.children));
    top.children &= top.children - 1;
    if (level == 0) {
      bound = visit(child);
    } else {
      --level;
      stack[level] = {child, near_children(a.boxes[level] + std::size_t{48} * child, box, bound)};
    }
  }
}

// Points near a group of queries, in index order. The lanes behind the last point are infinitely far away.
constexpr std::uint32_t kNearCapacity = 1024;
struct Nearby {
  float x[kNearCapacity + 16], y[kNearCapacity + 16], z[kNearCapacity + 16];
  std::uint32_t index[kNearCapacity + 16];
  std::uint32_t size;
};

// Collects all points within the squared distance `bound` of the box, and maybe others. Returns false when there are
// too many.
inline bool collect_nearby(const Cloud& a, const QueryBox& box, float bound, Nearby& out) {
  std::uint32_t size = 0;
  const F8 limit = splat(bound);
  visit_leaves(a, box, bound, [&](std::uint32_t leaf) {
    const std::uint32_t begin = leaf * 8;
    const F8 x = load8(a.x + begin), y = load8(a.y + begin), z = load8(a.z + begin);
    std::uint32_t hits = mask_le(gap2(box, x, y, z, x, y, z), limit);
    if (a.size - begin < 8) hits &= (1u << (a.size - begin)) - 1;
    const Pick8 pick = pick8(hits);
    put(out.x + size, pick, x);
    put(out.y + size, pick, y);
    put(out.z + size, pick, z);
    put_numbers(out.index + size, pick, begin);
    size += pick.count;
    return size > kNearCapacity - 8 ? -1.0f : bound;
  });
  out.size = size;
  for (std::uint32_t i = size; i < size + 16; ++i) out.x[i] = out.y[i] = out.z[i] = 3e38f;
  return size <= kNearCapacity - 8;
}

// The nearby points within a bound of one query, in index order, with their squared distances. Those behind the last
// are infinitely far away.
struct Within {
  float d2[kNearCapacity + 16];
  std::uint32_t index[kNearCapacity + 16];
  std::uint32_t size;
};

inline void measure(const Nearby& near, float x, float y, float z, float bound, Within& out) {
  const Wide qx = splat_wide(x), qy = splat_wide(y), qz = splat_wide(z), limit = splat_wide(bound);
  std::uint32_t size = 0;
  for (std::uint32_t i = 0; i < near.size; i += kWide) {
    const Wide dx = load_wide(near.x + i) - qx, dy = load_wide(near.y + i) - qy, dz = load_wide(near.z + i) - qz;
    const Wide d2 = dx * dx + dy * dy + dz * dz;
    append_values_le(out.d2 + size, d2, limit);
    size += append_le(out.index + size, near.index + i, d2, limit);
  }
  out.size = size;
  for (std::uint32_t i = size; i < size + kWide; ++i) out.d2[i] = 3e38f;
}

}  // namespace
