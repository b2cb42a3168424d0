// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "engine/error.h"
#include "engine/formats/las/las.h"

namespace ilot {
namespace {

class LasWriter final : public PointWriter {
 public:
  LasWriter(const std::filesystem::path& path, const CloudSpec& spec) : file_(path, spec) {}

  std::size_t record_length() const override { return file_.record_length(); }

  void write(std::span<const std::byte> records) override {
    file_.write_at(statistics_.count, records);
    statistics_.add(records, file_.layout());
  }

  void finish() override { file_.finish(statistics_); }

 private:
  LasFileWriter file_;
  PointStatistics statistics_;
};

}  // namespace

LasFileWriter::LasFileWriter(const std::filesystem::path& path, const CloudSpec& spec)
    : file_(path), plan_(plan_las(spec)) {
  const std::vector<std::byte> prefix = las_prefix(plan_);
  point_offset_ = prefix.size();
  file_.write_at(0, prefix);
}

void LasFileWriter::write_at(std::uint64_t first_row, std::span<const std::byte> records) {
  file_.write_at(point_offset_ + first_row * record_length(), records);
  rows_ += records.size() / record_length();
}

void LasFileWriter::finish(const PointStatistics& statistics) {
  if (statistics.count != rows_)
    throw Error(file_.path().string() + ": " + std::to_string(rows_) + " rows were written but " +
                std::to_string(statistics.count) + " were measured; the file is not kept");
  const std::uint64_t end = point_offset_ + statistics.count * record_length();
  file_.write_at(end, las_suffix(plan_));
  finish_header(plan_, statistics, end);
  file_.write_at(0, plan_.header);
  file_.commit();
}

std::unique_ptr<PointWriter> create_las(const std::filesystem::path& path, const CloudSpec& spec) {
  return std::make_unique<LasWriter>(path, spec);
}

}  // namespace ilot
