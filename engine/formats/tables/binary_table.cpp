// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "engine/formats/las/extra_bytes.h"
#include "engine/formats/row_buffer.h"
#include "engine/formats/tables/table.h"

namespace ilot {
namespace {

constexpr std::uint64_t kGrain = 1u << 16;  // rows between two boundaries

// Returns the number of rows that are read at a time, as they are in the file and as numbers.
std::size_t batch_of(const BinaryBody& body, const std::vector<TableColumn>& columns) {
  return rows_at_a_time(std::max<std::size_t>(1, body.stride + columns.size() * sizeof(double)), 1024);
}

double value_at(const std::byte* p, FieldType type, bool big_endian) {
  std::byte raw[8];
  const std::size_t size = type_size(type);
  std::copy(p, p + size, raw);
  if (big_endian) std::reverse(raw, raw + size);
  switch (type) {
    case FieldType::u8:
      return load<std::uint8_t>(raw);
    case FieldType::i8:
      return load<std::int8_t>(raw);
    case FieldType::u16:
      return load<std::uint16_t>(raw);
    case FieldType::i16:
      return load<std::int16_t>(raw);
    case FieldType::u32:
      return load<std::uint32_t>(raw);
    case FieldType::i32:
      return load<std::int32_t>(raw);
    case FieldType::u64:
      return static_cast<double>(load<std::uint64_t>(raw));
    case FieldType::i64:
      return static_cast<double>(load<std::int64_t>(raw));
    case FieldType::f32:
      return static_cast<double>(load<float>(raw));
    case FieldType::f64:
      return load<double>(raw);
    case FieldType::opaque:
      break;
  }
  return 0;
}

// Returns the values of `count` rows from `first` on; fewer when the source ends.
std::vector<double> read_values(const BinaryBody& body, const std::vector<TableColumn>& columns, std::uint64_t first,
                                std::size_t count) {
  std::vector<std::byte> raw(count * body.stride);
  const std::size_t rows = body.read_at(body.offset + first * body.stride, raw) / body.stride;
  std::vector<double> values(rows * columns.size());
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t i = 0; i < columns.size(); ++i)
      values[row * columns.size() + i] =
          value_at(&raw[row * body.stride + body.places[i]], columns[i].type, body.big_endian);
  return values;
}

std::vector<double> leading_rows(const BinaryBody& body, const std::vector<TableColumn>& columns) {
  return read_values(body, columns, 0,
                     std::min({kSample, batch_of(body, columns), static_cast<std::size_t>(body.rows)}));
}

// Returns rows from the whole file, because the first ones may be rays without an echo.
std::vector<double> spread_rows(const BinaryBody& body, const std::vector<TableColumn>& columns) {
  constexpr std::uint64_t kPlaces = 32, kRows = 32;
  std::vector<double> values;
  if (body.rows <= kSample) return values;
  for (std::uint64_t place = 0; place < kPlaces; ++place) {
    const std::uint64_t first = kSample + (body.rows - kSample) / kPlaces * place;
    const auto rows =
        read_values(body, columns, first, static_cast<std::size_t>(std::min<std::uint64_t>(kRows, body.rows - first)));
    values.insert(values.end(), rows.begin(), rows.end());
  }
  return values;
}

class BinaryTable final : public PointReader {
 public:
  BinaryTable(CloudInfo info, std::vector<TableColumn> columns, BinaryBody body)
      : info_(std::move(info)),
        columns_(std::move(columns)),
        body_(std::move(body)),
        plan_(info_.path, columns_, leading_rows(body_, columns_), spread_rows(body_, columns_)) {
    info_.layout = plan_.layout();
    note_lattice(info_, plan_.lattice());
    set_points(info_, body_.rows);
  }

  const CloudInfo& info() const override { return info_; }
  bool random_access() const override { return true; }

  std::vector<std::uint64_t> boundaries() const override {
    std::vector<std::uint64_t> result;
    for (std::uint64_t row = 0; row < info_.points; row += kGrain) result.push_back(row);
    result.push_back(info_.points);
    return result;
  }

  std::size_t read(std::uint64_t first, std::span<std::byte> records, std::span<std::uint8_t> valid) override {
    const std::size_t length = info_.layout.record_length;
    if (first >= info_.points) return 0;
    const auto rows = static_cast<std::size_t>(
        std::min<std::uint64_t>(std::min(records.size() / length, valid.size()), info_.points - first));
    const std::size_t batch = batch_of(body_, columns_);
    std::size_t done = 0;
    while (done < rows) {
      const std::vector<double> values = read_values(body_, columns_, first + done, std::min(batch, rows - done));
      const std::size_t got = values.size() / columns_.size();
      for (std::size_t i = 0; i < got; ++i)
        valid[done + i] = plan_.encode(std::span(values).subspan(i * columns_.size(), columns_.size()),
                                       records.subspan((done + i) * length, length));
      done += got;
      if (got == 0) break;
    }
    return done;
  }

 private:
  CloudInfo info_;
  std::vector<TableColumn> columns_;
  BinaryBody body_;
  TablePlan plan_;
};

}  // namespace

std::unique_ptr<PointReader> open_binary_table(CloudInfo info, std::vector<TableColumn> columns, BinaryBody body) {
  return std::make_unique<BinaryTable>(std::move(info), std::move(columns), std::move(body));
}

}  // namespace ilot
