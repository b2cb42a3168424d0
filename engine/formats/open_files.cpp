// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/open_files.h"

#include <unistd.h>

#include "engine/formats/file.h"

namespace ilot {
namespace {

constexpr std::size_t kMostOpen = 64;  // a sixteenth of the usual limit; opening one again costs microseconds

}  // namespace

OpenFiles::~OpenFiles() {
  for (const Entry& entry : entries_) ::close(entry.descriptor);
}

OpenFiles::Use::Use(OpenFiles& files, const InputFile& file)
    : files_(files), file_(file), descriptor_(files.take(file)) {}

OpenFiles::Use::~Use() {
  files_.give_back(file_);
}

int OpenFiles::take(const InputFile& file) {
  const std::lock_guard lock(mutex_);
  const auto found = places_.find(&file);
  if (found != places_.end()) {
    entries_.splice(entries_.begin(), entries_, found->second);
  } else {
    entries_.push_front({&file, file.reopen(), 0});
    places_[&file] = entries_.begin();
    close_unused();
  }
  ++entries_.front().users;
  return entries_.front().descriptor;
}

void OpenFiles::give_back(const InputFile& file) {
  const std::lock_guard lock(mutex_);
  --places_.at(&file)->users;
}

// The first entry stays, because it will be used next.
void OpenFiles::close_unused() {
  for (auto it = entries_.end(); entries_.size() > most_ && it != entries_.begin();) {
    --it;
    if (it == entries_.begin() || it->users > 0) continue;
    ::close(it->descriptor);
    places_.erase(it->file);
    it = entries_.erase(it);
  }
}

void OpenFiles::forget(const InputFile& file) {
  const std::lock_guard lock(mutex_);
  const auto found = places_.find(&file);
  if (found == places_.end()) return;
  ::close(found->second->descriptor);
  entries_.erase(found->second);
  places_.erase(found);
}

OpenFiles& open_files() {
  static OpenFiles files(kMostOpen);
  return files;
}

}  // namespace ilot
