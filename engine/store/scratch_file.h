// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <utility>

namespace ilot {

// Such a file begins with this for the moment in which it has a name. A process that is killed just then leaves it.
constexpr const char* kScratchFile = "scratch-";

// A file for what does not fit into memory and is not needed after the run. It has no name, so that it is gone with the
// process, however that ends. Any number of threads may read, write and append at once. Errors name the folder and what
// the system said.
class ScratchFile {
 public:
  ScratchFile() = default;
  explicit ScratchFile(const std::filesystem::path& folder);
  ~ScratchFile();
  ScratchFile(ScratchFile&& o) noexcept
      : folder_(std::move(o.folder_)), file_(std::exchange(o.file_, -1)), end_(o.end_.load()) {}
  ScratchFile& operator=(ScratchFile&& o) noexcept;

  bool is_open() const { return file_ >= 0; }
  void write(std::uint64_t offset, std::span<const std::byte> bytes);
  void read(std::uint64_t offset, std::span<std::byte> bytes) const;

  // Where the bytes begin in the file: each call has a place of its own. Not beside write().
  std::uint64_t append(std::span<const std::byte> bytes);

 private:
  std::filesystem::path folder_;
  int file_ = -1;
  std::atomic<std::uint64_t> end_{0};  // of what was appended
};

}  // namespace ilot
