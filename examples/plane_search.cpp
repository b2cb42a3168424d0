// SPDX-License-Identifier: Apache-2.0
// The planes of a small cloud, in memory.
// Usage: plane_search CLOUD
#include <ilot/clouds.h>
#include <ilot/error.h>
#include <ilot/plane_search.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

// All points of a small cloud.
static ilot::PointColumns read_all(const char* path) {
  ilot::CloudFile cloud(path);
  ilot::PointColumns points;
  cloud.read(0, cloud.description().points, points);
  return points;
}

int main(int argc, char** argv) try {
  if (argc < 2) return 2;
  const ilot::PointColumns points = read_all(argv[1]);
  const ilot::PlaneSearchResult found = ilot::find_planes(points.places(), {.epsilon = 0.03, .min_points = 100});
  std::printf("%zu planes, %g m between lattice points\n", found.segments.planes.size(), found.step);
  double farthest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::uint32_t label = found.segments.label[i];
    if (label == 0) continue;
    const ilot::Plane& plane = found.segments.planes[label - 1];
    farthest = std::max(farthest, std::abs(ilot::signed_distance(plane, {points.x[i], points.y[i], points.z[i]})));
  }
  std::printf("no labelled point is farther than %.4f m from its plane\n", farthest);
  return found.segments.planes.size() >= 7 && farthest <= found.epsilon ? 0 : 1;
} catch (const ilot::Error& fault) {
  std::fprintf(stderr, "%s\n", fault.what());
  return static_cast<int>(fault.code());
}
