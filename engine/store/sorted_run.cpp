// SPDX-License-Identifier: Apache-2.0
#include "engine/store/sorted_run.h"

#include <algorithm>
#include <map>

#include "engine/error.h"
#include "engine/store/column_file.h"
#include "engine/store/store.h"

namespace ilot {
namespace {

struct TilePoints {
  std::vector<std::uint64_t> codes;
  std::vector<InputOrder> order;
};

// Points of one run gathered by tile. Neighbours in a file mostly share a tile, so the last one is remembered.
class Gatherer {
 public:
  void add(const PointKey& key, InputOrder order) {
    if (last_ == nullptr || key.tile != last_tile_) {
      last_ = &tiles_[key.tile];
      last_tile_ = key.tile;
    }
    last_->codes.push_back(key.code);
    last_->order.push_back(order);
  }
  std::map<Tile, TilePoints>& tiles() { return tiles_; }

 private:
  std::map<Tile, TilePoints> tiles_;
  TilePoints* last_ = nullptr;
  Tile last_tile_;
};

template <class T>
std::vector<T> permuted(const std::vector<T>& values, const std::vector<std::uint32_t>& order) {
  std::vector<T> result(values.size());
  for (std::size_t i = 0; i < order.size(); ++i) result[i] = values[order[i]];
  return result;
}

// Sorts tile by tile and frees each as soon as it is written.
void write_columns(std::map<Tile, TilePoints>& tiles, SortedRun& run) {
  ColumnWriter codes(with_suffix(run.stem, ".codes"));
  ColumnWriter orders(with_suffix(run.stem, ".order"));
  std::uint64_t written = 0;
  for (auto& [tile, points] : tiles) {
    const std::vector<std::uint32_t> order = sorted_order(points.codes);
    points.codes = permuted(points.codes, order);
    points.order = permuted(points.order, order);
    const std::uint64_t n = points.codes.size();
    run.tiles.push_back({tile, written, written + n});
    const std::uint64_t to_sample = (kRunSample - written % kRunSample) % kRunSample;
    for (std::uint64_t i = to_sample; i < n; i += kRunSample) run.samples.push_back(points.codes[i]);
    codes.append<std::uint64_t>(points.codes);
    orders.append<InputOrder>(points.order);
    written += n;
    points = {};
  }
  codes.commit();
  orders.commit();
}

void write_table(const SortedRun& run) {
  ColumnWriter table(with_suffix(run.stem, ".table"));
  const std::uint64_t sizes[2]{run.tiles.size(), run.samples.size()};
  table.append<std::uint64_t>(sizes);
  table.append<std::uint64_t>(run.rejected);
  table.append<RunTile>(run.tiles);
  table.append<std::uint64_t>(run.samples);
  table.commit();
}

std::optional<Rejection> judge(std::span<const std::byte> record, std::uint8_t format, bool valid,
                               const LatticeMap& lattice, const IndexFilter& filter, Index3& at) {
  if (!valid) return Rejection::invalid;
  const PointFields f = decode_fields(record, format);
  if (!lattice.map(f.x, f.y, f.z, at)) return Rejection::invalid;
  if (f.withheld) return Rejection::withheld;
  if (filter.noise[f.classification]) return Rejection::noise;
  if (filter.keep && !filter.keep->contains(at)) return Rejection::outside;
  return std::nullopt;
}

}  // namespace

SortedRun make_sorted_run(const RunSource& source, double unit, const IndexFilter& filter,
                          const std::filesystem::path& stem, const std::function<void(std::uint64_t)>& read_rows) {
  constexpr std::uint64_t kBatch = 1 << 14;
  const CloudInfo& info = source.reader.info();
  const std::size_t length = info.layout.record_length;
  const LatticeMap lattice(info.layout, unit);
  SortedRun run{stem, {}, {}, {}};
  Gatherer gatherer;
  std::vector<std::byte> records(kBatch * length);
  std::vector<std::uint8_t> valid(kBatch);
  for (std::uint64_t done = 0; done < source.count;) {
    const std::uint64_t want = std::min(kBatch, source.count - done);
    const std::size_t got =
        source.reader.read(source.first + done, std::span(records).first(want * length), std::span(valid).first(want));
    if (got < want)
      throw Error(info.path.string() + ": point " + std::to_string(source.first + done + got) +
                  " can no longer be read; the file changed during the run");
    for (std::size_t i = 0; i < got; ++i) {
      Index3 at;
      const auto rejection = judge(std::span(records).subspan(i * length, length), info.layout.point_format,
                                   valid[i] != 0, lattice, filter, at);
      if (rejection) {
        ++run.rejected[static_cast<std::size_t>(*rejection)];
      } else {
        gatherer.add(key_of(at), input_order(source.file, source.first + done + i));
      }
    }
    done += got;
    read_rows(got);
  }
  write_columns(gatherer.tiles(), run);
  write_table(run);
  return run;
}

std::optional<SortedRun> find_sorted_run(const std::filesystem::path& stem) {
  const auto path = with_suffix(stem, ".table");
  if (!std::filesystem::exists(path)) return std::nullopt;
  const ColumnReader reader(path);
  SortedRun run{stem, {}, {}, {}};
  std::uint64_t sizes[2];
  std::uint64_t at = 0;
  const auto take = [&](auto span) {
    reader.read_bytes(at, std::as_writable_bytes(span));
    at += span.size_bytes();
  };
  take(std::span(sizes));
  take(std::span(run.rejected));
  run.tiles.resize(sizes[0]);
  run.samples.resize(sizes[1]);
  take(std::span(run.tiles));
  take(std::span(run.samples));
  return run;
}

}  // namespace ilot
