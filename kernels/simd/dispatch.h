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

struct Table {
  const char* name;
  void (*count_inliers)(const CountArgs&);
  void (*knn)(const KnnArgs&);
};

// The table of the best instruction set of this machine, chosen once. ILOT_FORCE_ISA=baseline|avx2 overrides it; a name
// that is unknown or not supported here gives the baseline.
const Table& table();

// A named table, for tests that compare them; nullptr where this machine or build lacks it.
const Table* find_table(const char* name);

}  // namespace ilot::simd
