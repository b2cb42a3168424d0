// SPDX-License-Identifier: Apache-2.0
#include "engine/scale/work_folder.h"

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <vector>

#include "engine/error.h"
#include "engine/system_reason.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

// A folder that a living process has just made may not be locked yet, and where a file system has no locks none ever
// is: younger folders are left alone.
constexpr std::chrono::hours kSurelyDead{1};  // Choice: far more than a task needs to lock its folder

void remove_dead(const fs::path& parent, const std::string& beginning) {
  std::vector<fs::path> dead;
  std::error_code gone;  // another task may remove the same folder at the same time
  for (const auto& entry : fs::directory_iterator(parent, gone)) {
    if (!entry.path().filename().string().starts_with(beginning)) continue;
    const auto changed = fs::last_write_time(entry.path(), gone);
    const bool locked_once = fs::exists(entry.path() / kLockFile, gone);
    const bool old = !gone && fs::file_time_type::clock::now() - changed > kSurelyDead;
    if ((locked_once || old) && !folder_holder(entry.path())) dead.push_back(entry.path());
  }
  for (const fs::path& path : dead) fs::remove_all(path, gone);
}

}  // namespace

WorkFolder::WorkFolder(const fs::path& parent, const std::string& beginning) {
  fs::create_directories(parent);
  remove_dead(parent, beginning);
  std::string name = (parent / (beginning + "XXXXXX")).string();
  if (mkdtemp(name.data()) == nullptr)
    throw Error(parent.string() + ": no folder can be made in it: " + system_reason(errno));
  path_ = name;
  lock_.emplace(path_, "or wait for it");
}

WorkFolder::~WorkFolder() {
  lock_.reset();
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace ilot
