// SPDX-License-Identifier: Apache-2.0
// Writes a cloud of a house on a lawn, and reads it back piece by piece.
// Usage: clouds CLOUD
#include <ilot/clouds.h>
#include <ilot/error.h>

#include <cmath>
#include <cstdio>

namespace {

constexpr double kStep = 0.1;                // metres between points
constexpr double kX = 652000, kY = 6862000;  // Lambert 93, Paris

void add(ilot::PointColumns& points, double x, double y, double z, std::uint8_t classification) {
  const double noise = 0.004 * std::sin(1000 * x + 777 * y + 555 * z);  // metres
  points.x.push_back(kX + x);
  points.y.push_back(kY + y);
  points.z.push_back(z + noise);
  points.classification.push_back(classification);
}

// 30 m x 24 m of ground; a house of 10 m x 8 m with a gable roof on it, 5 m to the eaves; a car beside it.
ilot::PointColumns house_and_car() {
  ilot::PointColumns points;
  const auto inside = [](double x, double y) { return x > 10 && x < 20 && y > 8 && y < 16; };
  for (double x = 0; x <= 30; x += kStep)
    for (double y = 0; y <= 24; y += kStep) {
      const bool car = x > 4 && x < 8 && y > 3 && y < 4.7;
      if (inside(x, y)) add(points, x, y, 5 + 0.8 * (4 - std::abs(y - 12)), 6);
      if (!inside(x, y)) add(points, x, y, car ? 1.4 : 0, car ? 1 : 2);
    }
  for (double z = 0; z <= 5; z += kStep) {
    for (double x = 10; x <= 20; x += kStep) {
      add(points, x, 8, z, 6);
      add(points, x, 16, z, 6);
    }
    for (double y = 8; y <= 16; y += kStep) {
      add(points, 10, y, z, 6);
      add(points, 20, y, z, 6);
    }
  }
  return points;
}

}  // namespace

int main(int argc, char** argv) try {
  const std::filesystem::path path = argc > 1 ? argv[1] : "house.laz";
  const ilot::PointColumns made = house_and_car();
  ilot::CloudWriter writer(path, {.crs = "EPSG:2154", .scale = 0.001, .offset = {kX, kY, 0}});
  writer.write(made);
  writer.finish();

  ilot::CloudFile cloud(path);
  std::printf("%s: %s, %s\n", path.c_str(), cloud.description().format.c_str(), cloud.description().crs.name.c_str());
  ilot::PointColumns piece;
  std::uint64_t ground = 0, points = 0;
  constexpr std::uint64_t kRows = 10000;
  for (std::uint64_t at = 0; cloud.read(at, kRows, piece) > 0; at += kRows) {
    points += piece.size();
    for (const std::uint8_t c : piece.classification) ground += c == 2;
  }
  const ilot::CloudMeasure measure = cloud.measure();
  std::printf("%llu points, %llu of them ground; %.1f points per m2\n", static_cast<unsigned long long>(points),
              static_cast<unsigned long long>(ground), measure.density);
  for (const ilot::CloudSuitability& s : cloud.suitability(measure))
    std::printf("  %s: %s, %s\n", s.product.c_str(), s.yes ? "yes" : "no", s.reason.c_str());
  return points == made.size() && measure.points == points ? 0 : 1;
} catch (const ilot::Error& fault) {
  std::fprintf(stderr, "%s\n", fault.what());
  return static_cast<int>(fault.code());
}
