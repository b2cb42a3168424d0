// SPDX-License-Identifier: Apache-2.0
// Body of knn. Lanes (F8, Wide, splat, mask_le ...) are those of kernels/simd/lanes_*.h: kernels/simd/bodies.cmake
// compiles this text once for each instruction set, behind the lanes of that set and knn_body.h.
// Near path: up to eight queries of one leaf share one sweep of the box hierarchy. The sweep collects the points within
// a guessed radius, which is somewhat more than the radius of the queries before. A query that finds k points within
// the radius is answered, because every point within it was collected. Otherwise the guess grows. Squared distances up
// to 2^24 are integers that float32 represents exactly (a rounded sum is never below 2^24), so no second measurement is
// needed.
// Far path, for wider bounds and very many points: there is one sweep per query within a proven bound. float32 only
// preselects, with a bound inflated by more than the rounding. The selected points are measured in integers.

#include "kernels/neighbours/leaves.inl"
#include "kernels/neighbours/sort_keys.inl"

namespace {

constexpr int kSlotBits = 16;
constexpr std::uint32_t kCapacity = 512;
constexpr std::uint64_t kSlotMask = (1u << kSlotBits) - 1;

// Candidates of one query. A key is the squared distance, then the slot. Slots are given out in index order, so equal
// distances sort by index.
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

// Keeps the k nearest and gives out their slots again, in index order.
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

// Returns the largest of the k smallest distances among the points around i in index order. It is an upper bound of the
// answer.
inline std::int64_t window_bound(const KnnArgs& a, std::uint32_t i) {
  const std::uint32_t reach = static_cast<std::uint32_t>(a.k) / 2 + 8;
  const std::uint32_t begin = i > reach ? i - reach : 0;
  const std::uint32_t end = a.size - i > reach ? i + reach + 1 : a.size;
  if (end - begin < static_cast<std::uint32_t>(a.k)) return a.max_d2;
  std::uint64_t key[kCapacity];
  for (std::uint32_t j = begin; j < end; ++j) {
    const std::int64_t d2 = exact_d2(a, i, j);  // up to 2^52, too large for a key: limited to max_d2
    key[j - begin] = static_cast<std::uint64_t>(d2 < a.max_d2 ? d2 : a.max_d2) << kSlotBits | (j - begin);
  }
  select_smallest(key, end - begin, static_cast<std::uint32_t>(a.k));
  std::uint64_t largest = 0;
  for (int n = 0; n < a.k; ++n) largest = key[n] > largest ? key[n] : largest;
  const std::int64_t bound = static_cast<std::int64_t>(largest >> kSlotBits);
  return bound < a.max_d2 ? bound : a.max_d2;
}

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
    // Later points have a larger index, so they lose at the same distance.
    bound = static_cast<std::int64_t>(largest >> kSlotBits) - 1;
  }
}

inline Cloud cloud_of(const KnnArgs& a) { return {a.x, a.y, a.z, a.size, a.boxes, a.levels}; }

// Collects every point within `bound` of the query, in index order. The bound shrinks when there are many.
inline void collect(const KnnArgs& a, std::uint32_t query, std::int64_t bound, Candidates& c) {
  const Cloud cloud = cloud_of(a);
  visit_leaves(cloud, box_around(cloud, &query, 1), inflate(bound), [&](std::uint32_t leaf) {
    scan_leaf(a, query, leaf, bound, c);
    return inflate(bound);
  });
}

// The far path works for any bound, any number of candidates and any ties.
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

inline std::uint32_t count_within(const float* d2, std::uint32_t size, float limit) {
  WideCount counts = zero_wide_count();
  const Wide l = splat_wide(limit);
  for (std::uint32_t i = 0; i < size; i += kWide) count_le(counts, load_wide(d2 + i), l);
  return total(counts);
}

// The answer of a query: all distances up to `all`, and of those equal to `tie` the first ones in index order.
struct Limit {
  float all, tie;
  std::uint32_t ties;
};

// Returns an integer strictly between two limits near the k-th distance, from the numbers of distances up to each
// limit.
inline float interpolate(float low, std::uint32_t at_low, float high, std::uint32_t at_high, std::uint32_t k) {
  const float share = (static_cast<float>(k - at_low) + 0.5f) / static_cast<float>(at_high - at_low);
  const float guess = static_cast<float>(static_cast<std::int32_t>(low + (high - low) * share));
  return guess <= low ? low + 1 : guess >= high ? high - 1 : guess;
}

// Distances are integers, of which `within` (at least k) do not exceed the bound. The function interpolates between
// counts, from a first guess, until exactly k are within a limit, or until two limits are one apart. In the second case
// the k-th is one of several equal distances. Returns false when neither was found soon.
inline bool find_limit(const float* d2, std::uint32_t size, std::uint32_t k, std::uint32_t within, float bound,
                       float guess, Limit& limit) {
  float low = -1.0f, high = bound;
  std::uint32_t at_low = 0, at_high = within;
  limit = {bound, 0, 0};
  if (within == k) return true;
  if (!(guess > low && guess < high) && high - low > 1) guess = interpolate(low, at_low, high, at_high, k);
  for (int round = 0; round < 20 && high - low > 1; ++round) {
    const std::uint32_t n = count_within(d2, size, guess);
    if (n == k) {
      limit.all = guess;
      return true;
    }
    if (n < k) {
      low = guess;
      at_low = n;
    } else {
      high = guess;
      at_high = n;
    }
    if (high - low > 1) guess = interpolate(low, at_low, high, at_high, k);
  }
  limit = {low, high, k - at_low};
  return high - low <= 1;
}

// Writes the points of an answer, at most k. Returns the largest distance.
inline float write_answer(const Within& near, float limit, std::uint32_t count, std::uint32_t k, std::uint32_t* out) {
  std::uint32_t chosen[64 + 16];
  std::uint32_t n = 0;
  const Wide l = splat_wide(limit);
  Wide largest = splat_wide(0.0f);
  for (std::uint32_t i = 0; i < near.size; i += kWide) {
    const Wide d2 = load_wide(near.d2 + i);
    n += append_le(chosen + n, near.index + i, d2, l);
    largest = max8(largest, where_le(d2, l));
  }
  for (std::uint32_t i = 0; i < k; ++i) out[i] = i < count ? chosen[i] : 0xffffffffu;
  return greatest(largest);
}

// Does the same where the last few of k are at the same distance as some points that are left out.
inline float write_tied_answer(const Within& near, Limit limit, std::uint32_t* out) {
  for (std::uint32_t i = 0; i < near.size; ++i) {
    const bool tied = near.d2[i] == limit.tie && limit.ties > 0;
    if (!tied && near.d2[i] > limit.all) continue;
    *out++ = near.index[i];
    limit.ties -= tied;
  }
  return limit.tie;
}

// Where few points, but more than k, are within the bound, each is compared with all of them: a point is one of the k
// nearest when at most k, itself among them, are as near. No branch depends on distances. Returns the largest distance,
// or -1 and no answer where the last of k are at the same distance as some that are left out.
// Choice: with more points, fewer comparisons find a limit.
constexpr std::uint32_t kFew = 32;
inline float answer_by_ranks(const Within& near, std::uint32_t k, std::uint32_t* out) {
  std::uint32_t chosen[kFew + 16];
  std::uint32_t n = 0;
  const Wide most = splat_wide(static_cast<float>(k));
  Wide largest = splat_wide(0.0f);
  for (std::uint32_t i = 0; i < near.size; i += kWide) {
    const Wide mine = load_wide(near.d2 + i);
    WideCount as_near = zero_wide_count();
    for (std::uint32_t j = 0; j < near.size; ++j) count_le(as_near, splat_wide(near.d2[j]), mine);
    const Wide rank = counts(as_near);
    largest = max8(largest, select_le(rank, most, mine, splat_wide(0.0f)));
    n += append_le(chosen + n, near.index + i, rank, most);
  }
  if (n < k) return -1;
  for (std::uint32_t i = 0; i < k; ++i) out[i] = chosen[i];
  return greatest(largest);
}

enum class Answer { kFound, kTooFew, kHard };

// Answers one query by the near path. kTooFew: there are fewer than k points within a bound that could grow. kHard: the
// far path is needed.
inline Answer near_query(const KnnArgs& a, std::uint32_t query, const Nearby& near, std::int64_t bound,
                         std::int64_t hint, std::uint32_t* out, std::int64_t& reach2) {
  Within within;
  const std::uint32_t k = static_cast<std::uint32_t>(a.k);
  const float wide = static_cast<float>(bound);
  measure(near, a.x[query], a.y[query], a.z[query], wide, within);
  if (within.size < k) {
    if (bound < a.max_d2) return Answer::kTooFew;
    write_answer(within, wide, within.size, k, out);
    reach2 = -1;
    return Answer::kFound;
  }
  if (within.size > k && within.size <= kFew) {
    reach2 = static_cast<std::int64_t>(answer_by_ranks(within, k, out));
    if (reach2 >= 0) return Answer::kFound;
  }
  Limit limit;
  if (!find_limit(within.d2, within.size, k, within.size, wide, static_cast<float>(hint), limit)) return Answer::kHard;
  reach2 = static_cast<std::int64_t>(limit.ties > 0 ? write_tied_answer(within, limit, out)
                                                    : write_answer(within, limit.all, k, k, out));
  return Answer::kFound;
}

// Returns the bound to try on a group of queries: a quarter more than the radius of the queries before, or from the
// points around when that is unknown.
inline std::int64_t first_guess(const KnnArgs& a, std::uint32_t query, std::int64_t reach2) {
  const std::int64_t guess = reach2 < 0 ? window_bound(a, query) : reach2 + reach2 / 4 + 1;
  return guess < a.max_d2 ? guess : a.max_d2;
}

// Answers queries of one leaf as far as the near path works, and returns how many.
inline std::uint32_t near_group(const KnnArgs& a, std::uint32_t begin, std::uint32_t end, Nearby& near,
                                std::int64_t& reach2) {
  const std::uint32_t k = static_cast<std::uint32_t>(a.k);
  const Cloud cloud = cloud_of(a);
  const QueryBox box = box_around(cloud, a.queries + begin, end - begin);
  std::int64_t bound = first_guess(a, a.queries[begin], reach2);
  std::int64_t farthest = -1, hint = reach2;
  std::uint32_t q = begin;
  for (int attempt = 0; attempt < 4 && q < end && bound < kExactInFloat; ++attempt) {
    if (!collect_nearby(cloud, box, static_cast<float>(bound), near)) break;
    Answer answer = Answer::kFound;
    while (q < end) {
      answer = near_query(a, a.queries[q], near, bound, hint, a.neighbours + std::size_t{q} * k, a.reach2[q]);
      if (answer != Answer::kFound) break;
      hint = a.reach2[q];
      farthest = hint > farthest ? hint : farthest;
      ++q;
    }
    if (answer == Answer::kHard) break;
    bound = 2 * bound < a.max_d2 ? 2 * bound : a.max_d2;
  }
  reach2 = farthest;
  return q - begin;
}

}  // namespace

void knn(const KnnArgs& a) {
  Nearby near;
  const std::uint32_t k = static_cast<std::uint32_t>(a.k);
  std::int64_t reach2 = -1;
  for (std::uint32_t begin = 0; begin < a.query_count;) {
    const std::uint32_t end = end_of_group(a.queries, begin, a.query_count);
    begin += near_group(a, begin, end, near, reach2);
    if (begin < end) {  // the query at which the near path gave up
      const std::uint32_t query = a.queries[begin];
      a.reach2[begin] = far_query(a, query, window_bound(a, query), a.neighbours + std::size_t{begin} * k);
      reach2 = a.reach2[begin] > reach2 ? a.reach2[begin] : reach2;
      ++begin;
    }
  }
}

// The last line exports the bodies compiled here under one name.
extern const KnnBody kKnn;
const KnnBody kKnn{knn};
