// SPDX-License-Identifier: Apache-2.0
#include "engine/store/scratch_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>

#include "engine/error.h"

namespace ilot {
namespace {

[[noreturn]] void fail_scratch(const std::filesystem::path& folder, const char* what) {
  const int code = errno;
  const char* advice =
      code == ENOSPC || code == EDQUOT ? "; free some space or give --store DIR on another disk, then --resume" : "";
  throw Error(folder.string() + ": " + what + ": " + std::strerror(code) + advice);
}

}  // namespace

ScratchFile::ScratchFile(const std::filesystem::path& folder) : folder_(folder) {
  std::string name = (folder / kScratchFile).string() + "XXXXXX";
  file_ = ::mkostemp(name.data(), O_CLOEXEC);
  if (file_ < 0) fail_scratch(folder_, "cannot create a temporary file");
  ::unlink(name.c_str());
}

ScratchFile::~ScratchFile() {
  if (file_ >= 0) ::close(file_);
}

ScratchFile& ScratchFile::operator=(ScratchFile&& o) noexcept {
  std::swap(folder_, o.folder_);
  std::swap(file_, o.file_);
  end_ = o.end_.exchange(end_);
  return *this;
}

void ScratchFile::write(std::uint64_t offset, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::pwrite(file_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) fail_scratch(folder_, "cannot write a temporary file");
    bytes = bytes.subspan(static_cast<std::size_t>(n));
    offset += static_cast<std::uint64_t>(n);
  }
}

void ScratchFile::read(std::uint64_t offset, std::span<std::byte> bytes) const {
  while (!bytes.empty()) {
    const ssize_t n = ::pread(file_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail_scratch(folder_, "cannot read a temporary file");
    if (n == 0) throw Error(folder_.string() + ": a temporary file is shorter than what was written");
    bytes = bytes.subspan(static_cast<std::size_t>(n));
    offset += static_cast<std::uint64_t>(n);
  }
}

std::uint64_t ScratchFile::append(std::span<const std::byte> bytes) {
  const std::uint64_t begin = end_.fetch_add(bytes.size());
  write(begin, bytes);
  return begin;
}

}  // namespace ilot
