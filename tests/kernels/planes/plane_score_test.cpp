// SPDX-License-Identifier: Apache-2.0
#include "kernels/planes/plane_score.h"
#include "kernels/planes/plane_score_body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
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

// As the kernel computes it: with the plane scaled so that the greatest distance is just below 2, and fused operations.
std::uint32_t naive(const Case& c, const PlaneHypothesis& h, const PlaneScoreParams& params, bool normals) {
  const float below = 1 - 0x1p-22f, k = 2 * below / params.max_distance;
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < c.set.size; ++i) {
    const float d =
        std::fma(k * h[0], c.set.x[i], std::fma(k * h[1], c.set.y[i], std::fma(k * h[2], c.set.z[i], k * h[3])));
    const float agreement = std::fma(k * h[0], c.nx[i], std::fma(k * h[1], c.ny[i], k * h[2] * c.nz[i]));
    count += std::abs(d) < 2 && (!normals || std::abs(agreement) >= k * params.min_cos * below);
  }
  return count;
}

// The points whose distance in double is not within rounding of the limit decide alike.
std::pair<std::uint32_t, std::uint32_t> bounds(const Case& c, const PlaneHypothesis& h, double limit) {
  std::pair<std::uint32_t, std::uint32_t> count;
  for (std::size_t i = 0; i < c.set.size; ++i) {
    const double terms[4] = {double(h[0]) * c.set.x[i], double(h[1]) * c.set.y[i], double(h[2]) * c.set.z[i], h[3]};
    double sum = 0, largest = 0;
    for (const double t : terms) sum += t, largest = std::max(largest, std::abs(t));
    count.first += std::abs(sum) < limit - 1e-6 * largest;
    count.second += std::abs(sum) < limit + 1e-6 * largest;
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

TEST(CountInliers, CountsAreThoseOfExactDistancesButForRounding) {
  const Case c = make_case(20000, 40);
  std::vector<std::uint32_t> counts(c.planes.size());
  for (const float limit : {0.0f, 0.3f, 50.0f, 500.0f, 1e6f}) {
    count_inliers({c.set.view()}, c.planes, {limit, 0}, counts);
    for (std::size_t i = 0; i < c.planes.size(); ++i) {
      const auto [least, most] = bounds(c, c.planes[i], limit);
      EXPECT_GE(counts[i], least) << limit;
      EXPECT_LE(counts[i], most) << limit;
    }
  }
}

TEST(CountInliers, NothingIsWithinANegativeDistance) {
  const Case c = make_case(100, 4);
  std::vector<std::uint32_t> counts(4, 9);
  count_inliers(c.oriented(), c.planes, {-1, 0}, counts);
  EXPECT_EQ(counts, std::vector<std::uint32_t>(4, 0));
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
