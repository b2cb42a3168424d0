// SPDX-License-Identifier: Apache-2.0
// Brings a value of every input row to the points of the store. The inputs are read once more into files by row, and
// each block gathers its values from these files. Therefore the memory is that of one block.
#pragma once
#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/error.h"
#include "engine/formats/reader.h"
#include "engine/formats/row_buffer.h"
#include "engine/pass/context.h"
#include "engine/pass/pass.h"
#include "engine/store/row_order.h"
#include "engine/store/store.h"

namespace ilot {

// Rows of one input whose values are in one file.
struct RowStretch {
  std::size_t file = 0;
  std::uint64_t first = 0, count = 0;
};

// The stretches of the inputs that are wanted, in the order of files and rows. An input without random access is one
// stretch.
std::vector<RowStretch> row_stretches(const std::vector<std::unique_ptr<PointReader>>& inputs,
                                      const std::function<bool(std::size_t)>& wanted);

// `Value` is plain data. The files are in a folder of the store. Files that an earlier run has completed are kept.
template <class Value>
class RowValues {
 public:
  // `store` and `inputs` must outlive this object.
  RowValues(const Store& store, const char* folder, const std::vector<std::unique_ptr<PointReader>>& inputs,
            const std::function<bool(std::size_t)>& wanted)
      : store_(store), folder_(store.folder() / folder), inputs_(inputs), stretches_(row_stretches(inputs, wanted)) {}

  bool empty() const { return stretches_.empty(); }
  const std::vector<RowStretch>& stretches() const { return stretches_; }

  // Reads every stretch: value_of(record, layout) of each row, and the sum of the valid ones by add(sum, value).
  template <class ValueOf, class Add>
  void read(std::uint32_t fields, const PassContext& context, const ValueOf& value_of, const Add& add) const {
    std::filesystem::create_directories(folder_);
    std::vector<PassTask> tasks;
    for (const RowStretch& s : stretches_)
      tasks.push_back({rows_at_once(s) * (inputs_[s.file]->info().layout.record_length + sizeof(Value)), s.count});
    for (const auto& input : inputs_) input->limit_to(fields);
    run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
      if (!std::filesystem::exists(path(stretches_[i]))) write(stretches_[i], value_of, add);
    });
    for (const auto& input : inputs_) input->limit_to(kAllFields);
  }

  Value sum(const RowStretch& s) const { return ColumnReader<Value>(path(s)).at(s.count); }

  // Writes the column of every block that does not have it: stored(value, file) for each point, and `none` for points
  // whose input is not wanted.
  template <class Stored, class ToStored>
  void gather(const Column<Stored>& column, Stored none, const PassContext& context, const ToStored& stored) const {
    constexpr std::uint64_t kBytesPerPoint = 52;
    std::vector<PassTask> tasks;
    for (const Block& b : store_.blocks()) tasks.push_back({b.points * kBytesPerPoint, b.points});
    run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
      const auto block = static_cast<std::uint32_t>(i);
      if (store_.has(block, column)) return;
      const auto order = store_.read(block, columns::kOrder);
      std::vector<Stored> values(order.size(), none);
      AscendingReader rows(*this);
      for (const std::uint32_t p : points_by_row(store_, block, order))
        if (const Value* value = rows.at(file_of(order[p]), row_of(order[p])))
          values[p] = stored(*value, static_cast<std::size_t>(file_of(order[p])));
      store_.write(block, column, values);
    });
  }

 private:
  static constexpr std::uint64_t kRows = 1 << 16;  // rows that are gathered at a time

  std::uint64_t rows_at_once(const RowStretch& s) const {
    return rows_at_a_time(inputs_[s.file]->info().layout.record_length, kRows);
  }

  std::filesystem::path path(const RowStretch& s) const {
    return folder_ / (std::to_string(s.file) + "_" + std::to_string(s.first));
  }

  // Writes the values by row, and their sum after them.
  template <class ValueOf, class Add>
  void write(const RowStretch& s, const ValueOf& value_of, const Add& add) const {
    PointReader& input = *inputs_[s.file];
    const RecordLayout& layout = input.info().layout;
    const std::uint64_t most = rows_at_once(s);
    std::vector<std::byte> records(most * layout.record_length);
    std::vector<std::uint8_t> valid(most);
    std::vector<Value> values;
    Value sum{};
    ColumnWriter<Value> writer(path(s));
    for (std::uint64_t done = 0; done < s.count; done += most) {
      const std::uint64_t n = std::min(most, s.count - done);
      const std::span rows = std::span(records).first(n * layout.record_length);
      if (input.read(s.first + done, rows, std::span(valid).first(n)) != n)
        throw Error(input.info().path.string() + ": can no longer be read in full; the file changed during the run");
      values.resize(n);
      for (std::size_t i = 0; i < n; ++i) {
        values[i] = value_of(rows.subspan(i * layout.record_length, layout.record_length), layout);
        if (valid[i] != 0) add(sum, values[i]);
      }
      writer.append(values);
    }
    writer.append(std::span(&sum, 1));
    writer.commit();
  }

  // Reads values by file and row, one window at a time. They must be asked for in ascending order.
  class AscendingReader {
   public:
    explicit AscendingReader(const RowValues& all) : all_(all) {}

    const Value* at(std::uint64_t file, std::uint64_t row) {
      const std::vector<RowStretch>& stretches = all_.stretches_;
      while (next_ < stretches.size() && before(stretches[next_], file, row)) ++next_, window_.clear();
      if (next_ == stretches.size() || stretches[next_].file != file) return nullptr;
      const RowStretch& s = stretches[next_];
      if (row < first_ || row >= first_ + window_.size()) {
        first_ = row;
        window_.resize(std::min(kRows, s.first + s.count - row));
        ColumnReader<Value>(all_.path(s)).read(row - s.first, window_);
      }
      return &window_[row - first_];
    }

   private:
    static bool before(const RowStretch& s, std::uint64_t file, std::uint64_t row) {
      return s.file != file ? s.file < file : s.first + s.count <= row;
    }

    const RowValues& all_;
    std::size_t next_ = 0;
    std::uint64_t first_ = 0;
    std::vector<Value> window_;
  };

  const Store& store_;
  std::filesystem::path folder_;
  const std::vector<std::unique_ptr<PointReader>>& inputs_;
  std::vector<RowStretch> stretches_;
};

}  // namespace ilot
