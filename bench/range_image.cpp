// SPDX-License-Identifier: Apache-2.0
// Range and accumulation images at one and at sixteen points a pixel beside the loop that one writes first: an array of
// points in metres, a division and a floor per axis. Pixels must be equal before any timing; as a share of copying the
// points.
#include "kernels/rasters/range_image.h"

#include <cmath>
#include <limits>

#include "bench/compare.h"
#include "bench/surface.h"

namespace {

using namespace ilot;

struct Pixel {
  std::uint32_t count = 0;
  double high = -std::numeric_limits<double>::infinity();
};

std::vector<Pixel> plain(const std::vector<Vec3>& points, const GridFrame& frame) {
  std::vector<Pixel> pixels(frame.size());
  for (const Vec3& p : points) {
    const double column = std::floor((p.x - static_cast<double>(frame.x)) / static_cast<double>(frame.pixel));
    const double row = std::floor((p.y - static_cast<double>(frame.y)) / static_cast<double>(frame.pixel));
    if (column < 0 || row < 0 || column >= frame.width || row >= frame.height) continue;
    Pixel& pixel = pixels[static_cast<std::size_t>(row) * frame.width + static_cast<std::size_t>(column)];
    ++pixel.count;
    pixel.high = std::max(pixel.high, p.z);
  }
  return pixels;
}

std::vector<float> copied(Points points) {
  std::vector<float> out(points.size * 3);
  std::copy_n(points.x, points.size, out.data());
  std::copy_n(points.y, points.size, out.data() + points.size);
  std::copy_n(points.z, points.size, out.data() + 2 * points.size);
  asm volatile("" : : "r"(out.data()) : "memory");
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  for (const double millions : bench::numbers(argc, argv, {1})) {
    const bench::Surface surface = bench::make_surface(static_cast<std::size_t>(millions * 1e6));
    const Points p = surface.view();
    std::vector<Vec3> structures;
    for (std::size_t i = 0; i < p.size; ++i) structures.push_back({p.x[i], p.y[i], p.z[i]});
    // 12 points a square metre: 300 mm is about one point a pixel, as 50 mm is in a street.
    for (const auto& [name, pixel] :
         {std::pair<std::string, std::int64_t>{"1 point a pixel, ", 300}, {"16 points a pixel, ", 1200}}) {
      const GridFrame frame = frame_of(p, pixel);
      const RangeImage got = range_image(p, frame);
      const std::vector<Pixel> want = plain(structures, frame);
      for (std::size_t i = 0; i < want.size(); ++i)
        bench::require(got.accumulation[i] == want[i].count &&
                           (want[i].count == 0 || got.range.values[i] == static_cast<Height>(want[i].high)),
                       "range_image: pixels differ from the plain loop's");
      bench::compare({"range_image", name + bench::in_millions(millions), 1, millions, "M points"},
                     {{"ilot", [&] { range_image(p, frame); }},
                      {"double, array of structures", [&] { plain(structures, frame); }},
                      {"ceiling", [&] { copied(p); }}});
    }
  }
}
