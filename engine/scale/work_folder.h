// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "engine/run/folder_lock.h"

namespace ilot {

// A folder of this process alone, below `parent`, that is removed at the end. Its name begins with `beginning` and ends
// with what no other process has, on any host. Folders of the same beginning that dead processes left are removed
// first.
class WorkFolder {
 public:
  WorkFolder(const std::filesystem::path& parent, const std::string& beginning);
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  std::optional<FolderLock> lock_;
};

}  // namespace ilot
