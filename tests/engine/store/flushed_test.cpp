// SPDX-License-Identifier: Apache-2.0
#include "engine/store/flushed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

// A folder in which some passes have left files.
void fill(const TemporaryFolder& folder) {
  for (const char* name :
       {"index", "rejected", "blocks/a.block", "blocks/a.codes", "blocks/a.order", "blocks/b.codes", "blocks/a.normals",
        "blocks/b.normals", "blocks/a.segment", "cells/x.cell", "roofs/labels-0", "manifest.json"})
    folder.put(name, "x");
}

std::vector<std::string> files_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().filename() != "flushed")
      names.push_back(fs::relative(entry.path(), folder).string());
  std::sort(names.begin(), names.end());
  return names;
}

TEST(Flushed, TheSameBootTrustsEverything) {
  const TemporaryFolder folder;
  open_flushed(folder.path(), "one");
  fill(folder);
  const auto before = files_in(folder.path());
  open_flushed(folder.path(), "one");
  EXPECT_EQ(files_in(folder.path()), before);
}

TEST(Flushed, AnotherBootTrustsWhatWasFlushed) {
  const TemporaryFolder folder;
  open_flushed(folder.path(), "one");
  fill(folder);
  flush_folder(folder.path(), Pass::index, "one");
  flush_folder(folder.path(), Pass::normals, "one");
  open_flushed(folder.path(), "two");
  EXPECT_EQ(files_in(folder.path()),
            (std::vector<std::string>{"blocks/a.block", "blocks/a.codes", "blocks/a.normals", "blocks/a.order",
                                      "blocks/b.codes", "blocks/b.normals", "index", "manifest.json", "rejected"}));
  folder.put("blocks/a.segment", "again");
  open_flushed(folder.path(), "two");
  EXPECT_TRUE(fs::exists(folder.path() / "blocks/a.segment")) << "written during this boot";
  open_flushed(folder.path(), "three");
  EXPECT_FALSE(fs::exists(folder.path() / "blocks/a.segment"));
  EXPECT_TRUE(fs::exists(folder.path() / "blocks/a.normals"));
}

TEST(Flushed, WithoutTheIndexNothingIsTrusted) {
  const TemporaryFolder folder;
  open_flushed(folder.path(), "one");
  fill(folder);
  open_flushed(folder.path(), "two");
  EXPECT_EQ(files_in(folder.path()), std::vector<std::string>{"manifest.json"});
}

TEST(Flushed, ABootWithoutANameIsAlwaysAnother) {
  const TemporaryFolder folder;
  open_flushed(folder.path(), "");
  fill(folder);
  open_flushed(folder.path(), "");
  EXPECT_EQ(files_in(folder.path()), std::vector<std::string>{"manifest.json"});
}

TEST(Flushed, ThisBootHasANameThatStays) {
  EXPECT_FALSE(this_boot().empty());
  EXPECT_EQ(this_boot(), this_boot());
}

}  // namespace
}  // namespace ilot
