// SPDX-License-Identifier: Apache-2.0
// Records which files of a store have reached the disk. A file that was renamed to its final name is complete for every
// process of the same boot, even after kill -9; after a power cut it may be empty. So finished passes are flushed
// together (a flush of one file waits 3 ms or more, and a store has about 20 files a block). A store that was last used
// before the machine was restarted keeps only what was flushed.
#pragma once
#include <filesystem>
#include <string>

#include "engine/store/store.h"

namespace ilot {

// Returns the name of this boot of the machine; it does not change until the next boot.
std::string this_boot();

// Called before work in the folder of a store begins or is resumed. When the folder was last opened during another
// boot, it removes the files that passes have written but not flushed.
void open_flushed(const std::filesystem::path& folder, const std::string& boot = this_boot());

// Called after a pass has finished. Writes to the disk all data of the folder's file system that is still in memory,
// and records that the pass is complete.
void flush_folder(const std::filesystem::path& folder, Pass pass, const std::string& boot = this_boot());

// Does the same when the store has so many points that its passes are worth keeping; the passes of smaller stores are
// repeated in seconds.
constexpr std::uint64_t kFlushedPoints = std::uint64_t{1} << 22;
inline void flush_pass(const Store& store, Pass pass) {
  if (store.points() >= kFlushedPoints) flush_folder(store.folder(), pass);
}

}  // namespace ilot
