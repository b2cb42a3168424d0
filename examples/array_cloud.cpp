// SPDX-License-Identifier: Apache-2.0
// Planes of points in memory: no cloud is written, and the labels come as an array.
// Usage: array_cloud CLOUD FOLDER
#include <ilot/array_cloud.h>
#include <ilot/clouds.h>
#include <ilot/run.h>

#include <cstdio>

int main(int argc, char** argv) try {
  if (argc != 3) return 2;
  ilot::CloudFile file(argv[1]);  // any source of points will do
  ilot::PointColumns points;
  file.read(0, file.description().points, points);
  ilot::ArrayCloud cloud{.name = "town", .x = points.x, .y = points.y, .z = points.z};
  cloud.classification = points.classification;
  ilot::RunOptions options;
  options.arrays = {cloud};
  options.output = argv[2];
  options.existing = ilot::Existing::overwrite;
  const ilot::RunReport report = ilot::run(options);
  std::printf("%llu of %zu points are labelled, in %s\n", static_cast<unsigned long long>(report.points_labelled),
              points.size(), report.clouds.at(0).c_str());
  return report.points_labelled > 0 && report.clouds.at(0) == "points/town.npy" ? 0 : 1;
} catch (const ilot::Error& fault) {
  std::fprintf(stderr, "%s\n", fault.what());
  return static_cast<int>(fault.code());
}
