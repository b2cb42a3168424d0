// SPDX-License-Identifier: Apache-2.0
// An image of a cloud from above, and how far things rise above what is around them.
// Usage: rasters CLOUD
#include <ilot/clouds.h>
#include <ilot/error.h>
#include <ilot/rasters.h>

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
  const ilot::Raster top = ilot::raster_of_points(points.places(), 0.25, ilot::PixelValue::highest);
  const ilot::Raster closed = ilot::fill_short_gaps(top, 4, 0.2);

  // Everything that is cut off when the ground may rise from the border of the image alone.
  ilot::Raster border = closed;
  for (std::uint32_t row = 1; row + 1 < border.height; ++row)
    for (std::uint32_t column = 1; column + 1 < border.width; ++column)
      border.values[row * border.width + column] = -1000;
  const ilot::Raster ground = ilot::reconstruct_by_dilation(border, closed, ilot::Adjacency::eight);
  double highest = 0;
  for (std::size_t i = 0; i < closed.values.size(); ++i)
    if (!std::isnan(closed.values[i])) highest = std::max(highest, closed.values[i] - ground.values[i]);
  std::printf("%u x %u pixels; up to %.2f m above the ground\n", top.width, top.height, highest);
  return highest > 7 && highest < 9 ? 0 : 1;
} catch (const ilot::Error& fault) {
  std::fprintf(stderr, "%s\n", fault.what());
  return static_cast<int>(fault.code());
}
