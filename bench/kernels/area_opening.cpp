// SPDX-License-Identifier: Apache-2.0
// Area opening of 50 pixels of the filled range image of a street. It is compared with the published union-find
// (Meijster, Wilkinson 2002) over std::sort, and given as a share of copying. Values must be equal before any timing.
#include "kernels/morphology/area_opening.h"

#include <numeric>

#include "bench/compare.h"
#include "bench/image_copy.h"
#include "bench/street_image.h"
#include "tests/oracles/whole_fill.h"

namespace {

using namespace ilot;

constexpr std::uint32_t kArea = 50;

struct Published {
  const Image& f;
  std::vector<std::int64_t> parent = std::vector<std::int64_t>(f.size(), 0);  // for roots: minus the area

  std::size_t root(std::size_t i) {
    if (parent[i] < 0) return i;
    const std::size_t r = root(static_cast<std::size_t>(parent[i]));
    parent[i] = static_cast<std::int64_t>(r);
    return r;
  }
  void join(std::size_t n, std::size_t p) {
    const std::size_t r = root(n);
    if (r == p) return;
    if (f.values[r] == f.values[p] || -parent[r] < kArea) {
      parent[p] += parent[r];
      parent[r] = static_cast<std::int64_t>(p);
    } else {
      parent[p] = -std::int64_t{kArea};
    }
  }
};

Image published(const Image& f) {
  std::vector<std::uint32_t> order(f.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return f.values[a] != f.values[b] ? f.values[a] > f.values[b] : a < b;
  });
  Published sets{f};
  std::vector<std::uint8_t> seen(f.size(), 0);
  const auto w = static_cast<std::int64_t>(f.width), h = static_cast<std::int64_t>(f.height);
  for (const std::uint32_t p : order) {
    sets.parent[p] = -1;
    seen[p] = 1;
    const std::int64_t x = p % w, y = p / w;
    for (std::int64_t qy = std::max<std::int64_t>(y - 1, 0); qy <= std::min(y + 1, h - 1); ++qy)
      for (std::int64_t qx = std::max<std::int64_t>(x - 1, 0); qx <= std::min(x + 1, w - 1); ++qx)
        if (const auto q = static_cast<std::size_t>(qy * w + qx); seen[q] != 0) sets.join(q, p);
  }
  Image out = f;
  for (std::size_t i = order.size(); i-- > 0;) {
    const std::uint32_t p = order[i];
    if (sets.parent[p] >= 0) out.values[p] = out.values[static_cast<std::size_t>(sets.parent[p])];
  }
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  for (const double millions : bench::numbers(argc, argv, {4})) {
    const Image street = test::fill_missing(
        test::fill_holes(bench::make_street_image(static_cast<std::size_t>(millions * 1e6)), Adjacency::eight));
    bench::require(area_opening(street, kArea, Adjacency::eight).values == published(street).values,
                   "area_opening: differs from the published union-find");
    bench::compare({"area_opening", "50 pixels, street, " + bench::in_megapixels(millions), 1, millions, "M pixels"},
                   {{"ilot", [&] { area_opening(street, kArea, Adjacency::eight); }},
                    {"published, std::sort", [&] { published(street); }},
                    {"ceiling", [&] { bench::copied(street); }}});
  }
}
