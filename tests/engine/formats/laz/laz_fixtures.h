// SPDX-License-Identifier: Apache-2.0
// What the LAZ tests share: all compressed files of the real data, made-up points of every format, chunks of
// a file.
#pragma once
#include <algorithm>
#include <cstring>
#include <memory>
#include <vector>

#include "engine/formats/laz/chunk_index.h"
#include "engine/formats/laz/laz.h"
#include "tests/engine/formats/fixtures.h"

namespace ilot::test {

inline std::vector<std::filesystem::path> laz_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(
           folder, std::filesystem::directory_options::follow_directory_symlink)) {
    if (entry.is_regular_file() && entry.path().extension() == ".laz") paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

// A compressed file down to its chunks, by the library's own steps below the reader.
struct OpenedLaz {
  explicit OpenedLaz(const std::filesystem::path& path) : file(path), container(parse_las(file)) {
    for (const Vlr& vlr : container.info.vlrs) {
      if (vlr.user_id != laz::kLaszipUserId) continue;
      const RecordLayout& l = container.info.layout;
      const auto parsed = laz::parse_laszip_record(vlr.payload, l.point_format, l.record_length);
      if (!parsed.problem.empty()) throw Error(parsed.problem);
      compression = parsed.compression;
    }
    index = laz::index_chunks(file, container.point_offset, container.info.declared_points, compression);
  }
  std::vector<std::byte> bytes(const laz::ChunkPlace& place) const {
    std::vector<std::byte> out(place.bytes);
    file.read_at(place.offset, out);
    return out;
  }
  InputFile file;
  LasContainer container;
  laz::Compression compression;
  laz::ChunkIndex index;
};

// Points that visit every branch of the codec: channels, returns, several clocks, jumps, extremes, rare
// changes.
class PointMaker {
 public:
  PointMaker(const laz::ChunkLayout& layout, std::uint64_t key)
      : layout_(layout), rng_(key), record_(layout.record_length) {}

  std::vector<std::byte> make(std::size_t count) {
    std::vector<std::byte> out;
    for (std::size_t i = 0; i < count; ++i) {
      advance();
      out.insert(out.end(), record_.begin(), record_.end());
    }
    return out;
  }

 private:
  template <class T>
  void add(std::size_t at, T difference) {
    store(&record_[at], static_cast<T>(load<T>(&record_[at]) + difference));
  }
  bool one_in(std::uint64_t n) { return rng_.below(n) == 0; }
  std::uint32_t spread() {
    return static_cast<std::uint32_t>(rng_.next() >> (32 + rng_.below(32))) -
           static_cast<std::uint32_t>(rng_.below(64));
  }

  void advance() {
    for (std::size_t axis = 0; axis < 3; ++axis)
      add<std::uint32_t>(4 * axis, one_in(50) ? static_cast<std::uint32_t>(rng_.next()) : spread());
    for (std::size_t i = 12; i < (layout_.layered() ? 22u : 20u); ++i) {
      if (one_in(i == 14 ? 2 : 9)) record_[i] = static_cast<std::byte>(rng_.below(one_in(3) ? 256 : 40));
    }
    if (const auto gps = gps_time_offset(layout_.point_format)) advance_time(*gps);
    for (std::size_t i = layout_.layered() ? 30 : standard_size(layout_.point_format); i < record_.size(); ++i) {
      if (one_in(5)) record_[i] = static_cast<std::byte>(rng_.below(256));
    }
    if (!layout_.layered()) {
      for (std::size_t i = 28; i < standard_size(layout_.point_format); ++i) {
        if (one_in(6)) record_[i] = static_cast<std::byte>(rng_.below(256));
      }
    }
  }
  void advance_time(std::size_t at) {
    if (one_in(3)) return;
    std::uint64_t& clock = clocks_[one_in(4) ? rng_.below(6) : 0];
    if (one_in(40)) clock = rng_.next();
    clock += one_in(8) ? rng_.next() >> (32 + rng_.below(32)) : 1000 * rng_.below(12) - 2000;
    store(&record_[at], clock);
  }

  laz::ChunkLayout layout_;
  Rng rng_;
  std::vector<std::byte> record_;
  std::uint64_t clocks_[6] = {};
};

}  // namespace ilot::test
