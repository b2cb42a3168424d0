// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/drawings/facade_drawing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/deliverables/drawings/drawing_sheet.h"
#include "tests/support/facades.h"

namespace ilot {
namespace {

// Two rows of three windows 1 wide and 1.5 high, a door, a band.
Facade drawn_facade() {
  std::vector<FacadeElement> elements;
  for (const double z : {4.0, 7.0})
    for (const double x : {1.0, 4.0, 7.0}) {
      elements.push_back(drawn("window", wall_rectangle(x, z, x + 1, z + 1.5)));
      elements.back().width_m = 1;
      elements.back().height_m = 1.5;
    }
  elements.push_back(drawn("door", wall_rectangle(4, 0, 5.2, 2.5)));
  elements.push_back(drawn("band", wall_rectangle(0, 3.2, 9, 3.4)));
  elements.push_back(drawn("outline", wall_rectangle(0, 0, 9, 10)));
  return facade_of(elements);
}

std::map<std::string, int> texts_of(const Drawing& drawing, DrawingRole role) {
  std::map<std::string, int> texts;
  for (const DrawingText& text : drawing.texts)
    if (text.role == role) ++texts[text.text];
  return texts;
}

bool says(const Drawing& drawing, const std::string& words) {
  return std::any_of(drawing.texts.begin(), drawing.texts.end(),
                     [&](const DrawingText& text) { return text.text.find(words) != std::string::npos; });
}

// Room of a text that is not turned.
FlatBox box_of(const DrawingText& text) {
  const double width = text_width(text.text, text.height);
  const double x = text.x - (text.anchor == TextAnchor::left     ? 0
                             : text.anchor == TextAnchor::middle ? width / 2
                                                                 : width);
  return {x, text.y, x + width, text.y + text.height};
}

TEST(FacadeDrawing, NumbersLevelsAndChains) {
  const Drawing drawing = facade_drawing(drawn_facade());
  const auto numbers = texts_of(drawing, DrawingRole::number);
  for (const char* id : {"1", "2", "3", "4", "5", "6", "7", "8"}) EXPECT_EQ(numbers.count(id), 1u) << id;
  EXPECT_EQ(numbers.count("9"), 0u);  // the outline
  EXPECT_EQ(numbers.at("1.00 x 1.50"), 6);
  const auto levels = texts_of(drawing, DrawingRole::level);
  for (const char* z : {"0.00", "2.50", "3.20", "3.40", "4.00", "5.50", "7.00", "8.50", "10.00"})
    EXPECT_EQ(levels.count(z), 1u) << z;
  EXPECT_EQ(levels.size(), 9u);
  const auto sizes = texts_of(drawing, DrawingRole::dimension);
  EXPECT_EQ(sizes.at("9.00"), 1);  // all of it
  EXPECT_EQ(sizes.at("10.00"), 1);
  EXPECT_EQ(sizes.at("1.20"), 1);  // the door
  EXPECT_EQ(sizes.at("3.80"), 1);  // right of it
  EXPECT_EQ(sizes.at("2.00"), 2);  // between windows
}

TEST(FacadeDrawing, TextsDoNotOverlapAndStayOffLines) {
  Facade facade = drawn_facade();
  for (int i = 0; i < 40; ++i)
    facade.elements.push_back(drawn("stone", wall_rectangle(0.2 * i, 9, 0.2 * i + 0.2, 9.5)));
  for (std::uint32_t i = 0; i < facade.elements.size(); ++i) facade.elements[i].id = i + 1;
  const Drawing drawing = facade_drawing(facade);
  std::vector<FlatBox> boxes;
  for (const DrawingText& text : drawing.texts)
    if (text.rotation_deg == 0 && text.role != DrawingRole::title) boxes.push_back(box_of(text));
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t k = i + 1; k < boxes.size(); ++k) {
      const bool apart = boxes[i].max.x <= boxes[k].min.x || boxes[k].max.x <= boxes[i].min.x ||
                         boxes[i].max.y <= boxes[k].min.y || boxes[k].max.y <= boxes[i].min.y;
      EXPECT_TRUE(apart) << i << " " << k;
    }
}

TEST(FacadeDrawing, LevelsThatLieCloseAreSpreadAndLed) {
  Facade facade = facade_of({});
  for (int i = 0; i < 6; ++i)
    facade.elements.push_back(drawn("window", wall_rectangle(2 * i, 1 + 0.03 * i, 2 * i + 1, 2)));
  const Drawing drawing = facade_drawing(facade);
  std::vector<double> places;
  for (const DrawingText& text : drawing.texts)
    if (text.role == DrawingRole::level) places.push_back(text.y);
  ASSERT_EQ(places.size(), 7u);
  std::sort(places.begin(), places.end());
  for (std::size_t i = 0; i + 1 < places.size(); ++i) EXPECT_GE(places[i + 1] - places[i], 1.4 * drawing.paper_mm(1.8));
}

TEST(FacadeDrawing, TheTitleBlockNamesTheDrawing) {
  FacadeDrawingParams params;
  params.scale = 100;
  params.title = "12 rue de l'\xC3\x89glise";
  params.heights = "NGF-IGN69";
  params.data_date = "2026-05-01";
  params.source = "scan.laz";
  Facade facade = drawn_facade();
  facade.crs = "EPSG:2154";
  facade.elements[0].edges.assign(4, {DrawnStatus::seen, 9, 0.001, 0.004, 0});
  const Drawing drawing = facade_drawing(facade, params);
  for (const char* words :
       {"12 rue de l'", "Scale 1:100", "CRS: EPSG:2154", "Heights: NGF-IGN69", "Date of data: 2026-05-01",
        "95 % of edges within 4.0 mm", "Source: scan.laz", "90.00 deg from grid north"})
    EXPECT_TRUE(says(drawing, words)) << words;
  const Drawing bare = facade_drawing(drawn_facade());
  for (const char* words : {"Elevation", "CRS: not known", "Date of data: not known", "Accuracy: not known"})
    EXPECT_TRUE(says(bare, words)) << words;
}

TEST(FacadeDrawing, PaperIsAStandardSizeThatFitsEverything) {
  for (const double width : {1.0, 8.0, 14.0, 30.0, 70.0}) {
    const Drawing drawing = facade_drawing(facade_of({drawn("outline", wall_rectangle(0, 0, width, 5))}));
    const double mm_wide = drawing.sheet.width() / drawing.paper_mm(1),
                 mm_high = drawing.sheet.height() / drawing.paper_mm(1);
    if (width < 50) {
      EXPECT_NEAR(std::max(mm_wide, mm_high) / std::min(mm_wide, mm_high), std::sqrt(2.0), 0.01) << width;
    }
    const FlatBox box = extent_of(drawing);
    EXPECT_GE(box.min.x, drawing.sheet.min.x);
    EXPECT_GE(box.min.y, drawing.sheet.min.y);
    EXPECT_LE(box.max.x, drawing.sheet.max.x);
    EXPECT_LE(box.max.y, drawing.sheet.max.y);
  }
}

TEST(FacadeDrawing, PaperLiesOrStandsAsTheFacadeDoes) {
  const auto lies = [](double width, double height) {
    const Drawing drawing = facade_drawing(facade_of({drawn("outline", wall_rectangle(0, 0, width, height))}));
    return drawing.sheet.width() > drawing.sheet.height();
  };
  EXPECT_TRUE(lies(19, 14));
  EXPECT_TRUE(lies(22, 18));
  EXPECT_FALSE(lies(12, 20));
}

TEST(FacadeDrawing, LongTextsAreCutToTheirColumn) {
  Drawing drawing;
  add_fitting_text({DrawingRole::title, 0, 0, 1, 0, TextAnchor::left, std::string(200, 'x')}, 10, drawing);
  add_fitting_text({DrawingRole::title, 0, 0, 1, 0, TextAnchor::left, "0123456789abcde"}, 10, drawing);
  add_fitting_text({DrawingRole::title, 0, 0, 1, 0, TextAnchor::left, "ok"}, 10, drawing);
  for (const DrawingText& text : drawing.texts) EXPECT_LE(text_width(text.text, text.height), 10.001);
  EXPECT_TRUE(drawing.texts[0].text.ends_with("..."));
  EXPECT_EQ(drawing.texts[1].text, "0123456789abcde");
  EXPECT_LT(drawing.texts[1].height, 1);
  EXPECT_EQ(drawing.texts[2].height, 1);
}

TEST(FacadeDrawing, ElementsOfOneOutlineAreDrawnOnce) {
  Facade facade = facade_of({drawn("stone", wall_rectangle(0, 0, 1, 1)), drawn("stone", wall_rectangle(0, 0, 1, 1))});
  std::rotate(facade.elements[1].ring.begin(), facade.elements[1].ring.begin() + 1, facade.elements[1].ring.end());
  const Drawing drawing = facade_drawing(facade);
  EXPECT_EQ(std::count_if(drawing.lines.begin(), drawing.lines.end(),
                          [](const DrawingLine& line) { return line.role == DrawingRole::stone && !line.is_sample; }),
            1);
}

TEST(FacadeDrawing, AnEmptyFacadeIsAnEmptySheet) {
  const Drawing drawing = facade_drawing(facade_of({}));
  EXPECT_GT(drawing.sheet.width(), 0);
  EXPECT_TRUE(texts_of(drawing, DrawingRole::dimension).empty());
}

}  // namespace
}  // namespace ilot
