// SPDX-License-Identifier: Apache-2.0
// Raw arguments of the vector bodies in rows.inl, compiled once for each instruction set; the public headers say what
// they mean.
#pragma once
#include <cstddef>
#include <cstdint>

#include "kernels/simd/variants.h"

namespace ilot::simd {

constexpr std::uint32_t kCodesOfEnds = 2;

struct LeastArgs {
  const std::int32_t *first, *second;
  std::int32_t* out;  // does not overlap with them
  std::size_t size;
};

struct StepArgs {
  const std::int32_t* from;
  std::int32_t* row;  // lowered to from + step
  std::size_t size;
  std::int32_t step;
};

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

struct RasterRowsBody {
  void (*least_of_two)(const LeastArgs&);
  void (*lower_by_step)(const StepArgs&);
  bool (*narrow_heights)(const NarrowArgs&);  // returns whether all heights have a code
  void (*widen_codes)(const WidenArgs&);
};
extern const Variants<RasterRowsBody> kRasterRows;

}  // namespace ilot::simd
