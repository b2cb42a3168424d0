// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/maps/street_book.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include "engine/deliverables/maps/map_sheets.h"
#include "engine/products/streets/make_streets.h"
#include "engine/products/streets/street_cover.h"
#include "tests/engine/products/streets/street_runs.h"

namespace ilot {
namespace {

constexpr FlatPoint kFrame{334, 277};  // millimetres, as in street_book.cpp

// The texts of a book: its file with all streams unpacked.
std::string unpacked(const std::string& book) {
  std::string out;
  for (std::size_t at = 0; at < book.size();) {
    const std::size_t begin = book.find(">>\nstream\n", at);
    if (begin == std::string::npos) return out + book.substr(at);
    out += book.substr(at, begin - at);
    std::string data(std::size_t{1} << 22, ' ');
    uLongf size = data.size();
    const std::size_t length = std::stoul(book.substr(book.rfind("/Length ", begin) + 8));
    EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(data.data()), &size,
                         reinterpret_cast<const Bytef*>(book.data() + begin + 10), length),
              Z_OK);
    out += data.substr(0, size);
    at = begin + 10 + length;
  }
  return out;
}

StreetObject car_at(double x, double y, std::uint32_t id) {
  StreetObject car;
  car.id = id, car.label = PointLabel::car, car.class_name = "car", car.middle = {x, y, 0};
  car.length_m = 4, car.width_m = 2;
  return car;
}

// A kerb across the plan and cars along it.
StreetPlan long_street(double length) {
  StreetPlan plan;
  StreetKerb kerb;
  kerb.id = 1, kerb.line = {{650000, 6860000, 0}, {650000 + length, 6860000 + length / 3, 0}};
  plan.kerbs = {kerb};
  for (std::uint32_t i = 0; i < 20; ++i)
    plan.objects.push_back(car_at(650000 + length * i / 20, 6860000 + length * i / 60, i + 1));
  return plan;
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(MapSheets, RoundNumbers) {
  EXPECT_EQ(round_up(1), 1);
  EXPECT_EQ(round_up(1.01), 2);
  EXPECT_EQ(round_up(300), 500);
  EXPECT_EQ(round_up(501), 1000);
  EXPECT_DOUBLE_EQ(round_up(0.3), 0.5);
  EXPECT_EQ(round_down(19), 10);
  EXPECT_EQ(round_down(20), 20);
  EXPECT_EQ(round_down(99), 50);
  EXPECT_EQ(round_up(0), 1);
}

TEST(MapSheets, EverythingIsOnASheetAndEachSheetShowsSomething) {
  for (const double length : {30.0, 400.0, 3000.0, 40000.0}) {
    StreetPlan plan = long_street(length);
    plan.objects.clear();
    const StreetShapes map = street_shapes(plan, 1);
    const SheetGrid grid = sheets_of(map, kFrame);
    ASSERT_LE(grid.sheets.size(), 40u) << length;
    std::vector<std::size_t> shown(grid.sheets.size(), 0);
    for (int i = 0; i <= 100000; ++i) {
      const FlatPoint p{length * i / 100000, length * i / 300000};
      std::size_t found = 0;
      for (std::size_t s = 0; s < grid.sheets.size(); ++s) {
        found += grid.ground(s).contains(p);
        shown[s] += grid.ground(s).grown(length / 1000).contains(p);  // a corner may be touched between two places
      }
      ASSERT_GE(found, 1u) << length << " at " << p.x;
    }
    EXPECT_EQ(grid.sheets.size() == 1, length == 30) << length;
    for (std::size_t s = 0; s < grid.sheets.size(); ++s) EXPECT_GT(shown[s], 0u) << length << ": sheet " << s;
  }
  EXPECT_EQ(sheets_of({}, kFrame).sheets.size(), 1u);
}

TEST(MapSheets, NeighboursHaveTheirNumbers) {
  const SheetGrid grid = sheets_of(street_shapes(long_street(400), 1), kFrame);
  for (std::size_t s = 0; s < grid.sheets.size(); ++s)
    for (const int column : {-1, 1})
      if (const std::size_t beside = grid.number_beside(s, column, 0); beside > 0) {
        EXPECT_EQ(grid.number_beside(beside - 1, -column, 0), s + 1);
        EXPECT_NEAR(grid.ground(beside - 1).min.x, grid.ground(s).min.x + column * grid.size.x, 1e-6);
      }
}

TEST(StreetBook, PagesAndWhatTheySay) {
  const std::string one = unpacked(street_book_pdf(long_street(30), 1));
  EXPECT_TRUE(one.starts_with("%PDF-1.5\n"));
  EXPECT_NE(one.find("/Count 1>>"), std::string::npos) << "no overview of one sheet";
  const StreetPlan plan = long_street(400);
  const std::size_t sheets = sheets_of(street_shapes(plan, 1), kFrame).sheets.size();
  const std::string file = street_book_pdf(plan, 1, std::vector<std::string>{"A note."}), book = unpacked(file);
  EXPECT_NE(book.find("/Count " + std::to_string(sheets + 1) + ">>"), std::string::npos);
  for (const char* text : {"(Overview of", "(Sheet 1 of", "(sheet 2)", "(A note.)", "(1 : 250 on A3, north is up)",
                           "(car \\(20\\))", "(650100)", "(6860050)"})
    EXPECT_NE(book.find(text), std::string::npos) << text;
  EXPECT_GE(count_of(book, "(20) Tj"), 2u) << "the number of the last car, its halo and itself";
  EXPECT_EQ(file, street_book_pdf(plan, 1, std::vector<std::string>{"A note."}));
}

// In feet the plan is as large on paper, and the crosses are at round feet.
TEST(StreetBook, FeetAreFeet) {
  constexpr double kFoot = 0.3048;
  StreetPlan plan;
  plan.objects = {car_at(1000, 1000, 1), car_at(1000 + 60 / kFoot, 1000, 2)};
  const std::string book = unpacked(street_book_pdf(plan, kFoot));
  EXPECT_NE(book.find("/Count 1>>"), std::string::npos);
  EXPECT_NE(book.find("(1150)"), std::string::npos) << "crosses are 50 feet apart";
}

TEST(StreetBook, AreasFarApartHaveSheetsOfTheirOwn) {
  StreetPlan plan;
  plan.objects = {car_at(0, 0, 1), car_at(400000, 0, 2)};
  const std::string book = unpacked(street_book_pdf(plan, 1));
  EXPECT_NE(book.find("/Count 2>>"), std::string::npos);
  EXPECT_NE(book.find("(Area 2. Sheet 1 of 1)"), std::string::npos);
  EXPECT_NE(street_book_pdf({}, 1).find("/Count 1>>"), std::string::npos) << "an empty plan";
}

TEST(StreetBook, PlacesInTheFileAreRight) {
  const std::string book = street_book_pdf(long_street(400), 1);
  const std::size_t begin = book.rfind("startxref\n");
  std::size_t at = std::stoul(book.substr(begin + 10));
  ASSERT_EQ(book.substr(at, 5), "xref\n");
  at = book.find('\n', book.find('\n', at) + 1) + 1;
  for (int object = 0; book[at] != 't'; ++object, at += 20)
    if (object > 0) {
      EXPECT_EQ(book.substr(std::stoul(book.substr(at, 10))).find(std::to_string(object) + " 0 obj"), 0u) << object;
    }
}

// The street of the tests: walls on both sides, ground between them. The image is 24 by 12 pixels of a metre.
TEST(StreetBook, TheCoverShowsGroundAndBuildings) {
  const test::CloudStore store(test::street_points(2, 3));
  const FoundStreet street = find_street(store.store(), {}, {});
  CoverImage image{
      {{700000, 660000}, {700024, 660012}}, 24, 12, std::vector<GroundCover>(24 * 12, GroundCover::unseen)};
  const CoverSource source = street_cover(*street.tiles);
  EXPECT_LE(source.pixel_m, 1);
  source.paint({&image, 1});
  for (std::size_t x = 0; x < 24; ++x) {
    EXPECT_EQ(image.pixels[x], GroundCover::building) << x << ": the north wall is the first row";
    EXPECT_EQ(image.pixels[11 * 24 + x], GroundCover::building) << x;
    EXPECT_EQ(image.pixels[2 * 24 + x], GroundCover::ground) << x;
  }
}

TEST(StreetBook, ARunWritesIt) {
  const TemporaryFolder folder;
  const test::StreetsOutcome out = test::run_cloud(folder, test::street_points(2, 3), "out");
  const std::string book = unpacked(test::file_bytes(out.out / "streets" / "streets.pdf"));
  EXPECT_NE(book.find("/Subtype /Image"), std::string::npos);
  EXPECT_NE(book.find("(ground that was seen)"), std::string::npos);
}

}  // namespace
}  // namespace ilot
