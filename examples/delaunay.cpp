// SPDX-License-Identifier: Apache-2.0
// The outline of what stands above the ground, in plan.
// Usage: delaunay CLOUD
#include <ilot/clouds.h>
#include <ilot/delaunay.h>
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
  std::vector<double> x, y;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points.z[i] < 0.5) continue;
    x.push_back(points.x[i]);
    y.push_back(points.y[i]);
  }
  std::printf("%zu triangles\n", ilot::delaunay(x, y).triangles());
  const ilot::AlphaShape shape = ilot::alpha_shape(x, y, {.reach = 0.3});
  for (const ilot::ShapePolygon& polygon : shape.polygons)
    std::printf("a polygon with %zu corners and %zu holes\n", polygon[0].size(), polygon.size() - 1);
  std::printf("%.2f m2\n", shape.area);
  return shape.polygons.size() == 2 ? 0 : 1;
} catch (const ilot::Error& fault) {
  std::fprintf(stderr, "%s\n", fault.what());
  return static_cast<int>(fault.code());
}
