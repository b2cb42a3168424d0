// SPDX-License-Identifier: Apache-2.0
// Body of hough_normals. The neighbours are put into a ring ordered by a hash of their positions. A round of draws is
// the triplets (s, s + a, s + b) for every s of the ring, with the offsets (a, b) of the round. So the lanes load side
// by side and every neighbour is drawn equally often.

#include "kernels/neighbours/sort_keys.inl"

namespace {

constexpr std::uint32_t kRing = 64;            // most neighbours
constexpr std::uint32_t kRoundsBetweenLooks = 2;
constexpr std::uint32_t kFaceCells = 8;        // per axis of a face of the cube
constexpr std::uint32_t kBins = 3 * kFaceCells * kFaceCells;
constexpr std::uint32_t kBinsAndNone = kBins + 32;  // votes of zero length go to bin kBins
// Choice: 10 degrees, about a bin; a smaller cone has few votes, a larger one bends normals beside edges.
constexpr float kCone = 0.96984631f;           // squared cosine of 10 degrees
// Derived: the comment on the line.
constexpr float kWarp = 0.27323954f;           // 4 / pi - 1: equal angles instead of equal tangents, nearly

struct Ring {
  float x[3 * kRing + 16], y[3 * kRing + 16], z[3 * kRing + 16];
};

// Votes round by round. Each round is filled up to a multiple of 16 with votes of zero length.
struct Votes {
  float x[kHoughVotes], y[kHoughVotes], z[kHoughVotes];
};

struct Accumulator {
  std::uint16_t count[kBinsAndNone];
};

inline std::uint64_t position_hash(std::int32_t x, std::int32_t y, std::int32_t z) {
  std::uint64_t h = static_cast<std::uint32_t>(x) * 0x9e3779b97f4a7c15ull;
  h = (h ^ (h >> 29) ^ static_cast<std::uint32_t>(y)) * 0xbf58476d1ce4e5b9ull;
  h = (h ^ (h >> 31) ^ static_cast<std::uint32_t>(z)) * 0x94d049bb133111ebull;
  return h ^ (h >> 32);
}

inline Ring make_ring(const HoughArgs& a, std::uint32_t query, const std::uint32_t* list) {
  const auto whole = [](float v) { return static_cast<std::int32_t>(v); };
  const std::uint32_t k = static_cast<std::uint32_t>(a.k);
  const std::int32_t qx = whole(a.x[query]), qy = whole(a.y[query]), qz = whole(a.z[query]);
  std::uint64_t order[kRing];
  for (std::uint32_t i = 0; i < k; ++i) {
    const std::uint32_t j = list[i];
    const std::uint64_t hash = position_hash(whole(a.x[j]) - qx, whole(a.y[j]) - qy, whole(a.z[j]) - qz);
    order[i] = (hash & ~std::uint64_t{kRing - 1}) | i;
  }
  sort_keys(order, k);
  Ring ring;
  for (std::uint32_t i = 0; i < k; ++i) {
    const std::uint32_t j = list[order[i] % kRing];
    for (std::uint32_t turn = 0; turn < 3; ++turn) {
      ring.x[turn * k + i] = a.x[j] - a.x[query];
      ring.y[turn * k + i] = a.y[j] - a.y[query];
      ring.z[turn * k + i] = a.z[j] - a.z[query];
    }
  }
  for (std::uint32_t i = 3 * k; i < 3 * k + 16; ++i) ring.x[i] = ring.y[i] = ring.z[i] = 0;
  return ring;
}

inline std::uint32_t row_of(std::uint32_t k) { return (k + 15) / 16 * 16; }

// Computes the normals of the triplets of a round. Their length is twice the area of the triplet.
inline void draw_round(const Ring& ring, std::uint32_t k, const std::uint32_t* offsets, float* x, float* y, float* z) {
  const std::uint32_t a = offsets[0], b = offsets[1];
  for (std::uint32_t s = 0; s < k; s += kWide) {
    const Wide px = load_wide(ring.x + s), py = load_wide(ring.y + s), pz = load_wide(ring.z + s);
    const Wide ux = load_wide(ring.x + s + a) - px, uy = load_wide(ring.y + s + a) - py,
               uz = load_wide(ring.z + s + a) - pz;
    const Wide vx = load_wide(ring.x + s + b) - px, vy = load_wide(ring.y + s + b) - py,
               vz = load_wide(ring.z + s + b) - pz;
    store_wide(x + s, uy * vz - uz * vy);
    store_wide(y + s, uz * vx - ux * vz);
    store_wide(z + s, ux * vy - uy * vx);
  }
  for (std::uint32_t s = k; s < row_of(k); ++s) x[s] = y[s] = z[s] = 0;
}

// Returns the cell of a tangent in [-1, 1] along an axis of a face.
inline Wide cell_of(Wide tangent) {
  const Wide warped = tangent * (splat_wide(1 + kWarp) - splat_wide(kWarp) * magnitude(tangent));
  const Wide cell = (warped + splat_wide(1.0f)) * splat_wide(kFaceCells / 2.0f);
  return min_wide(truncated(cell), splat_wide(kFaceCells - 1));
}

// Computes the bins of directions in a rotated frame (rows of r).
inline void bins_of(const float* x, const float* y, const float* z, const float* r, std::int32_t* bins) {
  const Wide vx = load_wide(x), vy = load_wide(y), vz = load_wide(z);
  const Wide a = splat_wide(r[0]) * vx + splat_wide(r[1]) * vy + splat_wide(r[2]) * vz;
  const Wide b = splat_wide(r[3]) * vx + splat_wide(r[4]) * vy + splat_wide(r[5]) * vz;
  const Wide c = splat_wide(r[6]) * vx + splat_wide(r[7]) * vy + splat_wide(r[8]) * vz;
  const Wide ma = magnitude(a), mb = magnitude(b), mc = magnitude(c);
  const Wide most = max8(max8(ma, mb), mc);
  // In face 0 a is the longest component, in face 1 b, in face 2 c. The axes of a face are the other two.
  const Wide nothing = splat_wide(0.0f);
  const Wide longest = select_le(most, nothing, splat_wide(1.0f), select_le(most, ma, a, select_le(most, mb, b, c)));
  const Wide first = select_le(most, ma, b, a);
  const Wide second = select_le(most, ma, c, select_le(most, mb, c, b));
  const Wide cells = splat_wide(kFaceCells * kFaceCells);
  const Wide face = select_le(most, ma, nothing, select_le(most, mb, cells, cells + cells));
  const Wide bin = face + cell_of(first / longest) * splat_wide(kFaceCells) + cell_of(second / longest);
  store_truncated(bins, select_le(most, nothing, splat_wide(kBins), bin));
}

inline void vote(const float* x, const float* y, const float* z, std::uint32_t k, const float* rotations,
                 Accumulator* accumulators) {
  std::int32_t bins[kRing];
  for (std::uint32_t r = 0; r < kHoughRotations; ++r) {
    for (std::uint32_t s = 0; s < k; s += kWide) bins_of(x + s, y + s, z + s, rotations + 9 * r, bins + s);
    for (std::uint32_t s = 0; s < k; ++s) ++accumulators[r].count[bins[s]];
  }
}

struct Leader {
  std::uint32_t rotation, bin, count, lead;
};

inline std::uint16_t most_votes(const Accumulator& accumulator) {
  std::uint16_t most = 0;
  for (std::uint32_t i = 0; i < kBins; ++i) most = accumulator.count[i] > most ? accumulator.count[i] : most;
  return most;
}

// `best` is the number of votes of the leading bin.
inline Leader leader_of(Accumulator& accumulator, std::uint32_t rotation, std::uint16_t best) {
  std::uint32_t bin = 0;
  while (accumulator.count[bin] != best) ++bin;
  accumulator.count[bin] = 0;
  const std::uint16_t second = most_votes(accumulator);
  accumulator.count[bin] = best;
  return {rotation, bin, best, static_cast<std::uint32_t>(best - second)};
}

// Returns the rotation whose leading bin has most votes. Ties go to the larger lead, then to the earlier rotation. Leads
// are found only of those that have most votes.
inline Leader best_leader(Accumulator* accumulators) {
  std::uint16_t votes[kHoughRotations], most = 0;
  for (std::uint32_t r = 0; r < kHoughRotations; ++r) {
    votes[r] = most_votes(accumulators[r]);
    most = votes[r] > most ? votes[r] : most;
  }
  Leader best{};
  bool any = false;
  for (std::uint32_t r = 0; r < kHoughRotations; ++r) {
    if (votes[r] != most) continue;
    const Leader other = leader_of(accumulators[r], r, most);
    if (!any || other.lead > best.lead) best = other;
    any = true;
  }
  return best;
}

struct Direction {
  double x, y, z;
};

inline Direction unit(double x, double y, double z) {
  const double length = __builtin_sqrt(x * x + y * y + z * z);
  if (!(length > 0)) return {0, 0, 0};
  return {x / length, y / length, z / length};
}

// Returns the tangent at the middle of a cell.
inline double cell_middle(std::uint32_t cell) {
  const double w = (2.0 * cell + 1) / kFaceCells - 1;
  const double v = w < 0 ? -w : w, b = 1.0 + kWarp;
  const double t = (b - __builtin_sqrt(b * b - 4 * kWarp * v)) / (2 * kWarp);
  return w < 0 ? -t : t;
}

inline Direction bin_centre(const Leader& leader, const float* rotations) {
  const std::uint32_t face = leader.bin / (kFaceCells * kFaceCells), cell = leader.bin % (kFaceCells * kFaceCells);
  const double first = cell_middle(cell / kFaceCells), second = cell_middle(cell % kFaceCells);
  const double a = face == 0 ? 1 : first, b = face == 0 ? first : face == 1 ? 1 : second, c = face == 2 ? 1 : second;
  const float* r = rotations + 9 * leader.rotation;
  return unit(r[0] * a + r[3] * b + r[6] * c, r[1] * a + r[4] * b + r[7] * c, r[2] * a + r[5] * b + r[8] * c);
}

inline double sum_of(F8 v) {
  float lane[8];
  store8(lane, v);
  double sum = 0;
  for (const float f : lane) sum += static_cast<double>(f);
  return sum;
}

// Returns the mean of the votes in a cone around a direction, weighted by area. It uses eight lanes on every
// instruction set, so the order of sums is fixed.
inline Direction mean_around(const Votes& votes, std::uint32_t rounds, std::uint32_t k, const Direction& axis) {
  const F8 ax = splat(static_cast<float>(axis.x)), ay = splat(static_cast<float>(axis.y)),
           az = splat(static_cast<float>(axis.z));
  const F8 zero = splat(0.0f), cone = splat(kCone);
  F8 sx = zero, sy = zero, sz = zero;
  for (std::uint32_t s = 0; s < rounds * row_of(k); s += 8) {
    const F8 x = load8(votes.x + s), y = load8(votes.y + s), z = load8(votes.z + s);
    const F8 along = x * ax + y * ay + z * az;
    const F8 inside = cone * (x * x + y * y + z * z), along2 = along * along;
    const F8 one = select_le(inside, along2, select_le(zero, along, splat(1.0f), splat(-1.0f)), zero);
    sx = sx + one * x;
    sy = sy + one * y;
    sz = sz + one * z;
  }
  return unit(sum_of(sx), sum_of(sy), sum_of(sz));
}

inline Direction hough_direction(const HoughArgs& a, const Ring& ring) {
  const std::uint32_t k = static_cast<std::uint32_t>(a.k);
  Votes votes;
  Accumulator accumulators[kHoughRotations];
  for (auto& accumulator : accumulators)
    for (std::uint16_t& n : accumulator.count) n = 0;
  Leader leader{};
  std::uint32_t round = 0;
  while (round < a.rounds) {
    const std::uint32_t at = round * row_of(k);
    float *x = votes.x + at, *y = votes.y + at, *z = votes.z + at;
    draw_round(ring, k, a.offsets + 2 * round, x, y, z);
    vote(x, y, z, k, a.rotations, accumulators);
    ++round;
    if (round % kRoundsBetweenLooks != 0 && round != a.rounds) continue;
    leader = best_leader(accumulators);
    // The shares of two bins are known within 1 / sqrt(n) each.
    if (leader.lead * leader.lead >= 4 * round * k) break;
  }
  if (leader.count == 0) return {0, 0, 0};
  const Direction first = mean_around(votes, round, k, bin_centre(leader, a.rotations));
  return mean_around(votes, round, k, first);
}

}  // namespace

void hough_directions(const HoughArgs& a) {
  for (std::uint32_t q = 0; q < a.query_count; ++q) {
    const Ring ring = make_ring(a, a.queries[q], a.neighbours + std::size_t{q} * static_cast<std::uint32_t>(a.k));
    const Direction d = hough_direction(a, ring);
    a.out[3 * std::size_t{q}] = d.x;
    a.out[3 * std::size_t{q} + 1] = d.y;
    a.out[3 * std::size_t{q} + 2] = d.z;
  }
}

// The last line exports the bodies compiled here under one name.
extern const HoughNormalsBody kHoughNormals;
const HoughNormalsBody kHoughNormals{hough_directions};
