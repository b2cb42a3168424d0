// SPDX-License-Identifier: Apache-2.0
// Plane scoring on an airborne town: one and sixteen planes at a time, with and without normals, beside the loop that
// one writes first (double, array of structures, one plane). The counts must be equal before anything is timed.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "bench/surface.h"
#include "kernels/planes/plane_score.h"

namespace {

using namespace ilot;

constexpr std::size_t kPoints = 1000000;
constexpr float kDistance = 64;  // 64 mm; the planes are chosen so that no point lies on the edge of it

const bench::Surface& surface() {
  static const bench::Surface s = bench::make_surface(kPoints);
  return s;
}

struct Normals {
  std::vector<float> x = std::vector<float>(kPoints + 16, 0.0f), y = x, z = std::vector<float>(kPoints + 16, 1.0f);
};
const Normals& up() {
  static const Normals n;
  return n;
}

// Level and sloping planes through the town, with coefficients that float32 and double hold alike.
std::vector<PlaneHypothesis> planes(std::size_t count) {
  std::vector<PlaneHypothesis> list;
  for (std::size_t i = 0; i < count; ++i)
    list.push_back(
        {0.0f, i % 2 == 0 ? 0.0f : 0.5f, i % 2 == 0 ? 1.0f : 0.75f, -9000.5f - 250.0f * static_cast<float>(i)});
  return list;
}

std::uint32_t naive(const std::vector<Vec3>& points, const PlaneHypothesis& h) {
  const Plane plane{{h[0], h[1], h[2]}, h[3]};
  std::uint32_t count = 0;
  for (const Vec3& p : points) count += std::abs(signed_distance(plane, p)) <= kDistance;
  return count;
}

const std::vector<Vec3>& structures() {
  static const std::vector<Vec3> points = [] {
    std::vector<Vec3> v;
    for (std::size_t i = 0; i < kPoints; ++i) v.push_back({surface().x[i], surface().y[i], surface().z[i]});
    return v;
  }();
  return points;
}

void check(const std::vector<PlaneHypothesis>& list) {
  std::vector<std::uint32_t> counts(list.size());
  count_inliers({surface().view()}, list, {kDistance, 0}, counts);
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (counts[i] == naive(structures(), list[i])) continue;
    std::fprintf(stderr, "plane %zu: %u inliers, the plain loop has %u\n", i, counts[i], naive(structures(), list[i]));
    std::exit(1);
  }
}

void BM_ilot(benchmark::State& state) {
  const auto list = planes(static_cast<std::size_t>(state.range(0)));
  const bool normals = state.range(1) != 0;
  check(list);
  std::vector<std::uint32_t> counts(list.size());
  OrientedPoints points{surface().view()};
  if (normals) points = {surface().view(), up().x.data(), up().y.data(), up().z.data()};
  for (auto _ : state) count_inliers(points, list, {kDistance, 0.9f}, counts);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kPoints * list.size()));
}
BENCHMARK(BM_ilot)
    ->ArgNames({"planes", "normals"})
    ->ArgsProduct({{1, 16, 64}, {0, 1}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

void BM_double_structures(benchmark::State& state) {
  const auto list = planes(1);
  structures();
  for (auto _ : state) benchmark::DoNotOptimize(naive(structures(), list[0]));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kPoints));
}
BENCHMARK(BM_double_structures)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
