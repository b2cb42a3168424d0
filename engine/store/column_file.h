// SPDX-License-Identifier: Apache-2.0
// Immutable binary files of values of one type: a header of 16 bytes, then the values. A file is written under a
// temporary name and renamed when it is complete. So every file that exists under its name is complete, and a killed
// run resumes from the files that exist. After a power cut this is not certain: engine/store/flushed.h.
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace ilot {

class KeptBytes;

enum class ValueKind : std::uint8_t { bytes, whole, unsigned_whole, real, record };

// The type of the values of a file, in enough detail to refuse a file that was written with another type.
struct ValueType {
  ValueKind kind = ValueKind::bytes;
  std::uint16_t bytes = 1;  // of one value
  friend bool operator==(const ValueType&, const ValueType&) = default;
};

template <class T>
constexpr ValueType value_type() {
  static_assert(std::is_trivially_copyable_v<T> && sizeof(T) <= UINT16_MAX);
  constexpr auto kBytes = static_cast<std::uint16_t>(sizeof(T));
  if constexpr (std::is_same_v<T, std::byte>) return {ValueKind::bytes, kBytes};
  if constexpr (std::is_enum_v<T>) return value_type<std::underlying_type_t<T>>();
  if constexpr (std::is_floating_point_v<T>) return {ValueKind::real, kBytes};
  if constexpr (std::is_integral_v<T>)
    return {std::is_signed_v<T> ? ValueKind::whole : ValueKind::unsigned_whole, kBytes};
  return {ValueKind::record, kBytes};
}

// The first bytes of a file.
struct ColumnHeader {
  std::uint8_t version = 0;
  ValueKind kind = ValueKind::bytes;
  std::uint16_t value_bytes = 0;
  std::uint32_t check = 0;  // checksum of the other members
  std::uint64_t count = 0;  // values
};
static_assert(sizeof(ColumnHeader) == 16);

// Sequential writer; no file appears under `path` before commit(). Errors name the path and the message of the system.
class ColumnOutput {
 public:
  ColumnOutput(std::filesystem::path path, ValueType type);
  ~ColumnOutput();
  ColumnOutput(const ColumnOutput&) = delete;
  ColumnOutput& operator=(const ColumnOutput&) = delete;

  void append(std::span<const std::byte> values);
  void commit();

 private:
  void write(std::span<const std::byte> bytes);

  std::filesystem::path path_, temporary_;
  ValueType type_;
  std::uint64_t bytes_ = 0;  // of values
  int file_ = -1;
};

// Random-access reader. Opening throws when the file does not contain complete values of this type in this format.
// Reading throws when it has fewer values than asked for.
class ColumnInput {
 public:
  ColumnInput(std::filesystem::path path, ValueType type);
  ~ColumnInput();
  ColumnInput(const ColumnInput&) = delete;
  ColumnInput& operator=(const ColumnInput&) = delete;
  ColumnInput(ColumnInput&& o) noexcept
      : path_(std::move(o.path_)), count_(o.count_), file_(std::exchange(o.file_, -1)), kept_(std::move(o.kept_)) {}

  std::uint64_t count() const { return count_; }
  void read_bytes(std::uint64_t offset, std::span<std::byte> out) const;  // from the first value on

 private:
  void check(ValueType type);
  void fill(std::uint64_t at, std::span<std::byte> out) const;

  std::filesystem::path path_;
  std::uint64_t count_ = 0;
  int file_ = -1;
  std::shared_ptr<const KeptBytes> kept_;  // all values, where the cache has them; then no file is open
};

template <class T>
class ColumnWriter {
 public:
  explicit ColumnWriter(std::filesystem::path path) : file_(std::move(path), value_type<T>()) {}
  void append(std::span<const T> values) { file_.append(std::as_bytes(values)); }
  void commit() { file_.commit(); }

 private:
  ColumnOutput file_;
};

template <class T>
class ColumnReader {
 public:
  explicit ColumnReader(std::filesystem::path path) : file_(std::move(path), value_type<T>()) {}
  std::uint64_t size() const { return file_.count(); }  // values
  void read(std::uint64_t first, std::span<T> out) const {
    file_.read_bytes(first * sizeof(T), std::as_writable_bytes(out));
  }
  T at(std::uint64_t i) const {
    T value;
    read(i, std::span(&value, 1));
    return value;
  }

 private:
  ColumnInput file_;
};

// Files of mixed records: their parts are written as bytes, one after the other.
using RecordWriter = ColumnWriter<std::byte>;
using RecordReader = ColumnReader<std::byte>;

template <class T>
void write_column(const std::filesystem::path& path, std::span<const T> values) {
  ColumnWriter<T> writer(path);
  writer.append(values);
  writer.commit();
}

template <class T>
std::vector<T> read_column(const std::filesystem::path& path) {
  const ColumnReader<T> reader(path);
  std::vector<T> values(reader.size());
  reader.read(0, values);
  return values;
}

}  // namespace ilot
