// SPDX-License-Identifier: Apache-2.0
// Writes integer points to a LAS file and makes a block store of it. Tests of the engine start from this store.
#pragma once
#include <algorithm>
#include <memory>
#include <vector>

#include "engine/formats/reader.h"
#include "engine/formats/writer.h"
#include "engine/pass/index.h"
#include "kernels/core/rng.h"
#include "tests/support/temporary_folder.h"

namespace ilot::test {

constexpr double kUnit = 0.001;

// Points are lattice coordinates. Their differences from `origin` must fit into 32 bits. Without classes all classes
// are 0.
inline void write_cloud(const std::filesystem::path& path, const std::vector<Index3>& points,
                        const std::vector<std::uint8_t>& classes = {}, std::uint8_t point_format = 0,
                        Index3 origin = {}) {
  CloudSpec spec;
  spec.like.layout.point_format = point_format;
  spec.like.layout.record_length = static_cast<std::uint16_t>(standard_size(point_format));
  spec.like.layout.scale = {kUnit, kUnit, kUnit};
  spec.like.layout.offset = {kUnit * static_cast<double>(origin.x), kUnit * static_cast<double>(origin.y),
                             kUnit * static_cast<double>(origin.z)};
  const std::size_t length = spec.like.layout.record_length;
  std::vector<std::byte> records(points.size() * length);
  for (std::size_t i = 0; i < points.size(); ++i) {
    PointFields f;
    f.x = static_cast<std::int32_t>(points[i].x - origin.x);
    f.y = static_cast<std::int32_t>(points[i].y - origin.y);
    f.z = static_cast<std::int32_t>(points[i].z - origin.z);
    f.intensity = static_cast<std::uint16_t>(i);
    if (!classes.empty()) f.classification = classes[i];
    encode_fields(f, std::span(records).subspan(i * length, length), point_format);
  }
  const auto writer = create_cloud(path, spec);
  writer->write(records);
  writer->finish();
}

// Files in a folder, opened in this order, and the store made from them.
struct FilesStore {
  FilesStore(const std::filesystem::path& folder, const std::vector<const char*>& names, std::uint64_t block_points) {
    for (const char* name : names) inputs.push_back(open_cloud(folder / name));
    IndexParams params;
    params.unit = kUnit;
    params.block_points = block_points;
    params.run_points = 1000;
    cloud = std::make_unique<Store>(build_index(inputs, params, folder / "store", {}).store);
  }
  std::vector<std::unique_ptr<PointReader>> inputs;
  std::unique_ptr<Store> cloud;
};

struct StoreOptions {
  std::uint64_t block_points = 1u << 20;
  std::uint64_t run_points = 1u << 20;
  std::size_t files = 1;  // number of files; the points are distributed to them in consecutive parts
  bool keep_strays = false;
};

// A store of these points in its own folder.
class CloudStore {
 public:
  explicit CloudStore(const std::vector<Index3>& points, const StoreOptions& options = {}) {
    for (std::size_t f = 0; f < options.files; ++f) {
      const auto at = [&](std::size_t n) {
        return points.begin() + static_cast<std::ptrdiff_t>(points.size() * n / options.files);
      };
      const auto path = folder_.path() / ("cloud" + std::to_string(f) + ".las");
      write_cloud(path, {at(f), at(f + 1)});
      inputs_.push_back(open_cloud(path));
    }
    IndexParams params;
    params.unit = kUnit;
    params.block_points = options.block_points;
    params.run_points = options.run_points;
    params.keep_strays = options.keep_strays;
    store_ = std::make_unique<Store>(build_index(inputs_, params, folder_.path() / "store", {}).store);
  }
  const Store& store() const { return *store_; }
  const std::vector<std::unique_ptr<PointReader>>& inputs() const { return inputs_; }
  std::filesystem::path folder() const { return folder_.path(); }

 private:
  TemporaryFolder folder_;
  std::vector<std::unique_ptr<PointReader>> inputs_;
  std::unique_ptr<Store> store_;
};

// Reads a column of the whole store, in global order.
template <class T>
std::vector<T> whole_column(const Store& store, const Column<T>& column) {
  std::vector<T> all;
  for (std::uint32_t b = 0; b < store.blocks().size(); ++b) {
    const auto part = store.read(b, column);
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

inline std::vector<Index3> positions(const Store& store) {
  std::vector<Index3> all;
  for (std::uint32_t b = 0; b < store.blocks().size(); ++b)
    for (const std::uint64_t code : store.read(b, columns::kCodes))
      all.push_back(index_of({store.blocks()[b].node.tile, code}));
  return all;
}

inline std::vector<Index3> in_global_order(std::vector<Index3> points) {
  std::stable_sort(points.begin(), points.end(), [](Index3 a, Index3 b) { return key_of(a) < key_of(b); });
  return points;
}

// Returns points around the origin, where eight tiles meet: a sparse cloud over all tiles, dense places of 300 units,
// and one point that is repeated many times.
inline std::vector<Index3> points_over_tiles(std::size_t n, std::uint64_t key) {
  Rng rng(key);
  const auto within = [&](std::int64_t reach) {
    return static_cast<std::int64_t>(rng.below(static_cast<std::uint64_t>(2 * reach))) - reach;
  };
  std::vector<Index3> points;
  for (std::size_t i = 0; i < n; ++i) {
    switch (rng.below(4)) {
      case 0:
        points.push_back({within(3000000), within(3000000), within(50000)});
        break;
      case 1:
        points.push_back({within(150), within(150), within(150)});
        break;
      case 2:
        points.push_back({2500000 + within(20000), -40000 + within(20000), within(10)});
        break;
      default:
        points.push_back({-1234567, 7654, -1});
        break;
    }
  }
  return points;
}

}  // namespace ilot::test
