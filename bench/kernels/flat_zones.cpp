// SPDX-License-Identifier: Apache-2.0
// Lambda-flat zones of the filled range image of a street (1 m, the ground mask) and connected components of its
// objects. They are compared with a simple flood from pixel to pixel. Labels must be equal before any timing.
#include "kernels/morphology/flat_zones.h"

#include <cstdlib>

#include "bench/compare.h"
#include "bench/image_copy.h"
#include "bench/street_image.h"
#include "tests/oracles/whole_fill.h"

namespace {

using namespace ilot;

PixelLabels flooded(const Image& image, Height lambda) {
  PixelLabels labels{image.width, image.height, 0, std::vector<std::uint32_t>(image.size(), 0)};
  const auto w = static_cast<std::int64_t>(image.width), h = static_cast<std::int64_t>(image.height);
  std::vector<std::int64_t> open;
  for (std::size_t start = 0; start < image.size(); ++start) {
    if (image.values[start] == kNoHeight || labels.of[start] != 0) continue;
    labels.of[start] = ++labels.count;
    open.push_back(static_cast<std::int64_t>(start));
    while (!open.empty()) {
      const std::int64_t p = open.back(), x = p % w, y = p / w;
      open.pop_back();
      for (std::int64_t qy = std::max<std::int64_t>(y - 1, 0); qy <= std::min(y + 1, h - 1); ++qy) {
        for (std::int64_t qx = std::max<std::int64_t>(x - 1, 0); qx <= std::min(x + 1, w - 1); ++qx) {
          const auto q = static_cast<std::size_t>(qy * w + qx);
          const Height a = image.values[static_cast<std::size_t>(p)], b = image.values[q];
          if (b == kNoHeight || labels.of[q] != 0 || std::abs(a - b) > lambda) continue;
          labels.of[q] = labels.count;
          open.push_back(qy * w + qx);
        }
      }
    }
  }
  return labels;
}

}  // namespace

int main(int argc, char** argv) {
  for (const double millions : bench::numbers(argc, argv, {4})) {
    const std::string size = bench::in_megapixels(millions);
    const Image street = bench::make_street_image(static_cast<std::size_t>(millions * 1e6));
    const Image filled = test::fill_missing(test::fill_holes(street, Adjacency::eight));
    Image scattered = street;  // one pixel in ten is missing: thousands of small gaps
    for (Height& v : scattered.values) v = v == kNoHeight ? 0 : kNoHeight;
    for (const auto& [name, image, lambda] :
         {std::tuple{"1 m, filled street, ", filled, 1000}, {"components of the gaps, ", scattered, 0}}) {
      const Height within = lambda;
      const Image& of = image;
      bench::require(flat_zones(of, within, Adjacency::eight).of == flooded(of, within).of,
                     "flat_zones: labels differ from the flood's");
      bench::compare({"flat_zones", name + size, 1, millions, "M pixels"},
                     {{"ilot", [&of, within] { flat_zones(of, within, Adjacency::eight); }},
                      {"flood", [&of, within] { flooded(of, within); }},
                      {"ceiling", [&of] { bench::copied(of); }}});
    }
  }
}
