// SPDX-License-Identifier: Apache-2.0
// Reconstruction by dilation, as h-maxima of 10 cm of the range image of a street. It is compared with the published
// hybrid of scans and a plain queue (Vincent 1993). A second image has a corridor that winds through it, where scans
// alone are not sufficient. Values must be equal before any timing. The time is also given as a share of copying.
#include "kernels/morphology/reconstruct.h"

#include <queue>

#include "bench/compare.h"
#include "bench/image_copy.h"
#include "bench/street_image.h"
#include "tests/oracles/whole_fill.h"

namespace {

using namespace ilot;

// One raster scan forward, one back, then a first-in first-out queue. Neighbours are found by comparing bounds.
Image hybrid(const Image& marker, const Image& mask) {
  Image g = marker;
  const auto w = static_cast<std::int64_t>(mask.width), h = static_cast<std::int64_t>(mask.height);
  constexpr int kBefore[4][2] = {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}};
  const auto inside = [&](std::int64_t x, std::int64_t y) { return x >= 0 && y >= 0 && x < w && y < h; };
  const auto raise = [&](std::int64_t x, std::int64_t y, int sign) {
    Height v = g.values[static_cast<std::size_t>(y * w + x)];
    for (const auto& [dx, dy] : kBefore)
      if (inside(x + sign * dx, y + sign * dy))
        v = std::max(v, g.values[static_cast<std::size_t>((y + sign * dy) * w + x + sign * dx)]);
    Height& out = g.values[static_cast<std::size_t>(y * w + x)];
    out = std::min(v, mask.values[static_cast<std::size_t>(y * w + x)]);
  };
  for (std::int64_t y = 0; y < h; ++y)
    for (std::int64_t x = 0; x < w; ++x) raise(x, y, 1);
  std::queue<std::int64_t> open;
  for (std::int64_t y = h; y-- > 0;) {
    for (std::int64_t x = w; x-- > 0;) {
      raise(x, y, -1);
      for (const auto& [dx, dy] : kBefore) {
        if (!inside(x - dx, y - dy)) continue;
        const auto q = static_cast<std::size_t>((y - dy) * w + x - dx);
        if (g.values[q] < g.values[static_cast<std::size_t>(y * w + x)] && g.values[q] < mask.values[q]) {
          open.push(y * w + x);
          break;
        }
      }
    }
  }
  while (!open.empty()) {
    const std::int64_t p = open.front(), x = p % w, y = p / w;
    open.pop();
    const Height v = g.values[static_cast<std::size_t>(p)];
    for (std::int64_t qy = y - 1; qy <= y + 1; ++qy) {
      for (std::int64_t qx = x - 1; qx <= x + 1; ++qx) {
        if (!inside(qx, qy)) continue;
        const auto q = static_cast<std::size_t>(qy * w + qx);
        if (g.values[q] >= v || g.values[q] == mask.values[q]) continue;
        g.values[q] = std::min(v, mask.values[q]);
        open.push(qy * w + qx);
      }
    }
  }
  return g;
}

// Rows of height 9 between walls of 0, joined at alternate ends. The marker is 9 where the corridor starts.
Image corridor(std::uint32_t side) {
  Image image = filled_image(side, side, 0);
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x)
      if (y % 2 == 0 || x == (y % 4 == 1 ? side - 1 : 0)) image.values[std::size_t{y} * side + x] = 9;
  return image;
}

void against_hybrid(const std::string& name, const Image& marker, const Image& mask) {
  bench::require(reconstruct_by_dilation(marker, mask, Adjacency::eight).values == hybrid(marker, mask).values,
                 "reconstruct: differs from the published hybrid");
  bench::compare({"reconstruct", name, 1, static_cast<double>(mask.size()) / 1e6, "M pixels"},
                 {{"ilot", [&] { reconstruct_by_dilation(marker, mask, Adjacency::eight); }},
                  {"scans and plain queue", [&] { hybrid(marker, mask); }},
                  {"ceiling", [&] { bench::copied(mask); }}});
}

}  // namespace

int main(int argc, char** argv) {
  for (const double millions : bench::numbers(argc, argv, {4})) {
    const std::string size = bench::in_megapixels(millions);
    const Image mask = test::fill_missing(
        test::fill_holes(bench::make_street_image(static_cast<std::size_t>(millions * 1e6)), Adjacency::eight));
    Image marker = mask;
    for (Height& v : marker.values)
      if (v != kNoHeight) v -= 100;
    against_hybrid("h = 100 mm, street, " + size, marker, mask);
  }
  const Image mask = corridor(2000);
  Image marker = filled_image(2000, 2000, 0);
  marker.values[0] = 9;
  against_hybrid("winding corridor, 4 M pixels", marker, mask);
}
