// SPDX-License-Identifier: Apache-2.0
#include "engine/report/sha256.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>

#include "engine/error.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

std::string sum_of(const std::string& text) {
  Sha256 sum;
  sum.update(std::as_bytes(std::span(text)));
  return sum.hex();
}

TEST(Sha256, PublishedVectors) {  // FIPS 180-4 examples
  EXPECT_EQ(sum_of(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sum_of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sum_of(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(ResultHash, IsTheDocumentedSum) {
  const TemporaryFolder folder;
  folder.put("points/a.las", "xyz");
  folder.put("planes.csv", "id\n");
  const std::string expected = std::string("planes.csv\0\3\0\0\0\0\0\0\0id\n", 10 + 1 + 8 + 3) +
                               std::string("points/a.las\0\3\0\0\0\0\0\0\0xyz", 12 + 1 + 8 + 3);
  EXPECT_EQ(result_hash(folder.path()), sum_of(expected));
}

TEST(ResultHash, LeavesOutWhatIsNoProduct) {
  const TemporaryFolder folder;
  folder.put("planes.csv", "id\n");
  const std::string before = result_hash(folder.path());
  folder.put("run.json", "{}");
  folder.put("report.html", "<p>");
  folder.put("report-tiles/models-0.js", "ilot");
  folder.put(".store/block", "1");
  folder.put("work/block", "1");
  EXPECT_EQ(result_hash(folder.path(), folder.path() / "work"), before);
  EXPECT_NE(result_hash(folder.path()), before);
}

TEST(ResultHash, SeesNamesContentsAndWhereOneFileEnds) {
  const TemporaryFolder a, b, c, large;
  a.put("a", "12");
  b.put("b", "12");
  c.put("a", "1");
  c.put("b", "2");
  EXPECT_NE(result_hash(a.path()), result_hash(b.path()));
  EXPECT_NE(result_hash(a.path()), result_hash(c.path()));
  large.put("a", std::string((1 << 20) + 1, 'x'));
  const std::string before = result_hash(large.path());
  large.put("a", std::string(1 << 20, 'x') + "y");
  EXPECT_NE(result_hash(large.path()), before);
}

TEST(ResultHash, MissingFolder) {
  EXPECT_THROW(result_hash("/nonexistent/out"), Error);
}

}  // namespace
}  // namespace ilot
