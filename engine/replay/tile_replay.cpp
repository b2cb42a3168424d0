// SPDX-License-Identifier: Apache-2.0
#include "engine/replay/tile_replay.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <mutex>
#include <set>

#include "engine/deliverables/layers/raster_file.h"
#include "engine/error.h"
#include "engine/products/streets/street_labels.h"
#include "engine/report/product_files.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

std::string range_of(const TileRaster& raster) {
  PointWindow low = raster.window(0), high = low;
  for (std::size_t t = 1; t < raster.grid.count(); ++t) {
    const PointWindow w = raster.window(t);
    low = {std::min(low.row, w.row), std::min(low.column, w.column)};
    high = {std::max(high.row, w.row), std::max(high.column, w.column)};
  }
  return fmt::format("its {} tiles are in rows {} to {} and columns {} to {}", raster.grid.count(), low.row, high.row,
                     low.column, high.column);
}

std::size_t number_of(const TileRaster& raster, const std::string& id) {
  double x = 0, y = 0;
  long long row = 0, column = 0;
  int end = 0;
  const auto whole = [&] { return static_cast<std::size_t>(end) == id.size(); };
  if (std::sscanf(id.c_str(), "at:%lf,%lf%n", &x, &y, &end) == 2 && whole()) {
    const std::size_t tile = raster.tile_over({std::llround(x / raster.unit), std::llround(y / raster.unit), 0});
    if (tile != kNoTile) return tile;
  } else if (std::sscanf(id.c_str(), "%lld,%lld%n", &row, &column, &end) == 2 && whole()) {
    for (std::size_t t = 0; t < raster.grid.count(); ++t)
      if (raster.window(t) == PointWindow{row, column}) return t;
  } else {
    throw Error("tile:" + id + ": write tile:ROW,COLUMN or tile:at:E,N", ExitCode::usage);
  }
  throw Error("tile:" + id + ": the run's street has no such tile; " + range_of(raster) + " (ilot replay OUT --list)",
              ExitCode::usage);
}

// Finds files of streets/ that differ from those of the run; compares its map of pages and tables too.
void compare_files(const fs::path& run, const fs::path& now, std::vector<std::string>& differences) {
  std::vector<std::string> names = product_files(run);
  for (const std::string& name : product_files(now)) names.push_back(name);
  const std::set<std::string> all(names.begin(), names.end());
  for (const std::string& name : all)
    if (!fs::exists(run / name) || !fs::exists(now / name) || text_of(run / name) != text_of(now / name))
      differences.push_back("streets/" + name + " is not as the run wrote it");
}

// Returns the labels of the run before the new ones replace them in the scratch store.
std::vector<std::vector<StreetLabel>> labels_of(const Store& store) {
  std::vector<std::vector<StreetLabel>> labels;
  for (std::uint32_t b = 0; b < store.blocks().size(); ++b) labels.push_back(store.read(b, columns::kStreet));
  return labels;
}

std::uint64_t changed_labels(const Store& store, const std::vector<std::vector<StreetLabel>>& before) {
  std::uint64_t changed = 0;
  for (std::uint32_t b = 0; b < before.size(); ++b) {
    const auto now = store.read(b, columns::kStreet);
    for (std::size_t i = 0; i < now.size(); ++i)
      changed += now[i].object != before[b][i].object || now[i].label != before[b][i].label;
  }
  return changed;
}

// True for layers with heights in units of the raster; others have numbers and counts.
bool holds_heights(const std::string& layer) {
  for (const char* name :
       {"range", "clear", "closed", "filled", "foot", "over", "raised", "height", "bare", "level", "standing"})
    if (layer == name) return true;
  return false;
}

}  // namespace

TileReplay replay_tile(const KeptRun& run, const std::string& id, Progress& progress) {
  if (!run.made("streets"))
    throw Error("tile:" + id + ": the run made no streets (--products streets)", ExitCode::usage);
  const Settings& settings = run.options().settings;
  const StreetPixel pixel = street_pixel(run.store(), settings.streets, run.context());
  TileReplay replay;
  const TileRaster raster = street_raster(run.store(), run.context(), pixel.metres);
  replay.tile = number_of(raster, id);
  replay.window = raster.window(replay.tile);
  std::mutex mutex;
  replay.steps.see = [&](const TileRaster& all, const char* layer, std::size_t tile, const Image& image) {
    if (tile != replay.tile || image.width != all.grid.side || image.height != all.grid.side) return;
    const std::lock_guard lock(mutex);
    replay.images[layer] = image;
  };
  const auto before = labels_of(run.store());
  const fs::path folder = run.store().folder() / "replayed";
  RunRecord record;
  Progress silent;  // the run has given these warnings
  progress.note("the whole street is found again, as its tiles depend on each other");
  make_streets(run.store(), settings, run.training(), run.inputs().crs, run.context(), {folder, silent, record},
               run.inputs().edits, &replay.steps);
  replay.steps.see = {};
  compare_files(run.options().output / "streets", folder, replay.differences);
  if (const std::uint64_t changed = changed_labels(run.store(), before); changed > 0)
    replay.differences.push_back(grouped(changed) + " points have another label than in the store");
  return replay;
}

void write_images(const TileReplay& replay, const Crs& crs, const fs::path& folder) {
  constexpr float kNone = -9999;
  const TileRaster& raster = *replay.steps.raster;
  const std::uint32_t side = raster.grid.side;
  const double tile = static_cast<double>(raster.tile_units()) * raster.unit;
  const RasterPlace place{static_cast<double>(replay.window.column) * tile,
                          static_cast<double>(replay.window.row + 1) * tile,
                          static_cast<double>(raster.pixel) * raster.unit, side, side};
  fs::create_directories(folder / "layers");
  for (const auto& [name, image] : replay.images) {
    const double unit = holds_heights(name) ? raster.scale.unit : 1;
    std::vector<float> values(image.size());
    for (std::uint32_t y = 0; y < side; ++y)
      for (std::uint32_t x = 0; x < side; ++x) {
        const Height v = image.values[std::size_t{side - 1 - y} * side + x];
        values[std::size_t{y} * side + x] = v == kNoHeight ? kNone : static_cast<float>(v * unit);
      }
    RasterFile file(folder / "layers" / (name + ".tif"), place, RasterValue::real, kNone, crs);
    file.write(0, 0, side, side, values);
    file.finish();
  }
}

std::vector<std::string> tiles_to_replay(const Store& store, const StreetsSettings& settings,
                                         const PassContext& context) {
  const TileRaster raster = street_raster(store, context, street_pixel(store, settings, context).metres);
  const double side = static_cast<double>(raster.tile_units()) * raster.unit;
  std::vector<std::string> lines;
  for (std::size_t t = 0; t < raster.grid.count(); ++t) {
    const PointWindow w = raster.window(t);
    lines.push_back(fmt::format("tile:{},{}  at {:.1f} {:.1f}  {:.1f} x {:.1f} m, pixels of {:g} m", w.row, w.column,
                                (static_cast<double>(w.column) + 0.5) * side, (static_cast<double>(w.row) + 0.5) * side,
                                side * context.metres_per_unit, side * context.metres_per_unit, raster.scale.pixel));
  }
  return lines;
}

}  // namespace ilot
