// SPDX-License-Identifier: Apache-2.0
// Fills the holes of the range image of a street, as it is (one pixel in ten is missing) and upside down (objects are
// holes then). It is compared with a priority flood (Barnes 2014: std::priority_queue, pits in a plain queue), and
// given as a share of copying. Values must be equal before any timing. Tiles of 512 pixels are compared with the whole
// image.

#include <queue>

#include "bench/compare.h"
#include "bench/image_copy.h"
#include "bench/street_image.h"
#include "kernels/morphology/tiled_filling.h"
#include "tests/oracles/whole_fill.h"

namespace {

using namespace ilot;

Image priority_flood(const Image& image) {
  using Item = std::pair<Height, std::uint32_t>;
  Image out = image;
  std::vector<std::uint8_t> closed(image.size(), 0);
  std::priority_queue<Item, std::vector<Item>, std::greater<>> open;
  std::queue<Item> pit;
  const auto w = static_cast<std::int64_t>(image.width), h = static_cast<std::int64_t>(image.height);
  for (std::int64_t y = 0; y < h; ++y) {
    for (std::int64_t x = 0; x < w; ++x) {
      if (x != 0 && y != 0 && x + 1 != w && y + 1 != h) continue;
      const auto p = static_cast<std::uint32_t>(y * w + x);
      open.emplace(out.values[p], p);
      closed[p] = 1;
    }
  }
  while (!open.empty() || !pit.empty()) {
    const Item item = pit.empty() ? open.top() : pit.front();
    pit.empty() ? open.pop() : pit.pop();
    const std::int64_t x = item.second % image.width, y = item.second / image.width;
    for (std::int64_t qy = std::max<std::int64_t>(y - 1, 0); qy <= std::min(y + 1, h - 1); ++qy) {
      for (std::int64_t qx = std::max<std::int64_t>(x - 1, 0); qx <= std::min(x + 1, w - 1); ++qx) {
        const auto q = static_cast<std::uint32_t>(qy * w + qx);
        if (closed[q] != 0) continue;
        closed[q] = 1;
        if (out.values[q] <= item.first) {
          out.values[q] = item.first;
          pit.emplace(item.first, q);
        } else {
          open.emplace(out.values[q], q);
        }
      }
    }
  }
  return out;
}

Image upside_down(Image image) {
  for (Height& v : image.values)
    if (v != kNoHeight) v = -v;
  return image;
}

// The whole image is in memory, so only the kernel is timed.
Image in_tiles(const Image& image) {
  const TileGrid grid{image.width, image.height, 512};
  Image out = filled_image(image.width, image.height, 0);
  const auto rows = [&grid](std::size_t tile, const auto& copy) {
    const TileFrame frame = tile_frame(grid, tile);
    for (std::uint32_t y = 0; y < frame.height; ++y)
      copy(std::size_t{frame.y + y} * grid.width + frame.x, std::size_t{y} * frame.width, frame.width);
    return frame;
  };
  const auto read = [&](std::size_t tile) {
    const TileFrame frame = tile_frame(grid, tile);
    Image part = filled_image(frame.width, frame.height, 0);
    rows(tile, [&](std::size_t whole, std::size_t at, std::size_t n) {
      std::copy_n(image.values.data() + whole, n, part.values.data() + at);
    });
    return part;
  };
  std::vector<Image> filled(grid.count());
  TiledFilling filling(grid, Adjacency::eight);
  for_each_tile(grid, [&](std::size_t tile) { filled[tile] = filling.fill(tile, read(tile)); });
  filling.join();
  for_each_tile(grid, [&](std::size_t tile) {
    filling.raise(tile, filled[tile]);
    rows(tile, [&](std::size_t whole, std::size_t at, std::size_t n) {
      std::copy_n(filled[tile].values.data() + at, n, out.values.data() + whole);
    });
  });
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  for (const double millions : bench::numbers(argc, argv, {4})) {
    const Image street = bench::make_street_image(static_cast<std::size_t>(millions * 1e6));
    const std::string size = bench::in_megapixels(millions);
    for (const bool over : {false, true}) {
      const Image image = over ? upside_down(test::fill_missing(street)) : street;
      const std::string name = over ? "upside down, " : "street, ";
      const Image want = priority_flood(image);
      bench::require(test::fill_holes(image, Adjacency::eight).values == want.values,
                     "fill: differs from a priority flood");
      bench::require(in_tiles(image).values == want.values, "fill: tiles differ from the whole");
      bench::compare({"fill", name + size, 1, millions, "M pixels"},
                     {{"ilot", [&] { test::fill_holes(image, Adjacency::eight); }},
                      {"ilot, tiles of 512", [&] { in_tiles(image); }},
                      {"priority flood", [&] { priority_flood(image); }},
                      {"ceiling", [&] { bench::copied(image); }}});
    }
    bench::scaling({.kernel = "fill", .variant = "tiles of 512, " + size}, [&] { in_tiles(street); });
  }
}
