// SPDX-License-Identifier: Apache-2.0
#include "engine/run/result_swap.h"

#include <gtest/gtest.h>

#include "engine/error.h"
#include "engine/report/product_files.h"
#include "tests/support/file_bytes.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;
using test::file_bytes;

using Names = std::vector<std::string>;

class ResultSwap : public testing::Test {
 protected:
  // An old result of three files, somebody's own beside it, and a new result that is ready.
  void SetUp() override {
    for (const char* name : {"planes.csv", "points/a.laz", "roofs/old/x.obj"}) folder_.put(name, "old");
    folder_.put("run.json", "old");
    folder_.put("points/mine.txt", "mine");
    for (const char* name : {".new/planes.csv", ".new/points/b.laz", ".new/streets/deep/map.svg", ".new/run.json"})
      folder_.put(name, "new");
  }
  const fs::path& out() const { return folder_.path(); }
  void expect_new() const {
    EXPECT_EQ(product_files(out()), (Names{"planes.csv", "points/b.laz", "points/mine.txt", "streets/deep/map.svg"}));
    for (const char* name : {"planes.csv", "points/b.laz", "streets/deep/map.svg", "run.json"})
      EXPECT_EQ(file_bytes(out() / name), "new") << name;
    EXPECT_EQ(file_bytes(out() / "points/mine.txt"), "mine");
    EXPECT_FALSE(fs::exists(out() / ".new") || fs::exists(out() / ".swap") || fs::exists(out() / "roofs"));
  }

  TemporaryFolder folder_;
  Names old_{"planes.csv", "points/a.laz", "roofs/old/x.obj"};
};

TEST_F(ResultSwap, TheNewTakesThePlaceOfTheOldAndOfNothingElse) {
  check_places(out(), old_, {"planes.csv", "points/b.laz", "streets/deep/map.svg"});
  swap_result(out(), old_);
  expect_new();
  finish_swap(out());
  expect_new();
}

TEST_F(ResultSwap, CutShortItIsFinished) {
  fs::rename(out() / ".new", out() / ".swap");
  folder_.put(".swap/.going", std::string("points/a.laz\0roofs/old/x.obj\0", 29));
  fs::remove(out() / "run.json");
  fs::remove(out() / "points/a.laz");
  fs::rename(out() / ".swap/planes.csv", out() / "planes.csv");
  finish_swap(out());
  expect_new();
}

TEST_F(ResultSwap, CutShortWhileClearingUp) {
  swap_result(out(), old_);
  folder_.put(".swap/.going", std::string("planes.csv\0", 11));
  finish_swap(out());
  expect_new();
}

TEST_F(ResultSwap, WhatIsNotOfTheRunIsNeverReplaced) {
  EXPECT_THROW(check_places(out(), {"points/a.laz"}, {"planes.csv"}), Error);
  EXPECT_THROW(check_places(out(), old_, {"points"}), Error) << "a folder";
  EXPECT_THROW(check_places(out(), old_, {"points/mine.txt/x"}), Error) << "a file where a folder is needed";
  fs::create_symlink("/tmp", out() / "streets");
  EXPECT_THROW(check_places(out(), old_, {"streets/deep/map.svg"}), Error) << "a link elsewhere";
  fs::create_symlink("/nowhere", out() / "shapes.csv");
  EXPECT_THROW(check_places(out(), old_, {"shapes.csv"}), Error) << "a link to nothing";
  EXPECT_NO_THROW(check_places(out(), old_, {"planes.csv", "new/one"}));
}

TEST_F(ResultSwap, TheSameContentIsNotInTheWay) {
  folder_.put("planes.csv", "new");
  check_places(out(), {}, {"planes.csv"});
  folder_.put("planes.csv", "nev");
  EXPECT_THROW(check_places(out(), {}, {"planes.csv"}), Error);
}

TEST_F(ResultSwap, NothingIsRemovedBehindALink) {
  const TemporaryFolder elsewhere;
  elsewhere.put("old/x.obj", "theirs");
  fs::remove_all(out() / "roofs");
  fs::create_symlink(elsewhere.path(), out() / "roofs");
  swap_result(out(), old_);
  EXPECT_EQ(file_bytes(elsewhere.path() / "old/x.obj"), "theirs");
}

TEST(IsInside, OnlyWhatARunWrites) {
  for (const char* path : {"planes.csv", "points/a.laz", "a/.b"}) EXPECT_TRUE(is_inside(path)) << path;
  for (const char* path : {"", "/etc/passwd", "../a", "a/../../b", "a/..", ".store/x", "."})
    EXPECT_FALSE(is_inside(path)) << path;
}

}  // namespace
}  // namespace ilot
