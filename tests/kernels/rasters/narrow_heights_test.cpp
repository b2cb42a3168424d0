// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/narrow_heights.h"

#include <gtest/gtest.h>

#include <vector>

#include "kernels/core/rng.h"
#include "kernels/rasters/rows_body.h"
#include "tests/support/instruction_sets.h"

namespace ilot {
namespace {

constexpr Height kBase = -70000;

std::vector<Height> heights_with_codes(std::size_t size) {
  Rng rng(size, 5);
  std::vector<Height> heights;
  for (std::size_t i = 0; i < size; ++i) {
    const auto kind = rng.below(4);
    heights.push_back(kind == 0 ? kNoHeight : kind == 1 ? kAboveAll : kBase + static_cast<Height>(rng.below(65534)));
  }
  return heights;
}

TEST(NarrowHeights, ComeBackAsTheyWere) {
  for (const std::size_t size : {0, 1, 7, 8, 9, 31, 512, 1000}) {
    const std::vector<Height> heights = heights_with_codes(size);
    std::vector<std::uint16_t> codes(size);
    std::vector<Height> back(size, 7);
    EXPECT_TRUE(narrow_heights(heights, kBase, codes));
    widen_codes(codes, kBase, back);
    EXPECT_EQ(back, heights) << size;
  }
}

TEST(NarrowHeights, OneWithoutACodeIsSeenWhereverItStands) {
  for (const Height beyond : {kBase - 1, kBase + 65534, kBase + 65535, kBase + 65536, kNoHeight + 1, kAboveAll - 1})
    for (std::size_t at = 0; at < 37; ++at) {
      std::vector<Height> heights(37, kBase);
      heights[at] = beyond;
      std::vector<std::uint16_t> codes(37);
      EXPECT_FALSE(narrow_heights(heights, kBase, codes)) << beyond << " at " << at;
    }
}

// All bodies of rows.inl.
TEST(NarrowHeights, SameOnEveryInstructionSet) {
  const simd::RasterRowsBody& base = simd::kRasterRows.of(simd::Isa::baseline);
  for (const simd::Isa isa : test::vector_isas())
    for (std::size_t size = 0; size < 70; ++size) {
      const std::vector<Height> a = heights_with_codes(size), b = heights_with_codes(size + 1);
      std::vector<Height> want(size, 1), got(size, 2);
      base.least_of_two({a.data(), b.data(), want.data(), size});
      simd::kRasterRows.of(isa).least_of_two({a.data(), b.data(), got.data(), size});
      EXPECT_EQ(got, want);
      std::vector<Height> from(size);
      for (std::size_t i = 0; i < size; ++i) from[i] = b[i] / 4;
      want = got = a;
      base.lower_by_step({from.data(), want.data(), size, 90000});
      simd::kRasterRows.of(isa).lower_by_step({from.data(), got.data(), size, 90000});
      EXPECT_EQ(got, want);
      std::vector<std::uint16_t> codes(size, 1), same(size, 2);
      EXPECT_EQ(base.narrow_heights({a.data(), codes.data(), size, kBase, kNoHeight, kAboveAll}),
                simd::kRasterRows.of(isa).narrow_heights({a.data(), same.data(), size, kBase, kNoHeight, kAboveAll}));
      EXPECT_EQ(codes, same);
      base.widen_codes({codes.data(), want.data(), size, kBase, kNoHeight, kAboveAll});
      simd::kRasterRows.of(isa).widen_codes({codes.data(), got.data(), size, kBase, kNoHeight, kAboveAll});
      EXPECT_EQ(got, want);
    }
}

}  // namespace
}  // namespace ilot
