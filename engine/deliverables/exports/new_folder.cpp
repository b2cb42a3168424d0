// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/exports/new_folder.h"

#include <string>

#include "engine/error.h"
#include "engine/system_reason.h"

namespace ilot {

namespace fs = std::filesystem;

NewFolder::NewFolder(const fs::path& path) : path_(path.has_filename() ? path : path.parent_path()) {
  std::error_code fault;
  const bool there = fs::exists(path_, fault);
  if (there && !(fs::is_directory(path_, fault) && fs::is_empty(path_, fault)))
    throw Error(path_.string() + ": is there already; give a new folder", ExitCode::usage);
  if (path_.has_parent_path()) fs::create_directories(path_.parent_path(), fault);
  // A folder of this name may be a user's, or that of another process at work.
  for (int number = 1; part_.empty() && !fault; ++number) {
    const fs::path part = path_.string() + ".part" + (number == 1 ? "" : std::to_string(number));
    if (fs::create_directory(part, fault)) part_ = part;
  }
  if (fault) throw Error(path_.string() + ": cannot be made: " + system_reason(fault.value()));
}

NewFolder::~NewFolder() {
  std::error_code fault;
  if (!part_.empty()) fs::remove_all(part_, fault);
}

void NewFolder::commit() {
  std::error_code fault;
  fs::remove(path_, fault);  // an empty folder
  fs::rename(part_, path_, fault);
  if (fault) throw Error(path_.string() + ": cannot be made: " + system_reason(fault.value()));
  part_.clear();
}

}  // namespace ilot
