// SPDX-License-Identifier: Apache-2.0
#include "kernels/planes/plane_score.h"
#include "kernels/planes/plane_score_body.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/instruction_sets.h"
#include "tests/support/point_sets.h"

namespace ilot {
namespace {

struct Case {
  test::PointSet set;
  std::vector<float> nx, ny, nz;
  std::vector<PlaneHypothesis> planes;
  OrientedPoints oriented() const { return {set.view(), nx.data(), ny.data(), nz.data()}; }
};

Case make_case(std::uint32_t n, std::size_t planes) {
  Case c{test::point_sets(n)[1], {}, {}, {}, {}};
  Rng rng(n);
  const auto unit = [&] {
    const Vec3 v{rng.uniform() - 0.5, rng.uniform() - 0.5, rng.uniform() + 0.1};
    return (1 / norm(v)) * v;
  };
  for (std::uint32_t i = 0; i < n + 16; ++i) {
    const Vec3 v = i % 7 == 0 ? Vec3{} : unit();
    c.nx.push_back(static_cast<float>(v.x));
    c.ny.push_back(static_cast<float>(v.y));
    c.nz.push_back(static_cast<float>(v.z));
  }
  for (std::size_t i = 0; i < planes; ++i) {
    const Vec3 v = unit();
    const std::size_t at = rng.below(n);
    const Vec3 p{c.set.x[at], c.set.y[at], c.set.z[at]};
    c.planes.push_back(
        {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), static_cast<float>(-dot(v, p))});
  }
  return c;
}

std::uint32_t naive(const Case& c, const PlaneHypothesis& h, const PlaneScoreParams& params, bool normals) {
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < c.set.size; ++i) {
    const float d = h[0] * c.set.x[i] + h[1] * c.set.y[i] + h[2] * c.set.z[i] + h[3];
    const float agreement = h[0] * c.nx[i] + h[1] * c.ny[i] + h[2] * c.nz[i];
    count += std::abs(d) <= params.max_distance && (!normals || std::abs(agreement) >= params.min_cos);
  }
  return count;
}

TEST(CountInliers, EqualsTheNaiveLoopForEverySizeAndPlaneCount) {
  for (const std::uint32_t n : {1u, 7u, 8u, 9u, 1023u, 1024u, 1025u, 5000u}) {
    for (const std::size_t planes : {1u, 3u, 4u, 5u, 16u, 19u}) {
      const Case c = make_case(n, planes);
      const PlaneScoreParams params{500, 0.9f};
      std::vector<std::uint32_t> with(planes), without(planes);
      count_inliers(c.oriented(), c.planes, params, with);
      count_inliers({c.set.view()}, c.planes, params, without);
      for (std::size_t i = 0; i < planes; ++i) {
        EXPECT_EQ(with[i], naive(c, c.planes[i], params, true)) << n << " " << i;
        EXPECT_EQ(without[i], naive(c, c.planes[i], params, false)) << n << " " << i;
      }
    }
  }
}

TEST(CountInliers, DistanceIsClosedAndNoPlanesIsFine) {
  const auto set = test::make_set("two", {{0, 0, 0}, {0, 0, 2}});
  std::uint32_t count = 0;
  const PlaneHypothesis ground{0, 0, 1, 0};
  count_inliers({set.view()}, std::span(&ground, 1), {2, 0}, std::span(&count, 1));
  EXPECT_EQ(count, 2u);
  count_inliers({set.view()}, {}, {2, 0}, {});
}

TEST(CountInliers, EveryInstructionSetGivesTheSameCounts) {
  const auto isas = test::vector_isas();
  if (isas.empty()) GTEST_SKIP() << "this machine has the baseline alone";
  const Case c = make_case(10007, 37);
  std::vector<std::uint32_t> a(37), b(37);
  simd::CountArgs args{c.set.x.data(), c.set.y.data(), c.set.z.data(),          c.nx.data(), c.ny.data(),
                       c.nz.data(),    c.set.size,     c.planes.data()->data(), 37,          300,
                       0.8f,           a.data()};
  simd::kPlaneScore.of(simd::Isa::baseline).count_inliers(args);
  args.counts = b.data();
  for (const simd::Isa isa : isas) {
    simd::kPlaneScore.of(isa).count_inliers(args);
    EXPECT_EQ(a, b) << simd::name_of(isa);
  }
}

}  // namespace
}  // namespace ilot
