// SPDX-License-Identifier: Apache-2.0
#include "engine/store/sorted_run.h"

#include <algorithm>
#include <map>
#include <memory>

#include "engine/error.h"
#include "engine/store/column_file.h"
#include "kernels/core/radix_sort.h"

namespace ilot {
namespace {

// Collects the points of one run by tile: code and value. Neighbours in a file are mostly in the same tile, so the last
// tile is remembered.
class Gatherer {
 public:
  explicit Gatherer(std::uint64_t points) : points_(points) {}

  void add(const PointKey& key, RunValue value) {
    if (last_ == nullptr || key.tile != last_tile_) {
      last_ = &tiles_[key.tile];
      refuse_many_tiles(tiles_.size());
      last_tile_ = key.tile;
      if (tiles_.size() == 1) last_->reserve(points_);  // mostly the only tile
    }
    last_->push_back({key.code, value});
  }
  std::map<Tile, std::vector<KeyValue>>& tiles() { return tiles_; }

 private:
  std::uint64_t points_;
  std::map<Tile, std::vector<KeyValue>> tiles_;
  std::vector<KeyValue>* last_ = nullptr;
  Tile last_tile_;
};

// Sorts tile by tile and frees each tile as soon as it is written.
void write_points(std::map<Tile, std::vector<KeyValue>>& tiles, SortedRun& run, std::optional<CoarseCells>& cells) {
  SortedRunWriter file(run.stem);
  for (auto& [tile, points] : tiles) {
    const std::uint64_t n = points.size();
    sort_pairs(points, {std::make_unique_for_overwrite<KeyValue[]>(n).get(), n});
    file.add(tile, points);
    if (cells) cells->add(tile, points);
    std::vector<KeyValue>().swap(points);
  }
  SortedRun written = file.finish();
  run.tiles = std::move(written.tiles);
  run.samples = std::move(written.samples);
}

void write_table(const SortedRun& run) {
  RecordWriter table(with_suffix(run.stem, ".table"));
  const std::uint64_t sizes[3]{run.tiles.size(), run.samples.size(), run.off_lattice.size()};
  table.append(std::as_bytes(std::span(sizes)));
  table.append(std::as_bytes(std::span(run.rejected)));
  table.append(std::as_bytes(std::span(run.tiles)));
  table.append(std::as_bytes(std::span(run.samples)));
  table.append(std::as_bytes(std::span(run.off_lattice)));
  table.commit();
}

}  // namespace

SortedRunWriter::SortedRunWriter(const std::filesystem::path& stem)
    : run_{stem, {}, {}, {}, {}}, file_(with_suffix(stem, ".points")) {}

void SortedRunWriter::add(Tile tile, std::span<const KeyValue> points) {
  if (points.empty()) return;
  const std::uint64_t n = points.size();
  if (run_.tiles.empty() || run_.tiles.back().tile != tile) run_.tiles.push_back({tile, written_, written_});
  run_.tiles.back().end += n;
  const std::uint64_t to_sample = (kRunSample - written_ % kRunSample) % kRunSample;
  for (std::uint64_t i = to_sample; i < n; i += kRunSample) run_.samples.push_back(points[i].key);
  file_.append(points);
  written_ += n;
}

SortedRun SortedRunWriter::finish() {
  file_.commit();
  return std::move(run_);
}

void refuse_many_tiles(std::size_t tiles) {
  if (tiles <= kMostTiles) return;
  throw Error("the points are spread too far for the steps that they are stored in: over more than " +
              std::to_string(kMostTiles) +
              " cubes of 2,097,152 steps a side; remove points that are far off, or give " +
              "--set index.finest_step with a coarser step, to which coordinates are rounded");
}

SortedRun make_sorted_run(const RowSource& source, const InputLattice& lattice, const IndexFilter& filter,
                          const std::filesystem::path& stem, const std::function<void(std::uint64_t)>& read_rows) {
  LatticeRowReader reader(source, lattice, filter);
  SortedRun run{stem, {}, {}, {}, {}};
  Gatherer gatherer(source.count);
  std::optional<CoarseCells> cells;
  if (filter.coarse_bits) cells.emplace(*filter.coarse_bits);
  for (LatticeRows rows; reader.next(rows); read_rows(rows.rows)) {
    for (const LatticePoint& p : rows.points)
      gatherer.add(key_of(p.at), run_value(input_order(source.file, p.row), p.classification, p.echoes));
    if (cells)
      for (const Index3& at : rows.outside) cells->add(at);
  }
  run.rejected = reader.rejected();
  run.off_lattice = reader.off_lattice();
  write_points(gatherer.tiles(), run, cells);
  if (cells) write_column<std::int64_t>(with_suffix(run.stem, ".cells"), cells->packed());
  write_table(run);
  return run;
}

CoarseCells coarse_cells_of(const SortedRun& run) {
  return CoarseCells::unpacked(read_column<std::int64_t>(with_suffix(run.stem, ".cells")));
}

std::optional<SortedRun> find_sorted_run(const std::filesystem::path& stem) {
  const auto path = with_suffix(stem, ".table");
  if (!std::filesystem::exists(path)) return std::nullopt;
  const RecordReader reader(path);
  SortedRun run{stem, {}, {}, {}, {}};
  std::uint64_t sizes[3];
  std::uint64_t at = 0;
  const auto take = [&](auto span) {
    reader.read(at, std::as_writable_bytes(span));
    at += span.size_bytes();
  };
  take(std::span(sizes));
  take(std::span(run.rejected));
  run.tiles.resize(sizes[0]);
  run.samples.resize(sizes[1]);
  run.off_lattice.resize(sizes[2]);
  take(std::span(run.tiles));
  take(std::span(run.samples));
  take(std::span(run.off_lattice));
  return run;
}

}  // namespace ilot
