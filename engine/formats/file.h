// SPDX-License-Identifier: Apache-2.0
// Files by descriptor: reads and writes at a place, every result checked, output that appears whole or not at all.
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

namespace ilot {

// A regular file to read. Throws Error when it is missing, unreadable or not a file. Reads are thread-safe. It is
// opened when it is read, and closed again when too many others are read (open_files.h): any number of them can exist.
class InputFile {
 public:
  explicit InputFile(const std::filesystem::path& path);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::uint64_t size() const { return size_; }  // bytes, when it was opened

  // Fills `out` from `offset` on; returns how many bytes there were (fewer only at the end of the file). What was
  // appended since it was opened does not belong to it; what was cut off is missing.
  std::size_t read_at(std::uint64_t offset, std::span<std::byte> out) const;

  // A new descriptor. Error when the path names another file by now, or one that has become shorter.
  int reopen() const;

 private:
  std::filesystem::path path_;
  std::uint64_t size_ = 0, device_ = 0, inode_ = 0;
};

// A file written under the name PATH.part and renamed to PATH by commit(). Without commit() nothing stays. Every
// write is checked and throws Error (disk full, no permission). write_at is thread-safe, append is not.
class OutputFile {
 public:
  explicit OutputFile(const std::filesystem::path& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::uint64_t position() const { return position_; }  // where append goes on
  void write_at(std::uint64_t offset, std::span<const std::byte> bytes);
  void append(std::span<const std::byte> bytes);
  void commit();

 private:
  std::filesystem::path path_, part_;
  int descriptor_ = -1;
  std::uint64_t position_ = 0;
};

}  // namespace ilot
