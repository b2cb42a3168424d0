// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/arrays/npy_writer.h"

#include <string>
#include <utility>

#include "engine/error.h"
#include "engine/formats/file.h"
#include "engine/formats/las/las_plan.h"

namespace ilot {
namespace {

// NumPy's name of a type.
const char* type_text(FieldType type) {
  switch (type) {
    case FieldType::u8:
      return "|u1";
    case FieldType::i8:
      return "|i1";
    case FieldType::u16:
      return "<u2";
    case FieldType::i16:
      return "<i2";
    case FieldType::u32:
      return "<u4";
    case FieldType::i32:
      return "<i4";
    case FieldType::u64:
      return "<u8";
    case FieldType::i64:
      return "<i8";
    case FieldType::f32:
      return "<f4";
    case FieldType::f64:
      return "<f8";
    case FieldType::opaque:
      break;
  }
  throw Error("npy: a field without a type cannot be written");
}

// [numpy.lib.format, version 1.0]: magic, version, length of the head, the head as a literal of Python, padded so that
// the data begin at a multiple of 64.
std::string head_of(const std::vector<ExtraField>& fields, std::uint64_t rows) {
  std::string types;
  for (const ExtraField& field : fields) types += "('" + field.name + "', '" + type_text(field.type) + "'), ";
  std::string text = "{'descr': [" + types + "], 'fortran_order': False, 'shape': (" + std::to_string(rows) + ",), }";
  constexpr std::size_t kBefore = 10, kAlign = 64;
  text.append(kAlign - 1 - (kBefore + text.size()) % kAlign, ' ');
  text.push_back('\n');
  const std::size_t length = text.size();
  return std::string("\x93NUMPY\x01", 7) + '\0' + static_cast<char>(length & 0xff) + static_cast<char>(length >> 8) +
         text;
}

class NpyWriter final : public PointWriter {
 public:
  NpyWriter(const std::filesystem::path& path, const CloudSpec& spec)
      : file_(path),
        before_(spec.like.layout.record_length),
        length_(output_layout(spec).record_length),
        rows_(spec.like.points) {
    const std::string head = head_of(spec.appended, rows_);
    file_.append(std::as_bytes(std::span(head)));
  }

  std::size_t record_length() const override { return length_; }

  void write(std::span<const std::byte> records) override {
    std::vector<std::byte> ours;
    ours.reserve(records.size() / length_ * (length_ - before_));
    for (std::size_t at = 0; at + length_ <= records.size(); at += length_, ++written_)
      ours.insert(ours.end(), &records[at] + before_, &records[at] + length_);
    file_.append(ours);
  }

  void finish() override {
    if (written_ != rows_)
      throw Error(file_.path().string() + ": " + std::to_string(written_) + " rows came, " + std::to_string(rows_) +
                  " were expected; the arrays changed during the run");
    file_.commit();
  }

 private:
  OutputFile file_;
  std::size_t before_, length_;
  std::uint64_t rows_, written_ = 0;
};

}  // namespace

std::unique_ptr<PointWriter> create_npy(const std::filesystem::path& path, const CloudSpec& spec) {
  return std::make_unique<NpyWriter>(path, spec);
}

}  // namespace ilot
