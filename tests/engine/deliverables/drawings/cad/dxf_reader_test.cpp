// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/drawings/cad/dxf_reader.h"

#include <gtest/gtest.h>

#include "engine/error.h"

namespace ilot {
namespace {

std::string entities(const std::string& groups) {
  return "0\nSECTION\n2\nENTITIES\n" + groups + "0\nENDSEC\n0\nEOF\n";
}

std::string dxf_fault(const std::string& text) {
  try {
    parse_dxf(text, "f.dxf");
  } catch (const Error& fault) {
    return fault.what();
  }
  return "none";
}

TEST(DxfReader, OldAndNewPolylines) {
  const DxfDrawing drawing = parse_dxf(entities("0\nLINE\n5\nA1\n8\nW\n10\n1\n20\n2\n30\n0\n11\n3\n21\n4\n31\n0\n"
                                                "0\nPOLYLINE\n8\nW\n66\n1\n10\n0\n20\n0\n30\n0\n70\n1\n0\nVERTEX\n8\nW"
                                                "\n10\n1\n20\n1\n42\n0.5\n0\nVERTEX\n8\nW\n"
                                                "10\n2\n20\n1\n0\nSEQEND\n8\nW\n"
                                                "0\nLWPOLYLINE\n8\nV 2\n90\n2\n70\n0\n10\n5\n20\n6\n10\n7\n20\n8\n"
                                                "0\nTEXT\n67\n1\n8\nW\n1\npaper\n"
                                                "0\nHATCH\n8\nW\n"),
                                       "f.dxf");
  ASSERT_EQ(drawing.entities.size(), 4u);
  EXPECT_EQ(drawing.entities[0].corners.at(1).y, 4);
  EXPECT_EQ(drawing.entities[0].handle, "A1");
  EXPECT_EQ(drawing.entities[0].line, 5u);
  EXPECT_TRUE(drawing.entities[1].closed);
  ASSERT_EQ(drawing.entities[1].corners.size(), 2u);
  EXPECT_EQ(drawing.entities[1].corners[0].bulge, 0.5);
  EXPECT_EQ(drawing.entities[2].layer, "V 2");
  EXPECT_EQ(drawing.entities[3].type, "HATCH");
}

TEST(DxfReader, HandlesOfReactorsAreNotTheEntitys) {
  const DxfDrawing drawing = parse_dxf(
      entities("0\nPOINT\n5\n2A\n102\n{ACAD_REACTORS\n330\nC\n5\nFF\n102\n}\n8\nL\n10\n1e1\n20\n+2\n"), "f.dxf");
  EXPECT_EQ(drawing.entities.at(0).handle, "2A");
  EXPECT_EQ(drawing.entities[0].corners.at(0).x, 10);
  EXPECT_EQ(drawing.entities[0].corners[0].y, 2);
}

TEST(DxfReader, NumbersThatAreNoneAreRemembered) {
  const DxfDrawing drawing =
      parse_dxf(entities("0\nPOINT\n10\nnan\n20\n1\n0\nPOINT\n10\n1,5\n20\n1\n0\nPOINT\n10\n1e999\n20\n1\n"), "f.dxf");
  for (const DxfEntity& e : drawing.entities) EXPECT_FALSE(e.finite);
}

TEST(DxfReader, WindowsLinesCommentsAndTrailingBlanks) {
  const DxfDrawing drawing = parse_dxf(
      "999\r\nby hand\r\n0\r\nSECTION\r\n2\r\nHEADER\r\n9\r\n$INSUNITS\r\n 70\r\n     "
      "4\r\n0\r\nENDSEC\r\n0\r\nEOF\r\n\r\n  ",
      "f.dxf");
  EXPECT_EQ(drawing.units, 4);
  EXPECT_TRUE(drawing.has_end);
}

TEST(DxfReader, FaultsNameTheLine) {
  EXPECT_NE(dxf_fault("AutoCAD Binary DXF\r\n\x1a").find("binary"), std::string::npos);
  EXPECT_NE(dxf_fault("0\nSECTION\n2\nENTITIES\nLINE\n").find("f.dxf:5: needs a group code"), std::string::npos);
  EXPECT_NE(dxf_fault("0\nSECTION\n2\nENTITIES\n0\n").find("f.dxf:5: the file ends within a pair"), std::string::npos);
  EXPECT_NE(dxf_fault("0\nSECTION\n2\nENTITIES\n0\nLINE\n8\nW\n").find("f.dxf:1: this section is not closed"),
            std::string::npos);
  EXPECT_NE(dxf_fault("0\nLINE\n").find("outside of a section"), std::string::npos);
  EXPECT_NE(dxf_fault("5\nLINE\n").find("needs the beginning of a section"), std::string::npos);
  EXPECT_NE(dxf_fault("0\nSECTION\n0\nENDSEC\n").find("without a name"), std::string::npos);
  EXPECT_EQ(dxf_fault(""), "none");
  EXPECT_THROW(read_dxf("/nowhere.dxf"), Error);
}

}  // namespace
}  // namespace ilot
