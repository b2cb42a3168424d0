// SPDX-License-Identifier: Apache-2.0
#include "study/cut_reader.h"

#include <cstring>

namespace ilot {
namespace {

class CutReader : public PointReader {
 public:
  CutReader(std::unique_ptr<PointReader> reader, const CutPlane& plane, double height)
      : reader_(std::move(reader)), plane_(plane), height_(height) {}

  const CloudInfo& info() const override { return reader_->info(); }
  bool random_access() const override { return reader_->random_access(); }
  std::vector<std::uint64_t> boundaries() const override { return reader_->boundaries(); }
  void limit_to(std::uint32_t fields) override { reader_->limit_to(fields); }

  std::size_t read(std::uint64_t first, std::span<std::byte> records, std::span<std::uint8_t> valid) override {
    const std::size_t rows = reader_->read(first, records, valid);
    for (std::size_t i = 0; i < rows; ++i)
      if (valid[i] != 0 && above(records.data() + i * info().layout.record_length) > height_) valid[i] = 0;
    return rows;
  }

 private:
  double above(const std::byte* record) const {
    std::int32_t raw[3];
    std::memcpy(raw, record, sizeof raw);
    const RecordLayout& layout = info().layout;
    const auto at = [&](std::size_t axis) { return raw[axis] * layout.scale[axis] + layout.offset[axis]; };
    return (plane_.a * at(0) + plane_.b * at(1) + plane_.c * at(2) + plane_.d) / plane_.c;
  }

  std::unique_ptr<PointReader> reader_;
  CutPlane plane_;
  double height_;
};

}  // namespace

std::unique_ptr<PointReader> cut_above(std::unique_ptr<PointReader> reader, const CutPlane& plane, double height) {
  return std::make_unique<CutReader>(std::move(reader), plane, height);
}

}  // namespace ilot
