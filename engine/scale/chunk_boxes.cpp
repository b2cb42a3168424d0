// SPDX-License-Identifier: Apache-2.0
#include "engine/scale/chunk_boxes.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "engine/error.h"
#include "engine/scale/records.h"

namespace ilot {

std::size_t ChunkBoxes::chunk_of(std::uint64_t row) const {
  return static_cast<std::size_t>(std::upper_bound(rows.begin(), rows.end(), row) - rows.begin()) - 1;
}

IndexBox ChunkBoxes::all() const {
  IndexBox whole = IndexBox::none();
  for (const IndexBox& box : boxes)
    if (!box.is_empty()) whole.add_box(box);
  return whole;
}

std::vector<ChunkBoxes> chunks_of(const std::vector<std::unique_ptr<PointReader>>& inputs) {
  std::vector<ChunkBoxes> all;
  for (const auto& input : inputs) {
    ChunkBoxes& chunks = all.emplace_back();
    chunks.rows = input->random_access() ? input->boundaries() : std::vector<std::uint64_t>{0, input->info().points};
    chunks.boxes.resize(chunks.rows.size() - 1, IndexBox::none());
  }
  return all;
}

std::vector<RowRange> rows_that_meet(const ChunkBoxes& chunks, const IndexBox& box) {
  std::vector<RowRange> ranges;
  for (std::size_t i = 0; i < chunks.boxes.size(); ++i) {
    if (chunks.boxes[i].is_empty() || !chunks.boxes[i].intersects(box)) continue;
    if (ranges.empty() || ranges.back().end != chunks.rows[i]) ranges.push_back({chunks.rows[i], chunks.rows[i]});
    ranges.back().end = chunks.rows[i + 1];
  }
  return ranges;
}

void write_chunks(const std::filesystem::path& path, const ChunkBoxes& chunks) {
  RecordFileWriter file(path, {{"kind", "chunks"}});
  for (std::size_t i = 0; i < chunks.boxes.size(); ++i) {
    const IndexBox& b = chunks.boxes[i];
    file.add({chunks.rows[i], chunks.rows[i + 1], b.min.x, b.min.y, b.min.z, b.max.x, b.max.y, b.max.z});
  }
  file.finish();
}

ChunkBoxes read_chunks(const std::filesystem::path& path) {
  ChunkBoxes chunks{{0}, {}};
  RecordFileReader file(path);
  try {
    while (const auto record = file.next()) {
      const auto v = record->get<std::array<std::int64_t, 8>>();
      chunks.rows.push_back(static_cast<std::uint64_t>(v[1]));
      chunks.boxes.push_back({{v[2], v[3], v[4]}, {v[5], v[6], v[7]}});
    }
  } catch (const nlohmann::json::exception&) {
    throw Error(path.string() + ": is damaged; make the plan again");
  }
  return chunks;
}

}  // namespace ilot
