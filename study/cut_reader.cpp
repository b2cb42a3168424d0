// SPDX-License-Identifier: Apache-2.0
#include "study/cut_reader.h"

#include <cstring>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

// Rejects points of another reader.
class SomePoints : public PointReader {
 public:
  explicit SomePoints(std::unique_ptr<PointReader> reader) : reader_(std::move(reader)) {}

  const CloudInfo& info() const override { return reader_->info(); }
  bool random_access() const override { return reader_->random_access(); }
  std::vector<std::uint64_t> boundaries() const override { return reader_->boundaries(); }
  void limit_to(std::uint32_t fields) override { reader_->limit_to(fields); }

  std::size_t read(std::uint64_t first, std::span<std::byte> records, std::span<std::uint8_t> valid) override {
    const std::size_t rows = reader_->read(first, records, valid);
    for (std::size_t i = 0; i < rows; ++i)
      if (valid[i] != 0 && !keeps(first + i, records.data() + i * info().layout.record_length)) valid[i] = 0;
    return rows;
  }

 private:
  virtual bool keeps(std::uint64_t number, const std::byte* record) const = 0;

  std::unique_ptr<PointReader> reader_;
};

class CutReader : public SomePoints {
 public:
  CutReader(std::unique_ptr<PointReader> reader, const CutPlane& plane, double height)
      : SomePoints(std::move(reader)), plane_(plane), height_(height) {}

 private:
  bool keeps(std::uint64_t, const std::byte* record) const override { return above(record) <= height_; }
  double above(const std::byte* record) const {
    std::int32_t raw[3];
    std::memcpy(raw, record, sizeof raw);
    const RecordLayout& layout = info().layout;
    const auto at = [&](std::size_t axis) { return raw[axis] * layout.scale[axis] + layout.offset[axis]; };
    return (plane_.a * at(0) + plane_.b * at(1) + plane_.c * at(2) + plane_.d) / plane_.c;
  }

  CutPlane plane_;
  double height_;
};

class ThinReader : public SomePoints {
 public:
  ThinReader(std::unique_ptr<PointReader> reader, std::uint32_t of) : SomePoints(std::move(reader)), of_(of) {}

 private:
  bool keeps(std::uint64_t number, const std::byte*) const override { return Rng(number, of_).below(of_) == 0; }
  std::uint64_t of_;
};

}  // namespace

std::unique_ptr<PointReader> cut_above(std::unique_ptr<PointReader> reader, const CutPlane& plane, double height) {
  return std::make_unique<CutReader>(std::move(reader), plane, height);
}

std::unique_ptr<PointReader> thinned(std::unique_ptr<PointReader> reader, std::uint32_t of) {
  return std::make_unique<ThinReader>(std::move(reader), of);
}

}  // namespace ilot
