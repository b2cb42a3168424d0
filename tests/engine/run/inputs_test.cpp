// SPDX-License-Identifier: Apache-2.0
#include "engine/run/inputs/inputs.h"

#include "tests/engine/formats/fixtures.h"

namespace ilot {
namespace {

using namespace test;
using Paths = std::vector<std::filesystem::path>;

Paths expand(const std::vector<std::string>& arguments) {
  return expand_inputs(arguments);
}

TEST(Inputs, FilesGlobsAndFoldersAreSortedAndUnique) {
  const Folder folder;
  std::filesystem::create_directories(folder / "in" / "deep");
  for (const char* name : {"in/b.las", "in/a č.LAZ", "in/deep/c.ply", "in/notes.txt", "in/x[1].las", "in/d.json"})
    spill_text(folder / name, "x");
  const std::string in = (folder / "in").string();
  const Paths all{in + "/a č.LAZ", in + "/b.las", in + "/deep/c.ply", in + "/x[1].las"};
  EXPECT_EQ(expand({in}), all);
  EXPECT_EQ(expand({in + "/"}), all);
  EXPECT_EQ(expand({in + "/x[1].las", in, in + "/b.las"}), all);
  EXPECT_EQ(expand({in + "/*.las"}), (Paths{in + "/b.las", in + "/x[1].las"}));
  EXPECT_EQ(expand({in + "/notes.txt"}), (Paths{in + "/notes.txt"}));
}

TEST(Inputs, WhatIsMissingIsNamed) {
  const Folder folder;
  std::filesystem::create_directories(folder / "empty");
  for (const std::string name : {"no.las", "no*.las", "empty"}) {
    try {
      expand({(folder / name).string()});
      ADD_FAILURE() << name;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find((folder / name).string()), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace ilot
