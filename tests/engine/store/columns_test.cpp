// SPDX-License-Identifier: Apache-2.0
#include "engine/store/columns.h"

#include <gtest/gtest.h>

#include <iterator>
#include <set>
#include <sstream>
#include <string>

#include "tests/support/file_bytes.h"

namespace ilot {
namespace {

std::string source(const char* path) {
  return test::file_bytes(std::string(ILOT_SOURCE_DIR) + "/" + path);
}

std::set<std::string> words_of(std::string text) {
  for (char& c : text)
    if (c == ',') c = ' ';
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

std::string row(const ColumnInfo& c) {
  return std::string("| `") + c.name + "` | " + c.type + " | " + info_of(c.writer).name + " | " + c.readers + " | " +
         c.meaning + " |\n";
}

std::string row(const PassInfo& p) {
  std::string folders;
  for (const std::string& folder : words_of(p.folders)) folders += (folders.empty() ? "`" : ", `") + folder + "/`";
  return std::string("| `") + p.name + "` | " + folders + " | " + p.work + " |\n";
}

TEST(Columns, TheListHasEveryDeclarationOnce) {
  const std::string header = source("engine/store/columns.h") + source("engine/store/extended_columns.h");
  std::size_t declared = 0;
  for (std::size_t at = header.find("constexpr Column<"); at != std::string::npos;
       at = header.find("constexpr Column<", at + 1))
    ++declared;
  std::set<std::string> names;
  for (const ColumnInfo* c : all_columns()) names.insert(c->name);
  EXPECT_EQ(all_columns().size(), declared);
  EXPECT_EQ(names.size(), declared);
}

TEST(Columns, ReadersArePasses) {
  std::set<std::string> passes{"all"};
  for (int p = 0; p < kPasses; ++p) passes.insert(info_of(static_cast<Pass>(p)).name);
  EXPECT_EQ(passes.size(), static_cast<std::size_t>(kPasses) + 1);
  for (const ColumnInfo* c : all_columns())
    for (const std::string& reader : words_of(c->readers)) EXPECT_EQ(passes.count(reader), 1u) << reader;
}

TEST(Columns, TheReadmeSaysTheSame) {
  const std::string readme = source("engine/store/README.md");
  std::string passes = "|---|---|---|\n", columns = "|---|---|---|---|---|\n";
  for (int p = 0; p < kPasses; ++p) passes += row(info_of(static_cast<Pass>(p)));
  for (const ColumnInfo* c : all_columns()) columns += row(*c);
  EXPECT_NE(readme.find(passes + "\n"), std::string::npos) << passes;
  EXPECT_EQ(readme.substr(readme.size() - std::min(readme.size(), columns.size())), columns);
}

}  // namespace
}  // namespace ilot
