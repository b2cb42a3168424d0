// SPDX-License-Identifier: Apache-2.0
// Bodies of the operations on whole rows: plain loops that the compiler turns into vectors of each instruction set.

void least_of_two(const LeastArgs& a) {
  const std::int32_t *first = a.first, *second = a.second;
  std::int32_t* __restrict out = a.out;
  for (std::size_t i = 0; i < a.size; ++i) out[i] = first[i] < second[i] ? first[i] : second[i];
}

void lower_by_step(const StepArgs& a) {
  const std::int32_t* __restrict from = a.from;
  std::int32_t* __restrict row = a.row;
  const std::int32_t step = a.step;
  for (std::size_t i = 0; i < a.size; ++i) {
    const std::int32_t through = from[i] + step;
    row[i] = through < row[i] ? through : row[i];
  }
}

bool narrow_heights(const NarrowArgs& a) {
  const std::int32_t* __restrict heights = a.heights;
  std::uint16_t* __restrict codes = a.codes;
  const auto base = static_cast<std::uint32_t>(a.base);
  std::uint32_t beyond = 0;
  for (std::size_t i = 0; i < a.size; ++i) {
    const std::uint32_t above = static_cast<std::uint32_t>(heights[i]) - base;
    const bool none = heights[i] == a.none, highest = heights[i] == a.highest;
    beyond |= (none | highest) ? 0u : (above + kCodesOfEnds) >> 16 | above >> 16;
    codes[i] = static_cast<std::uint16_t>(none ? 0xffffu : highest ? 0xfffeu : above);
  }
  return beyond == 0;
}

void widen_codes(const WidenArgs& a) {
  const std::uint16_t* __restrict codes = a.codes;
  std::int32_t* __restrict heights = a.heights;
  const auto base = static_cast<std::uint32_t>(a.base);
  for (std::size_t i = 0; i < a.size; ++i) {
    const auto height = static_cast<std::int32_t>(base + codes[i]);
    heights[i] = codes[i] == 0xffffu ? a.none : codes[i] == 0xfffeu ? a.highest : height;
  }
}

// The last line exports the bodies compiled here under one name.
extern const RasterRowsBody kRasterRows;
const RasterRowsBody kRasterRows{least_of_two, lower_by_step, narrow_heights, widen_codes};
