// SPDX-License-Identifier: Apache-2.0
#include "engine/whole_file.h"

#include <fcntl.h>
#include <unistd.h>
#include <cerrno>
#include <cstdio>
#include <string>
#include <utility>

#include "engine/error.h"
#include "engine/system_reason.h"
#include "engine/whole_file_writer.h"

namespace ilot {
namespace {

bool write_all(int file, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = write(file, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

}  // namespace

WholeFileWriter::WholeFileWriter(std::filesystem::path path)
    : path_(std::move(path)), beside_(path_.string() + "." + std::to_string(getpid()) + ".tmp") {
  file_ = open(beside_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file_ < 0) fail();
}

WholeFileWriter::~WholeFileWriter() {
  if (file_ < 0) return;
  close(file_);
  unlink(beside_.c_str());
}

void WholeFileWriter::append(std::string_view text) {
  constexpr std::size_t kBuffer = 1 << 16;
  if (buffer_.size() + text.size() > kBuffer) flush();
  if (text.size() < kBuffer) {
    buffer_ += text;
  } else if (!write_all(file_, text)) {
    fail();
  }
}

void WholeFileWriter::finish() {
  flush();
  if (fsync(file_) != 0) fail();
  if (close(std::exchange(file_, -1)) == 0 && std::rename(beside_.c_str(), path_.c_str()) == 0) return;
  const int fault = errno;
  unlink(beside_.c_str());
  errno = fault;
  fail();
}

void WholeFileWriter::flush() {
  if (!write_all(file_, buffer_)) fail();
  buffer_.clear();
}

void WholeFileWriter::fail() {
  throw Error(path_.string() + ": cannot be written: " + system_reason(errno));
}

void write_whole_file(const std::filesystem::path& path, std::string_view content) {
  WholeFileWriter file(path);
  file.append(content);
  file.finish();
}

}  // namespace ilot
