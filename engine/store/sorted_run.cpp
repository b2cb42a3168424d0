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

// Points of one run gathered by tile: code and value. Neighbours in a file mostly share a tile, so the last one
// is remembered.
class Gatherer {
 public:
  explicit Gatherer(std::uint64_t points) : points_(points) {}

  void add(const PointKey& key, RunValue value) {
    if (last_ == nullptr || key.tile != last_tile_) {
      last_ = &tiles_[key.tile];
      last_tile_ = key.tile;
      if (tiles_.size() == 1) last_->reserve(points_);  // mostly the only one
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

// Sorts tile by tile and frees each as soon as it is written.
void write_points(std::map<Tile, std::vector<KeyValue>>& tiles, SortedRun& run) {
  ColumnWriter<KeyValue> file(with_suffix(run.stem, ".points"));
  std::uint64_t written = 0;
  for (auto& [tile, points] : tiles) {
    const std::uint64_t n = points.size();
    sort_pairs(points, {std::make_unique_for_overwrite<KeyValue[]>(n).get(), n});
    run.tiles.push_back({tile, written, written + n});
    const std::uint64_t to_sample = (kRunSample - written % kRunSample) % kRunSample;
    for (std::uint64_t i = to_sample; i < n; i += kRunSample) run.samples.push_back(points[i].key);
    file.append(points);
    written += n;
    std::vector<KeyValue>().swap(points);
  }
  file.commit();
}

void write_table(const SortedRun& run) {
  RecordWriter table(with_suffix(run.stem, ".table"));
  const std::uint64_t sizes[2]{run.tiles.size(), run.samples.size()};
  table.append(std::as_bytes(std::span(sizes)));
  table.append(std::as_bytes(std::span(run.rejected)));
  table.append(std::as_bytes(std::span(run.tiles)));
  table.append(std::as_bytes(std::span(run.samples)));
  table.commit();
}

std::uint8_t echoes(const PointFields& f) {
  return static_cast<std::uint8_t>((f.return_count > 1 ? kOneOfSeveral : 0) |
                                   (f.return_number < f.return_count ? kNotTheLast : 0));
}

std::optional<Rejection> judge(const PointFields& f, bool valid, const LatticeMap& lattice, const IndexFilter& filter,
                               Index3& at) {
  if (!valid) return Rejection::invalid;
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
  if (source.first + source.count > kMostRowsOfInput)
    throw Error(info.path.string() + ": holds more than 17 billion points; cut it into several files first");
  SortedRun run{stem, {}, {}, {}};
  Gatherer gatherer(source.count);
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
      const PointFields fields =
          decode_fields(std::span(records).subspan(i * length, length), info.layout.point_format);
      const auto rejection = judge(fields, valid[i] != 0, lattice, filter, at);
      if (rejection) {
        ++run.rejected[static_cast<std::size_t>(*rejection)];
      } else {
        const InputOrder order = input_order(source.file, source.first + done + i);
        gatherer.add(key_of(at), run_value(order, fields.classification, echoes(fields)));
      }
    }
    done += got;
    read_rows(got);
  }
  write_points(gatherer.tiles(), run);
  write_table(run);
  return run;
}

std::optional<SortedRun> find_sorted_run(const std::filesystem::path& stem) {
  const auto path = with_suffix(stem, ".table");
  if (!std::filesystem::exists(path)) return std::nullopt;
  const RecordReader reader(path);
  SortedRun run{stem, {}, {}, {}};
  std::uint64_t sizes[2];
  std::uint64_t at = 0;
  const auto take = [&](auto span) {
    reader.read(at, std::as_writable_bytes(span));
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
