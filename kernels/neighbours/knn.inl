// SPDX-License-Identifier: Apache-2.0
// Body of knn. A query starts from an upper bound of its answer's radius, then one sweep of the box hierarchy in index
// order collects every point within it. Boxes and leaves are tried eight at a time in float32 against a bound that is
// inflated by more than the rounding; what passes is measured again in integers, so the answer is exact.

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

inline float inflate(std::int64_t d2) { return static_cast<float>(d2) * 1.000002f + 1.0f; }

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
    bound = static_cast<std::int64_t>(largest >> kSlotBits);
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

}  // namespace

void knn(const KnnArgs& a) {
  Candidates c;
  const std::uint32_t k = static_cast<std::uint32_t>(a.k);
  std::int64_t previous_reach2 = -1;
  std::uint32_t previous = 0;
  for (std::uint32_t q = 0; q < a.query_count; ++q) {
    const std::uint32_t query = a.queries[q];
    std::int64_t bound = a.max_d2;
    const std::int64_t step2 = previous_reach2 < 0 ? 0 : exact_d2(a, query, previous);
    if (previous_reach2 >= 0 && step2 <= previous_reach2) {
      bound = bound_from_previous(previous_reach2, step2);
      if (bound > a.max_d2) bound = a.max_d2;
    } else {
      bound = window_bound(a, query);
    }
    c.size = 0;
    collect(a, query, bound, c);
    const std::uint32_t found = c.size < k ? c.size : k;
    if (c.size > k) select_smallest(c.key, c.size, k);
    sort_keys(c.key, found);
    std::uint32_t* out = a.neighbours + std::size_t{q} * k;
    for (std::uint32_t i = 0; i < k; ++i) out[i] = i < found ? c.index[c.key[i] & kSlotMask] : 0xffffffffu;
    a.reach2[q] = found < k ? -1 : static_cast<std::int64_t>(c.key[k - 1] >> kSlotBits);
    previous_reach2 = a.reach2[q];
    previous = query;
  }
}
