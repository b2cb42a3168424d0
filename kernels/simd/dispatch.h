// SPDX-License-Identifier: Apache-2.0
// Instruction sets are known in this folder only. Each kernel body is one text (kernels/*/NAME.inl) over fixed lanes
// (lanes_*.h), compiled once per instruction set and reached through this table; the answers are the same bits in each.
#pragma once
#include <cstddef>
#include <cstdint>

namespace ilot::simd {

// Raw arguments of the vector bodies; the public headers beside each .inl say what they mean.
struct CountArgs {
  const float *x, *y, *z, *nx, *ny, *nz;  // nx == nullptr: distance alone
  std::size_t size;
  const float* planes;  // a b c d per plane
  std::size_t plane_count;
  float max_distance, min_cos;
  std::uint32_t* counts;  // one per plane, overwritten
};

struct KnnArgs {
  const float *x, *y, *z;
  std::uint32_t size;
  const float* const* boxes;  // per level: nodes of 8 child boxes, 48 floats each: min x8 y8 z8, max x8 y8 z8
  int levels;
  const std::uint32_t* queries;
  std::uint32_t query_count;
  int k;
  std::int64_t max_d2;
  std::uint32_t* neighbours;  // k per query
  std::int64_t* reach2;       // one per query
};

struct NormalArgs {
  const float *x, *y, *z;
  const std::uint32_t* queries;
  std::uint32_t query_count;
  const std::uint32_t* neighbours;  // k per query, all present, squared distances below 2^24
  int k;                            // at most 64
  std::int16_t* out;                // x y z and curvature as uint16 per query
};

struct HoughArgs {
  const float *x, *y, *z;
  const std::uint32_t* queries;
  std::uint32_t query_count;
  const std::uint32_t* neighbours;  // k per query, all present
  int k;                            // 3 to 64
  const std::uint32_t* offsets;     // a b per round
  std::uint32_t rounds;             // rounds x k, k rounded up to 16, at most kHoughVotes
  const float* rotations;           // kHoughRotations matrices, row by row
  double* out;                      // x y z per query, of unit length or all zero
};
constexpr std::size_t kHoughVotes = 2048;
constexpr std::uint32_t kHoughRotations = 5;

struct ShapeArgs {
  const float *x, *y, *z, *nx, *ny, *nz;  // leaves of 64 points; holes are not numbers
  const float* const* balls;              // per level: groups of 8, 32 floats each: x8 y8 z8 radius8
  int levels;
  const float* shape;  // origin, axis, radius, sine, cosine
  int kind;            // ShapeKind
  float max_distance, min_cos;
  float slack;            // more than rounding adds to a distance
  std::uint32_t* leaves;  // shape_leaves writes, shape_hits reads
  std::uint32_t leaf_count;
  std::uint32_t* found;  // nullptr: count only; else positions, with room for eight more
};

constexpr std::size_t kRadialRows = 16;
struct RadialArgs {
  const double* rows;     // kRadialRows of them, dimension by dimension
  const double* vectors;  // dimensions each
  const double* weights;  // sums each
  std::size_t vector_count, dimensions, sums;
  double gamma;
  double* totals;   // kRadialRows per sum, overwritten
  double* nearest;  // one per row, overwritten
};

struct LeastArgs {
  const std::int32_t *first, *second;
  std::int32_t* out;  // no part of them
  std::size_t size;
};

struct StepArgs {
  const std::int32_t* from;
  std::int32_t* row;  // lowered to from + step
  std::size_t size;
  std::int32_t step;
};

constexpr std::uint32_t kCodesOfEnds = 2;
struct NarrowArgs {
  const std::int32_t* heights;
  std::uint16_t* codes;
  std::size_t size;
  std::int32_t base, none, highest;
};

struct WidenArgs {
  const std::uint16_t* codes;
  std::int32_t* heights;
  std::size_t size;
  std::int32_t base, none, highest;
};

struct Table {
  const char* name;
  void (*count_inliers)(const CountArgs&);
  void (*knn)(const KnnArgs&);
  void (*neighbour_normals)(const NormalArgs&);
  void (*hough_directions)(const HoughArgs&);
  std::uint32_t (*shape_hits)(const ShapeArgs&);    // how many points of the leaves
  std::uint32_t (*shape_leaves)(const ShapeArgs&);  // how many leaves
  void (*radial_sums)(const RadialArgs&);
  void (*least_of_two)(const LeastArgs&);
  void (*lower_by_step)(const StepArgs&);
  bool (*narrow_heights)(const NarrowArgs&);  // whether all have a code
  void (*widen_codes)(const WidenArgs&);
};

// The table of the best instruction set of this machine, chosen once. ILOT_FORCE_ISA=baseline|avx2|avx512 overrides it;
// a name that is unknown or not supported here gives the baseline.
const Table& table();

// A named table, for tests that compare them; nullptr where this machine or build lacks it.
const Table* find_table(const char* name);

}  // namespace ilot::simd
