// SPDX-License-Identifier: Apache-2.0
// Places of rows that the index decodes stay in memory, in the cache of columns, until clouds are written again with
// labels: these need them once more, and to decode them again took half of the time of the writing.
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/formats/reader.h"
#include "engine/store/column_cache.h"

namespace ilot {

// Derived: the first bytes of a record of any point format from 6 on: place, intensity, returns and scanner channel.
constexpr std::size_t kPlaceBytes = 16;

// Keeps the places of rows of one input that come in their order, stretch by stretch between the boundaries() of its
// reader. A stretch that is not complete, or for which the cache has no room, is not kept.
class PlaceKeeper {
 public:
  // The rows [first, first + count) will be added.
  PlaceKeeper(std::filesystem::path store, std::uint32_t file, const PointReader& reader, std::uint64_t first,
              std::uint64_t count);
  void add(std::span<const std::byte> records, std::size_t record_length);

 private:
  void begin_stretch();

  std::filesystem::path store_;
  std::uint32_t file_;
  std::vector<std::uint64_t> bounds_;  // of stretches among the rows
  std::uint64_t next_;                 // row
  std::size_t stretch_ = 0;
  std::optional<KeptBytes> bytes_;  // of the stretch
};

// Writes the kept places of the stretch of an input that begins with row `first` to `records`, and nothing to the other
// bytes of the records. Returns false where these rows are not kept.
bool take_places(const std::filesystem::path& store, std::uint32_t file, std::uint64_t first, std::size_t record_length,
                 std::span<std::byte> records);

}  // namespace ilot
