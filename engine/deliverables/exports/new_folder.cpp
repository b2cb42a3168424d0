// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/exports/new_folder.h"

#include "engine/error.h"
#include "engine/system_reason.h"

namespace ilot {

namespace fs = std::filesystem;

NewFolder::NewFolder(const fs::path& path)
    : path_(path.has_filename() ? path : path.parent_path()), part_(path_.string() + ".part") {
  std::error_code fault;
  const bool there = fs::exists(path_, fault);
  if (there && !(fs::is_directory(path_, fault) && fs::is_empty(path_, fault)))
    throw Error(path_.string() + ": is there already; give a new folder", ExitCode::usage);
  fs::remove_all(part_, fault);  // of an earlier process that was killed
  fs::create_directories(part_, fault);
  if (fault) throw Error(part_.string() + ": cannot be made: " + system_reason(fault.value()));
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
