// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>

#include "engine/error.h"
#include "engine/formats/open_files.h"
#include "engine/formats/remote_file.h"
#include "engine/system_reason.h"

namespace ilot {
namespace {

constexpr std::size_t kLargestCall = std::size_t{1} << 30;  // one pread or pwrite moves less than 2 GiB

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& what) {
  throw Error(path.string() + ": " + what + ": " + system_reason(errno));
}

int open_to_read(const std::filesystem::path& path) {
  return ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
}

}  // namespace

InputFile::InputFile(const std::filesystem::path& path) : path_(path) {
  if (is_remote(path)) {
    remote_ = std::make_unique<RemoteFile>(path);
    size_ = remote_->size();
    return;
  }
  const int descriptor = open_to_read(path);
  if (descriptor < 0) fail(path, "cannot be opened");
  struct stat status {};
  const bool regular = ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
  ::close(descriptor);
  if (!regular) throw Error(path.string() + ": is not a regular file; give a point cloud file");
  size_ = static_cast<std::uint64_t>(status.st_size);
  device_ = status.st_dev;
  inode_ = status.st_ino;
}

InputFile::~InputFile() {
  open_files().forget(*this);
}

int InputFile::reopen() const {
  const int descriptor = open_to_read(path_);
  if (descriptor < 0) fail(path_, "cannot be opened");
  struct stat status {};
  const bool same = ::fstat(descriptor, &status) == 0 && status.st_dev == device_ && status.st_ino == inode_ &&
                    static_cast<std::uint64_t>(status.st_size) >= size_;
  if (same) return descriptor;
  ::close(descriptor);
  throw Error(path_.string() + ": is another file than at the start of the run; start again");
}

std::size_t InputFile::read_at(std::uint64_t offset, std::span<std::byte> out) const {
  if (offset >= size_) return 0;
  out = out.first(static_cast<std::size_t>(std::min<std::uint64_t>(out.size(), size_ - offset)));
  if (remote_) {
    remote_->read_at(offset, out);
    return out.size();
  }
  const OpenFiles::Use use(open_files(), *this);
  std::size_t done = 0;
  while (done < out.size()) {
    const std::size_t ask = std::min(out.size() - done, kLargestCall);
    const ssize_t got = ::pread(use.descriptor(), out.data() + done, ask, static_cast<off_t>(offset + done));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(path_, "cannot be read at byte " + std::to_string(offset + done));
    if (got == 0) break;
    done += static_cast<std::size_t>(got);
  }
  return done;
}

std::uint64_t bytes_of_file(const std::filesystem::path& path) {
  try {
    return InputFile(path).size();
  } catch (const Error&) {
    return 0;
  }
}

OutputFile::OutputFile(const std::filesystem::path& path) : path_(path), part_(path) {
  part_ += ".part";
  descriptor_ = ::open(part_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail(part_, "cannot be written");
}

OutputFile::~OutputFile() {
  if (descriptor_ < 0) return;
  ::close(descriptor_);
  ::unlink(part_.c_str());
}

void OutputFile::write_at(std::uint64_t offset, std::span<const std::byte> bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const std::size_t ask = std::min(bytes.size() - done, kLargestCall);
    const ssize_t put = ::pwrite(descriptor_, bytes.data() + done, ask, static_cast<off_t>(offset + done));
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) fail(part_, "cannot be written at byte " + std::to_string(offset + done));
    done += static_cast<std::size_t>(put);
  }
}

void OutputFile::append(std::span<const std::byte> bytes) {
  write_at(position_, bytes);
  position_ += bytes.size();
}

void OutputFile::commit() {
  const int descriptor = descriptor_;
  descriptor_ = -1;
  const bool flushed = ::fsync(descriptor) == 0 || errno == EINVAL;  // the content must be on the disk before the name
  const int fault = errno;
  const bool closed = ::close(descriptor) == 0;
  if (!flushed) errno = fault;
  if (!flushed || !closed || ::rename(part_.c_str(), path_.c_str()) != 0) {
    const int reason = errno;
    ::unlink(part_.c_str());
    errno = reason;
    fail(path_, "cannot be finished");
  }
}

}  // namespace ilot
