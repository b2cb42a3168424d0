// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <string>

#include "engine/error.h"
#include "engine/formats/copc/copc.h"
#include "engine/formats/copc/copc_octree.h"
#include "engine/formats/las/las_header.h"
#include "engine/formats/las/las_plan.h"
#include "engine/formats/las/modern_record.h"
#include "engine/formats/laz/chunk.h"
#include "engine/formats/laz/chunk_table.h"
#include "kernels/core/parallel.h"

namespace ilot {
namespace {

constexpr std::size_t kInfoPlace = las::header_size(4) + las::kVlrHeader;  // of the payload of the info record
constexpr std::size_t kBlockBytes = std::size_t{4} << 20;
constexpr std::uint16_t kInfoId = 1, kHierarchyId = 1000, kWaveformBits = 6;

struct Cube {
  Vec3 center;
  double halfsize = 0;
};

struct TimeRange {
  double min = INFINITY, max = -INFINITY;
};

// The data for compressing one node of a batch.
struct Slot {
  explicit Slot(const laz::ChunkLayout& layout) : encoder(layout) {}
  laz::ChunkEncoder encoder;
  std::vector<std::byte> rows, bytes;
};

Vlr copc_record(std::uint16_t id, const char* description, std::size_t bytes) {
  Vlr vlr;
  vlr.extended = id == kHierarchyId;
  vlr.user_id = "copc";
  vlr.record_id = id;
  vlr.description = description;
  vlr.payload.resize(bytes);
  return vlr;
}

// Returns a cube around the bounds with a margin of one coordinate step on each side, so that no point is on its
// border.
Cube cube_around(const PointStatistics& statistics, const RecordLayout& layout) {
  Cube cube;
  const double step = *std::max_element(layout.scale.begin(), layout.scale.end());
  cube.halfsize = step;
  if (statistics.count == 0) return cube;
  double center[3];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double low = statistics.min[axis], high = statistics.max[axis];
    center[axis] = (low + high) / 2 * layout.scale[axis] + layout.offset[axis];
    cube.halfsize = std::max(cube.halfsize, (high - low) / 2 * layout.scale[axis] + step);
  }
  cube.center = {center[0], center[1], center[2]};
  return cube;
}

std::uint32_t cell_along(double world, double center, double halfsize) {
  constexpr double kCells = 1u << kMortonBits;
  const double cell = std::floor((world - (center - halfsize)) / (2 * halfsize) * kCells);
  return static_cast<std::uint32_t>(std::clamp(cell, 0.0, kCells - 1));
}

std::uint64_t code_of(const std::byte* row, const RecordLayout& layout, const Cube& cube) {
  const auto world = [&](std::size_t axis) {
    return load<std::int32_t>(row + 4 * axis) * layout.scale[axis] + layout.offset[axis];
  };
  return morton_code({cell_along(world(0), cube.center.x, cube.halfsize),
                      cell_along(world(1), cube.center.y, cube.halfsize),
                      cell_along(world(2), cube.center.z, cube.halfsize)});
}

class CopcWriter final : public PointWriter {
 public:
  CopcWriter(const std::filesystem::path& path, const CloudSpec& spec)
      : memory_bytes_(spec.octree_bytes), given_(output_layout(spec)), file_(path), plan_(plan_las(modern_spec(spec))) {
    check_memory(spec.like.points);
    block_rows_ = kBlockBytes / plan_.layout.record_length;
    plan_.header.resize(las::header_size(4));
    store(&plan_.header[las::kHeaderSize], static_cast<std::uint16_t>(plan_.header.size()));
    const auto encoding = load<std::uint16_t>(&plan_.header[las::kGlobalEncoding]);
    store(&plan_.header[las::kGlobalEncoding], static_cast<std::uint16_t>((encoding & ~kWaveformBits) | las::kWktBit));
    compression_.layout = {plan_.layout.point_format, plan_.layout.record_length, 3};
    compression_.chunk_size = laz::kVariableChunks;
    plan_.vlrs.insert(plan_.vlrs.begin(), copc_record(kInfoId, "COPC info", kInfoSize));
    plan_.vlrs.push_back(
        {laz::kLaszipUserId, laz::kLaszipRecordId, "compressed points", laz::laszip_record(compression_)});
  }

  std::size_t record_length() const override { return given_.record_length; }

  void write(std::span<const std::byte> records) override {
    const std::size_t length = given_.record_length, extra = length - standard_size(given_.point_format);
    while (!records.empty()) {
      const std::size_t filled = static_cast<std::size_t>(points_ % block_rows_);
      const std::size_t rows = std::min(records.size() / length, block_rows_ - filled);
      check_memory(points_ + rows);
      if (filled == 0) blocks_.emplace_back().reserve(block_rows_ * plan_.layout.record_length);
      std::vector<std::byte>& block = blocks_.back();
      block.resize((filled + rows) * plan_.layout.record_length);
      modernise(records.first(rows * length), given_.point_format, extra,
                std::span(block).subspan(filled * plan_.layout.record_length));
      points_ += rows;
      records = records.subspan(rows * length);
    }
  }

  void finish() override {
    const PointStatistics statistics = measure();
    const Cube cube = cube_around(statistics, plan_.layout);
    std::vector<CopcPoint> points = place_points(cube);
    const std::vector<CopcNode> nodes = build_copc_octree(points);
    write_prefix();
    write_nodes(nodes, points);
    const std::uint64_t table = file_.position();
    file_.append(laz::encode_chunk_table(chunks_, true));
    std::byte place[8];
    store(place, table);
    file_.write_at(point_offset_, place);
    const std::uint64_t evlrs = file_.position();
    plan_.evlrs.push_back(hierarchy_);
    const std::vector<std::byte> suffix = las_suffix(plan_);
    file_.append(suffix);
    finish_header(plan_, statistics, evlrs);
    file_.write_at(0, plan_.header);
    file_.write_at(kInfoPlace, info_record(cube, file_.position() - hierarchy_.payload.size()));
    file_.commit();
  }

 private:
  // Counts the rows, and the code and the number of each.
  void check_memory(std::uint64_t points) const {
    const std::uint64_t most = memory_bytes_ / (plan_.layout.record_length + sizeof(CopcPoint));
    if (points <= std::min<std::uint64_t>(most, UINT32_MAX)) return;
    throw Error(file_.path().string() + ": more than " + std::to_string(most) + " points of " +
                std::to_string(plan_.layout.record_length) + " bytes do not fit the " +
                std::to_string(memory_bytes_ >> 20) +
                " MiB that sorting them into an octree may take; give more (ilot convert --memory), cut the cloud into "
                "tiles or write plain .laz");
  }

  const std::byte* row(std::uint64_t i) const {
    return &blocks_[static_cast<std::size_t>(i / block_rows_)][i % block_rows_ * plan_.layout.record_length];
  }

  PointStatistics measure() {
    std::vector<PointStatistics> parts(blocks_.size());
    parallel_for(blocks_.size(), [&](std::size_t b) { parts[b].add(blocks_[b], plan_.layout); });
    PointStatistics all;
    for (const PointStatistics& part : parts) all.merge(part);
    const std::size_t at = *gps_time_offset(plan_.layout.point_format);
    for (std::uint64_t i = 0; i < points_; ++i) {
      const auto time = load<double>(row(i) + at);
      if (!std::isfinite(time)) continue;
      times_.min = std::min(times_.min, time);
      times_.max = std::max(times_.max, time);
    }
    return all;
  }

  std::vector<CopcPoint> place_points(const Cube& cube) const {
    std::vector<CopcPoint> points(static_cast<std::size_t>(points_));
    parallel_for(blocks_.size(), [&](std::size_t b) {
      const std::size_t end = std::min(points.size(), (b + 1) * block_rows_);
      for (std::size_t i = b * block_rows_; i < end; ++i)
        points[i] = {code_of(row(i), plan_.layout, cube), static_cast<std::uint32_t>(i)};
    });
    return points;
  }

  void write_prefix() {
    std::vector<std::byte> prefix = las_prefix(plan_);
    prefix[las::kFormat] |= std::byte{0x80};
    plan_.header[las::kFormat] |= std::byte{0x80};
    point_offset_ = prefix.size();
    file_.append(prefix);
    file_.append(std::vector<std::byte>(8));  // space for the place of the table, which is written later
  }

  void write_nodes(const std::vector<CopcNode>& nodes, const std::vector<CopcPoint>& points) {
    std::vector<Slot> slots;
    for (int i = 0; i < thread_count(); ++i) slots.emplace_back(compression_.layout);
    for (std::size_t first = 0; first < nodes.size(); first += slots.size()) {
      const std::size_t batch = std::min(slots.size(), nodes.size() - first);
      parallel_for(batch, [&](std::size_t i) { encode(nodes[first + i], points, slots[i]); });
      for (std::size_t i = 0; i < batch; ++i) append(nodes[first + i], slots[i].bytes);
    }
  }

  void encode(const CopcNode& node, const std::vector<CopcPoint>& points, Slot& slot) const {
    slot.rows.clear();
    slot.bytes.clear();
    for (std::uint64_t i = node.first; i < node.end; ++i) {
      const std::byte* from = row(points[static_cast<std::size_t>(i)].row);
      slot.rows.insert(slot.rows.end(), from, from + plan_.layout.record_length);
    }
    if (!slot.rows.empty()) slot.encoder.encode(slot.rows, slot.bytes);
  }

  // Appends the chunk and its entry in the hierarchy.
  void append(const CopcNode& node, const std::vector<std::byte>& bytes) {
    if (bytes.size() > INT32_MAX)
      throw Error(file_.path().string() + ": a node grew beyond 2 GiB; remove duplicate points or write plain .laz");
    const std::uint64_t points = node.end - node.first;
    std::byte entry[kEntrySize];
    store(entry, std::int32_t{node.level});
    store(entry + 4, static_cast<std::int32_t>(node.cell.x));
    store(entry + 8, static_cast<std::int32_t>(node.cell.y));
    store(entry + 12, static_cast<std::int32_t>(node.cell.z));
    store(entry + 16, points == 0 ? 0 : file_.position());
    store(entry + 24, static_cast<std::int32_t>(bytes.size()));
    store(entry + 28, static_cast<std::int32_t>(points));
    hierarchy_.payload.insert(hierarchy_.payload.end(), entry, entry + kEntrySize);
    if (points == 0) return;
    chunks_.push_back({points, static_cast<std::uint32_t>(bytes.size())});
    file_.append(bytes);
  }

  std::vector<std::byte> info_record(const Cube& cube, std::uint64_t hierarchy) const {
    std::vector<std::byte> info(kInfoSize);
    const bool timed = times_.min <= times_.max;
    const double values[]{cube.center.x, cube.center.y, cube.center.z, cube.halfsize,
                          std::ldexp(cube.halfsize, 1 - kCopcGridBits)};
    for (std::size_t i = 0; i < 5; ++i) store(&info[8 * i], values[i]);
    store(&info[40], hierarchy);
    store(&info[48], static_cast<std::uint64_t>(hierarchy_.payload.size()));
    store(&info[56], timed ? times_.min : 0.0);
    store(&info[64], timed ? times_.max : 0.0);
    return info;
  }

  std::uint64_t memory_bytes_;
  RecordLayout given_;
  OutputFile file_;
  LasPlan plan_;
  laz::Compression compression_;
  std::size_t block_rows_ = 0;
  std::vector<std::vector<std::byte>> blocks_;  // rows, a fixed number in each
  std::uint64_t points_ = 0, point_offset_ = 0;
  TimeRange times_;
  std::vector<laz::ChunkEntry> chunks_;
  Vlr hierarchy_ = copc_record(kHierarchyId, "COPC hierarchy", 0);
};

}  // namespace

std::unique_ptr<PointWriter> create_copc(const std::filesystem::path& path, const CloudSpec& spec) {
  return std::make_unique<CopcWriter>(path, spec);
}

}  // namespace ilot
