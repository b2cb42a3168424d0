// SPDX-License-Identifier: Apache-2.0
#include "engine/run/row_labels.h"

#include <algorithm>
#include <numeric>

#include "engine/pass/pass.h"
#include "engine/store/row_order.h"

namespace ilot {
namespace {

constexpr std::uint64_t kBytesPerPoint = 64;
constexpr std::uint32_t kRowSample = 1024;

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
  std::vector<PlaneLabel> rows(sorted.size());
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const std::uint32_t from = sorted[i];
    rows[i] = {params.final_id[plane[from]], shape[from], normals[from], boundary[from]};
  }
  store.write<PlaneLabel>(block, "rows", rows);
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

// What a column of a block, sorted by rows, says of the rows [first, first + labels.size()).
template <class T>
void collect(const Store& store, std::uint32_t block, const char* column, std::uint32_t from,
             std::span<const InputOrder> orders, InputOrder first, std::span<T> labels) {
  std::vector<T> rows(orders.size());
  ColumnReader(store.path(block, column)).read<T>(from, rows);
  for (std::size_t i = 0; i < orders.size(); ++i)
    if (orders[i] >= first && orders[i] < first + labels.size()) labels[orders[i] - first] = rows[i];
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

StretchLabels collect_labels(const Store& store, const std::vector<BlockRows>& blocks, InputOrder first,
                             std::size_t count, const LabelParams& params) {
  StretchLabels labels{std::vector<PlaneLabel>(params.with_planes ? count : 0),
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
    if (params.with_planes) collect<PlaneLabel>(store, b, "rows", from, orders, first, labels.planes);
    if (params.with_roofs) collect<RoofLabel>(store, b, "roof_rows", from, orders, first, labels.roofs);
    if (params.with_streets) collect<StreetLabel>(store, b, "street_rows", from, orders, first, labels.streets);
    if (params.with_facades) collect<FacadeLabel>(store, b, "facade_rows", from, orders, first, labels.facades);
  }
  return labels;
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
