// SPDX-License-Identifier: Apache-2.0
// Allows only one run at a time in a folder.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ilot {

constexpr const char* kLockFile = ".ilot-lock";

// Locks the file .ilot-lock in a folder (flock). The system itself releases the lock when the process ends in any way:
// a killed run may leave the file, but never the lock. The file names the process that works there, its host and the
// time.
class FolderLock {
 public:
  // Creates the folder when it does not exist. Throws an Error with ExitCode::usage that names the process that works
  // there; `otherwise` ends its sentence: "or give another -o". Throws Error when the folder cannot be created or
  // written.
  FolderLock(const std::filesystem::path& folder, const std::string& otherwise);
  // Removes the file, and the folders that were created for it when they are empty.
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  // At the end the folder is removed too when it is empty, even if it existed before.
  void remove_empty_folder() { remove_folder_ = true; }

  // False on a file system without locks. There a second run would not be noticed.
  bool works() const { return works_; }

 private:
  bool try_open();
  void write_holder() const;

  std::filesystem::path folder_, path_;
  std::vector<std::filesystem::path> made_;  // the outermost folder first
  int file_ = -1;
  bool works_ = true, remove_folder_ = false;
};

// Returns "process 4711 on HOST has been working in this folder since 2026-01-31 12:00:00 UTC"; nullopt when no process
// works there.
std::optional<std::string> folder_holder(const std::filesystem::path& folder);

}  // namespace ilot
