// SPDX-License-Identifier: Apache-2.0
#include "engine/run/inputs/read_edits.h"

#include <gtest/gtest.h>

#include "engine/deliverables/tables/edits_csv.h"
#include "engine/error.h"

namespace ilot {
namespace {

const std::string kHead = "product,edit,kind,x1,y1,z1,x2,y2,z2\n";

std::string fault_of(const std::string& text) {
  try {
    parse_edits(text, "edits.csv");
  } catch (const Error& fault) {
    EXPECT_EQ(fault.code(), ExitCode::usage);
    const std::string what = fault.what();
    EXPECT_EQ(what.rfind("edits.csv", 0), 0u) << what;
    return what.substr(9);
  }
  return "no fault";
}

TEST(ReadEdits, ATableOfASpreadsheetAndOneByHand) {
  const auto plain = parse_edits("# by hand\n" + kHead + "\nfacades,added,window,1,2.5,3,4,5,6\n,,,,,,,,\n", "a.csv");
  const auto office = parse_edits(
      "\xef\xbb\xbfproduct;edit;kind;x1;y1;z1;x2;y2;z2;note\r\n"
      "facades;added;\"window\";1;2,5;3;4;5;6;\"bay; see \"\"A\"\"\"\r\n",
      "b.csv");
  ASSERT_EQ(plain.size(), 1u);
  ASSERT_EQ(office.size(), 1u);
  EXPECT_EQ(plain[0].where, "a.csv:4");
  EXPECT_EQ(office[0].where, "b.csv:2");
  EXPECT_EQ(office[0].note, "bay; see \"A\"");
  for (const Edit& e : {plain[0], office[0]}) {
    EXPECT_EQ(e.action, EditAction::added);
    EXPECT_EQ(e.kind, "window");
    ASSERT_EQ(e.at.size(), 2u);
    EXPECT_EQ(e.at[0].y, 2.5);
    EXPECT_EQ(e.at[1].z, 6);
  }
}

TEST(ReadEdits, WhatIsWrittenIsReadAgain) {
  Edit edit;
  edit.product = "facades";
  edit.action = EditAction::moved;
  edit.kind = "window", edit.to_kind = "door";
  edit.at = {{277877.1234, 6122529.25, 1}, {277878, 6122530, 2.5}};
  edit.to = {{277877.2, 6122529.5, 1}, {277878.5, 6122530.25, 2.75}};
  edit.note = "a, \"b\"";
  const auto read = parse_edits(edits_csv(std::span(&edit, 1)), "edits.csv");
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(edits_csv(read), edits_csv(std::span(&edit, 1)));
  EXPECT_EQ(read[0].at[0].x, 277877.1234);
  EXPECT_EQ(read[0].to[1].z, 2.75);
  EXPECT_EQ(read[0].to_kind, "door");
  EXPECT_EQ(read[0].note, edit.note);
}

TEST(ReadEdits, AreasOfPointsAndPlacesOnRoofs) {
  const auto read = parse_edits(
      "product,edit,to_kind,WKT,x1,y1,z1,x2,y2,z2\n"
      "roofs,kind,other,\"POLYGON ((0 0, 4 0, 4 3, 0 0))\",,,6.5,,,\n"
      "roofs,merged,,,1,2,,3,4,\n",
      "edits.csv");
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].area.max_x, 4);
  EXPECT_EQ(read[0].low, 6.5);
  EXPECT_FALSE(read[0].high);
  ASSERT_EQ(read[1].at.size(), 2u);
  EXPECT_EQ(read[1].at[1].y, 4);
  const auto again = parse_edits(edits_csv(read), "edits.csv");
  EXPECT_EQ(edits_csv(again), edits_csv(read));
  EXPECT_EQ(again[0].low, 6.5);
  EXPECT_FALSE(again[0].high);
}

TEST(ReadEdits, FaultsOfRoofs) {
  const std::string head = "product,edit,kind,x1,y1,z1,x2,y2,z2,to_kind,area\n";
  const std::string area = "\"POLYGON ((0 0, 4 0, 4 3, 0 0))\"";
  EXPECT_EQ(fault_of(head + "roofs,kind,,,,,,,,other,\n").rfind(":2: kind of roofs needs an area", 0), 0u);
  EXPECT_EQ(fault_of(head + "roofs,kind,,,,,,,,," + area + "\n").rfind(":2: kind of roofs needs a to_kind", 0), 0u);
  EXPECT_EQ(fault_of(head + "roofs,kind,,,,,,,,tree," + area + "\n"),
            ":2: \"tree\" is no kind of points: building, ground or other");
  EXPECT_EQ(fault_of(head + "roofs,kind,,,,9,,,5,other," + area + "\n"),
            ":2: z1 is the lowest height and z2 the greatest");
  EXPECT_EQ(fault_of(head + "roofs,merged,,1,2,,3,4,,other,\n"), ":2: merged of roofs needs no to_kind");
  EXPECT_EQ(fault_of(head + "streets,split,,1,2,,3,4,,car,\n"), ":2: split of streets needs no to_kind");
  EXPECT_EQ(fault_of(head + "roofs,merged,,1,2,,,,,,\n").rfind(":2: merged of roofs needs two places", 0), 0u);
  EXPECT_EQ(fault_of(head + "roofs,merged,,1,2,3,1,2,5,,\n"), ":2: two different places are needed");
}

TEST(ReadEdits, FaultsNameTheLineAndWhatToDo) {
  EXPECT_EQ(fault_of("").rfind(": is empty", 0), 0u);
  EXPECT_EQ(fault_of("product,edit,width\n").rfind(":1: \"width\" is no column", 0), 0u);
  EXPECT_EQ(fault_of("product,kind\n").rfind(":1: the column edit is needed", 0), 0u);
  EXPECT_EQ(fault_of("product,edit,edit\n").rfind(":1: the column \"edit\" comes twice", 0), 0u);
  EXPECT_EQ(fault_of(kHead + "facades,added,window,1,2,3,4,5\n").rfind(":2: a place needs x2, y2 and z2", 0), 0u);
  EXPECT_EQ(fault_of(kHead + "facades,added,window,1,2,3,4,5,six\n"), ":2: z2: \"six\" is not a number");
  EXPECT_EQ(fault_of(kHead + "facades,added,window,1e300,2,3,4,5,6\n").rfind(":2: x1: \"1e300\" is farther away", 0),
            0u);
  EXPECT_EQ(fault_of(kHead + "facades,added,,1,2,3,4,5,6\n"), ":2: added of facades needs a kind");
  EXPECT_EQ(fault_of(kHead + "facades,added,balcony,1,2,3,4,5,6\n").rfind(":2: \"balcony\" is no kind", 0), 0u);
  EXPECT_EQ(
      fault_of(kHead + "facades,moved,window,1,2,3,4,5,6\n").rfind(":2: moved of facades needs two places, to_x1", 0),
      0u);
  EXPECT_EQ(fault_of(kHead + "facades,deleted,window,1,2,3,1,2,6\n").rfind(":2: the corners", 0), 0u);
  EXPECT_EQ(fault_of(kHead + "facades,split,window,1,2,3,4,5,6\n")
                .rfind(":2: \"facades\" has no edit \"split\"; there are: facades: added", 0),
            0u);
  EXPECT_EQ(fault_of(kHead + "facades,deleted,window,1,2,3,4,5,6,7\n").rfind(":2: has more fields", 0), 0u);
  EXPECT_EQ(fault_of(kHead + "facades,deleted,\"window,1,2,3,4,5,6\n"), ":2: a quote is not closed on its line");
  EXPECT_EQ(fault_of(std::string("PK\0\0", 4)), ": is no text; a table of edits is CSV");
}

}  // namespace
}  // namespace ilot
