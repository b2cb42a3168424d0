// SPDX-License-Identifier: Apache-2.0
// A folder that appears with all its files or not at all.
#pragma once
#include <filesystem>

namespace ilot {

// Files are written into a new folder PATH.part (PATH.part2 ... where that is there), which becomes PATH at commit().
// Without commit() it is removed. Throws a usage
// Error when PATH is there and is not an empty folder.
class NewFolder {
 public:
  explicit NewFolder(const std::filesystem::path& path);
  ~NewFolder();
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;

  const std::filesystem::path& part() const { return part_; }
  void commit();

 private:
  std::filesystem::path path_, part_;
};

}  // namespace ilot
