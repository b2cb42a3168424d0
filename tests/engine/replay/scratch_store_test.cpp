// SPDX-License-Identifier: Apache-2.0
#include <fstream>

#include "engine/error.h"
#include "engine/replay/kept_run.h"
#include "engine/store/column_file.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

std::vector<int> kept_values(const fs::path& path) {
  return read_column<int>(path);
}

TEST(ScratchStore, WhatIsWrittenLeavesTheKeptStoreAsItIs) {
  const TemporaryFolder folder;
  const fs::path kept = folder.path() / "store", scratch = folder.path() / "scratch";
  fs::create_directories(kept / "blocks");
  const std::vector<int> before{1, 2, 3}, now{4, 5};
  write_column<int>(kept / "blocks" / "a.segment", before);
  {
    const ScratchStore store(kept, scratch);
    EXPECT_EQ(kept_values(store.folder() / "blocks" / "a.segment"), before);
    write_column<int>(store.folder() / "blocks" / "a.segment", now);
    write_column<int>(store.folder() / "blocks" / "b.segment", now);
    EXPECT_EQ(kept_values(store.folder() / "blocks" / "a.segment"), now);
    EXPECT_EQ(kept_values(kept / "blocks" / "a.segment"), before);
  }
  EXPECT_EQ(kept_values(kept / "blocks" / "a.segment"), before);
  EXPECT_FALSE(fs::exists(kept / "blocks" / "b.segment"));
  EXPECT_FALSE(fs::exists(scratch));
}

TEST(KeptOptions, AFolderWithoutARunOrAStoreIsRefused) {
  const TemporaryFolder folder;
  const auto refused = [&] {
    try {
      kept_options({folder.path(), {}, {}, {}, {}, {}});
    } catch (const Error& fault) {
      EXPECT_EQ(fault.code(), ExitCode::usage);
      return std::string(fault.what());
    }
    return std::string();
  };
  EXPECT_NE(refused().find("no finished run"), std::string::npos);
  std::ofstream(folder.path() / "run.json") << R"({"parameters": {}, "request": {"products": ["roofs"]}})";
  EXPECT_NE(refused().find("--keep-store"), std::string::npos);
}

}  // namespace
}  // namespace ilot
