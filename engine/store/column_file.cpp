// SPDX-License-Identifier: Apache-2.0
#include "engine/store/column_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "engine/error.h"

namespace ilot {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const char* what) {
  const int code = errno;
  std::string advice;
  if (code == ENOSPC || code == EDQUOT) advice = "; free some space or give --store DIR on another disk, then --resume";
  throw Error(path.string() + ": " + what + ": " + std::strerror(code) + advice);
}

}  // namespace

ColumnWriter::ColumnWriter(std::filesystem::path path) : path_(std::move(path)), temporary_(path_) {
  temporary_ += ".part";
  file_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file_ < 0) fail(temporary_, "cannot create");
}

ColumnWriter::~ColumnWriter() {
  if (file_ < 0) return;
  ::close(file_);
  ::unlink(temporary_.c_str());
}

void ColumnWriter::append(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(file_, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) fail(temporary_, "cannot write");
    bytes = bytes.subspan(static_cast<std::size_t>(n));
  }
}

void ColumnWriter::commit() {
  const int closed = ::close(std::exchange(file_, -1));
  if (closed == 0 && ::rename(temporary_.c_str(), path_.c_str()) == 0) return;
  const int code = errno;
  ::unlink(temporary_.c_str());
  errno = code;
  fail(path_, "cannot finish");
}

ColumnReader::ColumnReader(std::filesystem::path path) : path_(std::move(path)) {
  file_ = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC);
  if (file_ < 0) fail(path_, "cannot open");
}

ColumnReader::~ColumnReader() {
  if (file_ >= 0) ::close(file_);
}

std::uint64_t ColumnReader::size() const {
  struct stat s {};
  if (::fstat(file_, &s) != 0) fail(path_, "cannot stat");
  return static_cast<std::uint64_t>(s.st_size);
}

void ColumnReader::read_bytes(std::uint64_t offset, std::span<std::byte> out) const {
  while (!out.empty()) {
    const ssize_t n = ::pread(file_, out.data(), out.size(), static_cast<off_t>(offset));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail(path_, "cannot read");
    if (n == 0) throw Error(path_.string() + ": shorter than expected; delete the store and start again");
    out = out.subspan(static_cast<std::size_t>(n));
    offset += static_cast<std::uint64_t>(n);
  }
}

}  // namespace ilot
