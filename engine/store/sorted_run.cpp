// SPDX-License-Identifier: Apache-2.0
#include "engine/store/sorted_run.h"

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <tuple>

#include "engine/error.h"
#include "engine/formats/row_buffer.h"
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

// Finds the points that are not on a lattice that is coarser than the scale of their file.
class OffLattice {
 public:
  OffLattice(const RecordLayout& layout, const InputLattice& lattice)
      : multiple_(lattice.multiple), finest_(layout, lattice.finest()) {}

  void check(const PointFields& f) {
    Index3 p;
    if (multiple_ == 1 || places_.size() == kMostOffLattice || !finest_.map(f.x, f.y, f.z, p)) return;
    if (p.x % multiple_ != 0 || p.y % multiple_ != 0 || p.z % multiple_ != 0) places_.insert({p.x, p.y, p.z});
  }
  std::vector<Index3> places() const {
    std::vector<Index3> all;
    for (const auto& [x, y, z] : places_) all.push_back({x, y, z});
    return all;
  }

 private:
  std::int64_t multiple_;
  LatticeMap finest_;
  std::set<std::tuple<std::int64_t, std::int64_t, std::int64_t>> places_;
};

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

std::uint8_t echoes(const PointFields& f) {
  return static_cast<std::uint8_t>((f.return_count > 1 ? kMultipleReturns : 0) |
                                   (f.return_number < f.return_count ? kNotLastReturn : 0));
}

std::optional<Rejection> rejection_of(const PointFields& f, bool valid, const LatticeMap& lattice,
                                      const IndexFilter& filter, Index3& at) {
  if (!valid) return Rejection::invalid;
  if (!lattice.map(f.x, f.y, f.z, at)) return Rejection::invalid;
  if (f.withheld) return Rejection::withheld;
  if (filter.noise[f.classification]) return Rejection::noise;
  if (filter.keep && !filter.keep->contains(at)) return Rejection::outside;
  return std::nullopt;
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

SortedRun make_sorted_run(const RunSource& source, const InputLattice& lattice, const IndexFilter& filter,
                          const std::filesystem::path& stem, const std::function<void(std::uint64_t)>& read_rows) {
  const CloudInfo& info = source.reader.info();
  const std::size_t length = info.layout.record_length;
  const LatticeMap map(info.layout, lattice.unit);
  OffLattice off(info.layout, lattice);
  if (source.first + source.count > kMostRowsOfInput)
    throw Error(info.path.string() + ": contains more than 17 billion points; cut it into several files first");
  SortedRun run{stem, {}, {}, {}, {}};
  Gatherer gatherer(source.count);
  std::optional<CoarseCells> cells;
  if (filter.coarse_bits) cells.emplace(*filter.coarse_bits);
  const std::uint64_t batch = rows_at_a_time(length, 1u << 14);
  std::vector<std::byte> records(batch * length);
  std::vector<std::uint8_t> valid(batch);
  for (std::uint64_t done = 0; done < source.count;) {
    const std::uint64_t want = std::min(batch, source.count - done);
    const std::size_t got =
        source.reader.read(source.first + done, std::span(records).first(want * length), std::span(valid).first(want));
    if (got < want)
      throw Error(info.path.string() + ": point " + std::to_string(source.first + done + got) +
                  " can no longer be read; the file changed during the run");
    for (std::size_t i = 0; i < got; ++i) {
      Index3 at;
      const PointFields fields =
          decode_fields(std::span(records).subspan(i * length, length), info.layout.point_format);
      const auto rejection = rejection_of(fields, valid[i] != 0, map, filter, at);
      if (rejection != Rejection::invalid) off.check(fields);
      if (rejection) {
        ++run.rejected[static_cast<std::size_t>(*rejection)];
        if (cells && rejection == Rejection::outside) cells->add(at);
      } else {
        const InputOrder order = input_order(source.file, source.first + done + i);
        gatherer.add(key_of(at), run_value(order, fields.classification, echoes(fields)));
      }
    }
    done += got;
    read_rows(got);
  }
  run.off_lattice = off.places();
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
