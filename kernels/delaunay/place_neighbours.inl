// SPDX-License-Identifier: Apache-2.0
// Body of kth_distances: the search in cells, for one query after the other. Lanes (F8, splat, Least8 ...) are those of
// kernels/simd/lanes_*.h: kernels/simd/bodies.cmake compiles this text once for each instruction set, behind the lanes
// of that set and place_neighbours_body.h.
// float32 only preselects, with a limit inflated by more than the rounding: coordinates are integers below 2^24, so
// differences are exact. Squared distances of the selected places are integers below 2^50, which are exact in double.

namespace {

constexpr std::uint32_t kMostAround = 192;  // places that a query in cells examines
constexpr std::int32_t kMostRings = 4;      // of cells around its own

struct Query {
  std::int32_t x, y;
};

// Offsets from the query to places around it.
struct Offsets {
  float x[kMostAround + 8], y[kMostAround + 8];
  std::uint32_t size;
};

inline std::int32_t smaller(std::int32_t a, std::int32_t b) {
  return a < b ? a : b;
}
inline std::int32_t larger(std::int32_t a, std::int32_t b) {
  return a > b ? a : b;
}

// Collects all places within the squared distance `limit` in the cells around the query, and maybe others. Returns
// false when the cells have too many places.
inline bool gather(const PlaceNeighboursArgs& a, Query q, std::int32_t ring, double limit, Offsets& out) {
  const std::int32_t column = q.x >> a.shift, row = q.y >> a.shift;
  const std::int32_t left = larger(0, column - ring), right = smaller(a.columns - 1, column + ring) + 1;
  const std::int32_t top = smaller(a.rows - 1, row + ring);
  const F8 x = splat(static_cast<float>(q.x)), y = splat(static_cast<float>(q.y));
  const F8 most = splat(static_cast<float>(limit) * 1.000002f + 1.0f);
  std::uint32_t size = 0, seen = 0;
  for (std::int32_t r = larger(0, row - ring); r <= top; ++r) {
    const std::uint32_t* start = a.start + static_cast<std::size_t>(r) * static_cast<std::size_t>(a.columns);
    const std::uint32_t end = start[right];
    seen += end - start[left];
    if (seen > kMostAround) return false;
    for (std::uint32_t i = start[left]; i < end; i += 8) {
      const F8 dx = load8(a.x + i) - x, dy = load8(a.y + i) - y;
      std::uint32_t hits = mask_le(dx * dx + dy * dy, most);
      if (end - i < 8) hits &= (1u << (end - i)) - 1;
      const Pick8 pick = pick8(hits);
      put(out.x + size, pick, dx);
      put(out.y + size, pick, dy);
      size += pick.count;
    }
  }
  out.size = size;
  return true;
}

// Returns the k-th smallest of squared distances, without the 0 of the query itself; infinite for fewer places.
inline double kth_smallest(const Offsets& from, int k) {
  Least8 least = no_least();
  for (std::uint32_t i = 0; i < from.size; ++i) {
    const double dx = from.x[i], dy = from.y[i];
    add(least, dx * dx + dy * dy);
  }
  double ordered[8];
  store_least(ordered, least);
  return ordered[k];
}

// Returns the squared distance of the k-th place of the cells around, negative when they have too many places. `hint`
// is where the queries before let it be expected, so most of the other places need not be ordered.
inline double kth_around(const PlaceNeighboursArgs& a, Query q, std::int32_t ring, double hint, Offsets& offsets) {
  if (!gather(a, q, ring, hint, offsets)) return -1;
  if (offsets.size > static_cast<std::uint32_t>(a.k)) {
    const double kth = kth_smallest(offsets, a.k);
    if (kth <= hint) return kth;
  }
  gather(a, q, ring, __builtin_inf(), offsets);
  return kth_smallest(offsets, a.k);
}

// Returns how far v is from the borders of its cell and the `ring` cells to each side where there are cells beyond.
inline std::int64_t gap(std::int32_t v, int shift, std::int32_t ring, std::int32_t cells) {
  const std::int64_t low = (v >> shift) - ring, high = (v >> shift) + ring + 1;
  std::int64_t least = 0x7fffffff;
  if (low > 0 && v - (low << shift) < least) least = v - (low << shift);
  if (high < cells && (high << shift) - v < least) least = (high << shift) - v;
  return least;
}

// Returns a squared distance below which there is no place outside of the gathered cells.
inline std::int64_t squared_inside(const PlaceNeighboursArgs& a, Query q, std::int32_t ring) {
  const std::int64_t across = gap(q.x, a.shift, ring, a.columns), along = gap(q.y, a.shift, ring, a.rows);
  const std::int64_t least = across < along ? across : along;
  return least * least;
}

inline std::int64_t search(const PlaceNeighboursArgs& a, Query q, double& hint, Offsets& offsets) {
  for (std::int32_t ring = 1; ring <= kMostRings; ++ring) {
    const double kth = kth_around(a, q, ring, hint, offsets);
    if (kth < 0) break;
    const std::int64_t inside2 = squared_inside(a, q, ring);
    const bool sure = kth <= static_cast<double>(inside2);
    if (!sure && inside2 < a.limit2) continue;
    if (sure) hint = 1.5 * kth;  // usually more than k places are as near
    return kth <= static_cast<double>(a.limit2) ? static_cast<std::int64_t>(kth) : -1;
  }
  return kNotInCells;
}

}  // namespace

void in_cells(const PlaceNeighboursArgs& a) {
  Offsets offsets;
  double hint = __builtin_inf();
  for (std::size_t i = 0; i < a.query_count; ++i) {
    const Point2 place = a.places[a.queries[i]];
    a.squared[i] = search(a, {place.x - a.low.x, place.y - a.low.y}, hint, offsets);
  }
}

// The last line exports the bodies compiled here under one name.
extern const PlaceNeighboursBody kPlaceNeighbours;
const PlaceNeighboursBody kPlaceNeighbours{in_cells};
