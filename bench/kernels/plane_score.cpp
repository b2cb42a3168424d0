// SPDX-License-Identifier: Apache-2.0
// Plane scoring on an airborne town: one, 16 and 64 planes at a time, with and without normals. It is compared with the
// loop that one writes first (double, array of structures, one plane), with one that is written well
// (blocked_loop.h), and given as a share of the arithmetic ceiling.
#include "kernels/planes/plane_score.h"

#include <cmath>

#include "bench/ceiling/score_loop.h"
#include "bench/compare.h"
#include "bench/kernels/blocked_loop.h"
#include "bench/surface.h"
#include "kernels/core/parallel.h"

namespace {

using namespace ilot;

constexpr float kDistance = 64;  // 64 mm; no point is nearer than an eighth of a millimetre to this distance

struct Normals {
  std::vector<float> x, y, z;
};

// Returns horizontal and sloping planes through the town, with coefficients that are exact in float32 and in double.
std::vector<PlaneHypothesis> planes(std::size_t count) {
  std::vector<PlaneHypothesis> list;
  for (std::size_t i = 0; i < count; ++i)
    list.push_back(
        {0.0f, i % 2 == 0 ? 0.0f : 0.5f, i % 2 == 0 ? 1.0f : 0.75f, -9000.125f - 250.0f * static_cast<float>(i)});
  return list;
}

// The simple loop; with normals, as a programmer would usually write it.
std::uint32_t plain(const std::vector<Vec3>& points, const PlaneHypothesis& h) {
  const Plane plane{{h[0], h[1], h[2]}, h[3]};
  std::uint32_t count = 0;
  for (const Vec3& p : points) count += std::abs(signed_distance(plane, p)) <= kDistance;
  return count;
}

// Counts grains of whole lanes, each separately.
std::vector<std::uint32_t> in_parallel(const OrientedPoints& points, const std::vector<PlaneHypothesis>& list) {
  constexpr std::size_t kGrain = 1 << 16;
  const std::size_t grains = (points.points.size + kGrain - 1) / kGrain;
  std::vector<std::uint32_t> parts(grains * list.size()), counts(list.size(), 0);
  parallel_for(grains, [&](std::size_t g) {
    const std::size_t at = g * kGrain;
    const Points& p = points.points;
    OrientedPoints part{{p.x + at, p.y + at, p.z + at, std::min(kGrain, p.size - at)}};
    if (points.nx != nullptr) part = {part.points, points.nx + at, points.ny + at, points.nz + at};
    count_inliers(part, list, {kDistance, 0.9f}, std::span(parts).subspan(g * list.size(), list.size()));
  });
  for (std::size_t i = 0; i < parts.size(); ++i) counts[i % list.size()] += parts[i];
  return counts;
}

void against_plain_loop(const OrientedPoints& points, const std::vector<Vec3>& structures, const std::string& size) {
  for (const std::size_t count : {1, 16, 64}) {
    const auto list = planes(count);
    const auto counts = in_parallel(points, list);
    for (std::size_t i = 0; i < count; ++i)
      bench::require(counts[i] == plain(structures, list[i]), "plane_score: counts differ from the plain loop's");
    std::vector<std::uint32_t> blocked(count);
    bench::blocked_loop(points.points, list, kDistance, blocked);
    bench::require(blocked == counts, "plane_score: counts differ from the blocked loop's");
    std::uint32_t sink = 0;
    std::vector<bench::Way> ways{
        {"ilot", [&] { sink += in_parallel(points, list)[0]; }},
        {"float, blocks of arrays", [&] { bench::blocked_loop(points.points, list, kDistance, blocked); }},
        {"double, array of structures", [&] {
           for (const auto& h : list) sink += plain(structures, h);
         }}};
    const double items = static_cast<double>(points.points.size * count) / 1e9;
    bench::compare({"plane_score", std::to_string(count) + " planes, " + size, 1, items, "G point-planes"}, ways);
    bench::require(sink != 1, "");
  }
}

// The ratio of the ceiling is the share of it that we reach.
void against_ceiling(const OrientedPoints& points, const std::string& size, int threads) {
  const auto list = planes(16);
  const double items = static_cast<double>(points.points.size * list.size());
  bench::compare({"plane_score", "16 planes beside the register loop, " + size, threads, items / 1e9, "G point-planes"},
                 {{"ilot", [&] { in_parallel(points, list); }}, {"ceiling", [&] { bench::score_loop(items); }}});
}

}  // namespace

int main(int argc, char** argv) {
  for (const double millions : bench::numbers(argc, argv, {1})) {
    const bench::Surface surface = bench::make_surface(static_cast<std::size_t>(millions * 1e6));
    const Points points = surface.view();
    std::vector<Vec3> structures;
    for (std::size_t i = 0; i < points.size; ++i) structures.push_back({points.x[i], points.y[i], points.z[i]});
    const std::string size = bench::in_millions(millions);
    against_plain_loop({points}, structures, size);
    const Normals n{std::vector<float>(points.size + 16, 0.0f), std::vector<float>(points.size + 16, 0.0f),
                    std::vector<float>(points.size + 16, 1.0f)};
    const OrientedPoints oriented{points, n.x.data(), n.y.data(), n.z.data()};
    for (const int threads : {1, 2}) against_ceiling({points}, size, threads);
    bench::scaling({.kernel = "plane_score", .variant = "16 planes, " + size},
                   [&] { in_parallel({points}, planes(16)); });
    bench::scaling({.kernel = "plane_score", .variant = "16 planes with normals, " + size},
                   [&] { in_parallel(oriented, planes(16)); });
  }
}
