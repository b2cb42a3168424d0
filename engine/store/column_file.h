// SPDX-License-Identifier: Apache-2.0
// Immutable binary files: written beside, renamed when whole. Whatever exists under its name is complete, so a killed
// run resumes by looking at which files are there.
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <utility>
#include <vector>

namespace ilot {

// Sequential writer; nothing appears under `path` before commit(). Errors name the path and what the system said.
class ColumnWriter {
 public:
  explicit ColumnWriter(std::filesystem::path path);
  ~ColumnWriter();
  ColumnWriter(const ColumnWriter&) = delete;
  ColumnWriter& operator=(const ColumnWriter&) = delete;

  void append(std::span<const std::byte> bytes);
  template <class T>
  void append(std::span<const T> values) {
    append(std::as_bytes(values));
  }
  void commit();

 private:
  std::filesystem::path path_, temporary_;
  int file_ = -1;
};

// Random-access reader. read() throws when the file is shorter than asked.
class ColumnReader {
 public:
  explicit ColumnReader(std::filesystem::path path);
  ~ColumnReader();
  ColumnReader(const ColumnReader&) = delete;
  ColumnReader& operator=(const ColumnReader&) = delete;
  ColumnReader(ColumnReader&& o) noexcept : path_(std::move(o.path_)), file_(std::exchange(o.file_, -1)) {}

  std::uint64_t size() const;  // bytes
  void read_bytes(std::uint64_t offset, std::span<std::byte> out) const;
  template <class T>
  void read(std::uint64_t first, std::span<T> out) const {
    read_bytes(first * sizeof(T), std::as_writable_bytes(out));
  }

 private:
  std::filesystem::path path_;
  int file_ = -1;
};

template <class T>
void write_column(const std::filesystem::path& path, std::span<const T> values) {
  ColumnWriter writer(path);
  writer.append(values);
  writer.commit();
}

template <class T>
std::vector<T> read_column(const std::filesystem::path& path) {
  const ColumnReader reader(path);
  std::vector<T> values(reader.size() / sizeof(T));
  reader.read<T>(0, values);
  return values;
}

}  // namespace ilot
