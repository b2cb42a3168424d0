// SPDX-License-Identifier: Apache-2.0
// The labels that products give to the rows of the inputs: sorted by input row in each block, and read back in
// stretches. The products of a run are given in the order in which their classes count.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/pass/context.h"
#include "engine/products/product_labels.h"
#include "engine/store/store.h"

namespace ilot {

// Sorts the labels of each block by input order ("rows", "roof_rows"...), so that the labels of a stretch of an input
// are found with few reads.
void rows_pass(const Store& store, std::span<const ProductLabels> products, const PassContext& context);

// Labels of consecutive rows of a file, or of the points of a block.
struct StretchLabels {
  std::vector<std::vector<std::byte>> labels;  // by product: a value for each row
  std::vector<PointLabel> classes;             // by row
  std::vector<std::uint8_t> labelled;          // by row: 1 = has a label or a class
};

// The rows of one block in input order; every 1,024th order is kept in memory.
struct BlockRows {
  std::vector<InputOrder> samples;
  InputOrder last = 0;
  std::uint32_t points = 0;
};

// The rows of all blocks, after rows_pass.
std::vector<BlockRows> sample_rows(const Store& store);

// Gives the labels of the input rows [first, first + count). Needs few reads for each block that contains one of them.
StretchLabels collect_labels(const Store& store, const std::vector<BlockRows>& blocks, InputOrder first,
                             std::size_t count, std::span<const ProductLabels> products);

// The labels of all rows of the inputs, as rows_pass gives them, without a column of the store.
struct RowsInMemory {
  std::vector<std::uint64_t> first;            // by file: its first row among the rows of all files
  std::vector<std::vector<std::byte>> labels;  // by product: a value for each row of all files
};

// Gives none where the labels would take more than an eighth of the memory that is free; then rows_pass sorts them.
// `rows` has the number of rows of each file.
std::optional<RowsInMemory> rows_in_memory(const Store& store, std::span<const std::uint64_t> rows,
                                           std::span<const ProductLabels> products, const PassContext& context);

// The same as the function above for the rows [first, first + count) of a file.
StretchLabels collect_labels(const RowsInMemory& rows, InputOrder first, std::size_t count,
                             std::span<const ProductLabels> products);

// The bytes of the labels of one row in memory, at most, while a stretch is collected.
std::uint64_t bytes_of_row(std::span<const ProductLabels> products);

// The number of points that have a label; no rows are sorted for it.
std::uint64_t count_labelled(const Store& store, std::span<const ProductLabels> products, const PassContext& context);

}  // namespace ilot
