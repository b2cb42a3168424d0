// SPDX-License-Identifier: Apache-2.0
#include "engine/store/column_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string>

#include "engine/error.h"
#include "engine/store/column_cache.h"
#include "engine/system_reason.h"

namespace ilot {
namespace {

constexpr std::uint8_t kVersion = 2;  // of the files; another layout of any column needs another version
constexpr const char* kAdvice = "; delete the store and start again";

[[noreturn]] void fail(const std::filesystem::path& path, const char* what) {
  const int code = errno;
  const bool full = code == ENOSPC || code == EDQUOT || code == EFBIG;
  throw Error(path.string() + ": " + what + ": " + system_reason(code) + (full ? " (--store DIR), then --resume" : ""));
}

// FNV-1a of the header without the checksum itself. Bytes that are all zero, which disks may leave, do not pass.
std::uint32_t check_of(const ColumnHeader& h) {
  std::uint32_t hash = 2166136261u;
  const auto add = [&](std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) hash = (hash ^ (value >> 8 * i & 0xff)) * 16777619u;
  };
  add(h.version, 1);
  add(static_cast<std::uint8_t>(h.kind), 1);
  add(h.value_bytes, 2);
  add(h.count, 8);
  return hash;
}

// The type as the cache keeps it.
std::uint32_t number_of(ValueType type) {
  return static_cast<std::uint32_t>(type.kind) << 16 | type.bytes;
}

std::string text_of(ValueType type) {
  constexpr const char* kNames[]{"bytes", "whole numbers", "unsigned whole numbers", "real numbers", "records"};
  const auto kind = static_cast<std::size_t>(type.kind);
  return std::string(kind < std::size(kNames) ? kNames[kind] : "values of an unknown kind") + " of " +
         std::to_string(type.bytes) + " bytes";
}

}  // namespace

ColumnOutput::ColumnOutput(std::filesystem::path path, ValueType type)
    : path_(std::move(path)), temporary_(path_), type_(type) {
  temporary_ += ".part";
  file_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file_ < 0) fail(temporary_, "cannot create");
  try {
    const ColumnHeader empty;  // the count is known only at the end
    write(std::as_bytes(std::span(&empty, 1)));
  } catch (...) {
    ::close(file_);
    ::unlink(temporary_.c_str());
    throw;
  }
}

ColumnOutput::~ColumnOutput() {
  if (file_ < 0) return;
  ::close(file_);
  ::unlink(temporary_.c_str());
}

void ColumnOutput::append(std::span<const std::byte> values) {
  write(values);
  bytes_ += values.size();
}

void ColumnOutput::write(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(file_, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) fail(temporary_, "cannot write");
    bytes = bytes.subspan(static_cast<std::size_t>(n));
  }
}

void ColumnOutput::commit() {
  ColumnHeader header{kVersion, type_.kind, type_.bytes, 0, bytes_ / type_.bytes};
  header.check = check_of(header);
  ssize_t n = 0;
  do n = ::pwrite(file_, &header, sizeof header, 0);
  while (n < 0 && errno == EINTR);
  if (n != static_cast<ssize_t>(sizeof header)) fail(temporary_, "cannot write");
  const int closed = ::close(std::exchange(file_, -1));
  forget_file(path_);
  if (closed == 0 && ::rename(temporary_.c_str(), path_.c_str()) == 0) return;
  const int code = errno;
  ::unlink(temporary_.c_str());
  errno = code;
  fail(path_, "cannot finish");
}

ColumnInput::ColumnInput(std::filesystem::path path, ValueType type) : path_(std::move(path)) {
  kept_ = kept_file(path_);
  if (kept_ && kept_->type() == number_of(type)) {
    count_ = kept_->bytes().size() / type.bytes;
    return;
  }
  kept_ = nullptr;
  file_ = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC);
  if (file_ < 0) fail(path_, "cannot open");
  try {
    check(type);
    KeptBytes values(number_of(type), count_ * type.bytes);
    if (values.bytes().empty()) return;
    read_bytes(0, values.bytes());
    kept_ = keep_file(path_, std::move(values));
  } catch (...) {
    ::close(file_);
    throw;
  }
  ::close(std::exchange(file_, -1));
}

ColumnInput::~ColumnInput() {
  if (file_ >= 0) ::close(file_);
}

void ColumnInput::check(ValueType type) {
  ColumnHeader header;
  fill(0, std::as_writable_bytes(std::span(&header, 1)));
  if (header.check != check_of(header)) throw Error(path_.string() + ": is damaged at its beginning" + kAdvice);
  if (header.version != kVersion)
    throw Error(path_.string() + ": is in format " + std::to_string(header.version) + " of another version of ilot; " +
                "this one reads format " + std::to_string(kVersion) + kAdvice);
  const ValueType found{header.kind, header.value_bytes};
  if (!(found == type))
    throw Error(path_.string() + ": has " + text_of(found) + " where " + text_of(type) + " were expected" + kAdvice);
  struct stat s {};
  if (::fstat(file_, &s) != 0) fail(path_, "cannot stat");
  if (static_cast<std::uint64_t>(s.st_size) != sizeof header + header.count * type.bytes)
    throw Error(path_.string() + ": has " + std::to_string(s.st_size) + " bytes where its " +
                std::to_string(header.count) + " values take " +
                std::to_string(sizeof header + header.count * type.bytes) + kAdvice);
  count_ = header.count;
}

void ColumnInput::read_bytes(std::uint64_t offset, std::span<std::byte> out) const {
  if (!kept_) return fill(sizeof(ColumnHeader) + offset, out);
  const std::span<const std::byte> values = kept_->bytes();
  if (offset > values.size() || out.size() > values.size() - offset)
    throw Error(path_.string() + ": shorter than expected" + kAdvice);
  std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(offset), out.size(), out.begin());
}

void ColumnInput::fill(std::uint64_t at, std::span<std::byte> out) const {
  while (!out.empty()) {
    const ssize_t n = ::pread(file_, out.data(), out.size(), static_cast<off_t>(at));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail(path_, "cannot read");
    if (n == 0) throw Error(path_.string() + ": shorter than expected" + kAdvice);
    out = out.subspan(static_cast<std::size_t>(n));
    at += static_cast<std::uint64_t>(n);
  }
}

}  // namespace ilot
