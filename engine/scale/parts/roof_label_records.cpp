// SPDX-License-Identifier: Apache-2.0
#include "engine/scale/parts/roof_label_records.h"

#include <algorithm>

#include "engine/error.h"
#include "engine/scale/parts/record_bytes.h"

namespace ilot {
namespace {

using nlohmann::json;

// The codes of a block by its chunks: a building has points in few of them.
class CodesOfBlock {
 public:
  CodesOfBlock(const Store& store, std::uint32_t block)
      : reader_(store.open(block, columns::kCodes)), points_(store.blocks()[block].points) {}

  std::uint64_t code(std::uint32_t point) {
    const std::uint32_t first = point / kChunkPoints * kChunkPoints;
    if (codes_.empty() || first != first_) {
      first_ = first;
      codes_.resize(std::min(kChunkPoints, points_ - first));
      reader_.read(first, codes_);
    }
    return codes_[point - first];
  }

 private:
  ColumnReader<std::uint64_t> reader_;
  std::uint32_t points_ = 0, first_ = 0;
  std::vector<std::uint64_t> codes_;
};

// How many points before this one have its code.
std::uint32_t number_at_place(CodesOfBlock& codes, std::uint32_t point, std::uint64_t code) {
  std::uint32_t before = 0;
  while (before < point && codes.code(point - before - 1) == code) ++before;
  return before;
}

}  // namespace

PlacedLabels stored_labels(const Store& store, std::uint32_t site, const LabelRun& run) {
  PlacedLabels placed{site, store.blocks()[run.block].node.tile, std::vector<std::uint64_t>(run.count),
                      std::vector<SitePointLabel>(run.count)};
  ColumnReader<SitePointLabel>(store.folder() / "roofs" / "labels").read(run.first, placed.labels);
  CodesOfBlock codes(store, run.block);
  std::uint32_t first = 0;  // the first point of the block that has the code
  for (std::size_t i = 0; i < placed.labels.size(); ++i) {
    std::uint32_t& point = placed.labels[i].point;
    placed.codes[i] = codes.code(point);
    if (i == 0 || placed.codes[i] != placed.codes[i - 1])
      first = point - number_at_place(codes, point, placed.codes[i]);
    point -= first;
  }
  return placed;
}

void find_points(std::span<const std::uint64_t> block, std::span<const std::uint64_t> codes,
                 std::vector<SitePointLabel>& labels) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < codes.size(); ++i) {
    const auto place = static_cast<std::uint64_t>(std::ranges::lower_bound(block, codes[i]) - block.begin());
    const std::uint64_t point = place + labels[i].point;
    if (point >= block.size() || block[point] != codes[i]) continue;
    labels[kept] = labels[i];
    labels[kept++].point = static_cast<std::uint32_t>(point);
  }
  labels.resize(kept);
}

json record_of(const PlacedLabels& labels) {
  return {{"labels_of", labels.site},
          {"tile", {labels.tile.x, labels.tile.y, labels.tile.z}},
          {"codes", bytes_json(labels.codes)},
          {"labels", bytes_json(labels.labels)}};
}

bool is_placed_labels(const json& record) {
  return record.contains("labels_of");
}

PlacedLabels placed_labels(const json& record) {
  const json& tile = record.at("tile");
  PlacedLabels r{record.at("labels_of").get<std::uint32_t>(),
                 {tile.at(0).get<std::int32_t>(), tile.at(1).get<std::int32_t>(), tile.at(2).get<std::int32_t>()},
                 values_of<std::uint64_t>(record, "codes"),
                 values_of<SitePointLabel>(record, "labels")};
  if (r.codes.size() != r.labels.size()) throw Error("the labels of a building do not belong together");
  return r;
}

}  // namespace ilot
