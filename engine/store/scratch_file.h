// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <utility>

namespace ilot {

// The name of such a file begins with this while it has a name for a moment. A process that is killed in this moment
// leaves the file.
constexpr const char* kScratchFile = "scratch-";

// A file for data that does not fit into memory and is not needed after the run. It has no name, so it disappears when
// the process ends in any way. Any number of threads may read, write and append at once. Errors name the folder and the
// message of the system.
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

  // Returns where the bytes begin in the file; each call gets its own place. It must not be called at the same time as
  // write().
  std::uint64_t append(std::span<const std::byte> bytes);

 private:
  std::filesystem::path folder_;
  int file_ = -1;
  std::atomic<std::uint64_t> end_{0};  // end of the appended bytes
};

}  // namespace ilot
