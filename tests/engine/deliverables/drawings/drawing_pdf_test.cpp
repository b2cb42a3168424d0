// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/drawings/drawing_pdf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace ilot {
namespace {

Drawing paper_drawing() {
  Drawing drawing;
  drawing.title =
      "Fa\xC3\xA7"
      "ade (1)";
  drawing.sheet = {0, 0, 10.5, 14.85};  // A4 at 1:50
  drawing.lines.push_back({DrawingRole::opening, {{0, 0, 0}, {2, 0, 0}, {2, 3, 1}, {0, 3, 0}}, true});
  drawing.lines.push_back({DrawingRole::error, {{0, 0, 0}, {1, 1, 0}}, false});
  drawing.arcs.push_back({DrawingRole::detail, 5, 5, 1, 0, 360});
  drawing.points.push_back({DrawingRole::section_points, 7, 7});
  drawing.texts.push_back(
      {DrawingRole::number, 1, 1, 0.125, 90, TextAnchor::middle, "12 \\ (a) \xE2\x82\xAC \xE6\xBC\xA2"});
  return drawing;
}

TEST(DrawingPdf, ItsTableSaysWhereObjectsBegin) {
  const std::string pdf = drawing_pdf(paper_drawing(), preset_layers("ilot"));
  const std::size_t table = std::strtoull(pdf.c_str() + pdf.rfind("startxref\n") + 10, nullptr, 10);
  ASSERT_EQ(pdf.compare(table, 7, "xref\n0 "), 0);
  const std::size_t count = std::strtoull(pdf.c_str() + table + 7, nullptr, 10);
  const std::size_t rows = pdf.find('\n', table + 7) + 1;
  ASSERT_EQ(count, 7 + 5u);  // the free one, six of the file, a layer for each role in use
  for (std::size_t i = 1; i < count; ++i) {
    const std::size_t begin = std::strtoull(pdf.c_str() + rows + 20 * i, nullptr, 10);
    const std::string head = std::to_string(i) + " 0 obj\n";
    EXPECT_EQ(pdf.compare(begin, head.size(), head), 0) << i;
  }
  const std::size_t length = std::strtoull(pdf.c_str() + pdf.find("/Length ") + 8, nullptr, 10);
  EXPECT_EQ(pdf.find("endstream"), pdf.find("stream\n") + 7 + length);
  EXPECT_TRUE(pdf.ends_with("%%EOF\n"));
}

TEST(DrawingPdf, IsToScaleWithItsLayers) {
  const std::string pdf = drawing_pdf(paper_drawing(), preset_layers("aia"));
  EXPECT_NE(pdf.find("/MediaBox [0 0 595.276 841.890]"), std::string::npos);
  EXPECT_NE(pdf.find("/Name (A-ELEV-OPNG)"), std::string::npos);
  EXPECT_NE(pdf.find("/OFF [9 0 R ]"), std::string::npos);  // opening, detail, error
  EXPECT_NE(pdf.find("0.000 0.000 m\n40.000 0.000 l\n40.000 60.000 l\n"), std::string::npos);
  EXPECT_NE(pdf.find("(12 \\\\ \\(a\\) \\200 ?) Tj"), std::string::npos);
  EXPECT_NE(pdf.find("/Title (Fa\\347ade \\(1\\))"), std::string::npos);
}

// Points of every curve lie on the circle.
TEST(DrawingPdf, CurvesFollowTheirArcs) {
  Drawing drawing;
  drawing.sheet = {0, 0, 10, 10};
  drawing.scale = 1000;  // a millimetre is a metre
  drawing.lines.push_back({DrawingRole::opening, {{7, 3, 1}, {3, 3, 0}}, false});
  const std::string pdf = drawing_pdf(drawing, preset_layers("ilot"));
  double x = 7, y = 3;
  int curves = 0;
  for (std::size_t end = pdf.find(" c\n"); end != std::string::npos; end = pdf.find(" c\n", end + 1), ++curves) {
    double v[6];
    const char* at = pdf.c_str() + pdf.rfind('\n', end) + 1;
    for (double& number : v) {
      char* next = nullptr;
      number = std::strtod(at, &next);
      at = next;
    }
    for (double t = 0; t <= 1; t += 0.125) {
      const double a = (1 - t) * (1 - t) * (1 - t), b = 3 * t * (1 - t) * (1 - t), c = 3 * t * t * (1 - t),
                   d = t * t * t;
      const double px = a * x + b * v[0] + c * v[2] + d * v[4], py = a * y + b * v[1] + c * v[3] + d * v[5];
      EXPECT_NEAR(std::hypot(px - 5, py - 3), 2, 2e-3);
      EXPECT_GE(py, 3 - 1e-3);
    }
    x = v[4], y = v[5];
  }
  EXPECT_EQ(curves, 4);
  EXPECT_NEAR(x, 3, 1e-9);
}

}  // namespace
}  // namespace ilot
