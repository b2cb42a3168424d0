// SPDX-License-Identifier: Apache-2.0
// The part of a cloud above the ground, parted where there are gaps.
// Usage: clusters CLOUD
#include <ilot/clouds.h>
#include <ilot/clusters.h>
#include <ilot/error.h>

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
  std::vector<double> x, y, z;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points.z[i] < 0.5) continue;
    x.push_back(points.x[i]);
    y.push_back(points.y[i]);
    z.push_back(points.z[i]);
  }
  const ilot::Clusters clusters = ilot::euclidean_clusters({x, y, z}, 0.5);
  std::vector<std::size_t> size(clusters.count);
  for (const std::uint32_t id : clusters.id) ++size[id];
  for (std::size_t id = 0; id < size.size(); ++id) std::printf("cluster %zu: %zu points\n", id, size[id]);
  return clusters.count == 2 ? 0 : 1;
} catch (const ilot::Error& fault) {
  std::fprintf(stderr, "%s\n", fault.what());
  return static_cast<int>(fault.code());
}
