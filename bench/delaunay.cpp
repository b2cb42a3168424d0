// SPDX-License-Identifier: Apache-2.0
// Delaunay triangulations and alpha shapes of points seen from above, beside other libraries where they were built in.
// Rounds take turns; what counts is the median of the ratios within a round. Numbers of triangles must be equal before.
// Usage: bench_delaunay [MILLIONS [ROUNDS]]
#include "kernels/delaunay/delaunay.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "bench/peers/delaunay.h"
#include "bench/surface.h"
#include "kernels/core/parallel.h"
#include "kernels/delaunay/alpha_shape.h"

namespace {

using namespace ilot;

struct Set {
  const char* name;
  std::vector<Point2> points;
  float reach;  // lattice units
};

// A town from the air in Morton order, at 1 mm; the same points in no order; the lattice of a raster.
std::vector<Set> sets(std::size_t n) {
  const bench::Surface s = bench::make_surface(n);
  Set town{"town", {}, 600}, shuffled{"shuffled town", {}, 600}, lattice{"lattice", {}, 400};
  for (std::size_t i = 0; i < n; ++i)
    town.points.push_back({static_cast<std::int32_t>(s.x[i]), static_cast<std::int32_t>(s.y[i])});
  shuffled.points = town.points;
  Rng rng(2);
  for (std::size_t i = n; i > 1; --i) std::swap(shuffled.points[i - 1], shuffled.points[rng.below(i)]);
  const auto columns = static_cast<std::int32_t>(std::sqrt(static_cast<double>(n)));
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(n); ++i)
    lattice.points.push_back({i % columns * 500, i / columns * 500});
  return {town, shuffled, lattice};
}

double seconds(const std::function<void()>& run) {
  const auto start = std::chrono::steady_clock::now();
  run();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> v) {
  std::sort(v.begin(), v.end());
  return v[v.size() / 2];
}

void compare(const char* set, const char* what, int rounds, const std::function<void()>& ours, const char* other,
             const std::function<void()>& theirs) {
  std::vector<double> mine, ratios;
  for (int i = 0; i < rounds; ++i) {
    mine.push_back(seconds(ours));
    ratios.push_back(seconds(theirs) / mine.back());
  }
  std::printf("%-14s %-12s ilot %.3f s, %s takes %.2f times as long\n", set, what, median(mine), other, median(ratios));
  std::fflush(stdout);
}

std::size_t shape_size(const Set& set) {
  const Triangulation t = delaunay(set.points);
  const std::vector<float> reach(set.points.size(), set.reach);
  const auto keep = shape_triangles(t, set.points, {TriangleRule::kCircumradius, reach});
  return static_cast<std::size_t>(std::count(keep.begin(), keep.end(), 1));
}

void require(std::size_t ours, std::size_t theirs, const std::string& peer) {
  if (ours == theirs) return;
  std::fprintf(stderr, "delaunay: %zu triangles, %s finds %zu\n", ours, peer.c_str(), theirs);
  std::exit(1);
}

void run(const Set& set, int rounds) {
  const auto triangulate = [&] { delaunay(set.points); };
  with_threads(1, [&] {
    for (const auto& peer : bench::delaunay_peers()) {
      require(delaunay(set.points).triangles(), peer.triangles(set.points, 0), peer.name);
      compare(set.name, "Delaunay", rounds, triangulate, peer.name.c_str(), [&] { peer.triangles(set.points, 0); });
    }
    for (const auto& peer : bench::alpha_shape_peers()) {
      require(shape_size(set), peer.triangles(set.points, set.reach), peer.name);
      compare(
          set.name, "alpha shape", peer.slow ? 1 : rounds, [&] { shape_size(set); }, peer.name.c_str(),
          [&] { peer.triangles(set.points, set.reach); });
    }
  });
  compare(
      set.name, "2 threads", rounds, [&] { with_threads(2, triangulate); }, "one thread",
      [&] { with_threads(1, triangulate); });
}

}  // namespace

int main(int argc, char** argv) {
  const double millions = argc > 1 ? std::atof(argv[1]) : 1;
  const int rounds = argc > 2 ? std::max(1, std::atoi(argv[2])) : 5;
  for (const Set& set : sets(static_cast<std::size_t>(millions * 1e6))) run(set, rounds);
}
