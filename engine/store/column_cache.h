// SPDX-License-Identifier: Apache-2.0
// Column files that were read are kept in memory, so that reading them again needs no call to the system. There is one
// cache for the process, because its memory is common. It is off until it gets room; files that change or are removed
// outside of this process are not noticed while it is on. Its memory comes from the system and goes back to it at once:
// it is the first memory that a run gives up (engine/pass/kept_columns.h).
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <utility>

namespace ilot {

// Sets how many bytes the cache may have, and frees kept files until it has no more, those first that were not read for
// the longest time. The memory of a file that is being read is freed when its reader ends.
void set_column_cache(std::uint64_t most_bytes);

// Returns the bytes that the cache has now.
std::uint64_t column_cache_bytes();

// Frees the kept files in a folder, or one kept file.
void forget_folder(const std::filesystem::path& folder);
void forget_file(const std::filesystem::path& path);

// Memory of a fixed size that counts for the cache while it exists. `type` is what the caller knows its values by.
class KeptBytes {
 public:
  // All bytes are zero; there are none where the cache has no room for them.
  KeptBytes(std::uint32_t type, std::size_t bytes);
  ~KeptBytes();
  KeptBytes(const KeptBytes&) = delete;
  KeptBytes& operator=(const KeptBytes&) = delete;
  KeptBytes(KeptBytes&& o) noexcept
      : type_(o.type_), data_(std::exchange(o.data_, nullptr)), size_(std::exchange(o.size_, 0)) {}

  std::uint32_t type() const { return type_; }
  std::span<std::byte> bytes() { return {data_, size_}; }  // they begin at the start of a page
  std::span<const std::byte> bytes() const { return {data_, size_}; }

 private:
  std::uint32_t type_;
  std::byte* data_ = nullptr;
  std::size_t size_ = 0;
};

// Keeps the values of a file in place of those that are kept under its path, and returns them.
std::shared_ptr<const KeptBytes> keep_file(const std::filesystem::path& path, KeptBytes bytes);

// Returns the kept values of a file; nullptr: it is not kept.
std::shared_ptr<const KeptBytes> kept_file(const std::filesystem::path& path);

}  // namespace ilot
