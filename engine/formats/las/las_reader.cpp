// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "engine/formats/las/las.h"

namespace ilot {
namespace {

constexpr std::uint64_t kGrain = 1u << 16;  // rows between two boundaries

class LasReader final : public PointReader {
 public:
  LasReader(std::unique_ptr<InputFile> file, LasContainer container)
      : file_(std::move(file)), container_(std::move(container)) {}

  const CloudInfo& info() const override { return container_.info; }
  bool random_access() const override { return true; }

  std::vector<std::uint64_t> boundaries() const override {
    std::vector<std::uint64_t> result;
    for (std::uint64_t row = 0; row < info().points; row += kGrain) result.push_back(row);
    result.push_back(info().points);
    return result;
  }

  std::size_t read(std::uint64_t first, std::span<std::byte> records, std::span<std::uint8_t> valid) override {
    const std::size_t length = info().layout.record_length;
    if (first >= info().points) return 0;
    const std::size_t asked = std::min(records.size() / length, valid.size());
    const auto rows = static_cast<std::size_t>(std::min<std::uint64_t>(asked, info().points - first));
    const std::size_t got = file_->read_at(container_.point_offset + first * length, records.first(rows * length));
    std::fill_n(valid.begin(), got / length, std::uint8_t{1});
    return got / length;
  }

 private:
  std::unique_ptr<InputFile> file_;
  LasContainer container_;
};

}  // namespace

std::unique_ptr<PointReader> open_las(std::unique_ptr<InputFile> file, LasContainer container) {
  return std::make_unique<LasReader>(std::move(file), std::move(container));
}

}  // namespace ilot
