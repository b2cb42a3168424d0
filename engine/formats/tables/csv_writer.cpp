// SPDX-License-Identifier: Apache-2.0
#include <charconv>
#include <string>

#include "engine/formats/export.h"
#include "engine/formats/las/las_plan.h"
#include "engine/formats/tables/text.h"

namespace ilot {
namespace {

std::string header_name(const std::string& name) {
  std::string safe = name;
  for (char& c : safe)
    if (c == ',' || c == '"' || c == ';' || static_cast<unsigned char>(c) <= ' ') c = '_';
  return safe.empty() ? "unnamed" : safe;
}

template <class T>
void append_number(std::string& out, T value) {
  char text[32];
  out.append(text, std::to_chars(text, text + sizeof text, value).ptr);
}

class CsvWriter final : public PointWriter {
 public:
  CsvWriter(const std::filesystem::path& path, const CloudSpec& spec)
      : file_(path), layout_(output_layout(spec)), columns_(export_columns(layout_)), values_(columns_.size()) {
    std::string line;
    for (const ExportColumn& column : columns_) line += (line.empty() ? "" : ",") + header_name(column.name);
    append(line + "\n");
  }

  std::size_t record_length() const override { return layout_.record_length; }

  void write(std::span<const std::byte> records) override {
    std::string text;
    for (std::size_t at = 0; at + layout_.record_length <= records.size(); at += layout_.record_length) {
      append_row(records.subspan(at, layout_.record_length), text);
      if (text.size() < kPiece) continue;
      append(text);
      text.clear();
    }
    append(text);
  }

  void finish() override { file_.commit(); }

 private:
  static constexpr std::size_t kPiece = std::size_t{1} << 20;

  void append(const std::string& text) { file_.append(std::as_bytes(std::span(text))); }

  void append_row(std::span<const std::byte> record, std::string& text) {
    export_row(record, layout_, columns_, values_);
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const ExportColumn& column = columns_[i];
      if (i > 0) text.push_back(',');
      if (column.type == FieldType::u64)
        append_number(text, load<std::uint64_t>(&record[column.place]));
      else if (column.type == FieldType::i64)
        append_number(text, load<std::int64_t>(&record[column.place]));
      else if (column.type == FieldType::f32 && column.raw == FieldType::f32)
        append_number(text, static_cast<float>(values_[i]));
      else
        append_number(text, values_[i]);
    }
    text.push_back('\n');
  }

  OutputFile file_;
  RecordLayout layout_;
  std::vector<ExportColumn> columns_;
  std::vector<double> values_;
};

}  // namespace

std::unique_ptr<PointWriter> create_csv(const std::filesystem::path& path, const CloudSpec& spec) {
  return std::make_unique<CsvWriter>(path, spec);
}

}  // namespace ilot
