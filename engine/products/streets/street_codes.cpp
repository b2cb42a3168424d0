// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/street_codes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <mutex>

#include "engine/report/counted.h"
#include "engine/store/stretches.h"
#include "engine/tiles/lattice_cells.h"

namespace ilot {
namespace {

constexpr std::uint64_t kBytesOfThreeLayers = 12;  // layers of a tile
constexpr std::uint64_t kBytesOfCodes = 1u << 20;  // memory of points while they are read, with their chunks
constexpr double kSure = 0.9;                      // Choice: probability from which a class counts as sure

std::array<bool, 256> set_of(std::span<const int> codes) {
  std::array<bool, 256> set{};
  for (const int code : codes) set[static_cast<std::size_t>(code)] = true;
  return set;
}

// The separated parts of one tile.
class TileParts {
 public:
  TileParts(const StreetTiles& tiles, std::size_t tile, Height least)
      : level_(layer_tile(tiles.layers(), "level", tile)),
        part_(layer_tile(tiles.layers(), "candidates", tile)),
        structure_(layer_tile(tiles.cells().layers, "structure", tile)),
        cells_(tiles.cells()),
        corner_(tiles.raster().corner(tile)),
        pixel_of_(tiles.raster().pixel),
        least_(least),
        clearance_(tiles.raster().scale.units(kClearance)) {}

  bool any() const {
    return std::ranges::any_of(part_.values, [](Height part) { return part != 0; });
  }

  // The separated part that the point stands in, 0 = none.
  std::uint32_t part_of(Index3 p) const {
    const std::size_t pixel = std::size_t{pixel_of_(p.y - corner_.y)} * level_.width + pixel_of_(p.x - corner_.x);
    if (part_.values[pixel] == 0 || level_.values[pixel] == kNoHeight) return 0;
    const Height above = height_of(p.z) - level_.values[pixel];
    const auto structure = static_cast<Structure>(structure_.values[cells_.cell_of(pixel, level_.width)]);
    if (above < least_ || is_taken_out(structure, above, clearance_)) return 0;
    return static_cast<std::uint32_t>(part_.values[pixel]);
  }

 private:
  Image level_, part_, structure_;
  const Cells& cells_;
  Index3 corner_;
  LatticeCells pixel_of_;
  Height least_, clearance_;
};

}  // namespace

std::vector<CodedPoints> coded_points(const Store& store, const StreetTiles& tiles,
                                      std::span<const std::uint32_t> candidate_of, std::span<const int> vegetation,
                                      double least_height) {
  if (store.blocks().empty() || !store.has(0, columns::kClass)) return {};
  const std::array<bool, 256> is_vegetation = set_of(vegetation);
  const TileRaster& raster = tiles.raster();
  const Height least = raster.scale.units(least_height);
  std::vector<CodedPoints> counts(1 + std::ranges::max(candidate_of));
  std::mutex mutex;
  const std::uint64_t pixels = std::uint64_t{raster.grid.side} * raster.grid.side;
  const std::vector<std::uint64_t> bytes(raster.grid.count(), kBytesOfThreeLayers * pixels + kBytesOfCodes);
  run_tasks(raster.grid, bytes, [&](std::size_t tile) {
    const TileParts parts(tiles, tile, least);
    if (!parts.any()) return;
    const IndexBox box = raster.box(tile);
    std::map<std::uint32_t, CodedPoints> own;  // by candidate
    for_each_stretch(store, plan_view(store, box, {}).slices, [&](const Stretch& s) {
      const std::vector<std::uint8_t> codes = s.read(store, columns::kClass);
      for (std::size_t i = 0; i < codes.size(); ++i) {
        const Index3 p = s.position(i);
        const std::uint32_t part = box.contains(p) ? parts.part_of(p) : 0;
        if (part == 0) continue;
        CodedPoints& c = own[candidate_of[part]];
        ++c.all, c.vegetation += is_vegetation[codes[i]];
      }
    });
    const std::lock_guard lock(mutex);
    for (const auto& [candidate, c] : own) counts[candidate].all += c.all, counts[candidate].vegetation += c.vegetation;
  });
  return counts;
}

CodesVote vote_on_codes(std::span<const CodedPoints> counts, const SelectedObjects& selected) {
  CodesVote vote;
  for (std::size_t i = 0; i + 1 < counts.size(); ++i) {
    if (selected.taken[i] == 0 || selected.by_hand[i] != 0) continue;
    const CandidateClass& c = selected.classes[i];
    if (c.probability < kSure || !is_street_object(c.label) || c.label == PointLabel::planter) continue;
    ++vote.sure, vote.coded += counts[i + 1].is_vegetation();
  }
  return vote;
}

void name_by_codes(std::span<const CodedPoints> counts, SelectedObjects& selected, RunRecord& record) {
  std::uint64_t named = 0, coded = 0;
  for (const CodedPoints& c : counts) coded += c.is_vegetation();
  if (coded == 0) return;
  const CodesVote vote = vote_on_codes(counts, selected);
  for (std::size_t i = 0; vote.used() && i + 1 < counts.size(); ++i) {
    if (selected.taken[i] == 0 || selected.by_hand[i] != 0 || !counts[i + 1].is_vegetation()) continue;
    PointLabel& label = selected.classes[i].label;
    named += is_street_object(label);
    label = PointLabel::vegetation;
  }
  record.chosen.push_back(
      {"streets.trust_classes", std::string(vote.used() ? "true" : "false"),
       fmt::format("{0} of {1} that are sure by their form have class codes of vegetation: {2}", vote.coded,
                   counted(vote.sure, "object"),
                   vote.used() ? counted(named, "object") + " with such codes became vegetation"
                               : "these codes do not tell vegetation from objects and were not used")});
}

void name_by_codes(const Store& store, const StreetTiles& tiles, const Settings& settings,
                   std::span<const std::uint32_t> candidate_of, SelectedObjects& selected, RunRecord& record) {
  if (!settings.streets.trust_classes) return;
  name_by_codes(coded_points(store, tiles, candidate_of, settings.classes.vegetation, settings.streets.least_height),
                selected, record);
}

}  // namespace ilot
