// SPDX-License-Identifier: Apache-2.0
#include "engine/run/run_estimate.h"

#include <algorithm>

namespace ilot {
namespace {

// What a product adds to the index, each point. The bytes are measured and rounded up: the largest share of a district
// of 100,000 and 500,000 points and of a coloured facade of 200,000 (planes 92, roofs 86, facades 100, streets 44 and
// all four 172 bytes with the index). The seconds are the means of these runs on one thread.
struct Share {
  const char* product;
  double store_bytes, result_bytes, microseconds;
};
constexpr Share kIndex{"", 44, 0, 0.5};
constexpr Share kPlanes{"planes", 48, 6, 2.5};
constexpr Share kOthers[]{{"roofs", 44, 8, 1.5}, {"facades", 16, 12, 1.5}, {"streets", 30, 8, 1.0}};
constexpr std::uint64_t kTables = 1u << 20;  // of a product of a cloud of few points: a GeoPackage is 100 KB when empty
constexpr std::uint64_t kLabels = 44;        // of a point, all of them and its normal

bool makes(const RunOptions& options, const char* product) {
  return std::find(options.products.begin(), options.products.end(), product) != options.products.end();
}

}  // namespace

RunEstimate estimate_run(const RunOptions& options, const RunInputs& inputs) {
  const auto points = static_cast<double>(inputs.points);
  RunEstimate estimate;
  const auto add = [&](const Share& share) {
    estimate.store_bytes += static_cast<std::uint64_t>(points * share.store_bytes) + kTables;
    estimate.result_bytes += static_cast<std::uint64_t>(points * share.result_bytes) + kTables;
    estimate.processor_seconds += points * share.microseconds * 1e-6;
  };
  add(kIndex);
  if (makes(options, "planes") || makes(options, "facades")) add(kPlanes);  // facades are found among planes
  for (const Share& share : kOthers)
    if (makes(options, share.product)) add(share);
  if (!options.clouds) return estimate;
  for (const auto& reader : inputs.readers)
    estimate.result_bytes += reader->info().points * (reader->info().layout.record_length + kLabels);
  return estimate;
}

}  // namespace ilot
