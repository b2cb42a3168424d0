// SPDX-License-Identifier: Apache-2.0
// A small street, and a run of it with the product streets.
#pragma once
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "engine/run/run.h"
#include "tests/support/cloud_store.h"
#include "tests/support/file_bytes.h"
#include "training/object_model_training.h"

namespace ilot::test {

inline ObjectModel learn(std::span<const TrainingSample> samples) {
  return train_object_model(samples);
}

inline nlohmann::json record_of(const std::filesystem::path& out) {
  return nlohmann::json::parse(file_bytes(out / "run.json"));
}

struct StreetsOutcome {
  int code = 0;
  nlohmann::json record;
  std::filesystem::path out;
};

inline StreetsOutcome run_cloud(const TemporaryFolder& folder, const std::vector<Index3>& points,
                                const std::string& name, const std::function<void(RunOptions&)>& change = {}) {
  const auto cloud = folder.path() / "street.las";
  write_cloud(cloud, points);
  RunOptions options;
  options.inputs = {cloud};
  options.output = folder.path() / name;
  options.products = {"streets"};
  options.crs = "EPSG:2154";
  options.threads = 2;
  if (change) change(options);
  Progress progress;
  StreetsOutcome out{run(options, progress, learn), {}, options.output};
  out.record = record_of(out.out);
  return out;
}

// The same from the street, without labelled clouds.
inline StreetsOutcome run_mapped(const TemporaryFolder& folder, const std::vector<Index3>& points,
                                 const std::function<void(RunOptions&)>& change = {}) {
  return run_cloud(folder, points, "out", [&](RunOptions& options) {
    options.clouds = false;
    options.settings.streets.view = StreetView::street;
    if (change) change(options);
  });
}

// 24 m of street between facades of 9 m, a point each 5 cm, millimetres; boxes stand on it.
inline std::vector<Index3> street_points(int slope_percent, int boxes, bool right_side = true) {
  Rng rng(3);
  std::vector<Index3> points;
  for (std::int64_t x = 0; x < 24000; x += 50)
    for (std::int64_t y = 0; y < 12000; y += 50) {
      const std::int64_t base = 30000 + x * slope_percent / 100 + static_cast<std::int64_t>(rng.below(15));
      if (y < 600 || (right_side && y >= 11400)) {
        for (std::int64_t z = 0; z < 9000; z += 450) points.push_back({700000000 + x, 660000000 + y, base + z});
        continue;
      }
      bool on_box = false;
      for (std::int64_t b = 0; b < boxes; ++b)
        on_box |= x >= 3000 + 6000 * b && x < 7000 + 6000 * b && y >= 3000 && y < 4700;
      points.push_back({700000000 + x, 660000000 + y, base + (on_box ? 1400 : 0)});
    }
  return points;
}

}  // namespace ilot::test
