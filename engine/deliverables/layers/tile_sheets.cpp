// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/layers/tile_sheets.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "engine/deliverables/layers/raster_mosaic.h"
#include "kernels/core/integers.h"

namespace ilot {
namespace {

constexpr std::int64_t kMostPixels = (std::int64_t{1} << 31) - 1;

}  // namespace

void TileSheets::TileBox::add(const PointWindow& w) {
  first_row = std::min(first_row, w.row), last_row = std::max(last_row, w.row);
  first_column = std::min(first_column, w.column), last_column = std::max(last_column, w.column);
}

TileSheets::TileSheets(const TileRaster& raster, const std::filesystem::path& folder, const Crs& crs)
    : raster_(raster), folder_(folder), crs_(crs) {
  cut();
}

void TileSheets::cut() {
  const auto sheet_of = [](std::int64_t tile) { return floor_divided(tile, kMostTilesOfSheet); };
  std::map<PointWindow, Sheet> by_place;
  for (std::size_t tile = 0; tile < raster_.grid.count(); ++tile) whole_.add(raster_.window(tile));
  const bool one = whole_.rows() <= kMostTilesOfSheet && whole_.columns() <= kMostTilesOfSheet;
  for (std::size_t tile = 0; tile < raster_.grid.count(); ++tile) {
    const PointWindow at = raster_.window(tile);
    Sheet& sheet = by_place[one ? PointWindow{} : PointWindow{sheet_of(at.row), sheet_of(at.column)}];
    sheet.box.add(at);
    sheet.tiles.push_back(tile);
  }
  for (auto& entry : by_place) sheets_.push_back(std::move(entry.second));
}

void TileSheets::write(const SheetLayer& layer) const {
  if (sheets_.size() == 1) {
    write_sheet(layer, sheets_[0], std::string(layer.name) + ".tif");
    return;
  }
  std::vector<MosaicPart> parts;
  for (const Sheet& sheet : sheets_) {
    const std::string name = fmt::format("{}_{}.tif", layer.name, parts.size() + 1);
    write_sheet(layer, sheet, name);
    const RasterPlace place = place_of(sheet.box);
    parts.push_back({name, side() * (sheet.box.first_column - whole_.first_column),
                     side() * (whole_.last_row - sheet.box.last_row), place.width, place.height});
  }
  if (std::max(whole_.rows(), whole_.columns()) * side() <= kMostPixels)
    write_raster_mosaic(folder_ / (std::string(layer.name) + ".vrt"), place_of(whole_), layer.kind, layer.nodata, crs_,
                        parts);
}

RasterPlace TileSheets::place_of(const TileBox& box) const {
  const double units = static_cast<double>(raster_.pixel) * raster_.unit;  // CRS units of a pixel
  const auto at = [&](std::int64_t tile) {
    return static_cast<double>(tile * side()) * static_cast<double>(raster_.pixel) * raster_.unit;
  };
  return {at(box.first_column), at(box.last_row + 1), units, static_cast<std::uint32_t>(box.columns() * side()),
          static_cast<std::uint32_t>(box.rows() * side())};
}

void TileSheets::write_sheet(const SheetLayer& layer, const Sheet& sheet, const std::string& name) const {
  RasterFile file(folder_ / name, place_of(sheet.box), layer.kind, layer.nodata, crs_);
  const std::uint32_t size = raster_.grid.side;
  for (const std::size_t tile : sheet.tiles) {
    const std::vector<float> rows = layer.values(tile);
    std::vector<float> turned(rows.size());
    for (std::size_t y = 0; y < size; ++y)
      std::copy_n(rows.begin() + static_cast<std::ptrdiff_t>(y * size), size,
                  turned.begin() + static_cast<std::ptrdiff_t>((size - 1 - y) * size));
    const PointWindow at = raster_.window(tile);
    file.write(static_cast<std::uint32_t>(at.column - sheet.box.first_column) * size,
               static_cast<std::uint32_t>(sheet.box.last_row - at.row) * size, size, size, turned);
  }
  file.finish();
}

}  // namespace ilot
