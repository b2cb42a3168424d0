// SPDX-License-Identifier: Apache-2.0
// Trains the model that tells what stands in the cells of streets that were scanned from the ground: trees on the
// features of cells, from scanned scenes and the true classes of their points. Streets from the air are left out.
// Points of no class are rooms behind windows and points between two surfaces: a cell that has no others is of a
// facade. Usage: study_structures STREET.laz... --model FILE [--most N] [--few N] [--rounds N] [--depth N] [LEAVING
// OUT]...
//        [--check STREET.laz...]
//        study_structures --judge MODEL [LEAVING OUT]... --check STREET.laz...
// With --most, at most N cells of a kind are taken from each street, evenly spread. Points are also left out: with
// --cut H those higher than H metres above the road, with --bare H these and the ground, with --thin N all but one in
// N. Each street is used as it is, and in one of these ways in turn, with at most --few cells of a kind. The streets
// after
// --check are not trained with; the table of kinds is printed for them, and for them with points left out.
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "engine/pass/index.h"
#include "engine/products/streets/ground/structure_model.h"
#include "engine/products/streets/ground/structures.h"
#include "engine/products/streets/make_streets.h"
#include "engine/products/streets/street_tiles.h"
#include "engine/proof/point_stream.h"
#include "engine/whole_file.h"
#include "kernels/core/parallel.h"
#include "study/cut_reader.h"
#include "training/tree_boosting.h"

namespace {

using namespace ilot;
namespace fs = std::filesystem;

// Points of a cell that are so high: of each kind, and of no class.
constexpr std::size_t kNoClass = kStandingKinds;
using KindPoints = std::array<std::uint32_t, kStandingKinds + 1>;
constexpr std::uint32_t kLeastOfRoom = 5;  // points of no class; fewer are those between two surfaces

// The kind of a true class of `street-wild`; ground is none.
int kind_of(std::uint32_t true_class) {
  switch (true_class) {
    case 0:
      return static_cast<int>(kNoClass);
    case 1:
      return -1;
    case 2:
      return static_cast<int>(StandingKind::facade);
    case 7:
      return static_cast<int>(StandingKind::crown);
    case 8:
      return static_cast<int>(StandingKind::roof);
    default:
      return static_cast<int>(StandingKind::object);
  }
}

// Cells of one street: features, and their points.
struct Cloud {
  std::vector<double> rows;
  std::vector<KindPoints> points;
};

using CellPoints = std::vector<KindPoints>;  // of the cells of a tile

// The points of each cell by kind: those that are as high as a wall (StructureParams::least_wall), so that a crown over
// a car is a crown, and where there are none all that are decided.
std::vector<CellPoints> true_points(PointReader& reader, const StreetTiles& tiles) {
  const CloudInfo& info = reader.info();
  const ExtraField kind = *find_integer_field(info.layout, "true_class");
  const TileRaster& raster = tiles.raster();
  const LatticeMap lattice(info.layout, raster.unit);
  const Cells& cells = tiles.cells();
  const Height least = raster.scale.units(kLeastDecided), wall = raster.scale.units(StructureParams{}.least_wall);
  std::vector<CellPoints> out(raster.grid.count(), CellPoints(std::size_t{cells.side()} * cells.side())), low = out;
  std::vector<Image> terrain;
  for (std::size_t t = 0; t < out.size(); ++t) terrain.push_back(layer_tile(cells.layers, "terrain", t));
  for_each_record(reader, [&](const std::byte* record) {
    std::int32_t raw[3];
    std::memcpy(raw, record, sizeof raw);
    Index3 p;
    if (!lattice.map(raw[0], raw[1], raw[2], p)) return;
    const std::int64_t x = raster.column(p.x), y = raster.row(p.y), side = raster.grid.side;
    const std::size_t tile = raster.grid.tile_with(x, y);
    const int k = kind_of(static_cast<std::uint32_t>(integer_of(record, kind)));
    if (tile == kNoTile || k < 0) return;
    const std::size_t cell = cells.cell_of(static_cast<std::size_t>(y % side * side + x % side), raster.grid.side);
    const Height ground = terrain[tile].values[cell];
    if (ground == kNoHeight || height_of(p.z) - ground < least) return;
    ++(height_of(p.z) - ground < wall ? low : out)[tile][cell][static_cast<std::size_t>(k)];
  });
  for (std::size_t tile = 0; tile < out.size(); ++tile)
    for (std::size_t cell = 0; cell < out[tile].size(); ++cell)
      if (out[tile][cell] == KindPoints{}) out[tile][cell] = low[tile][cell];
  return out;
}

Cloud cells_of_cloud(const fs::path& cloud, const Leaving& leaving) {
  const fs::path folder = fs::temp_directory_path() / ("study_structures_" + cloud.stem().string() + leaving.name());
  fs::remove_all(folder);
  fs::create_directories(folder);
  const std::vector<std::unique_ptr<PointReader>> readers = open_street(cloud, leaving);
  PassContext context;
  const IndexResult index = build_index(readers, {}, folder, context);
  const StreetPixel pixel = street_pixel(index.store, {}, context);
  Cloud out;
  if (pixel.view == StreetView::street) {
    const StreetTiles tiles(index.store, context, pixel.metres, pixel.density.median);
    const Cells& cells = tiles.cells();
    find_terrain(cells);
    tiles.draw_heights(pixel.view);
    const std::vector<CellPoints> truth = true_points(*readers[0], tiles);
    for (std::size_t tile = 0; tile < truth.size(); ++tile) {
      const CellMeasures around = cell_measures_around(cells, tile);
      const StandingRows rows = standing_rows(around, cells.scale, cells.factor, cells.scale.units(kLeastDecided));
      out.rows.insert(out.rows.end(), rows.rows.begin(), rows.rows.end());
      for (const std::uint32_t cell : rows.cells) out.points.push_back(truth[tile][cell_of_tile(around, cell)]);
    }
  }
  fs::remove_all(folder);
  return out;
}

// The kind that most of the points of a cell have; kStandingKinds where it has none. Rooms are of their building.
std::uint32_t kind_of_cell(const KindPoints& points) {
  const auto most = std::max_element(points.begin(), points.begin() + kStandingKinds);
  if (*most > 0) return static_cast<std::uint32_t>(most - points.begin());
  return points[kNoClass] >= kLeastOfRoom ? static_cast<std::uint32_t>(StandingKind::facade) : kStandingKinds;
}

struct Samples {
  std::vector<double> rows;
  std::vector<std::uint32_t> kinds;

  // Takes at most `most` cells of each kind, evenly spread.
  void add(const Cloud& cloud, std::size_t most) {
    std::array<std::vector<std::size_t>, kStandingKinds> of_kind;
    for (std::size_t i = 0; i < cloud.points.size(); ++i)
      if (const std::uint32_t kind = kind_of_cell(cloud.points[i]); kind < kStandingKinds) of_kind[kind].push_back(i);
    const std::size_t columns = standing_features();
    for (std::uint32_t kind = 0; kind < kStandingKinds; ++kind) {
      const std::size_t n = of_kind[kind].size(), take = std::min(n, most);
      for (std::size_t k = 0; k < take; ++k) {
        const auto first = cloud.rows.begin() + static_cast<std::ptrdiff_t>(of_kind[kind][k * n / take] * columns);
        rows.insert(rows.end(), first, first + static_cast<std::ptrdiff_t>(columns));
        kinds.push_back(kind);
      }
    }
  }
};

using Table = std::array<std::array<std::uint64_t, kStandingKinds>, kStandingKinds>;  // points: true kind, found kind

void print_table(const Table& table) {
  constexpr std::array<const char*, kStandingKinds> kNames{"facade", "roof", "crown", "object"};
  fmt::print("points of cells that are decided, percent; rows are the truth\n{:8} {:>8} {:>8} {:>8} {:>8}\n", "",
             "facade", "roof", "crown", "object");
  for (std::size_t k = 0; k < kStandingKinds; ++k) {
    std::uint64_t all = 0;
    for (const std::uint64_t n : table[k]) all += n;
    fmt::print("{:8}", kNames[k]);
    for (const std::uint64_t n : table[k])
      fmt::print(" {:8.1f}", 100 * static_cast<double>(n) / static_cast<double>(std::max<std::uint64_t>(1, all)));
    fmt::print("  of {}\n", all);
  }
}

void check(const StructureModel& model, const std::vector<std::string>& clouds, const Leaving& leaving) {
  Table all{};
  for (const std::string& name : clouds) {
    Cloud cloud = cells_of_cloud(name, leaving);
    StandingRows rows;
    rows.cells.resize(cloud.points.size());
    rows.rows = std::move(cloud.rows);
    const std::vector<StandingKind> kinds = standing_kinds(model, rows);
    for (std::size_t i = 0; i < kinds.size(); ++i)
      for (std::size_t k = 0; k < kStandingKinds; ++k) all[k][static_cast<std::size_t>(kinds[i])] += cloud.points[i][k];
  }
  if (clouds.empty()) return;
  fmt::print("\nclouds{}: ", leaving.name().empty() ? " as they are" : leaving.name());
  print_table(all);
}

struct Arguments {
  std::vector<std::string> clouds, checked;
  fs::path model, judged;
  std::size_t most = 500, few = 150;
  std::vector<Leaving> leavings;
  TreeBoostingParams trees;
};

Arguments read_arguments(const std::vector<std::string>& words) {
  Arguments a;
  a.trees.rounds = 100, a.trees.drawn_of = 8;
  std::vector<std::string>* list = &a.clouds;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "--model" && i + 1 < words.size())
      a.model = words[++i];
    else if (words[i] == "--judge" && i + 1 < words.size())
      a.judged = words[++i];
    else if (words[i] == "--most" && i + 1 < words.size())
      a.most = std::stoul(words[++i]);
    else if (words[i] == "--few" && i + 1 < words.size())
      a.few = std::stoul(words[++i]);
    else if (words[i] == "--rounds" && i + 1 < words.size())
      a.trees.rounds = std::stoul(words[++i]);
    else if (words[i] == "--depth" && i + 1 < words.size())
      a.trees.depth = std::stoul(words[++i]);
    else if (is_leaving(words[i]) && i + 1 < words.size())
      a.leavings.push_back(leaving_of(words[i], words[i + 1])), ++i;
    else if (words[i] == "--check")
      list = &a.checked;
    else
      list->push_back(words[i]);
  }
  if (a.judged.empty() ? a.clouds.empty() || a.model.empty() : a.checked.empty())
    throw std::runtime_error(
        "usage: study_structures STREET.laz... --model FILE [--most N] [--few N] [--rounds N] [--depth N] [--cut H] "
        "[--bare H] "
        "[--thin N] [--check STREET.laz...], or study_structures --judge MODEL --check STREET.laz...");
  return a;
}

StructureModel trained(const Arguments& a) {
  Samples samples;
  std::string names;
  for (std::size_t c = 0; c < a.clouds.size(); ++c) {
    samples.add(cells_of_cloud(a.clouds[c], {}), a.most);
    if (!a.leavings.empty()) samples.add(cells_of_cloud(a.clouds[c], a.leavings[c % a.leavings.size()]), a.few);
    names += " " + fs::path(a.clouds[c]).filename().string();
  }
  std::string left_out;
  for (const Leaving& leaving : a.leavings) left_out += leaving.option();
  const TreeSamples all{standing_features(), kStandingKinds, columns_of_rows(samples.rows, standing_features()),
                        samples.kinds};
  StructureModel model;
  model.trees = boost_trees(all, a.trees);
  model.recipe = fmt::format("study_structures{}{} --most {} --few {} --rounds {} --depth {}\n{} cells\n", names,
                             left_out, a.most, a.few, a.trees.rounds, a.trees.depth, samples.kinds.size());
  write_whole_file(a.model, structure_model_text(model));
  fmt::print("{}: {} cells, {} trees\n", a.model.string(), samples.kinds.size(), model.trees.trees());
  return model;
}

StructureModel read_model(const fs::path& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path.string() + ": cannot be read");
  std::stringstream text;
  text << file.rdbuf();
  return parse_structure_model(text.str(), path.string());
}

void run(const Arguments& a) {
  const StructureModel model = a.judged.empty() ? trained(a) : read_model(a.judged);
  check(model, a.checked, {});
  for (const Leaving& leaving : a.leavings) check(model, a.checked, leaving);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const Arguments arguments = read_arguments({argv + 1, argv + argc});
    with_threads(hardware_threads(), [&] { run(arguments); });
    return 0;
  } catch (const std::exception& e) {
    fmt::print(stderr, "study_structures: {}\n", e.what());
    return 1;
  }
}
