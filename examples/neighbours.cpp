// SPDX-License-Identifier: Apache-2.0
// The normals and the nearest neighbours of the points of a cloud.
// Usage: neighbours CLOUD
#include <ilot/clouds.h>
#include <ilot/error.h>
#include <ilot/neighbours.h>

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
  const ilot::NeighbourTable near = ilot::nearest_neighbours(points.places(), {.count = 8});
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) sum += near.distance[8 * i + 1];
  std::printf("mean distance to the nearest other point: %.3f m\n", sum / static_cast<double>(points.size()));

  const ilot::NormalArrays normals = ilot::estimate_normals(points.places(), {.count = 16, .max_distance = 1});
  std::size_t level = 0;
  for (const float z : normals.z) level += z > 0.98f;
  std::printf("%zu of %zu points lie level\n", level, points.size());
  return level > 0 && level < points.size() ? 0 : 1;
} catch (const ilot::Error& fault) {
  std::fprintf(stderr, "%s\n", fault.what());
  return static_cast<int>(fault.code());
}
