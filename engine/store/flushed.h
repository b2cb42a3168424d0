// SPDX-License-Identifier: Apache-2.0
// What of a store has reached the disk. A file that was renamed into place is complete for every process of the same
// boot, also after kill -9; after a power cut it may be empty. So the finished passes are flushed together (one flush a
// file takes 3 ms and more of waiting, and a store has some 20 files a block), and a store that was last worked on
// before the machine was started again keeps only what was flushed.
#pragma once
#include <filesystem>
#include <string>

#include "engine/store/store.h"

namespace ilot {

// What names this start of the machine; the same as long as it runs.
std::string this_boot();

// Before work in the folder of a store begins, new or to be resumed: removes what passes have written and not flushed,
// when the folder was last opened during another boot.
void open_flushed(const std::filesystem::path& folder, const std::string& boot = this_boot());

// After a pass has finished: writes all that the folder's file system still has in memory to the disk, and notes that
// the pass is there.
void flush_folder(const std::filesystem::path& folder, Pass pass, const std::string& boot = this_boot());

// The same for a store of so many points that its passes are worth keeping; smaller ones are made again in seconds.
constexpr std::uint64_t kFlushedPoints = std::uint64_t{1} << 22;
inline void flush_pass(const Store& store, Pass pass) {
  if (store.points() >= kFlushedPoints) flush_folder(store.folder(), pass);
}

}  // namespace ilot
