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
  for (const DrawingText& text : flattened(drawing).texts)
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

// The foot of the wall and a door sill, two centimetres apart, and three heads within as much.
TEST(FacadeDrawing, ALevelIsThatOfSomething) {
  std::vector<FacadeElement> elements{
      drawn("outline", wall_rectangle(0, 0.011, 9, 10)), drawn("door", wall_rectangle(1, 0.029, 2, 2.484)),
      drawn("window", wall_rectangle(3, 1, 4, 2.5)), drawn("window", wall_rectangle(5, 1, 6, 2.5))};
  const auto levels = texts_of(facade_drawing(facade_of(elements)), DrawingRole::level);
  for (const char* z : {"0.01", "1.00", "2.50", "10.00"}) EXPECT_EQ(levels.count(z), 1u) << z;
  EXPECT_EQ(levels.size(), 4u);
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

// What lies beside the wall has no part in its sizes; a storey that stands back above it has, and its top has a level.
TEST(FacadeDrawing, OverallSizesAreThoseOfWalls) {
  std::vector<FacadeElement> elements{
      drawn("outline", wall_rectangle(0, 0, 9, 10)), drawn("window", wall_rectangle(1, 1, 2, 2.5)),
      drawn("possible opening", wall_rectangle(8, 1, 9.07, 2)), drawn("balcony", wall_rectangle(-0.4, 4, 2, 4.5)),
      drawn("recess", wall_rectangle(3, 10.03, 6, 12.5))};
  elements[2].status = DrawnStatus::occluded;
  const Drawing drawing = facade_drawing(facade_of(elements));
  const auto sizes = texts_of(drawing, DrawingRole::dimension);
  EXPECT_EQ(sizes.count("9.00"), 1u);
  EXPECT_EQ(sizes.count("12.50"), 1u);
  EXPECT_EQ(texts_of(drawing, DrawingRole::level).count("12.50"), 1u);
  EXPECT_EQ(texts_of(drawing, DrawingRole::level).count("10.03"), 0u) << "it begins at the top of the wall";
}

// Heights that are written alike are one level, however they lie in groups of half a millimetre on paper.
TEST(FacadeDrawing, NoLevelIsWrittenTwice) {
  std::vector<FacadeElement> elements{drawn("outline", wall_rectangle(0, 0, 20, 12))};
  const double tops[] = {8.2863, 8.3042, 8.3053, 8.3062, 8.3124, 8.3172};
  for (int i = 0; i < 6; ++i) elements.push_back(drawn("window", wall_rectangle(3 * i + 1, 7, 3 * i + 2, tops[i])));
  for (const auto& [words, times] : texts_of(facade_drawing(facade_of(elements)), DrawingRole::level))
    EXPECT_EQ(times, 1) << words;
}

// What each dimension says is what it measures.
TEST(FacadeDrawing, DimensionsMeasureWhatTheySay) {
  const Drawing drawing = facade_drawing(drawn_facade());
  ASSERT_FALSE(drawing.dimensions.empty());
  for (const DrawingDimension& d : drawing.dimensions)
    EXPECT_NEAR(std::stod(d.text.text), d.upright ? d.to.y - d.from.y : d.to.x - d.from.x, 0.005 + 1e-9);
}

TEST(FacadeDrawing, OpeningsAreBlocksWithASchedule) {
  Facade facade = drawn_facade();
  facade.elements[0].edges.assign(4, {});
  facade.elements[0].edges[2].error_m = 0.0042;
  const Drawing drawing = facade_drawing(facade);
  ASSERT_EQ(drawing.blocks.size(), 7u);
  std::map<std::string, std::string> schedule;
  for (const DrawingAttribute& a : drawing.blocks[0].attributes) schedule[a.tag] = a.value;
  EXPECT_EQ(schedule["ID"], "1");
  EXPECT_EQ(schedule["KIND"], "window");
  EXPECT_EQ(schedule["WIDTH"], "1.000");
  EXPECT_EQ(schedule["SILL"], "4.000");
  EXPECT_EQ(schedule["HEAD"], "5.500");
  EXPECT_EQ(schedule["ERROR"], "4.2");
}

std::size_t lines_of(const Drawing& drawing, DrawingRole role) {
  const Drawing flat = flattened(drawing);
  return static_cast<std::size_t>(
      std::count_if(flat.lines.begin(), flat.lines.end(), [&](const DrawingLine& l) { return l.role == role; }));
}

TEST(FacadeDrawing, ABalconyHidesTheWindowBehindIt) {
  FacadeElement balcony = drawn("balcony", wall_rectangle(0.5, 3.8, 2.5, 4.6));
  balcony.depth_m = 0.8;
  const FacadeElement window = drawn("window", wall_rectangle(1, 4, 2, 6));
  const Drawing drawing = facade_drawing(facade_of({window, balcony}));
  const Drawing flat = flattened(drawing);
  double hidden = 0, open = 0;
  for (const DrawingLine& line : flat.lines)
    for (std::size_t i = 0; i + 1 < line.corners.size() + line.closed; ++i) {
      const DrawingCorner &a = line.corners[i], &b = line.corners[(i + 1) % line.corners.size()];
      if (line.is_sample) continue;
      (line.role == DrawingRole::hidden    ? hidden
       : line.role == DrawingRole::opening ? open
                                           : balcony.depth_m) += std::abs(a.x - b.x) + std::abs(a.y - b.y);
    }
  EXPECT_NEAR(hidden, 1 + 2 * 0.6, 1e-6);  // its foot and what is below 4.6 of its jambs
  EXPECT_NEAR(open, 1 + 2 * 1.4, 1e-6);
  // A sill is no obstacle to the sight of an opening, and what is thinner than 2 cm hides nothing.
  balcony.depth_m = 0.01;
  EXPECT_EQ(lines_of(facade_drawing(facade_of({window, balcony})), DrawingRole::hidden), 0u);
  FacadeElement sill = drawn("sill", wall_rectangle(0.5, 3.8, 2.5, 4.6));
  sill.depth_m = 0.2;
  EXPECT_EQ(lines_of(facade_drawing(facade_of({window, sill})), DrawingRole::hidden), 0u);
}

TEST(FacadeDrawing, ABandEndsAtTheOpeningsItRunsAcross) {
  FacadeElement band = drawn("band", wall_rectangle(0, 4.4, 9, 4.6));
  band.depth_m = 0.05;
  const Drawing drawing = facade_drawing(facade_of({drawn("window", wall_rectangle(1, 4, 2, 6)), band}));
  EXPECT_EQ(lines_of(drawing, DrawingRole::hidden), 2u + 1u);  // and its sample in the legend
  for (const DrawingLine& line : drawing.lines) {
    if (line.role == DrawingRole::hidden && !line.is_sample) {
      EXPECT_NEAR(std::abs(line.corners.back().x - line.corners.front().x), 1, 1e-6);
    }
  }
}

TEST(FacadeDrawing, TheGroundIsDrawnWhereTheFootWasSeen) {
  Facade facade = facade_of({drawn("outline", wall_rectangle(0, 0, 9, 10))});
  const auto grounds = [&] { return lines_of(facade_drawing(facade), DrawingRole::ground); };
  EXPECT_EQ(grounds(), 2u);  // and its sample in the legend
  facade.elements[0].edges.assign(4, {});
  facade.elements[0].edges[0].status = DrawnStatus::completed;
  EXPECT_EQ(grounds(), 0u);
}

TEST(FacadeDrawing, SectionsAreMarkedWhereTheyCut) {
  FacadeDrawingParams params;
  params.sections.levels = {4.5};
  params.sections.uprights = {3};
  const Drawing drawing = facade_drawing(drawn_facade(), params);
  EXPECT_EQ(lines_of(drawing, DrawingRole::mark), 2u * 2u * 2u);
  EXPECT_EQ(texts_of(drawing, DrawingRole::mark).size(), 2u);
  bool upright = false, level = false;
  for (const DrawingLine& line : drawing.lines) {
    if (line.role != DrawingRole::mark || line.corners.size() != 3) continue;
    upright |= line.corners[0].x == 3 && line.corners[1].x == 3;
    level |= line.corners[0].y == 4.5 && line.corners[1].y == 4.5;
  }
  EXPECT_TRUE(upright && level);
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
        "95 % of seen edges within 4.0 mm", "Source: scan.laz", "90.00 deg from grid north"})
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
