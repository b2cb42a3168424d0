// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/maps/street_book.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "engine/deliverables/drawings/pdf_file.h"
#include "engine/deliverables/drawings/pdf_text.h"
#include "engine/deliverables/maps/map_pdf.h"
#include "engine/deliverables/maps/map_sheets.h"
#include "engine/model/street_areas.h"
#include "engine/whole_file.h"

namespace ilot {
namespace {

// Millimetres on paper.
constexpr double kPaperWidth = 420, kPaperHeight = 297, kEdge = 10, kStrip = 66;
constexpr FlatBox kFrame{{kEdge, kEdge}, {kPaperWidth - kEdge - kStrip, kPaperHeight - kEdge}};
constexpr double kTitle = 4.5, kText = 2.2, kNumber = 1.6, kRow = 6, kLine = 4;  // heights of texts, rows and lines
constexpr double kSample = 4;                                                    // side of a legend's unit
constexpr double kGridOnPaper = 40, kCross = 2;  // least distance of crosses, half of their size
constexpr double kBarOnPaper = 45;               // greatest length of the bar
constexpr double kPixelOnPaper = 0.4;            // least pixel of the cover
constexpr double kBeside = 0.4;                  // between a small symbol and its number
constexpr double kAlong = 14;                    // from the side of the frame, beside coordinates

// What is on all pages of an area.
struct Book {
  StreetShapes map;
  std::vector<LegendRow> legend;
  std::span<const std::string> notes;
  double metres_per_unit;
};

struct Page {
  MapPlace place;
  FlatBox ground;  // metres on the map that the frame shows
  std::string title;
  std::string above = {};  // operators, above the shapes
  bool numbers = true;     // of objects
  CoverImage cover = {};
};

// By GroundCover.
constexpr std::array<std::array<std::uint8_t, 3>, kCovers> kPalette{
    {{255, 255, 255}, {246, 244, 239}, {226, 238, 221}, {205, 201, 194}}};

// The legend of the cover, as rows of the legend.
std::vector<LegendRow> cover_legend() {
  constexpr std::array<const char*, kCovers> kNames{"", "ground that was seen", "crowns", "buildings"};
  std::vector<LegendRow> rows;
  for (std::size_t i = 1; i < kCovers; ++i)
    rows.push_back({area_sample({kPalette[i][0], kPalette[i][1], kPalette[i][2]}), kNames[i]});
  return rows;
}

// An image of what the frame of a page shows, nothing seen yet.
CoverImage cover_of(const Page& page, Vec3 origin, double metres_per_unit, double least_pixel_m) {
  const double pixel = std::max(kPixelOnPaper * page.place.scale / 1000, least_pixel_m);
  const auto crs = [&](FlatPoint p) {
    return FlatPoint{origin.x + p.x / metres_per_unit, origin.y + p.y / metres_per_unit};
  };
  const auto count = [&](double metres) {
    return static_cast<std::uint32_t>(std::max(1.0, std::floor(metres / pixel)));
  };
  CoverImage image{
      {crs(page.ground.min), crs(page.ground.max)}, count(page.ground.width()), count(page.ground.height()), {}};
  image.pixels.assign(std::size_t{image.width} * image.height, GroundCover::unseen);
  return image;
}

// The multiples of the step, in CRS units, whose places on the map lie between the two, in metres.
std::vector<double> round_coordinates(double least, double most, double origin, double step, double metres_per_unit) {
  std::vector<double> all;
  for (double i = std::ceil((origin + least / metres_per_unit) / step); (i * step - origin) * metres_per_unit <= most;
       ++i)
    all.push_back(i * step);
  return all;
}

// Crosses at round coordinates, whose values stand along the left and the lower side of the frame.
std::string grid_pdf(const Book& book, const Page& page) {
  const double unit = book.metres_per_unit, step = round_up(kGridOnPaper * page.place.scale / 1000 / unit);
  const int decimals = step >= 1 ? 0 : static_cast<int>(std::ceil(-std::log10(step)));
  const Vec3 origin = book.map.origin;
  const auto at = [&](double x, double y) {
    return page.place.mm(FlatPoint{(x - origin.x) * unit, (y - origin.y) * unit});
  };
  const auto xs = round_coordinates(page.ground.min.x, page.ground.max.x, origin.x, step, unit);
  const auto ys = round_coordinates(page.ground.min.y, page.ground.max.y, origin.y, step, unit);
  std::string out = "0.55 0.55 0.55 RG 0.1 w [] 0 d\n";
  for (const double x : xs)
    for (const double y : ys) {
      const FlatPoint p = at(x, y);
      out += fmt::format("{0} {2} m {1} {2} l S {3} {4} m {3} {5} l S\n", decimal(p.x - kCross, 3),
                         decimal(p.x + kCross, 3), decimal(p.y, 3), decimal(p.x, 3), decimal(p.y - kCross, 3),
                         decimal(p.y + kCross, 3));
    }
  for (const double x : xs)
    out += text_pdf({{at(x, origin.y).x, kFrame.min.y + 1}, kNumber, TextAnchor::middle, true}, decimal(x, decimals));
  for (const double y : ys)
    out += text_pdf({{kFrame.min.x + 1, at(origin.x, y).y}, kNumber, TextAnchor::left, true}, decimal(y, decimals));
  return out;
}

// The lines of a text that is at most so wide, broken between words.
std::vector<std::string> broken(const std::string& text, double height, double widest) {
  std::vector<std::string> lines{""};
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
    if (lines.back().empty() || pdf_letters(longer).width * height / kCapitalOfHelvetica <= widest)
      lines.back() = longer;
    else
      lines.push_back(word);
  }
  return lines;
}

// The strip on the right: what the page is, the legend, notes, north, the bar.
std::string strip_pdf(const Book& book, const Page& page) {
  const double left = kFrame.max.x + 5, widest = kPaperWidth - kEdge - left;
  double y = kFrame.max.y - kTitle;
  std::string out = text_pdf({{left, y}, kTitle}, "Street map");
  for (const std::string& line : {page.title, fmt::format("1 : {:.0f} on A3, north is up", page.place.scale)})
    out += text_pdf({{left, y -= kRow}, kText}, line);
  y -= kRow;
  for (const LegendRow& row : book.legend) {
    y -= kRow;
    const MapPlace place{{0, 0}, {left + kSample, y + kText / 2}, 1000 / kSample};
    for (const MapShape& shape : row.sample) out += shape_pdf(shape, place);
    out += text_pdf({{left + 2.5 * kSample, y}, kText}, row.name);
  }
  y -= kRow;
  std::vector<std::string> notes{"Numbers are object_id, counts are of all sheets. Crosses are at round coordinates."};
  notes.insert(notes.end(), book.notes.begin(), book.notes.end());
  for (const std::string& note : notes)
    for (const std::string& line : broken(note, kText, widest)) out += text_pdf({{left, y -= kLine}, kText}, line);
  const double bar = round_down(kBarOnPaper * page.place.scale / 1000);
  out += fmt::format("0.1 0.1 0.1 RG 0.6 w [] 0 d {0} {1} m {2} {1} l S\n", decimal(left, 3),
                     decimal(kFrame.min.y + 1, 3), decimal(left + page.place.mm(bar), 3));
  out += text_pdf({{left, kFrame.min.y + 3}, kText}, fmt::format("{:g} m", bar));
  const double north = kPaperWidth - kEdge - 5;
  out += fmt::format("0.4 w {0} {1} m {0} {2} l {3} {4} m {0} {2} l {5} {4} l S\n", decimal(north, 3),
                     decimal(kFrame.min.y, 3), decimal(kFrame.min.y + 12, 3), decimal(north - 2, 3),
                     decimal(kFrame.min.y + 8, 3), decimal(north + 2, 3));
  return out + text_pdf({{north, kFrame.min.y + 13.5}, kText, TextAnchor::middle}, "N");
}

// The number of an object is in the middle of its symbol, or beside a symbol that it would hide.
std::string number_pdf(const MapNumber& number, const MapPlace& place) {
  const std::string id = std::to_string(number.id);
  const FlatPoint p = place.mm(number.place);
  const double reach = place.mm(number.reach);
  if (2 * reach >= kNumber) return text_pdf({{p.x, p.y - kNumber / 2}, kNumber, TextAnchor::middle, true}, id);
  return text_pdf({{p.x + reach + kBeside, p.y + kBeside}, kNumber, TextAnchor::left, true}, id);
}

// The cover below, what the frame shows of the map, what is above it, and the strip beside.
void add_page(const Book& book, const Page& page, PdfBook& pdf) {
  std::string inside;
  if (!page.cover.pixels.empty())
    inside +=
        fmt::format("q {} 0 0 {} {} {} cm /Image Do Q\n", kFrame.width(), kFrame.height(), kFrame.min.x, kFrame.min.y);
  for (const MapShape& shape : book.map.shapes)
    if (shape.box().grown(shape.width).overlaps(page.ground)) inside += shape_pdf(shape, page.place);
  inside += grid_pdf(book, page);
  for (const MapNumber& number : book.map.numbers)
    if (page.numbers && page.ground.contains(number.place)) inside += number_pdf(number, page.place);
  const std::string clip =
      fmt::format("q {} {} {} {} re W n\n", kFrame.min.x, kFrame.min.y, kFrame.width(), kFrame.height());
  PdfPage out{kPaperWidth, kPaperHeight,
              clip + inside + page.above + "Q\n" + frame_pdf(kFrame) + strip_pdf(book, page)};
  if (!page.cover.pixels.empty())
    out.image = PdfImage{page.cover.width,
                         page.cover.height,
                         kPalette,
                         {reinterpret_cast<const char*>(page.cover.pixels.data()), page.cover.pixels.size()}};
  pdf.add(out);
}

// The numbers of the sheets beside, at the middles of the sides of the frame.
std::string neighbours_pdf(const SheetGrid& grid, std::size_t sheet) {
  const FlatPoint middle = kFrame.middle();
  struct Side {
    int column, row;
    PageText text;
  };
  const std::array<Side, 4> sides{{{-1, 0, {{kFrame.min.x + kAlong, middle.y}, kText, TextAnchor::left, true}},
                                   {1, 0, {{kFrame.max.x - 1.5, middle.y}, kText, TextAnchor::right, true}},
                                   {0, -1, {{middle.x, kFrame.min.y + kAlong / 3}, kText, TextAnchor::middle, true}},
                                   {0, 1, {{middle.x, kFrame.max.y - 4}, kText, TextAnchor::middle, true}}}};
  std::string out;
  for (const Side& side : sides)
    if (const std::size_t number = grid.number_beside(sheet, side.column, side.row); number > 0)
      out += text_pdf(side.text, fmt::format("sheet {}", number));
  return out;
}

// Where the sheets lie, on the overview.
std::string index_pdf(const SheetGrid& grid, const MapPlace& place) {
  std::string out;
  for (std::size_t i = 0; i < grid.sheets.size(); ++i) {
    const FlatBox ground = grid.ground(i);
    out += frame_pdf({place.mm(ground.min), place.mm(ground.max)});
    const FlatPoint corner = place.mm(FlatPoint{ground.min.x, ground.max.y});
    out += text_pdf({{corner.x + 1, corner.y - 1 - kText}, kText, TextAnchor::left, true}, std::to_string(i + 1));
  }
  return out;
}

// The place of the ground around a middle, at the middle of the frame.
Page page_around(FlatPoint middle, double scale, const std::string& title) {
  const double x = kFrame.width() * scale / 2000, y = kFrame.height() * scale / 2000;
  const FlatBox ground{{middle.x - x, middle.y - y}, {middle.x + x, middle.y + y}};
  return {{ground.min, kFrame.min, scale}, ground, title};
}

// The pages of an area: its overview, and its sheets.
std::vector<Page> pages_of(const StreetShapes& map, const std::string& area) {
  const SheetGrid grid = sheets_of(map, {kFrame.width(), kFrame.height()});
  const std::size_t count = grid.sheets.size();
  std::vector<Page> pages;
  if (count > 1) {
    const double least = 1000 * std::max(map.box.width() / kFrame.width(), map.box.height() / kFrame.height());
    Page page = page_around(map.box.middle(), round_up(least), fmt::format("{}Overview of {} sheets", area, count));
    page.above = index_pdf(grid, page.place);
    page.numbers = false;
    pages.push_back(std::move(page));
  }
  for (std::size_t i = 0; i < count; ++i) {
    Page page = page_around(grid.ground(i).middle(), grid.scale, fmt::format("{}Sheet {} of {}", area, i + 1, count));
    page.above = neighbours_pdf(grid, i);
    pages.push_back(std::move(page));
  }
  return pages;
}

void add_cover(const CoverSource& cover, const Book& book, std::vector<Page>& pages) {
  std::vector<CoverImage> images;
  for (const Page& page : pages) images.push_back(cover_of(page, book.map.origin, book.metres_per_unit, cover.pixel_m));
  cover.paint(images);
  for (std::size_t i = 0; i < pages.size(); ++i) pages[i].cover = std::move(images[i]);
}

void add_area(const Book& book, const CoverSource& cover, const std::string& area, PdfBook& pdf) {
  std::vector<Page> pages = pages_of(book.map, area);
  if (cover.paint) add_cover(cover, book, pages);
  for (const Page& page : pages) add_page(book, page, pdf);
}

}  // namespace

std::string street_book_pdf(const StreetPlan& plan, double metres_per_unit, std::span<const std::string> notes,
                            const CoverSource& cover) {
  const std::vector<StreetPlan> areas = street_areas(plan, metres_per_unit);
  PdfBook pdf;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    Book book{street_shapes(areas[i], metres_per_unit), street_legend(areas[i]), notes, metres_per_unit};
    if (cover.paint) std::ranges::copy(cover_legend(), std::back_inserter(book.legend));
    add_area(book, cover, areas.size() == 1 ? "" : fmt::format("Area {}. ", i + 1), pdf);
  }
  return std::move(pdf).file("Street map");
}

void write_street_book(const std::filesystem::path& folder, const StreetPlan& plan, double metres_per_unit,
                       std::span<const std::string> notes, const CoverSource& cover) {
  write_whole_file(folder / "streets.pdf", street_book_pdf(plan, metres_per_unit, notes, cover));
}

}  // namespace ilot
