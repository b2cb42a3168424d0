// SPDX-License-Identifier: Apache-2.0
// One run at a time in a folder.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ilot {

constexpr const char* kLockFile = ".ilot-lock";

// Holds the file .ilot-lock in a folder locked (flock), so that the system itself gives the lock back however the
// process ends: a killed run leaves the file perhaps, but never the lock. The file contains who works there: process,
// host, time.
class FolderLock {
 public:
  // Makes the folder when it does not exist. Throws an Error with ExitCode::usage that names the process which works
  // there; `otherwise` ends its sentence: "or give another -o". Error when the folder cannot be made or written.
  FolderLock(const std::filesystem::path& folder, const std::string& otherwise);
  // Removes the file, and the folders that were made for it when they are empty.
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  // At the end the folder goes too when it is empty, whoever made it.
  void remove_empty_folder() { remove_folder_ = true; }

  // False on a file system without locks: then a second run would not be noticed.
  bool works() const { return works_; }

 private:
  bool try_open();
  void write_holder() const;

  std::filesystem::path folder_, path_;
  std::vector<std::filesystem::path> made_;  // the outermost first
  int file_ = -1;
  bool works_ = true, remove_folder_ = false;
};

// "process 4711 on HOST has been working in this folder since 2026-01-31 12:00:00 UTC"; nullopt when nobody does.
std::optional<std::string> folder_holder(const std::filesystem::path& folder);

}  // namespace ilot
