// SPDX-License-Identifier: Apache-2.0
// Marker-driven watershed of the gradient of the filled range image of a street, from its maxima above 10 cm. It is
// compared with one priority queue by level, step and label, which decides ties by the same rule. Labels must be equal
// before any timing.
#include "kernels/morphology/watershed.h"

#include <queue>
#include <tuple>

#include "bench/compare.h"
#include "bench/image_copy.h"
#include "bench/street_image.h"
#include "kernels/morphology/h_maxima.h"
#include "kernels/rasters/gradient.h"
#include "tests/oracles/whole_fill.h"

namespace {

using namespace ilot;

PixelLabels one_queue(const Image& relief, const PixelLabels& markers) {
  using Item = std::tuple<Height, std::uint32_t, std::uint32_t, std::int64_t>;  // level, step, label, pixel
  std::priority_queue<Item, std::vector<Item>, std::greater<>> open;
  PixelLabels out = markers;
  const auto w = static_cast<std::int64_t>(relief.width), h = static_cast<std::int64_t>(relief.height);
  const auto spread = [&](std::int64_t p, Height level, std::uint32_t step) {
    const std::int64_t x = p % w, y = p / w;
    for (std::int64_t qy = std::max<std::int64_t>(y - 1, 0); qy <= std::min(y + 1, h - 1); ++qy) {
      for (std::int64_t qx = std::max<std::int64_t>(x - 1, 0); qx <= std::min(x + 1, w - 1); ++qx) {
        const std::int64_t q = qy * w + qx;
        const Height height = relief.values[static_cast<std::size_t>(q)];
        if (out.of[static_cast<std::size_t>(q)] != 0 || height == kNoHeight) continue;
        open.emplace(std::max(level, height), height <= level ? step + 1 : 1, out.of[static_cast<std::size_t>(p)], q);
      }
    }
  };
  for (std::size_t p = 0; p < relief.size(); ++p)
    if (markers.of[p] != 0) spread(static_cast<std::int64_t>(p), kNoHeight, 0);
  while (!open.empty()) {
    const auto [level, step, label, p] = open.top();
    open.pop();
    if (out.of[static_cast<std::size_t>(p)] != 0) continue;
    out.of[static_cast<std::size_t>(p)] = label;
    spread(p, level, step);
  }
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  for (const double millions : bench::numbers(argc, argv, {4})) {
    const Image street = test::fill_holes(
        test::fill_missing(bench::make_street_image(static_cast<std::size_t>(millions * 1e6))), Adjacency::eight);
    Image present = street;
    for (Height& v : present.values) v = std::max(v, -100);
    const Image relief = gradient(present, Adjacency::eight);
    const PixelLabels markers = regional_maxima(h_maxima(present, 100, Adjacency::eight), Adjacency::eight);
    bench::require(watershed(relief, markers, Adjacency::eight).of == one_queue(relief, markers).of,
                   "watershed: labels differ from one queue's");
    const std::string size = bench::in_megapixels(millions);
    bench::compare({"watershed", "maxima above 100 mm, street, " + size, 1, millions, "M pixels"},
                   {{"ilot", [&] { watershed(relief, markers, Adjacency::eight); }},
                    {"one priority queue", [&] { one_queue(relief, markers); }},
                    {"ceiling", [&] { bench::copied(relief); }}});
  }
}
