// SPDX-License-Identifier: Apache-2.0
#include "engine/store/row_places.h"

#include <algorithm>
#include <cstring>
#include <string>

namespace ilot {
namespace {

// The name under which the cache has a stretch; there is no such file.
std::filesystem::path name_of(const std::filesystem::path& store, std::uint32_t file, std::uint64_t first) {
  return store / "places" / (std::to_string(file) + "_" + std::to_string(first));
}

}  // namespace

PlaceKeeper::PlaceKeeper(std::filesystem::path store, std::uint32_t file, const PointReader& reader,
                         std::uint64_t first, std::uint64_t count)
    : store_(std::move(store)), file_(file), next_(first) {
  for (const std::uint64_t bound : reader.boundaries())
    if (bound >= first && bound <= first + count) bounds_.push_back(bound);
  begin_stretch();
}

void PlaceKeeper::begin_stretch() {
  if (stretch_ + 1 >= bounds_.size()) return;
  bytes_.emplace(0u, (bounds_[stretch_ + 1] - bounds_[stretch_]) * kPlaceBytes);
}

void PlaceKeeper::add(std::span<const std::byte> records, std::size_t record_length) {
  for (std::size_t at = 0; at < records.size(); at += record_length, ++next_) {
    if (stretch_ + 1 >= bounds_.size() || next_ < bounds_[stretch_]) continue;
    const std::span<std::byte> to = bytes_->bytes();
    if (!to.empty())
      std::memcpy(to.data() + (next_ - bounds_[stretch_]) * kPlaceBytes, records.data() + at, kPlaceBytes);
    if (next_ + 1 < bounds_[stretch_ + 1]) continue;
    if (!to.empty()) keep_file(name_of(store_, file_, bounds_[stretch_]), std::move(*bytes_));
    ++stretch_;
    begin_stretch();
  }
}

bool take_places(const std::filesystem::path& store, std::uint32_t file, std::uint64_t first, std::size_t record_length,
                 std::span<std::byte> records) {
  const auto kept = kept_file(name_of(store, file, first));
  if (kept == nullptr || kept->bytes().size() / kPlaceBytes != records.size() / record_length) return false;
  const std::byte* from = kept->bytes().data();
  for (std::size_t at = 0; at < records.size(); at += record_length, from += kPlaceBytes)
    std::memcpy(records.data() + at, from, kPlaceBytes);
  return true;
}

}  // namespace ilot
