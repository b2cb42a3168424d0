// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/ground/street_mask.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <span>

#include "engine/products/streets/ground/standing_form.h"
#include "kernels/rasters/box_minimum.h"

namespace ilot {
namespace {

// Derived: ground of 35 % rises by so much over the three cells that are compared.
constexpr double kSlopeOfCells = 1;  // metres a metre of a cell's side

// Derived: the same for ground of 12 %. There a car along the slope is filled to its lower end only.
constexpr double kSteepOfCells = 0.36;  // metres a metre of a cell's side

// Choice: where a cloud is cut low, a pixel of a wall has few points, and its highest is below the cut.
constexpr Height kQuartersOfTop = 3;  // quarters of the highest point of a cell

bool is_building(Height structure) {
  return structure == static_cast<Height>(Structure::wall) || structure == static_cast<Height>(Structure::roof);
}

// What a pixel is: a part of a building, what may be fixed to one, a high filling without a point, or the rest.
enum class Part : std::uint8_t { other, building, loose, unseen };

// The highest of the terrain in a pixel's cell and its eight neighbours would hide low walls: the cell's own counts.
Image parts_around(const TileLayers& layers, const Cells& cells, std::size_t tile, std::uint32_t halo,
                   const StreetMaskParams& params) {
  const Height high = cells.scale.units(params.building_height), low = cells.scale.units(params.on_ground);
  const std::uint32_t f = cells.factor, cell_halo = (halo + f - 1) / f;
  Image filled = layer_around(layers, "filled", tile, halo);
  const Image range = layer_around(layers, "range", tile, halo);
  const Image terrain = layer_around(cells.layers, "terrain", tile, cell_halo),
              structure = layer_around(cells.layers, "structure", tile, cell_halo),
              top = layer_around(cells.layers, "top", tile, cell_halo);
  const std::uint32_t offset = cell_halo * f - halo;
  const int of_cell = std::countr_zero(f);
  for (std::uint32_t y = 0; y < filled.height; ++y)
    for (std::uint32_t x = 0; x < filled.width; ++x) {
      const std::size_t i = std::size_t{y} * filled.width + x;
      const std::size_t cell = std::size_t{(y + offset) >> of_cell} * terrain.width + ((x + offset) >> of_cell);
      Part part = Part::other;
      if (filled.values[i] != kNoHeight && terrain.values[cell] != kNoHeight) {
        const Height above = filled.values[i] - terrain.values[cell];
        if (is_building(structure.values[cell]) && above >= std::min(high, kQuartersOfTop * top.values[cell] / 4))
          part = Part::building;
        else if (above >= high && range.values[i] == kNoHeight)
          part = Part::unseen;
        else if (above >= low)
          part = Part::loose;
      }
      filled.values[i] = static_cast<Height>(part);
    }
  return filled;
}

// The highest of each pixel and its eight neighbours, for pixels inside the image.
Image box_maximum_within(Image image) {
  for (Height& v : image.values) v = v == kNoHeight ? v : -v;
  image = box_minimum_within(image, 1);
  for (Height& v : image.values) v = v == kNoHeight ? v : -v;
  return image;
}

// Whether a pixel of a building is within `reach` along rows and columns.
bool near_building(const Image& parts, std::size_t x, std::size_t y, std::size_t reach) {
  for (std::size_t v = y - reach; v <= y + reach; ++v)
    for (std::size_t u = x - reach; u <= x + reach; ++u)
      if (parts.values[v * parts.width + u] == static_cast<Height>(Part::building)) return true;
  return false;
}

// The heights of cells between which those of a row of pixels lie.
struct CellRows {
  const Height* upper = nullptr;  // of the row of cells whose middles are above the pixels; the next row follows
  const Height* own = nullptr;    // of the row of cells in which the pixels are, from the first of these on
  std::uint32_t width = 0;        // cells of a row
  std::int64_t dy = 0;            // halves of a pixel, from the middles of the upper row
};

// Heights of a row of pixels between the four nearest middles of cells of `f` pixels. Where one of these is unknown it
// is the height of the pixel's own cell. Between two middles the weighted sum grows by the same amount each pixel.
void interpolate(const CellRows& rows, std::uint32_t f, std::span<Height> to) {
  const int shift = std::countr_zero(f);
  const std::int64_t side = 2 * std::int64_t{f}, dy = rows.dy;
  const Height* lower = rows.upper + rows.width;
  for (std::uint32_t x = 0; x < to.size();) {
    const std::uint32_t u = 2 * x + 1 + f, j = u >> (shift + 1);
    const std::uint32_t end = std::min(static_cast<std::uint32_t>(to.size()), f * (j + 1) - (f + 1) / 2);
    const Height *a = rows.upper + j, *c = lower + j;
    const bool known = a[0] != kNoHeight && a[1] != kNoHeight && c[0] != kNoHeight && c[1] != kNoHeight;
    const std::int64_t left = (side - dy) * a[0] + dy * c[0], right = (side - dy) * a[1] + dy * c[1];
    const std::int64_t dx = u & (side - 1), step = 2 * (right - left);
    std::int64_t sum = (side - dx) * left + dx * right;
    for (; x < end; ++x, sum += step)
      to[x] = known ? static_cast<Height>(sum >> (2 * (shift + 1))) : rows.own[x >> shift];
  }
}

}  // namespace

void find_street_mask(const TileLayers& layers, const Cells& cells, const StreetMaskParams& params) {
  const std::uint32_t reach =
      cells.factor >= 4 ? static_cast<std::uint32_t>(params.fixed_reach / (cells.scale.pixel / cells.factor)) : 0;
  for_each_tile(layers.grid,
                [&](std::size_t tile) {
                  const TileFrame frame = tile_frame(layers.grid, tile);
                  const Image parts = parts_around(layers, cells, tile, reach, params),
                              filled = layer_tile(layers, "filled", tile);
                  Image mask = filled_image(frame.width, frame.height, 0);
                  for (std::uint32_t y = 0; y < mask.height; ++y)
                    for (std::uint32_t x = 0; x < mask.width; ++x) {
                      const std::size_t i = std::size_t{y} * mask.width + x;
                      const auto part =
                          static_cast<Part>(parts.values[(std::size_t{y} + reach) * parts.width + x + reach]);
                      const bool fixed = part == Part::building || part == Part::unseen ||
                                         (part == Part::loose && near_building(parts, x + reach, y + reach, reach));
                      mask.values[i] = filled.values[i] != kNoHeight && !fixed;
                    }
                  layers.write("mask", tile, mask);
                  layers.write("foot", tile, terrain_of_pixels(cells, tile, 0));
                },
                {24, reach});
  cells.layers.drop("top");
}

void put_on_terrain(const TileLayers& layers, const Cells& cells, double farthest, double least_height) {
  const Height far = cells.scale.units(farthest), least = cells.scale.units(least_height);
  const Height slope = cells.scale.units(kSteepOfCells * cells.scale.pixel);
  const Height step = std::max(far, cells.scale.units(kSlopeOfCells * cells.scale.pixel));
  for_each_tile(layers.grid, [&](std::size_t tile) {
    const Image terrain = terrain_of_pixels(cells, tile, 0), filled = layer_tile(layers, "filled", tile),
                mask = layer_tile(layers, "mask", tile);
    const Image around = layer_around(cells.layers, "terrain", tile, 1), lowest = box_minimum_within(around, 1),
                highest = box_maximum_within(around);
    Image bare = layer_tile(layers, "bare", tile), height = layer_tile(layers, "height", tile);
    for (std::size_t i = 0; i < bare.size(); ++i) {
      if (mask.values[i] != 1 || terrain.values[i] == kNoHeight) continue;
      const std::size_t cell = cells.cell_of(i, bare.width);
      // At a step of the ground, what is no higher than the upper side is ground.
      const bool at_step = highest.values[cell] - lowest.values[cell] > step;
      if (at_step && filled.values[i] <= highest.values[cell] + least)
        bare.values[i] = filled.values[i];
      else if (std::abs(bare.values[i] - terrain.values[i]) > far ||
               (height.values[i] != kNoHeight && highest.values[cell] - lowest.values[cell] > slope))
        bare.values[i] = std::min(terrain.values[i], filled.values[i]);
      else
        continue;
      const Height above = filled.values[i] - bare.values[i];
      height.values[i] = above < least ? kNoHeight : above;
    }
    layers.write("bare", tile, bare);
    layers.write("height", tile, height);
  });
}

Image terrain_of_pixels(const Cells& cells, std::size_t tile, std::uint32_t halo) {
  const std::uint32_t f = cells.factor, cell_halo = (halo + f - 1) / f;
  const Image around = layer_around(cells.layers, "terrain", tile, cell_halo + 1);
  Image out = filled_image((around.width - 2) * f, (around.height - 2) * f, kNoHeight);
  // Positions are halves of a pixel from the middle of the first cell; a cell is a power of two of them.
  const int shift = std::countr_zero(f) + 1;
  const std::uint32_t side = 2 * f;
  for (std::uint32_t y = 0; y < out.height; ++y) {
    const std::uint32_t v = 2 * y + 1 + f;
    const CellRows rows{around.values.data() + std::size_t{v >> shift} * around.width,
                        around.values.data() + (std::size_t{y >> (shift - 1)} + 1) * around.width + 1, around.width,
                        v & (side - 1)};
    interpolate(rows, f, std::span(out.values).subspan(std::size_t{y} * out.width, out.width));
  }
  return cell_halo * f == halo ? out : without_halo(out, cell_halo * f - halo);
}

}  // namespace ilot
