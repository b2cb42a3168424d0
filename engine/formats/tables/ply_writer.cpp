// SPDX-License-Identifier: Apache-2.0
#include <set>
#include <string>

#include "engine/formats/export.h"
#include "engine/formats/las/extra_bytes.h"
#include "engine/formats/las/las_plan.h"
#include "engine/formats/row_buffer.h"
#include "engine/formats/tables/ply.h"

namespace ilot {
namespace {

FieldType ply_type(FieldType type) {
  return type == FieldType::u64 || type == FieldType::i64 ? FieldType::f64 : type;
}

const char* type_name(FieldType type) {
  constexpr const char* kNames[] = {"",    "uchar",  "char",   "ushort", "short", "uint",
                                    "int", "double", "double", "float",  "double"};
  return kNames[static_cast<std::size_t>(type)];
}

// Names in PLY are single words, and each name occurs once.
std::string property_name(const std::string& name, std::set<std::string>& taken) {
  std::string word = name.empty() ? "unnamed" : name;
  for (char& c : word)
    if (static_cast<unsigned char>(c) <= ' ' || c == ',' || c == ';' || c == '"') c = '_';
  while (!taken.insert(word).second) word += "_";
  return word;
}

void store_number(FieldType type, double value, std::byte* p) {
  switch (type) {
    case FieldType::u8:
      return store(p, static_cast<std::uint8_t>(value));
    case FieldType::i8:
      return store(p, static_cast<std::int8_t>(value));
    case FieldType::u16:
      return store(p, static_cast<std::uint16_t>(value));
    case FieldType::i16:
      return store(p, static_cast<std::int16_t>(value));
    case FieldType::u32:
      return store(p, static_cast<std::uint32_t>(value));
    case FieldType::i32:
      return store(p, static_cast<std::int32_t>(value));
    case FieldType::f32:
      return store(p, static_cast<float>(value));
    default:
      return store(p, value);
  }
}

class PlyWriter final : public PointWriter {
 public:
  PlyWriter(const std::filesystem::path& path, const CloudSpec& spec)
      : file_(path), layout_(output_layout(spec)), columns_(export_columns(layout_)), values_(columns_.size()) {
    for (const ExportColumn& column : columns_) stride_ += type_size(ply_type(column.type));
    append(header());
  }

  std::size_t record_length() const override { return layout_.record_length; }

  void write(std::span<const std::byte> records) override {
    const std::size_t batch = rows_at_a_time(stride_, 4096);
    std::vector<std::byte> rows(batch * stride_);
    std::size_t filled = 0;
    for (std::size_t at = 0; at + layout_.record_length <= records.size(); at += layout_.record_length) {
      std::byte* p = &rows[filled * stride_];
      export_row(records.subspan(at, layout_.record_length), layout_, columns_, values_);
      for (std::size_t i = 0; i < columns_.size(); ++i) {
        const FieldType type = ply_type(columns_[i].type);
        store_number(type, values_[i], p);
        p += type_size(type);
      }
      ++rows_;
      if (++filled < batch) continue;
      file_.append(rows);
      filled = 0;
    }
    file_.append(std::span(rows).first(filled * stride_));
  }

  void finish() override {
    const std::string text = header();
    file_.write_at(0, std::as_bytes(std::span(text)));
    file_.commit();
  }

 private:
  void append(const std::string& text) { file_.append(std::as_bytes(std::span(text))); }

  // The header has the same length for any number of rows: a comment fills the space that the digits leave.
  std::string header() const {
    const std::string count = std::to_string(rows_);
    std::string text = "ply\nformat binary_little_endian 1.0\ncomment " + std::string(20 - count.size(), '-') +
                       "\nelement vertex " + count + "\n";
    std::set<std::string> taken;
    for (const ExportColumn& column : columns_)
      text += std::string("property ") + type_name(column.type) + " " + property_name(column.name, taken) + "\n";
    return text + "end_header\n";
  }

  OutputFile file_;
  RecordLayout layout_;
  std::vector<ExportColumn> columns_;
  std::vector<double> values_;
  std::size_t stride_ = 0;
  std::uint64_t rows_ = 0;
};

}  // namespace

std::unique_ptr<PointWriter> create_ply(const std::filesystem::path& path, const CloudSpec& spec) {
  return std::make_unique<PlyWriter>(path, spec);
}

}  // namespace ilot
