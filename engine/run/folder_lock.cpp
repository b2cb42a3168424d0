// SPDX-License-Identifier: Apache-2.0
#include "engine/run/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>

#include "engine/error.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

enum class Taken { yes, by_another, impossible };

Taken take(int file) {
  while (flock(file, LOCK_EX | LOCK_NB) != 0) {
    if (errno == EINTR) continue;
    return errno == EWOULDBLOCK ? Taken::by_another : Taken::impossible;
  }
  return Taken::yes;
}

// Tells whether the open file still has this name: the previous run removes its file when it ends.
bool has_name(int file, const fs::path& path) {
  struct stat open_file {
  }, named{};
  return fstat(file, &open_file) == 0 && stat(path.c_str(), &named) == 0 && open_file.st_dev == named.st_dev &&
         open_file.st_ino == named.st_ino;
}

std::string host_name() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "an unknown host";
}

std::string utc_now() {
  const std::time_t seconds = std::time(nullptr);
  std::tm parts{};
  std::array<char, 32> text{};
  if (gmtime_r(&seconds, &parts) == nullptr) return "an unknown time";
  std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M:%S UTC", &parts);
  return text.data();
}

// Returns the sentence in the file; a process that has just taken the lock may not have written it yet.
std::string holder(int file) {
  std::array<char, 512> text{};
  const ssize_t got = pread(file, text.data(), text.size(), 0);
  if (got <= 0) return "another process has just begun to work in this folder";
  return {text.data(), static_cast<std::size_t>(got)};
}

}  // namespace

FolderLock::FolderLock(const fs::path& folder, const std::string& otherwise) : folder_(folder) {
  path_ = folder / kLockFile;
  std::error_code problem;
  for (fs::path part = fs::absolute(folder).lexically_normal(); !fs::exists(part, problem); part = part.parent_path())
    if (part.has_filename()) made_.insert(made_.begin(), part);
  try {
    constexpr int kTries = 1000;  // one try is lost for each run that ends at that moment
    for (int i = 0; !try_open(); ++i)
      if (i == kTries)
        throw Error(folder.string() + ": cannot be created: something removes it again; give another place");
    const Taken taken = take(file_);
    if (taken == Taken::by_another)
      throw Error(folder.string() + ": " + holder(file_) + "; wait until it ends or stop it, " + otherwise,
                  ExitCode::usage);
    works_ = taken == Taken::yes;
    write_holder();
  } catch (...) {
    if (file_ >= 0) close(file_);
    for (auto it = made_.rbegin(); it != made_.rend(); ++it) rmdir(it->c_str());
    throw;
  }
}

// True when the file is open and either this process or another one has the lock; false to try again, because the
// previous run has just removed its file or folder.
bool FolderLock::try_open() {
  std::error_code problem;
  fs::create_directories(folder_, problem);
  if (problem == std::errc::no_such_file_or_directory) return false;
  if (problem)
    throw Error(folder_.string() + ": cannot be created: " + problem.message() + "; give another place or permission");
  file_ = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
  if (file_ < 0 && errno == ENOENT) return false;
  if (file_ < 0)
    throw Error(folder_.string() + ": cannot be written: " + std::strerror(errno) +
                "; change its permissions or give another folder");
  if (take(file_) == Taken::yes && !has_name(file_, path_)) {
    close(file_);
    file_ = -1;
    return false;
  }
  return true;
}

void FolderLock::write_holder() const {
  const std::string text = "process " + std::to_string(getpid()) + " on " + host_name() +
                           " has been working in this folder since " + utc_now();
  if (ftruncate(file_, 0) != 0 || pwrite(file_, text.data(), text.size(), 0) != static_cast<ssize_t>(text.size())) {
    const int reason = errno;
    unlink(path_.c_str());
    throw Error(folder_.string() + ": cannot be written: " + std::strerror(reason) + "; free some space");
  }
}

FolderLock::~FolderLock() {
  unlink(path_.c_str());
  close(file_);
  if (remove_folder_ && rmdir(folder_.c_str()) != 0) return;
  for (auto it = made_.rbegin(); it != made_.rend(); ++it) rmdir(it->c_str());
}

std::optional<std::string> folder_holder(const fs::path& folder) {
  const int file = open((folder / kLockFile).c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW);
  if (file < 0) return std::nullopt;
  std::optional<std::string> text;
  if (take(file) == Taken::by_another) text = holder(file);
  close(file);
  return text;
}

}  // namespace ilot
