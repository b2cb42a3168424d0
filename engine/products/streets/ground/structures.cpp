// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/ground/structures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <vector>

#include "engine/products/streets/ground/structure_model.h"
#include "kernels/morphology/flat_zones_tiled.h"

namespace ilot {
namespace {

constexpr std::uint32_t kLeastWalls = 3;  // cells of a wall near what belongs to it
// Derived: the edges of roofs are decided from two cells around and the neighbours of those.
constexpr std::uint32_t kEdgeHalo = 3;  // cells
// Derived: 72 features and their bins, and 36 sums and maxima, of eight bytes.
constexpr std::uint32_t kBytesOfLearntCell = 1000;
// Derived: three images of four bytes, and ten counts and two sums of rows of two bytes, twice.
constexpr std::uint32_t kBytesOfVotedCell = 60;
// Derived: a line aslant to the cells crosses five of nine, and the eaves before it cover two more.
constexpr std::uint32_t kSolidCells = 8;  // of nine; so many of volumes are no edge of a building
// Derived: of the nine cells around one beside the edge of a roof, three are of the edge.
constexpr std::uint32_t kRoofCells =
    6;  // of nine; so many on planes are a roof and no branches that are flat by chance

// Derived: the last of the bins of half a metre below kClearance (street_tiles.h), 2 to 2.5 m: above cars and people,
// below what is cut off above them.
constexpr HeightBins kBelowClearance = 1u << 4;

// The number of cells of each form around each cell, over a box of 2 reach + 1, by sums over rows and then columns.
using Votes = std::array<std::vector<std::uint16_t>, 5>;

Votes votes_of(const Image& shape, const Image& top, std::uint32_t reach, Height least) {
  Votes votes;
  const std::size_t w = shape.width, h = shape.height;
  for (std::size_t s = 0; s < votes.size(); ++s) {
    std::vector<std::uint16_t> own(w * h, 0), rows(w * h, 0);
    for (std::size_t i = 0; i < own.size(); ++i)
      own[i] = shape.values[i] == static_cast<Height>(s) && top.values[i] >= least;
    for (std::size_t y = 0; y < h; ++y)
      for (std::size_t x = reach; x + reach < w; ++x)
        for (std::size_t u = x - reach; u <= x + reach; ++u)
          rows[y * w + x] = static_cast<std::uint16_t>(rows[y * w + x] + own[y * w + u]);
    votes[s].assign(w * h, 0);
    for (std::size_t y = reach; y + reach < h; ++y)
      for (std::size_t v = y - reach; v <= y + reach; ++v)
        for (std::size_t x = 0; x < w; ++x)
          votes[s][y * w + x] = static_cast<std::uint16_t>(votes[s][y * w + x] + rows[v * w + x]);
  }
  return votes;
}

// Whether a tall cell touches one of a form.
bool touches(const Image& shape, const Image& top, std::size_t i, StandingForm form, Height least) {
  const std::size_t w = shape.width;
  for (const std::size_t j : {i - w - 1, i - w, i - w + 1, i - 1, i, i + 1, i + w - 1, i + w, i + w + 1})
    if (shape.values[j] == static_cast<Height>(form) && top.values[j] >= least) return true;
  return false;
}

// Seen from the air, the edge of a building has points of its roof, its eaves and its wall, which are on no plane
// together. Such cells form a band along the roof, while a crown fills squares of three cells. Cells of volumes that
// are in no such square and that have a roof beside them become cells of the roof. Cells nearer than three to the end
// of the image are not decided.
void give_edges_to_roofs(Image& shape, const Image& top, Height least) {
  const auto volume = static_cast<std::size_t>(StandingForm::volume),
             pole = static_cast<std::size_t>(StandingForm::pole),
             inclined = static_cast<std::size_t>(StandingForm::inclined);
  const Votes near = votes_of(shape, top, 1, least);
  const std::size_t w = shape.width, h = shape.height;
  const auto any_within = [&](std::size_t i, std::size_t reach, const auto& is) {
    for (std::size_t y = i / w - reach; y <= i / w + reach; ++y)
      for (std::size_t x = i % w - reach; x <= i % w + reach; ++x)
        if (is(y * w + x)) return true;
    return false;
  };
  const auto is_solid = [&](std::size_t i) { return near[volume][i] + near[pole][i] >= kSolidCells; };
  const auto is_roof = [&](std::size_t i) { return near[inclined][i] >= kRoofCells; };
  for (std::size_t y = 2; y + 2 < h; ++y)
    for (std::size_t x = 2; x + 2 < w; ++x) {
      const std::size_t i = y * w + x;
      const auto form = static_cast<std::size_t>(shape.values[i]);
      if ((form == volume || form == pole) && any_within(i, 2, is_roof) && !any_within(i, 1, is_solid))
        shape.values[i] = static_cast<Height>(inclined);
    }
}

bool is_of_building(Structure s) {
  return s == Structure::wall || s == Structure::roof || is_overhang(s);
}

struct Building {
  Height top = 0;
  std::int64_t x0 = INT64_MAX, y0 = INT64_MAX, x1 = INT64_MIN, y1 = INT64_MIN;

  void add(Height t, std::int64_t x, std::int64_t y) {
    top = std::max(top, t);
    x0 = std::min(x0, x), y0 = std::min(y0, y), x1 = std::max(x1, x), y1 = std::max(y1, y);
  }
  void add(const Building& o) {
    top = std::max(top, o.top);
    x0 = std::min(x0, o.x0), y0 = std::min(y0, o.y0), x1 = std::max(x1, o.x1), y1 = std::max(y1, o.y1);
  }
  std::int64_t side() const { return x1 < x0 ? 0 : std::max(x1 - x0, y1 - y0) + 1; }
};

// Whether a measure is `least` or more in one of the cells within `reach` of cell i of images with their halo.
bool any_near(const CellMeasures& around, CellMeasure measure, Height least, std::uint32_t i, std::uint32_t reach) {
  const Image& image = around[static_cast<std::size_t>(measure)];
  const std::uint32_t x = i % image.width, y = i / image.width;
  for (std::uint32_t v = y - reach; v <= y + reach; ++v)
    for (std::uint32_t u = x - reach; u <= x + reach; ++u)
      if (const Height n = image.values[std::size_t{v} * image.width + u]; n != kNoHeight && n >= least) return true;
  return false;
}

HeightBins bins_of(const CellMeasures& around, std::uint32_t cell) {
  return static_cast<HeightBins>(around[static_cast<std::size_t>(CellMeasure::bins)].values[cell]);
}

class StructureFinder {
 public:
  StructureFinder(const Cells& cells, StreetView view, const StructureParams& params)
      : cells_(cells),
        layers_(cells.layers),
        params_(params),
        view_(view),
        reach_(std::max(2u, cells.scale.pixels(params.around))),
        least_(cells.scale.units(params.least_height)),
        wall_(cells.scale.units(params.least_wall)) {}

  void find() {
    const auto found = [&](std::size_t tile) { return view_ == StreetView::air ? voted(tile) : learnt(tile); };
    for_each_tile(layers_.grid, [&](std::size_t tile) { layers_.write("structure", tile, found(tile)); },
                  {view_ == StreetView::air ? kBytesOfVotedCell : kBytesOfLearntCell,
                   std::max(reach_ + kEdgeHalo, kStandingHalo)});
    drop_small_buildings();
  }

 private:
  Structure verdict(const Image& shape, const Image& top, const Votes& votes, std::size_t i) const {
    const std::uint32_t walls = votes[static_cast<std::size_t>(StandingForm::upright)][i],
                        roofs = votes[static_cast<std::size_t>(StandingForm::inclined)][i],
                        crowns = votes[static_cast<std::size_t>(StandingForm::volume)][i] +
                                 votes[static_cast<std::size_t>(StandingForm::pole)][i];
    const bool fixed = touches(shape, top, i, StandingForm::upright, wall_);
    // Seen from the air, only what is upright is a wall: a roof and a crown reach over it.
    if (walls >= kLeastWalls && shape.values[i] == static_cast<Height>(StandingForm::upright)) return Structure::wall;
    if (top.values[i] < least_) return walls >= kLeastWalls && fixed ? Structure::wall : Structure::none;
    // The cells along the edges of a roof are of no plane.
    if (walls + roofs + (walls + roofs) / 2 > crowns && walls + roofs >= 2 * reach_ && roofs > 0)
      return Structure::roof;
    if (crowns >= 4 && crowns > walls + roofs) return Structure::crown;
    if (walls >= kLeastWalls && fixed) return Structure::wall;
    return Structure::none;
  }

  // What the learnt trees say of the cells of a tile.
  Image learnt(std::size_t tile) const {
    const CellMeasures around = cell_measures_around(cells_, tile);
    const Image shape = layer_tile(layers_, "shape", tile), top = layer_tile(layers_, "top", tile);
    const StandingRows rows =
        standing_rows(around, cells_.scale, cells_.factor, cells_.scale.units(params_.least_learnt_wall));
    const std::vector<StandingKind> kinds = standing_kinds(default_structure_model(), rows);
    Image out = filled_image(shape.width, shape.height, 0);
    for (std::size_t k = 0; k < kinds.size(); ++k) {
      const std::size_t i = cell_of_tile(around, rows.cells[k]);
      Structure structure = structure_of(kinds[k], static_cast<StandingForm>(shape.values[i]), top.values[i]);
      // In a sparse cloud no pixel of a wall is upright; where there is none nearby, nothing hangs over.
      if (structure == Structure::overhang &&
          !any_near(around, CellMeasure::upright, 1, rows.cells[k], kStandingReaches[1]))
        structure = Structure::wall;
      // What is low beside something high leans on a wall or stands before it. A wall that is cut has nothing high.
      if (structure == Structure::wall && top.values[i] < wall_ &&
          any_near(around, CellMeasure::top, least_, rows.cells[k], kStandingReaches.back()))
        structure = Structure::none;
      if (top.values[i] >= least_) structure = where_free_below(structure, bins_of(around, rows.cells[k]));
      out.values[i] = static_cast<Height>(structure);
    }
    return out;
  }

  Structure structure_of(StandingKind kind, StandingForm form, Height top) const {
    switch (kind) {
      case StandingKind::facade:
        return form == StandingForm::upright || top < least_ ? Structure::wall : Structure::overhang;
      case StandingKind::roof:
        return top < least_ ? Structure::none : Structure::roof;
      case StandingKind::crown:
        return top < least_ ? Structure::none : Structure::crown;
      case StandingKind::object:
        break;
    }
    return Structure::none;
  }

  Image voted(std::size_t tile) const {
    const std::uint32_t halo = reach_ + kEdgeHalo;
    Image shape = layer_around(layers_, "shape", tile, halo);
    const Image top = layer_around(layers_, "top", tile, halo);
    give_edges_to_roofs(shape, top, least_);
    const Votes votes = votes_of(shape, top, reach_, wall_);
    Image out = without_halo(shape, halo);
    for (std::uint32_t y = 0; y < out.height; ++y)
      for (std::uint32_t x = 0; x < out.width; ++x) {
        const std::size_t i = (std::size_t{y} + halo) * shape.width + x + halo;
        const Structure s = top.values[i] >= wall_ ? verdict(shape, top, votes, i) : Structure::none;
        out.values[std::size_t{y} * out.width + x] = static_cast<Height>(s);
      }
    return out;
  }

  // Buildings that are smaller than a house are none.
  void drop_small_buildings() {
    std::vector<Building> found;
    std::mutex mutex;
    const auto read = [&](std::size_t tile) {
      Image image = layer_tile(layers_, "structure", tile);
      for (Height& v : image.values) v = is_of_building(static_cast<Structure>(v)) ? 0 : kNoHeight;
      return image;
    };
    const auto write = [&](std::size_t tile, const PixelLabels& labels) {
      const TileFrame frame = tile_frame(layers_.grid, tile);
      const Image top = layer_tile(layers_, "top", tile);
      layers_.write("buildings", tile, {labels.width, labels.height, {labels.of.begin(), labels.of.end()}});
      std::vector<std::pair<std::uint32_t, Building>> runs;
      for (std::size_t i = 0; i < labels.of.size(); ++i) {
        if (labels.of[i] == 0) continue;
        if (runs.empty() || runs.back().first != labels.of[i]) runs.push_back({labels.of[i], {}});
        runs.back().second.add(top.values[i], frame.x + static_cast<std::int64_t>(i % labels.width),
                               frame.y + static_cast<std::int64_t>(i / labels.width));
      }
      const std::lock_guard lock(mutex);
      for (const auto& [number, part] : runs) {
        if (number >= found.size()) found.resize(number + 1);
        found[number].add(part);
      }
    };
    flat_zones_tiled(layers_.grid, 0, Adjacency::eight, read, write);
    for_each_tile(layers_.grid, [&](std::size_t tile) {
      Image structure = layer_tile(layers_, "structure", tile);
      const Image of = layer_tile(layers_, "buildings", tile);
      for (std::size_t i = 0; i < of.size(); ++i)
        if (of.values[i] > 0 && !is_house(found[static_cast<std::size_t>(of.values[i])])) structure.values[i] = 0;
      layers_.write("structure", tile, structure);
    });
    layers_.drop("buildings");
  }

  bool is_house(const Building& b) const {
    const double side = static_cast<double>(b.side()) * cells_.scale.pixel;
    if (b.top < least_) return side >= params_.length_of_cut_wall;
    const double longest = view_ == StreetView::air ? params_.length_of_house : params_.length_of_learnt_house;
    return side >= params_.least_length && (b.top >= cells_.scale.units(params_.height_of_house) || side >= longest);
  }

  const Cells& cells_;
  const TileLayers& layers_;
  const StructureParams& params_;
  StreetView view_;
  std::uint32_t reach_;
  Height least_, wall_;
};

}  // namespace

Structure where_free_below(Structure of_cell, HeightBins bins) {
  const bool hangs = (bins & kBelowClearance) == 0 && (bins & (kBelowClearance - 1)) != 0;
  if (!hangs || (of_cell != Structure::wall && of_cell != Structure::roof)) return of_cell;
  return of_cell == Structure::roof ? Structure::eaves : Structure::overhang;
}

void find_structures(const Cells& cells, StreetView view, const StructureParams& params) {
  StructureFinder(cells, view, params).find();
}

}  // namespace ilot
