// SPDX-License-Identifier: Apache-2.0
// Body of knn. A query starts from an upper bound of its answer's radius, taken from the query before it or from the
// points around it in index order; every point within the bound is a candidate, and the k nearest are selected.
// Near path: up to eight queries of one leaf share one sweep of the box hierarchy. Squared distances up to 2^24 are
// integers that float32 holds exactly (a rounded sum is never below 2^24), so no second measurement is needed.
// Far path, for wider bounds, crowds of coincident points and ties at the k-th: one sweep a query, float32 only culls
// with a bound inflated by more than the rounding, and what passes is measured in integers.

namespace {

constexpr int kSlotBits = 16;
constexpr std::uint32_t kCapacity = 512;
constexpr std::uint64_t kSlotMask = (1u << kSlotBits) - 1;

// Candidates of one query: key = squared distance, then slot; slots are handed out in index order, so equal distances
// sort by index.
struct Candidates {
  std::uint64_t key[kCapacity];
  std::uint32_t index[kCapacity];
  std::uint32_t size;
};

inline void swap_keys(std::uint64_t& a, std::uint64_t& b) {
  const std::uint64_t t = a;
  a = b;
  b = t;
}

// Afterwards key[0..k-1] are the k smallest, in any order. Keys are distinct.
inline void select_smallest(std::uint64_t* key, std::uint32_t size, std::uint32_t k) {
  std::uint32_t lo = 0, hi = size;
  while (hi - lo > 1 && lo < k && k < hi) {
    const std::uint64_t a = key[lo], b = key[lo + (hi - lo) / 2], c = key[hi - 1];
    const std::uint64_t low = a < b ? a : b, high = a < b ? b : a;
    const std::uint64_t pivot = c < low ? low : c > high ? high : c;
    std::uint32_t m = lo;
    for (std::uint32_t i = lo; i < hi; ++i) {
      const bool below = key[i] < pivot;
      swap_keys(key[i], key[m]);
      m += below;
    }
    if (m == lo) {  // the pivot is the minimum: put it first
      for (std::uint32_t i = lo; i < hi; ++i)
        if (key[i] == pivot) swap_keys(key[i], key[lo]);
      m = lo + 1;
    }
    if (m > k) {
      hi = m;
    } else {
      lo = m;
    }
  }
}

inline void sort_keys(std::uint64_t* key, std::uint32_t size) {
  for (std::uint32_t i = 1; i < size; ++i) {
    const std::uint64_t v = key[i];
    std::uint32_t j = i;
    for (; j > 0 && key[j - 1] > v; --j) key[j] = key[j - 1];
    key[j] = v;
  }
}

// Keeps the k nearest and hands their slots out anew, in index order.
inline void shrink(Candidates& c, std::uint32_t k) {
  select_smallest(c.key, c.size, k);
  std::uint64_t by_slot[kCapacity];
  for (std::uint32_t i = 0; i < k; ++i) by_slot[i] = (c.key[i] & kSlotMask) << 48 | i;
  sort_keys(by_slot, k);
  std::uint64_t key[kCapacity];
  std::uint32_t index[kCapacity];
  for (std::uint32_t i = 0; i < k; ++i) {
    const std::uint64_t old = c.key[by_slot[i] & kSlotMask];
    key[i] = (old & ~kSlotMask) | i;
    index[i] = c.index[old & kSlotMask];
  }
  for (std::uint32_t i = 0; i < k; ++i) {
    c.key[i] = key[i];
    c.index[i] = index[i];
  }
  c.size = k;
}

inline std::int64_t exact_d2(const KnnArgs& a, std::uint32_t i, std::uint32_t j) {
  const std::int64_t dx = static_cast<std::int32_t>(a.x[i]) - static_cast<std::int32_t>(a.x[j]);
  const std::int64_t dy = static_cast<std::int32_t>(a.y[i]) - static_cast<std::int32_t>(a.y[j]);
  const std::int64_t dz = static_cast<std::int32_t>(a.z[i]) - static_cast<std::int32_t>(a.z[j]);
  return dx * dx + dy * dy + dz * dz;
}

// Largest of the k smallest distances among the points around i in index order: an upper bound of the answer.
inline std::int64_t window_bound(const KnnArgs& a, std::uint32_t i) {
  const std::uint32_t reach = static_cast<std::uint32_t>(a.k) / 2 + 8;
  const std::uint32_t begin = i > reach ? i - reach : 0;
  const std::uint32_t end = a.size - i > reach ? i + reach + 1 : a.size;
  if (end - begin < static_cast<std::uint32_t>(a.k)) return a.max_d2;
  std::uint64_t key[kCapacity];
  for (std::uint32_t j = begin; j < end; ++j) {
    const std::int64_t d2 = exact_d2(a, i, j);  // up to 2^52, which a key has no room for; beyond max_d2 it does not matter
    key[j - begin] = static_cast<std::uint64_t>(d2 < a.max_d2 ? d2 : a.max_d2) << kSlotBits | (j - begin);
  }
  select_smallest(key, end - begin, static_cast<std::uint32_t>(a.k));
  std::uint64_t largest = 0;
  for (int n = 0; n < a.k; ++n) largest = key[n] > largest ? key[n] : largest;
  const std::int64_t bound = static_cast<std::int64_t>(largest >> kSlotBits);
  return bound < a.max_d2 ? bound : a.max_d2;
}

// The previous answer reaches r; a query d away reaches at most r + d.
inline std::int64_t bound_from_previous(std::int64_t reach2, std::int64_t d2) {
  const double r = __builtin_sqrt(static_cast<double>(reach2)) + __builtin_sqrt(static_cast<double>(d2));
  return static_cast<std::int64_t>(r * r * 1.000000001) + 1;
}

inline float inflate(std::int64_t d2) { return d2 < 0 ? -1.0f : static_cast<float>(d2) * 1.000002f + 1.0f; }

inline void scan_leaf(const KnnArgs& a, std::uint32_t query, std::uint32_t leaf, std::int64_t& bound, Candidates& c) {
  const std::uint32_t begin = leaf * 8;
  const F8 dx = load8(a.x + begin) - splat(a.x[query]);
  const F8 dy = load8(a.y + begin) - splat(a.y[query]);
  const F8 dz = load8(a.z + begin) - splat(a.z[query]);
  std::uint32_t hits = mask_le(dx * dx + dy * dy + dz * dz, splat(inflate(bound)));
  if (a.size - begin < 8) hits &= (1u << (a.size - begin)) - 1;
  while (hits != 0) {
    const std::uint32_t j = begin + static_cast<std::uint32_t>(__builtin_ctz(hits));
    hits &= hits - 1;
    const std::int64_t d2 = exact_d2(a, query, j);
    if (d2 > bound) continue;
    c.key[c.size] = static_cast<std::uint64_t>(d2) << kSlotBits | c.size;
    c.index[c.size++] = j;
  }
  if (c.size > kCapacity - 8) {
    shrink(c, static_cast<std::uint32_t>(a.k));
    std::uint64_t largest = 0;
    for (int n = 0; n < a.k; ++n) largest = c.key[n] > largest ? c.key[n] : largest;
    // Whatever comes later has a larger index, so at the same distance it loses.
    bound = static_cast<std::int64_t>(largest >> kSlotBits) - 1;
  }
}

inline std::uint32_t near_children(const float* node, F8 qx, F8 qy, F8 qz, F8 bound) {
  const F8 zero = splat(0.0f);
  const F8 dx = max8(max8(load8(node) - qx, qx - load8(node + 24)), zero);
  const F8 dy = max8(max8(load8(node + 8) - qy, qy - load8(node + 32)), zero);
  const F8 dz = max8(max8(load8(node + 16) - qz, qz - load8(node + 40)), zero);
  return mask_le(dx * dx + dy * dy + dz * dz, bound);
}

// Every point within `bound` of the query, in index order.
inline void collect(const KnnArgs& a, std::uint32_t query, std::int64_t bound, Candidates& c) {
  struct Pending {
    std::uint32_t node;
    std::uint32_t children;  // mask still to visit
  };
  Pending stack[16];
  const F8 qx = splat(a.x[query]), qy = splat(a.y[query]), qz = splat(a.z[query]);
  int level = a.levels - 1;
  stack[level] = {0, near_children(a.boxes[level], qx, qy, qz, splat(inflate(bound)))};
  while (level < a.levels) {
    Pending& top = stack[level];
    if (top.children == 0) {
      ++level;
      continue;
    }
    const std::uint32_t child = top.node * 8 + static_cast<std::uint32_t>(__builtin_ctz(top.children));
    top.children &= top.children - 1;
    if (level == 0) {
      scan_leaf(a, query, child, bound, c);
    } else {
      --level;
      stack[level] = {child, near_children(a.boxes[level] + std::size_t{48} * child, qx, qy, qz, splat(inflate(bound)))};
    }
  }
}

// The far path: any bound, any number of candidates, any ties.
inline std::int64_t far_query(const KnnArgs& a, std::uint32_t query, std::int64_t bound, std::uint32_t* out) {
  Candidates c;
  c.size = 0;
  const std::uint32_t k = static_cast<std::uint32_t>(a.k);
  collect(a, query, bound, c);
  if (c.size > k) shrink(c, k);
  for (std::uint32_t i = 0; i < k; ++i) out[i] = i < c.size ? c.index[i] : 0xffffffffu;
  if (c.size < k) return -1;
  std::uint64_t largest = 0;
  for (std::uint32_t i = 0; i < k; ++i) largest = c.key[i] > largest ? c.key[i] : largest;
  return static_cast<std::int64_t>(largest >> kSlotBits);
}

constexpr std::int64_t kExactInFloat = std::int64_t{1} << 24;
constexpr std::uint32_t kNearCapacity = 256;
constexpr std::uint32_t kLeafCapacity = 192;

struct Leaves {
  std::uint32_t leaf[kLeafCapacity];
  std::uint32_t size;
};

struct NearCandidates {
  float d2[kNearCapacity + 16];
  std::uint32_t index[kNearCapacity + 16];
  std::uint32_t size;
};

inline std::uint32_t near_boxes(const float* node, const F8 (&low)[3], const F8 (&high)[3], F8 bound) {
  const F8 zero = splat(0.0f);
  const F8 dx = max8(max8(load8(node) - high[0], low[0] - load8(node + 24)), zero);
  const F8 dy = max8(max8(load8(node + 8) - high[1], low[1] - load8(node + 32)), zero);
  const F8 dz = max8(max8(load8(node + 16) - high[2], low[2] - load8(node + 40)), zero);
  return mask_le(dx * dx + dy * dy + dz * dz, bound);
}

// Leaves that may hold a point within the bound of any of the queries, ascending. False when there are too many.
inline bool collect_leaves(const KnnArgs& a, const std::uint32_t* queries, std::uint32_t count, float bound, Leaves& out) {
  float box[6] = {a.x[queries[0]], a.y[queries[0]], a.z[queries[0]], a.x[queries[0]], a.y[queries[0]], a.z[queries[0]]};
  for (std::uint32_t i = 1; i < count; ++i) {
    const float v[3] = {a.x[queries[i]], a.y[queries[i]], a.z[queries[i]]};
    for (int axis = 0; axis < 3; ++axis) {
      box[axis] = v[axis] < box[axis] ? v[axis] : box[axis];
      box[axis + 3] = v[axis] > box[axis + 3] ? v[axis] : box[axis + 3];
    }
  }
  const F8 low[3] = {splat(box[0]), splat(box[1]), splat(box[2])};
  const F8 high[3] = {splat(box[3]), splat(box[4]), splat(box[5])};
  const F8 limit = splat(bound);
  struct Pending {
    std::uint32_t node, children;
  };
  Pending stack[16];
  int level = a.levels - 1;
  out.size = 0;
  stack[level] = {0, near_boxes(a.boxes[level], low, high, limit)};
  while (level < a.levels) {
    Pending& top = stack[level];
    if (top.children == 0) {
      ++level;
      continue;
    }
    const std::uint32_t child = top.node * 8 + static_cast<std::uint32_t>(__builtin_ctz(top.children));
    top.children &= top.children - 1;
    if (level == 0) {
      if (out.size == kLeafCapacity) return false;
      out.leaf[out.size++] = child;
    } else {
      --level;
      stack[level] = {child, near_boxes(a.boxes[level] + std::size_t{48} * child, low, high, limit)};
    }
  }
  return true;
}

// Points of the leaves within the bound, ascending. False when there are too many.
inline bool scan_leaves(const KnnArgs& a, std::uint32_t query, const Leaves& leaves, float bound, NearCandidates& c) {
  const F8 qx = splat(a.x[query]), qy = splat(a.y[query]), qz = splat(a.z[query]), limit = splat(bound);
  c.size = 0;
  for (std::uint32_t l = 0; l < leaves.size; ++l) {
    const std::uint32_t begin = leaves.leaf[l] * 8;
    const F8 dx = load8(a.x + begin) - qx, dy = load8(a.y + begin) - qy, dz = load8(a.z + begin) - qz;
    const F8 d2 = dx * dx + dy * dy + dz * dz;
    std::uint32_t hits = mask_le(d2, limit);
    if (a.size - begin < 8) hits &= (1u << (a.size - begin)) - 1;
    c.size += append8(c.d2 + c.size, c.index + c.size, d2, begin, hits);
    if (c.size > kNearCapacity) return false;
  }
  return true;
}

// A value that exactly k of the candidates do not exceed, by interpolation between counts; false when there is none
// (a tie at the k-th) or it was not found soon.
inline bool find_limit(NearCandidates& c, std::uint32_t k, float bound, float& limit) {
  if (c.size == k) {
    limit = bound;
    return true;
  }
  for (std::uint32_t i = c.size; i < c.size + 8; ++i) c.d2[i] = 3e38f;
  float low = -1.0f, high = bound;
  std::uint32_t at_low = 0, at_high = c.size;
  for (int round = 0; round < 16; ++round) {
    const float share = static_cast<float>(k - at_low) / static_cast<float>(at_high - at_low);
    const float guess = low + (high - low) * share;
    if (!(guess > low && guess < high)) return false;
    Count8 counts = zero_count();
    const F8 g = splat(guess);
    for (std::uint32_t i = 0; i < c.size; i += 8) count_le(counts, load8(c.d2 + i), g);
    const std::uint32_t n = total(counts);
    if (n == k) {
      limit = guess;
      return true;
    }
    if (n < k) {
      low = guess;
      at_low = n;
    } else {
      high = guess;
      at_high = n;
    }
  }
  return false;
}

// The near path of one query; false = take the far path.
inline bool near_query(const KnnArgs& a, std::uint32_t query, const Leaves& leaves, std::int64_t bound,
                       std::uint32_t* out, std::int64_t& reach2) {
  NearCandidates c;
  const std::uint32_t k = static_cast<std::uint32_t>(a.k);
  const float limit = static_cast<float>(bound);
  if (!scan_leaves(a, query, leaves, limit, c)) return false;
  float kept = limit;
  if (c.size > k && !find_limit(c, k, limit, kept)) return false;
  std::uint32_t n = 0;
  float largest = 0;
  for (std::uint32_t i = 0; i < c.size && n < k; ++i) {
    const bool take = c.d2[i] <= kept;
    out[n] = c.index[i];
    const float d2 = take ? c.d2[i] : 0.0f;
    largest = d2 > largest ? d2 : largest;
    n += take;
  }
  reach2 = n < k ? -1 : static_cast<std::int64_t>(largest);
  for (; n < k; ++n) out[n] = 0xffffffffu;
  return true;
}

struct Previous {
  std::uint32_t query;
  std::int64_t reach2;  // -1: unknown
};

inline std::int64_t bound_of(const KnnArgs& a, std::uint32_t query, const Previous& previous) {
  if (previous.reach2 < 0) return window_bound(a, query);
  const std::int64_t step2 = exact_d2(a, query, previous.query);
  if (step2 > previous.reach2) return window_bound(a, query);
  const std::int64_t bound = bound_from_previous(previous.reach2, step2);
  return bound < a.max_d2 ? bound : a.max_d2;
}

}  // namespace

void knn(const KnnArgs& a) {
  Leaves leaves;
  leaves.size = 0;
  Previous previous{0, -1};
  const std::uint32_t k = static_cast<std::uint32_t>(a.k);
  for (std::uint32_t begin = 0; begin < a.query_count;) {
    std::uint32_t end = begin + 1;
    while (end < a.query_count && end - begin < 8 && a.queries[end] / 8 == a.queries[begin] / 8) ++end;
    std::int64_t bounds[8], widest = 0;
    for (std::uint32_t q = begin; q < end; ++q) {
      bounds[q - begin] = bound_of(a, a.queries[q], previous);
      widest = bounds[q - begin] > widest ? bounds[q - begin] : widest;
    }
    const bool near = widest < kExactInFloat &&
                      collect_leaves(a, a.queries + begin, end - begin, static_cast<float>(widest) * 1.000001f, leaves);
    for (std::uint32_t q = begin; q < end; ++q) {
      std::uint32_t* out = a.neighbours + std::size_t{q} * k;
      std::int64_t bound = bounds[q - begin];
      if (q > begin) {  // the neighbour just answered may know better
        const std::int64_t closer = bound_of(a, a.queries[q], previous);
        bound = closer < bound ? closer : bound;
      }
      if (!near || !near_query(a, a.queries[q], leaves, bound, out, a.reach2[q]))
        a.reach2[q] = far_query(a, a.queries[q], bound, out);
      previous = {a.queries[q], a.reach2[q]};
    }
    begin = end;
  }
}
