// SPDX-License-Identifier: Apache-2.0
// Range and accumulation images of an airborne town beside the loop that one writes first: an array of points in
// metres, a division and a floor per axis, one struct per pixel. Counts and heights must be equal before any timing.
#include "kernels/rasters/grid.h"

#include <cmath>
#include <limits>

#include "bench/compare.h"
#include "bench/surface.h"

namespace {

using namespace ilot;

struct Pixel {
  std::uint32_t count = 0;
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
};

std::vector<Pixel> plain(const std::vector<Vec3>& points, const GridFrame& frame) {
  std::vector<Pixel> pixels(frame.size());
  for (const Vec3& p : points) {
    const double column = std::floor((p.x - static_cast<double>(frame.x)) / static_cast<double>(frame.pixel));
    const double row = std::floor((p.y - static_cast<double>(frame.y)) / static_cast<double>(frame.pixel));
    if (column < 0 || row < 0 || column >= frame.width || row >= frame.height) continue;
    Pixel& pixel = pixels[static_cast<std::size_t>(row) * frame.width + static_cast<std::size_t>(column)];
    ++pixel.count;
    pixel.low = std::min(pixel.low, p.z);
    pixel.high = std::max(pixel.high, p.z);
  }
  return pixels;
}

}  // namespace

int main(int argc, char** argv) {
  for (const double millions : bench::numbers(argc, argv, {1})) {
    const bench::Surface surface = bench::make_surface(static_cast<std::size_t>(millions * 1e6));
    const Points p = surface.view();
    std::vector<Vec3> structures;
    for (std::size_t i = 0; i < p.size; ++i) structures.push_back({p.x[i], p.y[i], p.z[i]});
    const GridFrame frame = frame_of(p, 200);  // 5 pixels a metre
    const GridHeights got = grid_heights(p, frame);
    const std::vector<Pixel> want = plain(structures, frame);
    for (std::size_t i = 0; i < want.size(); ++i) {
      bench::require(got.count[i] == want[i].count && got.low[i] == static_cast<float>(want[i].low) &&
                         got.high[i] == static_cast<float>(want[i].high),
                     "grid: pixels differ from the plain loop's");
    }
    bench::compare({"grid", "5 px/m, " + bench::in_millions(millions), 1, millions, "M points"},
                   {{"ilot", [&] { grid_heights(p, frame); }},
                    {"double, array of structures", [&] { plain(structures, frame); }}});
  }
}
