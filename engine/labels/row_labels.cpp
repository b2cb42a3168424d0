// SPDX-License-Identifier: Apache-2.0
#include "engine/labels/row_labels.h"

#include <algorithm>
#include <cstring>
#include <numeric>

#include "engine/pass/pass.h"
#include "engine/pass/resident.h"
#include "engine/store/flushed.h"
#include "engine/store/row_order.h"

namespace ilot {
namespace {

constexpr std::uint64_t kBytesPerPoint = 64;
constexpr std::uint32_t kRowSample = 1024;

// "row_order" is written first: a block is known to be complete by the column that is written last.
void sort_rows(const Store& store, std::uint32_t block, std::span<const ProductLabels> products) {
  const auto order = store.read(block, columns::kOrder);
  const std::vector<std::uint32_t> sorted = points_by_row(store, block, order);
  std::vector<InputOrder> orders(order.size());
  for (std::size_t i = 0; i < sorted.size(); ++i) orders[i] = order[sorted[i]];
  store.write(block, columns::kRowOrder, orders);
  for (const ProductLabels& product : products) product.sort(store, block, sorted);
}

// Decides the class of each row among those that the products give, and whether the row has a label at all.
void set_classes(std::span<const ProductLabels> products, std::size_t count, StretchLabels& rows) {
  rows.classes.assign(count, PointLabel::none);
  rows.labelled.assign(count, 0);
  std::vector<std::uint8_t> decided(count, 0);
  std::vector<PointClass> given(count);
  for (std::size_t p = 0; p < products.size(); ++p) {
    products[p].classify(rows.labels[p], given);
    for (std::size_t i = 0; i < count; ++i) {
      rows.labelled[i] |= given[i].labelled;
      if (decided[i] != 0 || (!given[i].decides && rows.classes[i] != PointLabel::none)) continue;
      rows.classes[i] = given[i].label;
      decided[i] = given[i].decides && given[i].label != PointLabel::none;
    }
  }
  for (std::size_t i = 0; i < count; ++i) rows.labelled[i] |= rows.classes[i] != PointLabel::none;
}

// The rows [from, to) of a block contain all of those in [first, end).
struct RowRange {
  std::uint32_t from = 0, to = 0;
};

RowRange rows_between(const BlockRows& block, InputOrder first, InputOrder end) {
  if (block.samples.front() >= end || block.last < first) return {};
  const auto lower = std::upper_bound(block.samples.begin(), block.samples.end(), first);
  const auto upper = std::lower_bound(block.samples.begin(), block.samples.end(), end);
  return {static_cast<std::uint32_t>(std::max<std::ptrdiff_t>(0, lower - block.samples.begin() - 1)) * kRowSample,
          std::min(block.points, static_cast<std::uint32_t>(upper - block.samples.begin()) * kRowSample)};
}

}  // namespace

void rows_pass(const Store& store, std::span<const ProductLabels> products, const PassContext& context) {
  std::vector<PassTask> tasks;
  for (const Block& b : store.blocks()) tasks.push_back({b.points * kBytesPerPoint, b.points});
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    const auto block = static_cast<std::uint32_t>(i);
    if (!products.back().is_sorted(store, block)) sort_rows(store, block, products);
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
                             std::size_t count, std::span<const ProductLabels> products) {
  StretchLabels rows;
  for (const ProductLabels& product : products) rows.labels.emplace_back(count * product.row_bytes);
  std::vector<InputOrder> orders;
  std::vector<std::byte> stored;
  for (std::uint32_t b = 0; b < blocks.size(); ++b) {
    const auto [from, to] = rows_between(blocks[b], first, first + count);
    if (from == to) continue;
    orders.resize(to - from);
    store.open(b, columns::kRowOrder).read(from, orders);
    for (std::size_t p = 0; p < products.size(); ++p) {
      const std::size_t bytes = products[p].row_bytes;
      stored.resize(orders.size() * bytes);
      products[p].read(store, b, from, stored);
      for (std::size_t i = 0; i < orders.size(); ++i)
        if (orders[i] >= first && orders[i] < first + count)
          std::memcpy(rows.labels[p].data() + (orders[i] - first) * bytes, stored.data() + i * bytes, bytes);
    }
  }
  set_classes(products, count, rows);
  return rows;
}

std::optional<RowsInMemory> rows_in_memory(const Store& store, std::span<const std::uint64_t> rows,
                                           std::span<const ProductLabels> products, const PassContext& context) {
  // Choice: an eighth of what is free; the rest is for the stretches that are written and their compression.
  constexpr std::uint64_t kPart = 8;
  std::uint64_t count = 0, bytes = 0;
  RowsInMemory all;
  for (const std::uint64_t n : rows) {
    all.first.push_back(count);
    count += n;
  }
  for (const ProductLabels& product : products) bytes += product.row_bytes;
  if (count * bytes > affordable(context.budget_bytes) / kPart) return std::nullopt;
  for (const ProductLabels& product : products) all.labels.emplace_back(count * product.row_bytes);
  std::vector<PassTask> tasks;
  for (const Block& b : store.blocks()) tasks.push_back({b.points * kBytesPerPoint, b.points});
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    const auto block = static_cast<std::uint32_t>(i);
    const auto order = store.read(block, columns::kOrder);
    for (std::size_t p = 0; p < products.size(); ++p) {
      const std::size_t width = products[p].row_bytes;
      const std::vector<std::byte> labels = products[p].of_points(store, block);
      for (std::size_t at = 0; at < order.size(); ++at)
        std::memcpy(all.labels[p].data() + (all.first[file_of(order[at])] + row_of(order[at])) * width,
                    labels.data() + at * width, width);
    }
  });
  return all;
}

StretchLabels collect_labels(const RowsInMemory& rows, InputOrder first, std::size_t count,
                             std::span<const ProductLabels> products) {
  StretchLabels found;
  for (std::size_t p = 0; p < products.size(); ++p) {
    const std::size_t width = products[p].row_bytes;
    const auto begin =
        rows.labels[p].begin() + static_cast<std::ptrdiff_t>((rows.first[file_of(first)] + row_of(first)) * width);
    found.labels.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(count * width));
  }
  set_classes(products, count, found);
  return found;
}

std::uint64_t bytes_of_row(std::span<const ProductLabels> products) {
  std::uint64_t all = 0, largest = 0;
  for (const ProductLabels& product : products) {
    all += product.row_bytes;
    largest = std::max<std::uint64_t>(largest, product.row_bytes);
  }
  return sizeof(InputOrder) + all + largest + sizeof(PointClass) + 3;
}

std::uint64_t count_labelled(const Store& store, std::span<const ProductLabels> products, const PassContext& context) {
  std::vector<std::uint64_t> labelled(store.blocks().size(), 0);
  std::vector<PassTask> tasks;
  for (const Block& b : store.blocks()) tasks.push_back({b.points * kBytesPerPoint, b.points});
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    const auto block = static_cast<std::uint32_t>(i);
    StretchLabels points;
    for (const ProductLabels& product : products) points.labels.push_back(product.of_points(store, block));
    set_classes(products, store.blocks()[block].points, points);
    labelled[i] = std::accumulate(points.labelled.begin(), points.labelled.end(), std::uint64_t{0});
  });
  return std::accumulate(labelled.begin(), labelled.end(), std::uint64_t{0});
}

}  // namespace ilot
