// SPDX-License-Identifier: Apache-2.0
// What a product says of points: the fields that it adds to clouds, the columns that their values come from, and the
// class that it gives to a point. Each product makes its own record; engine/labels writes the labels of all of them
// and knows none.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/cloud/record.h"
#include "engine/model/point_label.h"
#include "engine/store/lattice.h"
#include "engine/store/store.h"

namespace ilot {

// Rows of an input that are labelled together, as they are in the file.
struct LabelledRows {
  std::span<const std::byte> records;
  std::size_t record_length = 0;
  std::span<const std::uint8_t> valid;  // 0: the row is not written, its labels need no value
  LatticeMap lattice;
  double metres = 1;  // of a step of the lattice
};

// Where the values of a field go: that of row i to first + i * stride.
struct FieldOutput {
  std::byte* first = nullptr;
  std::size_t stride = 0;
};

// The order of the fields behind those of the input. Fields of the same place are in the order of the products.
enum class FieldPlace : std::uint8_t { plane, unit, object, facade, label, face, normal, last };

// A field that a product adds. `labels` of `write` has one value of the product's rows for each row.
struct LabelField {
  FieldPlace place = FieldPlace::last;
  ExtraField field;
  std::function<void(std::span<const std::byte> labels, const LabelledRows& rows, FieldOutput to)> write;
};

// The class that a product gives to a point. The first product that decides and has a class gives the field `label`.
// Where none does, it is the first class that was given behind the last product that decides for no class.
struct PointClass {
  PointLabel label = PointLabel::none;
  bool decides = false;
  bool labelled = false;  // the point counts as labelled even without a class
};

struct ProductLabels {
  std::vector<LabelField> fields;
  bool gives_classes = false;  // clouds get the field `label`
  std::size_t row_bytes = 0;   // of the label of one point

  // The labels of a block in the order of its points, as bytes.
  std::function<std::vector<std::byte>(const Store& store, std::uint32_t block)> of_points;
  // Writes them in the order `sorted` to a column of their own, and reads from it.
  std::function<void(const Store& store, std::uint32_t block, std::span<const std::uint32_t> sorted)> sort;
  std::function<bool(const Store& store, std::uint32_t block)> is_sorted;
  std::function<void(const Store& store, std::uint32_t block, std::uint64_t first, std::span<std::byte> out)> read;
  // Gives the class of each label; classes.size() labels.
  std::function<void(std::span<const std::byte> labels, std::span<PointClass> classes)> classify;
};

template <class T>
constexpr FieldType label_field_type() {
  if constexpr (std::is_same_v<T, std::uint8_t>) return FieldType::u8;
  if constexpr (std::is_same_v<T, std::uint16_t>) return FieldType::u16;
  if constexpr (std::is_same_v<T, std::uint32_t>) return FieldType::u32;
  if constexpr (std::is_same_v<T, float>) return FieldType::f32;
}

template <class Row>
Row label_at(std::span<const std::byte> labels, std::size_t i) {
  return load<Row>(labels.data() + i * sizeof(Row));
}

// A field whose value is value(label), or value(label, record, rows) where it depends on the position of the point.
// Name and meaning have at most 32 bytes.
template <class Row, class Value>
LabelField label_field(FieldPlace place, const char* name, const char* meaning, Value value) {
  constexpr bool kOfRecord = std::is_invocable_v<Value, const Row&, const std::byte*, const LabelledRows&>;
  const auto value_of = [value](const Row& row, const std::byte* record, const LabelledRows& rows) {
    if constexpr (kOfRecord)
      return value(row, record, rows);
    else
      return value(row);
  };
  using T = std::invoke_result_t<decltype(value_of), const Row&, const std::byte*, const LabelledRows&>;
  return {place,
          {name, meaning, label_field_type<T>()},
          [value_of](std::span<const std::byte> labels, const LabelledRows& rows, FieldOutput to) {
            for (std::size_t i = 0; i < rows.valid.size(); ++i)
              if (rows.valid[i] != 0)
                ilot::store<T>(to.first + i * to.stride,
                               value_of(label_at<Row>(labels, i), rows.records.data() + i * rows.record_length, rows));
          }};
}

template <class Row>
std::vector<std::byte> label_bytes(const std::vector<Row>& rows) {
  const auto bytes = std::as_bytes(std::span(rows));
  return {bytes.begin(), bytes.end()};
}

// Labels that of_points(store, block) gives as values of type Row; `sorted` is the column of the labels by input row,
// and class_of gives the PointClass of one of them.
template <class Row, class OfPoints, class ClassOf>
ProductLabels product_labels(OfPoints of_points, const Column<Row>& sorted, ClassOf class_of,
                             std::vector<LabelField> fields) {
  ProductLabels labels;
  labels.fields = std::move(fields);
  labels.row_bytes = sizeof(Row);
  labels.of_points = [of_points](const Store& store, std::uint32_t block) {
    return label_bytes<Row>(of_points(store, block));
  };
  labels.sort = [of_points, &sorted](const Store& store, std::uint32_t block, std::span<const std::uint32_t> order) {
    const std::vector<Row> points = of_points(store, block);
    std::vector<Row> rows(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) rows[i] = points[order[i]];
    store.write(block, sorted, rows);
  };
  labels.is_sorted = [&sorted](const Store& store, std::uint32_t block) { return store.has(block, sorted); };
  labels.read = [&sorted](const Store& store, std::uint32_t block, std::uint64_t first, std::span<std::byte> out) {
    ColumnInput(store.path(block, sorted), value_type<Row>()).read_bytes(first * sizeof(Row), out);
  };
  labels.classify = [class_of](std::span<const std::byte> bytes, std::span<PointClass> classes) {
    for (std::size_t i = 0; i < classes.size(); ++i) classes[i] = class_of(label_at<Row>(bytes, i));
  };
  return labels;
}

}  // namespace ilot
