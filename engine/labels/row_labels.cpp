// SPDX-License-Identifier: Apache-2.0
#include "engine/labels/row_labels.h"

#include <algorithm>
#include <numeric>

#include "engine/pass/pass.h"
#include "engine/store/flushed.h"
#include "engine/store/row_order.h"

namespace ilot {
namespace {

constexpr std::uint64_t kBytesPerPoint = 64;
constexpr std::uint32_t kRowSample = 1024;

void sort_plane_rows(const Store& store, std::uint32_t block, const LabelParams& params,
                     std::span<const std::uint32_t> sorted) {
  const auto plane = store.read(block, columns::kPlane);
  const auto boundary = store.read(block, columns::kBoundary);
  std::vector<std::uint32_t> shape(sorted.size());
  if (!params.final_shape.empty()) {
    shape = store.read(block, columns::kShape);
    for (std::uint32_t& s : shape) s = params.final_shape[s];
  }
  std::vector<PackedNormal> normals(sorted.size());
  if (params.write_normals) normals = store.read(block, columns::kNormals);
  std::vector<PlaneLabel> rows(sorted.size());
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const std::uint32_t from = sorted[i];
    rows[i] = {params.final_id[plane[from]], shape[from], normals[from], boundary[from]};
  }
  store.write(block, columns::kPlaneRows, rows);
}

template <class T>
void sort_column(const Store& store, std::uint32_t block, const Column<T>& column, const Column<T>& as,
                 std::span<const std::uint32_t> sorted) {
  const auto labels = store.read(block, column);
  std::vector<T> rows(labels.size());
  for (std::size_t i = 0; i < sorted.size(); ++i) rows[i] = labels[sorted[i]];
  store.write(block, as, rows);
}

// "row_order" is written first: a block is known to be complete by the column that is written last.
void sort_rows(const Store& store, std::uint32_t block, const LabelParams& params) {
  const auto order = store.read(block, columns::kOrder);
  const std::vector<std::uint32_t> sorted = points_by_row(store, block, order);
  std::vector<InputOrder> orders(order.size());
  for (std::size_t i = 0; i < sorted.size(); ++i) orders[i] = order[sorted[i]];
  store.write(block, columns::kRowOrder, orders);
  if (params.with_planes) sort_plane_rows(store, block, params, sorted);
  if (params.with_streets) sort_column(store, block, columns::kStreet, columns::kStreetRows, sorted);
  if (params.with_facades) sort_column(store, block, columns::kFacade, columns::kFacadeRows, sorted);
  if (params.with_roofs) sort_column(store, block, columns::kRoof, columns::kRoofRows, sorted);
}

// Collects the values of a column of a block, sorted by rows, for the rows [first, first + labels.size()).
template <class T>
void collect(const Store& store, std::uint32_t block, const Column<T>& column, std::uint32_t from,
             std::span<const InputOrder> orders, InputOrder first, std::span<T> labels) {
  std::vector<T> rows(orders.size());
  store.open(block, column).read(from, rows);
  for (std::size_t i = 0; i < orders.size(); ++i)
    if (orders[i] >= first && orders[i] < first + labels.size()) labels[orders[i] - first] = rows[i];
}

}  // namespace

void rows_pass(const Store& store, const LabelParams& params, const PassContext& context) {
  std::vector<PassTask> tasks;
  for (const Block& b : store.blocks()) tasks.push_back({b.points * kBytesPerPoint, b.points});
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    const auto block = static_cast<std::uint32_t>(i);
    const bool done = params.with_roofs     ? store.has(block, columns::kRoofRows)
                      : params.with_facades ? store.has(block, columns::kFacadeRows)
                      : params.with_streets ? store.has(block, columns::kStreetRows)
                                            : store.has(block, columns::kPlaneRows);
    if (!done) sort_rows(store, block, params);
  });
  flush_pass(store, Pass::rows);
}

std::vector<BlockRows> sample_rows(const Store& store) {
  std::vector<BlockRows> all(store.blocks().size());
  for (std::uint32_t b = 0; b < all.size(); ++b) {
    all[b].points = store.blocks()[b].points;
    const auto reader = store.open(b, columns::kRowOrder);
    for (std::uint32_t i = 0; i < all[b].points; i += kRowSample) {
      all[b].samples.push_back(reader.at(i));
    }
    all[b].last = reader.at(all[b].points - 1);
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
    store.open(b, columns::kRowOrder).read(from, orders);
    if (params.with_planes) collect(store, b, columns::kPlaneRows, from, orders, first, std::span(labels.planes));
    if (params.with_roofs) collect(store, b, columns::kRoofRows, from, orders, first, std::span(labels.roofs));
    if (params.with_streets) collect(store, b, columns::kStreetRows, from, orders, first, std::span(labels.streets));
    if (params.with_facades) collect(store, b, columns::kFacadeRows, from, orders, first, std::span(labels.facades));
  }
  return labels;
}

std::uint64_t count_labelled(const Store& store, const LabelParams& params, const PassContext& context) {
  std::vector<std::uint64_t> labelled(store.blocks().size(), 0);
  std::vector<PassTask> tasks;
  for (const Block& b : store.blocks()) tasks.push_back({b.points * kBytesPerPoint, b.points});
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    const auto block = static_cast<std::uint32_t>(i);
    const auto column = [&]<class T>(bool made, const Column<T>& name, std::vector<T>& values) {
      if (made) values = store.read(block, name);
    };
    std::vector<std::uint32_t> plane, shape;
    StretchLabels labels;
    column(params.with_planes, columns::kPlane, plane);
    column(params.with_planes && !params.final_shape.empty(), columns::kShape, shape);
    column(params.with_roofs, columns::kRoof, labels.roofs);
    column(params.with_streets, columns::kStreet, labels.streets);
    column(params.with_facades, columns::kFacade, labels.facades);
    labels.planes.resize(plane.size());
    for (std::size_t p = 0; p < plane.size(); ++p) {
      labels.planes[p].plane = params.final_id[plane[p]];
      if (!shape.empty()) labels.planes[p].shape = params.final_shape[shape[p]];
    }
    for (std::size_t p = 0; p < store.blocks()[block].points; ++p) labelled[i] += labels.row(p).is_labelled();
  });
  return std::accumulate(labelled.begin(), labelled.end(), std::uint64_t{0});
}

}  // namespace ilot
