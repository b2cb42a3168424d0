// SPDX-License-Identifier: Apache-2.0
#include "engine/whole_file.h"

#include <fcntl.h>
#include <unistd.h>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

#include "engine/error.h"

namespace ilot {
namespace {

bool write_all(int file, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = write(file, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return fsync(file) == 0;
}

}  // namespace

void write_whole_file(const std::filesystem::path& path, std::string_view content) {
  const std::string beside = path.string() + "." + std::to_string(getpid()) + ".tmp";
  const int file = open(beside.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  bool good = file >= 0 && write_all(file, content);
  int fault = good ? 0 : errno;
  if (file >= 0 && close(file) != 0 && good) good = false, fault = errno;
  if (good && std::rename(beside.c_str(), path.c_str()) != 0) good = false, fault = errno;
  if (good) return;
  if (file >= 0) unlink(beside.c_str());
  throw Error(path.string() + ": cannot be written: " + std::strerror(fault));
}

}  // namespace ilot
