// SPDX-License-Identifier: Apache-2.0
#include "engine/run/labelled_clouds.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "engine/error.h"
#include "engine/formats/writer.h"
#include "engine/pass/pass.h"
#include "engine/run/facade_labels.h"
#include "engine/run/roof_labels.h"
#include "engine/run/street_labels.h"
#include "engine/store/row_order.h"
#include "engine/version.h"
#include "kernels/core/parallel.h"
#include "kernels/neighbours/normals.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kBytesPerPoint = 64;
constexpr std::uint32_t kRowSample = 1024;
constexpr std::uint64_t kStretch = 50000;  // rows labelled at a time: a chunk of the output

// What the planes say of one input row.
struct RowLabel {
  std::uint32_t plane = 0, shape = 0;
  PackedNormal normal;
  std::uint8_t boundary = 0;
};

// One block's rows in input order, and every 1,024th order kept in memory.
struct BlockRows {
  std::vector<InputOrder> samples;
  InputOrder last = 0;
  std::uint32_t points = 0;
};

void sort_plane_rows(const Store& store, std::uint32_t block, const LabelParams& params,
                     std::span<const std::uint32_t> sorted) {
  const auto plane = store.read<std::uint32_t>(block, "plane");
  const auto boundary = store.read<std::uint8_t>(block, "boundary");
  std::vector<std::uint32_t> shape(sorted.size());
  if (!params.final_shape.empty()) {
    shape = store.read<std::uint32_t>(block, "shape");
    for (std::uint32_t& s : shape) s = params.final_shape[s];
  }
  std::vector<PackedNormal> normals(sorted.size());
  if (params.write_normals) normals = store.read<PackedNormal>(block, "normals");
  std::vector<RowLabel> rows(sorted.size());
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const std::uint32_t from = sorted[i];
    rows[i] = {params.final_id[plane[from]], shape[from], normals[from], boundary[from]};
  }
  store.write<RowLabel>(block, "rows", rows);
}

template <class T>
void sort_column(const Store& store, std::uint32_t block, const char* column, const char* as,
                 std::span<const std::uint32_t> sorted) {
  const auto labels = store.read<T>(block, column);
  std::vector<T> rows(labels.size());
  for (std::size_t i = 0; i < sorted.size(); ++i) rows[i] = labels[sorted[i]];
  store.write<T>(block, as, rows);
}

// "row_order" is written first: whoever looks for finished blocks asks for what is written last.
void sort_rows(const Store& store, std::uint32_t block, const LabelParams& params) {
  const auto order = store.read<InputOrder>(block, "order");
  const std::vector<std::uint32_t> sorted = points_by_row(store, block, order);
  std::vector<InputOrder> orders(order.size());
  for (std::size_t i = 0; i < sorted.size(); ++i) orders[i] = order[sorted[i]];
  store.write<InputOrder>(block, "row_order", orders);
  if (params.with_planes) sort_plane_rows(store, block, params, sorted);
  if (params.with_streets) sort_column<StreetLabel>(store, block, "street", "street_rows", sorted);
  if (params.with_facades) sort_column<FacadeLabel>(store, block, "facade", "facade_rows", sorted);
  if (params.with_roofs) sort_column<RoofLabel>(store, block, "roof", "roof_rows", sorted);
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

// What the products say of one input row; nullptr: the product did not run.
struct RowOf {
  const RowLabel* plane = nullptr;
  const RoofLabel* roof = nullptr;
  const StreetLabel* street = nullptr;
  const FacadeLabel* facade = nullptr;

  // A building's word comes first, then a facade's, then the street's.
  PointLabel label() const {
    if (roof != nullptr && roof->unit != 0) return roof->label;
    if (facade != nullptr && facade->facade != 0) return facade->label;
    if (street != nullptr && street->label != PointLabel::none) return street->label;
    return roof == nullptr ? PointLabel::none : roof->label;
  }
  bool says_anything() const {
    return (plane != nullptr && (plane->plane != 0 || plane->shape != 0)) || (roof != nullptr && roof->unit != 0) ||
           (street != nullptr && street->object != 0) || label() != PointLabel::none;
  }
};

// Labels of consecutive rows of a file, or of the points of a block; empty: of a product that did not run.
struct StretchLabels {
  std::vector<RowLabel> planes;
  std::vector<RoofLabel> roofs;
  std::vector<StreetLabel> streets;
  std::vector<FacadeLabel> facades;

  RowOf row(std::size_t i) const {
    return {planes.empty() ? nullptr : &planes[i], roofs.empty() ? nullptr : &roofs[i],
            streets.empty() ? nullptr : &streets[i], facades.empty() ? nullptr : &facades[i]};
  }
};

// What a column of a block, sorted by rows, says of the rows [first, first + labels.size()).
template <class T>
void collect(const Store& store, std::uint32_t block, const char* column, std::uint32_t from,
             std::span<const InputOrder> orders, InputOrder first, std::span<T> labels) {
  std::vector<T> rows(orders.size());
  ColumnReader(store.path(block, column)).read<T>(from, rows);
  for (std::size_t i = 0; i < orders.size(); ++i)
    if (orders[i] >= first && orders[i] < first + labels.size()) labels[orders[i] - first] = rows[i];
}

StretchLabels collect_labels(const Store& store, const std::vector<BlockRows>& blocks, InputOrder first,
                             std::size_t count, const LabelParams& params) {
  StretchLabels labels{std::vector<RowLabel>(params.with_planes ? count : 0),
                       std::vector<RoofLabel>(params.with_roofs ? count : 0),
                       std::vector<StreetLabel>(params.with_streets ? count : 0),
                       std::vector<FacadeLabel>(params.with_facades ? count : 0)};
  const InputOrder end = first + count;
  std::vector<InputOrder> orders;
  for (std::uint32_t b = 0; b < blocks.size(); ++b) {
    const BlockRows& block = blocks[b];
    if (block.samples.front() >= end || block.last < first) continue;
    const auto lower = std::upper_bound(block.samples.begin(), block.samples.end(), first);
    const auto upper = std::lower_bound(block.samples.begin(), block.samples.end(), end);
    const auto from =
        static_cast<std::uint32_t>(std::max<std::ptrdiff_t>(0, lower - block.samples.begin() - 1)) * kRowSample;
    const auto to = std::min(block.points, static_cast<std::uint32_t>(upper - block.samples.begin()) * kRowSample);
    orders.resize(to - from);
    ColumnReader(store.path(b, "row_order")).read<InputOrder>(from, orders);
    if (params.with_planes) collect<RowLabel>(store, b, "rows", from, orders, first, labels.planes);
    if (params.with_roofs) collect<RoofLabel>(store, b, "roof_rows", from, orders, first, labels.roofs);
    if (params.with_streets) collect<StreetLabel>(store, b, "street_rows", from, orders, first, labels.streets);
    if (params.with_facades) collect<FacadeLabel>(store, b, "facade_rows", from, orders, first, labels.facades);
  }
  return labels;
}

CloudSpec labelled_spec(const PointReader& input, const LabelParams& params) {
  CloudSpec spec;
  spec.like = input.info();
  spec.software = "ilot " + version();
  const auto add = [&](const char* name, const char* meaning, FieldType type) {
    spec.appended.push_back({name, meaning, type});
  };
  if (params.with_planes || params.with_roofs) add("plane_id", "0 = none", FieldType::u32);
  if (params.with_planes) {
    add("residual", "signed distance to plane, m", FieldType::f32);
    add("boundary", "1 = on its plane's outline", FieldType::u8);
    if (!params.final_shape.empty()) add("shape_id", "sphere, cylinder, cone; 0 = none", FieldType::u32);
  }
  if (params.with_roofs) add("unit_id", "building, 0 = none", FieldType::u32);
  if (params.with_streets) add("object_id", "on the street, 0 = none", FieldType::u32);
  if (params.with_facades) add("facade_id", "0 = none", FieldType::u16);
  if (params.with_facades) add("element_id", "on its facade, 0 = none", FieldType::u32);
  if (params.with_roofs || params.with_streets || params.with_facades)
    add("label", "1 ground, 2 roof, 5 facade...", FieldType::u8);
  if (params.with_roofs) {
    if (params.with_planes) add("roof_plane_id", "roof face, 0 = none", FieldType::u32);
  }
  if (params.write_normals)
    for (const char* name : {"NormalX", "NormalY", "NormalZ"}) add(name, "unit normal, 0 0 0 = none", FieldType::f32);
  return spec;
}

// Signed distance from the coordinates as they stand in the input, in lattice units.
double residual(const std::byte* record, const LatticeMap& lattice, const JoinedPlane& plane) {
  const Vec3 offset = lattice.offset_from(plane.anchor, load<std::int32_t>(record), load<std::int32_t>(record + 4),
                                          load<std::int32_t>(record + 8));
  return signed_distance(plane.plane, offset);
}

// Appends values behind a record, one after the other.
class Appender {
 public:
  explicit Appender(std::byte* to) : to_(to) {}
  template <class T>
  void add(T value) {
    store<T>(to_, value);
    to_ += sizeof value;
  }

 private:
  std::byte* to_;
};

// In the order of labelled_spec().
void append_labels(const RowOf& row, double residual_m, const LabelParams& params, std::byte* to) {
  Appender out(to);
  if (row.plane != nullptr || row.roof != nullptr)
    out.add<std::uint32_t>(row.plane != nullptr ? row.plane->plane : row.roof->plane);
  if (row.plane != nullptr) {
    out.add<float>(static_cast<float>(residual_m));
    out.add<std::uint8_t>(row.plane->boundary);
    if (!params.final_shape.empty()) out.add<std::uint32_t>(row.plane->shape);
  }
  if (row.roof != nullptr) out.add<std::uint32_t>(row.roof->unit);
  if (row.street != nullptr) out.add<std::uint32_t>(row.street->object);
  if (row.facade != nullptr) {
    out.add<std::uint16_t>(row.facade->facade);
    out.add<std::uint32_t>(row.facade->element);
  }
  if (row.roof != nullptr || row.street != nullptr || row.facade != nullptr)
    out.add<std::uint8_t>(static_cast<std::uint8_t>(row.label()));
  if (row.roof != nullptr && row.plane != nullptr) out.add<std::uint32_t>(row.roof->plane);
  if (row.plane == nullptr || !params.write_normals) return;
  for (const std::int16_t n : {row.plane->normal.x, row.plane->normal.y, row.plane->normal.z})
    out.add<float>(static_cast<float>(n) / 32767.0f);
}

// A stretch of one input on its way to the output.
struct Stretch {
  std::uint64_t first = 0, count = 0;
  std::vector<std::byte> rows;  // labelled, those that are not valid left out
  std::uint64_t labelled = 0;
};

class Labeller {
 public:
  Labeller(const Store& store, const std::vector<BlockRows>& blocks, const LabelParams& params,
           const PassContext& context)
      : store_(store), blocks_(blocks), params_(params), context_(context) {}

  void fill(Stretch& s, PointReader& input, std::uint32_t file, std::size_t out_length) const {
    const std::size_t in_length = input.info().layout.record_length;
    std::vector<std::byte> in(s.count * in_length);
    std::vector<std::uint8_t> valid(s.count);
    if (input.read(s.first, in, valid) != s.count)
      throw Error(input.info().path.string() + ": can no longer be read in full; the file changed during the run");
    const StretchLabels labels = collect_labels(store_, blocks_, input_order(file, s.first), s.count, params_);
    const LatticeMap lattice(input.info().layout, store_.unit());
    const double metres = store_.unit() * context_.metres_per_unit;
    s.rows.resize(s.count * out_length);
    std::byte* row = s.rows.data();
    for (std::size_t i = 0; i < s.count; ++i) {
      if (valid[i] == 0) continue;
      std::copy_n(in.data() + i * in_length, in_length, row);
      const RowOf say = labels.row(i);
      const bool on_plane = say.plane != nullptr && say.plane->plane != 0;
      const double distance = on_plane ? metres * residual(row, lattice, params_.planes[say.plane->plane - 1]) : 0;
      append_labels(say, distance, params_, row + in_length);
      s.labelled += say.says_anything();
      row += out_length;
    }
    s.rows.resize(static_cast<std::size_t>(row - s.rows.data()));
  }

  // Stretches are read and labelled in parallel, a few at a time, and written in order.
  std::uint64_t copy(PointReader& input, std::uint32_t file, PointWriter& writer) const {
    const std::size_t together = input.random_access() ? 2 * static_cast<std::size_t>(thread_count()) : 1;
    std::vector<Stretch> batch;
    std::uint64_t labelled = 0, first = 0;
    while (first < input.info().points) {
      stop_if_asked();
      batch.clear();
      for (; batch.size() < together && first < input.info().points; first += batch.back().count)
        batch.push_back({first, std::min(kStretch, input.info().points - first), {}, 0});
      parallel_for(batch.size(), [&](std::size_t i) { fill(batch[i], input, file, writer.record_length()); });
      for (const Stretch& s : batch) {
        writer.write(s.rows);
        labelled += s.labelled;
        context_.advance(s.count);
      }
    }
    writer.finish();
    return labelled;
  }

 private:
  const Store& store_;
  const std::vector<BlockRows>& blocks_;
  const LabelParams& params_;
  const PassContext& context_;
};

std::vector<std::string> output_names(const std::vector<std::unique_ptr<PointReader>>& inputs) {
  std::map<std::string, int> stems;
  for (const auto& input : inputs) ++stems[cloud_stem(input->info().path)];
  std::set<std::string> used;
  for (const auto& [stem, count] : stems)
    if (count == 1) used.insert(stem);
  std::vector<std::string> names;
  for (const auto& input : inputs) {
    const fs::path path = fs::absolute(input->info().path);
    std::string name = cloud_stem(path);
    if (stems[name] > 1) {
      const std::string base = path.parent_path().filename().string() + "_" + name;
      name = base;
      for (int n = 2; !used.insert(name).second; ++n) name = base + "_" + std::to_string(n);
    }
    names.push_back(name);
  }
  return names;
}

}  // namespace

void rows_pass(const Store& store, const LabelParams& params, const PassContext& context) {
  std::vector<PassTask> tasks;
  for (const Block& b : store.blocks()) tasks.push_back({b.points * kBytesPerPoint, b.points});
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    const auto block = static_cast<std::uint32_t>(i);
    const char* last = params.with_roofs     ? "roof_rows"
                       : params.with_facades ? "facade_rows"
                       : params.with_streets ? "street_rows"
                                             : "rows";
    if (!store.has(block, last)) sort_rows(store, block, params);
  });
}

std::uint64_t write_labelled_clouds(const Store& store, const std::vector<std::unique_ptr<PointReader>>& inputs,
                                    const LabelParams& params, const fs::path& folder, const PassContext& context) {
  fs::create_directories(folder);
  const std::vector<BlockRows> blocks = sample_rows(store);
  const std::vector<std::string> names = output_names(inputs);
  const Labeller labeller(store, blocks, params, context);
  std::uint64_t labelled = 0;
  for (std::uint32_t f = 0; f < inputs.size(); ++f) {
    const auto writer = create_cloud(folder / (names[f] + kCloudExtension), labelled_spec(*inputs[f], params));
    labelled += labeller.copy(*inputs[f], f, *writer);
  }
  return labelled;
}

std::uint64_t count_labelled(const Store& store, const LabelParams& params, const PassContext& context) {
  std::vector<std::uint64_t> labelled(store.blocks().size(), 0);
  std::vector<PassTask> tasks;
  for (const Block& b : store.blocks()) tasks.push_back({b.points * kBytesPerPoint, b.points});
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    const auto block = static_cast<std::uint32_t>(i);
    const auto column = [&]<class T>(bool made, const char* name, std::vector<T>& values) {
      if (made) values = store.read<T>(block, name);
    };
    std::vector<std::uint32_t> plane, shape;
    StretchLabels labels;
    column(params.with_planes, "plane", plane);
    column(params.with_planes && !params.final_shape.empty(), "shape", shape);
    column(params.with_roofs, "roof", labels.roofs);
    column(params.with_streets, "street", labels.streets);
    column(params.with_facades, "facade", labels.facades);
    labels.planes.resize(plane.size());
    for (std::size_t p = 0; p < plane.size(); ++p) {
      labels.planes[p].plane = params.final_id[plane[p]];
      if (!shape.empty()) labels.planes[p].shape = params.final_shape[shape[p]];
    }
    for (std::size_t p = 0; p < store.blocks()[block].points; ++p) labelled[i] += labels.row(p).says_anything();
  });
  return std::accumulate(labelled.begin(), labelled.end(), std::uint64_t{0});
}

}  // namespace ilot
