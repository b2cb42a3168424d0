// SPDX-License-Identifier: Apache-2.0
// Files that are read and written by descriptor at a given place. Every result is checked. An output file appears
// complete or not at all.
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

namespace ilot {

class RemoteFile;

// A regular file, or a remote one, to read. Throws Error when it is missing, unreadable or not a file. Reads are
// thread-safe. The file is opened when it is read, and closed again when too many others are read (open_files.h), so
// any number of InputFiles can exist.
class InputFile {
 public:
  explicit InputFile(const std::filesystem::path& path);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::uint64_t size() const { return size_; }  // bytes at the time of opening

  // Fills `out` from `offset` on and returns the number of bytes read (fewer only at the end of the file). Bytes that
  // were appended since the file was opened do not belong to it; bytes that were cut off are missing.
  std::size_t read_at(std::uint64_t offset, std::span<std::byte> out) const;

  // Returns a new descriptor. Throws Error when the path now names another file, or one that has become shorter.
  int reopen() const;

 private:
  std::filesystem::path path_;
  std::uint64_t size_ = 0, device_ = 0, inode_ = 0;
  std::unique_ptr<RemoteFile> remote_;  // none: a file of this machine
};

// The bytes of a file, remote or not; 0 where it cannot be opened.
std::uint64_t bytes_of_file(const std::filesystem::path& path);

// A file that is written under the name PATH.part and renamed to PATH by commit(). Without commit() no file remains.
// Every write is checked and throws Error (disk full, no permission). write_at is thread-safe, append is not.
class OutputFile {
 public:
  explicit OutputFile(const std::filesystem::path& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::uint64_t position() const { return position_; }  // where the next append writes
  void write_at(std::uint64_t offset, std::span<const std::byte> bytes);
  void append(std::span<const std::byte> bytes);
  void commit();

 private:
  std::filesystem::path path_, part_;
  int descriptor_ = -1;
  std::uint64_t position_ = 0;
};

}  // namespace ilot
