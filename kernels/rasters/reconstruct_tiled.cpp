// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/reconstruct_tiled.h"

#include <numeric>
#include <vector>

#include "kernels/rasters/border_pixels.h"
#include "kernels/rasters/radix_heap.h"
#include "kernels/rasters/reconstruct.h"
#include "kernels/rasters/tiles.h"

namespace ilot {
namespace {

constexpr std::uint32_t kBytesPerPixel = 64;  // of a tile that tells: marker, mask, the flood of its spills

// What a tile tells of its border: heights of the mask, what the tile's own marker reaches, and the spills between.
struct Border {
  std::vector<Height> mask, reached;
  std::vector<SpillEdge> spills;
};

// Marker and mask of one tile.
struct TileImages {
  Image marker, mask;
};
using ReadImages = std::function<TileImages(std::size_t tile)>;

std::vector<Height> border_of(const Image& image) {
  const Perimeter perimeter{image.width, image.height};
  std::vector<Height> out(perimeter.size());
  for (std::uint32_t i = 0; i < out.size(); ++i) {
    const auto [x, y] = perimeter.place(i);
    out[i] = image.values[std::size_t{y} * image.width + x];
  }
  return out;
}

bool silent_inside(const Image& marker) {
  for (std::uint32_t y = 1; y + 1 < marker.height; ++y) {
    const Height* row = marker.values.data() + std::size_t{y} * marker.width;
    for (std::uint32_t x = 1; x + 1 < marker.width; ++x)
      if (row[x] != kAboveAll) return false;
  }
  return true;
}

// From the marker's border alone the spills go on; what it says inside has to be carried to the border first.
Border told_by(const TileImages& tile, Adjacency adjacency) {
  Border border{border_of(tile.mask), {}, spill_tree(tile.mask, adjacency)};
  border.reached =
      border_of(silent_inside(tile.marker) ? tile.marker : reconstruct_by_erosion(tile.marker, tile.mask, adjacency));
  for (std::size_t i = 0; i < border.mask.size(); ++i) border.reached[i] = std::max(border.reached[i], border.mask[i]);
  return border;
}

// The pixels of all borders as one list, tile after tile.
class BorderGraph {
 public:
  BorderGraph(const TileGrid& grid, std::vector<Border> borders) : pixels_(grid) {
    for (Border& border : borders) {
      mask_.insert(mask_.end(), border.mask.begin(), border.mask.end());
      reached_.insert(reached_.end(), border.reached.begin(), border.reached.end());
    }
    link_spills(borders);
  }

  // Lowers what each pixel is reached at to what reaches it from any tile.
  void settle(Adjacency adjacency) {
    RadixHeap queue;
    for (std::uint32_t p = 0; p < reached_.size(); ++p)
      if (reached_[p] != kAboveAll) queue.push(reached_[p], p);
    while (!queue.empty()) {
      const RadixHeap::Item item = queue.pop();
      const Height v = item.height();
      if (reached_[item.pixel] != v) continue;  // lowered since
      const auto lower = [&](std::uint32_t q, Height through) {
        if (through >= reached_[q]) return;
        reached_[q] = through;
        queue.push(through, q);
      };
      for (std::size_t l = links_from_[item.pixel]; l < links_from_[item.pixel + 1]; ++l)
        lower(links_[l].to, std::max(v, links_[l].height));
      pixels_.for_beyond(item.pixel, adjacency, [&](std::uint32_t q) { lower(q, std::max(v, mask_[q])); });
    }
  }

  Height reached(std::size_t tile, std::uint32_t index) const { return reached_[pixels_.first(tile) + index]; }

 private:
  struct Link {
    std::uint32_t to;
    Height height;
  };

  void link_spills(const std::vector<Border>& borders) {
    links_from_.assign(mask_.size() + 1, 0);
    for (std::size_t t = 0; t < borders.size(); ++t) {
      for (const SpillEdge& e : borders[t].spills) {
        ++links_from_[pixels_.first(t) + e.a + 1];
        ++links_from_[pixels_.first(t) + e.b + 1];
      }
    }
    std::partial_sum(links_from_.begin(), links_from_.end(), links_from_.begin());
    links_.resize(links_from_.back());
    auto at = links_from_;
    for (std::size_t t = 0; t < borders.size(); ++t) {
      for (const SpillEdge& e : borders[t].spills) {
        const std::uint32_t a = pixels_.first(t) + e.a, b = pixels_.first(t) + e.b;
        links_[at[a]++] = {b, e.height};
        links_[at[b]++] = {a, e.height};
      }
    }
  }

  BorderPixels pixels_;
  std::vector<Height> mask_, reached_;
  std::vector<std::size_t> links_from_;
  std::vector<Link> links_;
};

// The marker of a tile, and on its border what comes in from the others.
Image with_border(Image marker, const BorderGraph& graph, std::size_t tile) {
  const Perimeter perimeter{marker.width, marker.height};
  for (std::uint32_t i = 0; i < perimeter.size(); ++i) {
    const auto [x, y] = perimeter.place(i);
    Height& v = marker.values[std::size_t{y} * marker.width + x];
    v = std::min(v, graph.reached(tile, i));
  }
  return marker;
}

// The image on the border of the whole, above all inside.
Image border_marker(const TileGrid& grid, std::size_t tile, Image image) {
  const TileFrame frame = tile_frame(grid, tile);
  for (std::uint32_t y = 0; y < frame.height; ++y) {
    for (std::uint32_t x = 0; x < frame.width; ++x) {
      const bool inside = x > 0 && y > 0 && x + 1 < frame.width && y + 1 < frame.height;
      if (inside || !grid.ends_at(frame.x + x, frame.y + y)) image.values[std::size_t{y} * frame.width + x] = kAboveAll;
    }
  }
  return image;
}

Image turned_over(Image image) {
  for (Height& v : image.values) v = ~v;
  return image;
}

void settle_tiles(const TileGrid& grid, Adjacency adjacency, const ReadImages& read, const WriteTile& write) {
  std::vector<Border> borders(grid.count());
  for_each_tile(grid, [&](std::size_t tile) { borders[tile] = told_by(read(tile), adjacency); }, {kBytesPerPixel, 0});
  BorderGraph graph(grid, std::move(borders));
  graph.settle(adjacency);
  for_each_tile(grid, [&](std::size_t tile) {
    TileImages images = read(tile);
    write(tile, reconstruct_by_erosion(with_border(std::move(images.marker), graph, tile), images.mask, adjacency));
  });
}

}  // namespace

void reconstruct_by_erosion_tiled(const TileGrid& grid, Adjacency adjacency, const ReadTile& read_marker,
                                  const ReadTile& read_mask, const WriteTile& write) {
  const auto read = [&](std::size_t tile) { return TileImages{read_marker(tile), read_mask(tile)}; };
  settle_tiles(grid, adjacency, read, write);
}

void reconstruct_by_dilation_tiled(const TileGrid& grid, Adjacency adjacency, const ReadTile& read_marker,
                                   const ReadTile& read_mask, const WriteTile& write) {
  const auto read = [&](std::size_t tile) {
    return TileImages{turned_over(read_marker(tile)), turned_over(read_mask(tile))};
  };
  settle_tiles(grid, adjacency, read, [&](std::size_t tile, const Image& image) { write(tile, turned_over(image)); });
}

void fill_holes_tiled(const TileGrid& grid, Adjacency adjacency, const ReadTile& read, const WriteTile& write) {
  const auto both = [&](std::size_t tile) {
    Image mask = read(tile);
    return TileImages{border_marker(grid, tile, mask), std::move(mask)};
  };
  settle_tiles(grid, adjacency, both, write);
}

}  // namespace ilot
