// SPDX-License-Identifier: Apache-2.0
#include "engine/run/labelled_clouds.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>

#include "engine/error.h"
#include "engine/formats/las.h"
#include "engine/pass/pass.h"
#include "engine/version.h"
#include "kernels/neighbours/morton.h"
#include "kernels/neighbours/normals.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kBytesPerPoint = 64;
constexpr std::uint32_t kRowSample = 1024;
constexpr std::uint64_t kStretch = 1 << 17;  // rows written at a time

// What is known of one input row.
struct RowLabel {
  std::uint32_t plane = 0;
  float residual = 0;
  PackedNormal normal;
};

// One block's rows in input order: the column "rows", and every 1,024th order kept in memory.
struct BlockRows {
  std::vector<InputOrder> samples;
  InputOrder last = 0;
  std::uint32_t points = 0;
};

void sort_rows(const Store& store, std::uint32_t block, const LabelParams& params) {
  const auto order = store.read<InputOrder>(block, "order");
  const std::vector<std::uint32_t> sorted = sorted_order(order);
  auto plane = store.read<std::uint32_t>(block, "plane");
  auto residual = store.read<float>(block, "residual");
  std::vector<PackedNormal> normals(order.size());
  if (params.write_normals) normals = store.read<PackedNormal>(block, "normals");
  std::vector<InputOrder> orders(order.size());
  std::vector<RowLabel> rows(order.size());
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const std::uint32_t from = sorted[i];
    orders[i] = order[from];
    rows[i] = {params.final_id[plane[from]], residual[from], normals[from]};
  }
  store.write<InputOrder>(block, "row_order", orders);
  store.write<RowLabel>(block, "rows", rows);
}

std::vector<BlockRows> sample_rows(const Store& store) {
  std::vector<BlockRows> all(store.blocks().size());
  for (std::uint32_t b = 0; b < all.size(); ++b) {
    all[b].points = store.blocks()[b].points;
    const ColumnReader reader(store.path(b, "row_order"));
    for (std::uint32_t i = 0; i < all[b].points; i += kRowSample) {
      InputOrder order = 0;
      reader.read<InputOrder>(i, std::span(&order, 1));
      all[b].samples.push_back(order);
    }
    reader.read<InputOrder>(all[b].points - 1, std::span(&all[b].last, 1));
  }
  return all;
}

// Labels of rows [first, first + labels.size()) of a file.
void collect_labels(const Store& store, const std::vector<BlockRows>& blocks, InputOrder first,
                    std::span<RowLabel> labels) {
  const InputOrder end = first + labels.size();
  std::vector<InputOrder> orders;
  std::vector<RowLabel> rows;
  for (std::uint32_t b = 0; b < blocks.size(); ++b) {
    const BlockRows& block = blocks[b];
    if (block.samples.front() >= end || block.last < first) continue;
    const auto lower = std::upper_bound(block.samples.begin(), block.samples.end(), first);
    const auto upper = std::lower_bound(block.samples.begin(), block.samples.end(), end);
    const auto from = static_cast<std::uint32_t>(std::max<std::ptrdiff_t>(0, lower - block.samples.begin() - 1)) * kRowSample;
    const auto to = std::min(block.points, static_cast<std::uint32_t>(upper - block.samples.begin()) * kRowSample);
    orders.resize(to - from);
    rows.resize(to - from);
    ColumnReader(store.path(b, "row_order")).read<InputOrder>(from, orders);
    ColumnReader(store.path(b, "rows")).read<RowLabel>(from, rows);
    for (std::size_t i = 0; i < orders.size(); ++i)
      if (orders[i] >= first && orders[i] < end) labels[orders[i] - first] = rows[i];
  }
}

CloudSpec labelled_spec(const PointReader& input, const LabelParams& params) {
  CloudSpec spec;
  spec.like = input.info();
  spec.software = "ilot " + version();
  spec.appended.push_back({"plane_id", "0 = none", FieldType::u32});
  spec.appended.push_back({"residual", "signed distance to plane, m", FieldType::f32});
  if (params.write_normals)
    for (const char* name : {"NormalX", "NormalY", "NormalZ"})
      spec.appended.push_back({name, "unit normal, 0 0 0 = none", FieldType::f32});
  return spec;
}

void append_label(const RowLabel& label, const LabelParams& params, double metres_per_unit, std::byte* to) {
  store<std::uint32_t>(to, label.plane);
  store<float>(to + 4, label.plane == 0 ? 0.0f : static_cast<float>(label.residual * metres_per_unit));
  if (!params.write_normals) return;
  const std::int16_t n[3]{label.normal.x, label.normal.y, label.normal.z};
  for (int axis = 0; axis < 3; ++axis) store<float>(to + 8 + 4 * axis, static_cast<float>(n[axis]) / 32767.0f);
}

// One output while several threads fill it.
class LabelledCloud {
 public:
  LabelledCloud(const Store& store, const std::vector<BlockRows>& blocks, PointReader& input, std::uint32_t file,
                const LabelParams& params, const fs::path& path, const PassContext& context)
      : store_(store),
        blocks_(blocks),
        input_(input),
        file_(file),
        params_(params),
        context_(context),
        writer_(path, labelled_spec(input, params)) {}

  // Reads, labels and writes rows; rows that are not valid are left out, so first_out is where the next one goes.
  std::uint64_t copy(std::uint64_t first, std::uint64_t count, std::uint64_t first_out) {
    const std::size_t in_length = input_.info().layout.record_length;
    const std::size_t out_length = writer_.record_length();
    std::vector<std::byte> in(count * in_length), out(count * out_length);
    std::vector<std::uint8_t> valid(count);
    std::vector<RowLabel> labels(count);
    if (input_.read(first, in, valid) != count)
      throw Error(input_.info().path.string() + ": can no longer be read in full; the file changed during the run");
    collect_labels(store_, blocks_, input_order(file_, first), labels);
    std::uint64_t written = 0, labelled = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (valid[i] == 0) continue;
      std::byte* row = out.data() + written++ * out_length;
      std::copy_n(in.data() + i * in_length, in_length, row);
      append_label(labels[i], params_, context_.metres_per_unit, row + in_length);
      labelled += labels[i].plane != 0;
    }
    out.resize(written * out_length);
    writer_.write_at(first_out, out);
    PointStatistics part;
    part.add(out, writer_.layout());
    const std::lock_guard lock(mutex_);
    statistics_.merge(part);
    labelled_ += labelled;
    context_.advance(count);
    return written;
  }

  void finish() { writer_.finish(statistics_); }
  std::uint64_t labelled() const { return labelled_; }

 private:
  const Store& store_;
  const std::vector<BlockRows>& blocks_;
  PointReader& input_;
  std::uint32_t file_;
  const LabelParams& params_;
  const PassContext& context_;
  LasFileWriter writer_;
  std::mutex mutex_;
  PointStatistics statistics_;
  std::uint64_t labelled_ = 0;
};

// Every row of a LAS file is valid, so where a stretch goes is known before the others are read.
bool rows_keep_their_place(const PointReader& input) {
  return input.random_access() && !input.info().header.empty();
}

void copy_in_parallel(LabelledCloud& cloud, std::uint64_t points, const PassContext& context) {
  std::vector<PassTask> tasks((points + kStretch - 1) / kStretch, {kStretch * 256, kStretch});
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    const std::uint64_t first = i * kStretch;
    cloud.copy(first, std::min(kStretch, points - first), first);
  });
}

void copy_in_order(LabelledCloud& cloud, std::uint64_t points) {
  std::uint64_t out = 0;
  for (std::uint64_t first = 0; first < points; first += kStretch)
    out += cloud.copy(first, std::min(kStretch, points - first), out);
}

std::vector<std::string> output_names(const std::vector<std::unique_ptr<PointReader>>& inputs) {
  std::map<std::string, int> stems;
  for (const auto& input : inputs) ++stems[input->info().path.stem().string()];
  std::map<std::string, int> used;
  std::vector<std::string> names;
  for (const auto& input : inputs) {
    const fs::path path = fs::absolute(input->info().path);
    std::string name = path.stem().string();
    if (stems[name] > 1) name = path.parent_path().filename().string() + "_" + name;
    const int before = used[name]++;
    names.push_back(before == 0 ? name : name + "_" + std::to_string(before + 1));
  }
  return names;
}

}  // namespace

void rows_pass(const Store& store, const LabelParams& params, const PassContext& context) {
  std::vector<PassTask> tasks;
  for (const Block& b : store.blocks()) tasks.push_back({b.points * kBytesPerPoint, b.points});
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    const auto block = static_cast<std::uint32_t>(i);
    if (!store.has(block, "rows")) sort_rows(store, block, params);
  });
}

std::uint64_t write_labelled_clouds(const Store& store, const std::vector<std::unique_ptr<PointReader>>& inputs,
                                    const LabelParams& params, const fs::path& folder, const PassContext& context) {
  fs::create_directories(folder);
  const std::vector<BlockRows> blocks = sample_rows(store);
  const std::vector<std::string> names = output_names(inputs);
  std::uint64_t labelled = 0;
  for (std::uint32_t f = 0; f < inputs.size(); ++f) {
    LabelledCloud cloud(store, blocks, *inputs[f], f, params, folder / (names[f] + ".las"), context);
    const std::uint64_t points = inputs[f]->info().points;
    if (rows_keep_their_place(*inputs[f])) {
      copy_in_parallel(cloud, points, context);
    } else {
      copy_in_order(cloud, points);
    }
    cloud.finish();
    labelled += cloud.labelled();
  }
  return labelled;
}

}  // namespace ilot
