// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

namespace ilot {

// A file for what does not fit into memory and is not needed after the run: it has no name once it is open, so that it
// is gone with the process, however that ends. Called from several threads at once. Errors name the path and what the
// system said.
class ScratchFile {
 public:
  explicit ScratchFile(std::filesystem::path path);
  ~ScratchFile();
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  // Where the bytes begin in the file: each call has a place of its own.
  std::uint64_t append(std::span<const std::byte> bytes);
  void read(std::uint64_t offset, std::span<std::byte> out) const;

 private:
  std::filesystem::path path_;
  int file_ = -1;
  std::atomic<std::uint64_t> end_{0};
};

}  // namespace ilot
