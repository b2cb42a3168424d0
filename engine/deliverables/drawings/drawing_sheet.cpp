// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/drawings/drawing_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "kernels/core/portable_math.h"

namespace ilot {
namespace {

// Millimetres on paper.
constexpr double kMargin = 10, kGap = 6, kBlockWidth = 190, kBlockHeight = 40, kTitle = 3.5, kPlain = 1.8, kLine = 3.4;
constexpr std::array<std::array<double, 2>, 5> kSizes{{{210, 297}, {297, 420}, {420, 594}, {594, 841}, {841, 1189}}};
constexpr double kLeastShare = 0.7;

struct Paper {
  double width = 0, height = 0;
};

// Returns the smallest paper that has room for this size in millimetres inside its margins. It is portrait or
// landscape, whichever leaves the greater smallest margin.
Paper paper_for(double width, double height) {
  width += 2 * kMargin, height += 2 * kMargin;
  const auto room = [&](const Paper& paper) { return std::min(paper.width - width, paper.height - height); };
  for (const auto& [shorter, longer] : kSizes) {
    const Paper upright{shorter, longer}, lying{longer, shorter};
    const Paper& better = room(lying) > room(upright) ? lying : upright;
    if (room(better) >= 0) return better;
  }
  return {std::ceil(width / 10) * 10, std::ceil(height / 10) * 10};
}

// Draws in millimetres from a corner of the paper.
class PaperPen {
 public:
  PaperPen(Drawing& drawing, double x0, double y0) : drawing_(drawing), x0_(x0), y0_(y0) {}
  double x(double mm) const { return x0_ + drawing_.paper_mm(mm); }
  double y(double mm) const { return y0_ + drawing_.paper_mm(mm); }
  void line(double ax, double ay, double bx, double by, DrawingRole role) {
    drawing_.lines.push_back({role, {{x(ax), y(ay)}, {x(bx), y(by)}}, false});
  }
  void sample(double ax, double ay, double length, DrawingRole role) {
    line(ax, ay, ax + length, ay, role);
    drawing_.lines.back().is_sample = true;
  }
  void box(double ax, double ay, double bx, double by, DrawingRole role) {
    drawing_.lines.push_back({role, {{x(ax), y(ay)}, {x(bx), y(ay)}, {x(bx), y(by)}, {x(ax), y(by)}}, true});
  }
  void circle(double ax, double ay, double radius, DrawingRole role) {
    drawing_.lines.push_back({role, {{x(ax - radius), y(ay), 1}, {x(ax + radius), y(ay), 1}}, true});
  }
  void text(double ax, double ay, double height, double room, const std::string& words,
            TextAnchor anchor = TextAnchor::left) {
    add_fitting_text({DrawingRole::title, x(ax), y(ay), drawing_.paper_mm(height), 0, anchor, words},
                     drawing_.paper_mm(room), drawing_);
  }

 private:
  Drawing& drawing_;
  double x0_, y0_;
};

// Returns the longest of 1, 2, 5, 10... metres whose length on paper is at most most_mm.
double bar_metres(const Drawing& drawing, double most_mm) {
  double metres = 0.01;
  for (int i = 0;; ++i) {
    const double next = metres * (i % 3 == 1 ? 2.5 : 2);
    if (next > drawing.paper_mm(most_mm)) return metres;
    metres = next;
  }
}

std::string short_number(double value, bool comma) {
  std::string text = decimal(value, 2);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  if (comma) std::replace(text.begin(), text.end(), '.', ',');
  return text;
}

// Draws five pieces; the first, third and fifth have a line along their middle.
void scale_bar(PaperPen& pen, const Drawing& drawing, double x, double y, double most_mm) {
  const double metres = bar_metres(drawing, most_mm), mm = metres / drawing.paper_mm(1);
  pen.box(x, y, x + mm, y + 1.2, DrawingRole::title);
  for (int i = 0; i < 5; ++i) {
    const double from = x + mm * i / 5, to = x + mm * (i + 1) / 5;
    if (i > 0) pen.line(from, y, from, y + 1.2, DrawingRole::title);
    if (i % 2 == 0) pen.line(from, y + 0.6, to, y + 0.6, DrawingRole::title);
  }
  pen.text(x, y + 1.9, kPlain, 10, "0");
  pen.text(x + mm, y + 1.9, kPlain, 20, short_number(metres, drawing.decimal_comma) + " m", TextAnchor::middle);
}

// An arrow to grid north in a circle. The line across it is the plane of the drawing, which is seen from below.
void north_arrow(PaperPen& pen, double x, double y, double north_deg) {
  constexpr double kRadius = 4.5, kHead = 1.4;
  const auto at = [&](double along, double aside) {
    const double c = cos_degrees(north_deg), s = cos_degrees(north_deg - 90);
    return FlatPoint{x + along * c - aside * s, y + along * s + aside * c};
  };
  const FlatPoint tail = at(-kRadius, 0), head = at(kRadius, 0), left = at(kRadius - 2 * kHead, kHead),
                  right = at(kRadius - 2 * kHead, -kHead), letter = at(kRadius + 1.6, 0);
  pen.circle(x, y, kRadius, DrawingRole::title);
  pen.line(x - kRadius, y, x + kRadius, y, DrawingRole::title);
  pen.line(tail.x, tail.y, head.x, head.y, DrawingRole::title);
  pen.line(left.x, left.y, head.x, head.y, DrawingRole::title);
  pen.line(right.x, right.y, head.x, head.y, DrawingRole::title);
  pen.text(letter.x, letter.y - kPlain / 2, kPlain, 5, "N", TextAnchor::middle);
}

void title_block(PaperPen& pen, const SheetText& text, const Drawing& drawing, double x, double y) {
  constexpr double kFirst = 76, kSecond = 148, kPad = 2;
  pen.box(x, y, x + kBlockWidth, y + kBlockHeight, DrawingRole::frame);
  for (const double column : {kFirst, kSecond})
    pen.line(x + column, y, x + column, y + kBlockHeight, DrawingRole::frame);
  const double top = y + kBlockHeight;
  constexpr double kArrow = 14;  // room of the arrow to north
  const double room = kFirst - 2 * kPad - (text.north_deg ? kArrow : 0);
  if (text.north_deg) north_arrow(pen, x + kFirst - kArrow / 2 - 1, top - 12, *text.north_deg);
  pen.text(x + kPad, top - 6.5, kTitle, room, text.title);
  double line = top - 12;
  for (const std::string& words : text.subject) {
    pen.text(x + kPad, line, 2.5, room, words);
    line -= 4.6;
  }
  scale_bar(pen, drawing, x + kPad, y + 3, kFirst - 4 * kPad);
  line = top - 4.5;
  for (const std::string& words : text.reference) {
    pen.text(x + kFirst + kPad, line, kPlain, kSecond - kFirst - 2 * kPad, words);
    line -= kLine;
  }
  line = top - 4.5;
  for (const auto& [role, words] : text.legend) {
    pen.sample(x + kSecond + kPad, line + kPlain / 2, 8, role);
    pen.text(x + kSecond + kPad + 10, line, kPlain, kBlockWidth - kSecond - 2 * kPad - 10, words);
    line -= kLine;
  }
}

}  // namespace

void add_fitting_text(DrawingText text, double room, Drawing& drawing) {
  const double width = text_width(text.text, text.height);
  if (width > room) text.height *= std::max(kLeastShare, room / width);
  if (text_width(text.text, text.height) > room * 1.0001) {
    std::string kept;
    std::vector<std::string> letters;
    const std::string clean = clean_text(text.text);
    for (const char c : clean) {
      if ((static_cast<unsigned char>(c) & 0xC0u) == 0x80 && !letters.empty())
        letters.back() += c;
      else
        letters.emplace_back(1, c);
    }
    for (const std::string& letter : letters) {
      if (text_width(kept + letter + "...", text.height) > room) break;
      kept += letter;
    }
    text.text = kept + "...";
  }
  drawing.texts.push_back(std::move(text));
}

void add_sheet(const SheetText& text, Drawing& drawing) {
  const FlatBox box = extent_of(drawing);
  const double mm = drawing.paper_mm(1), width = box.width() / mm, height = box.height() / mm;
  const Paper paper = paper_for(std::max(width + 2 * kGap, kBlockWidth), height + 2 * kGap + kBlockHeight);
  const double free = paper.height - 2 * kMargin - kBlockHeight;
  const double x0 = (box.min.x + box.max.x) / 2 - paper.width / 2 * mm;
  const double y0 = (box.min.y + box.max.y) / 2 - (kMargin + kBlockHeight + free / 2) * mm;
  drawing.sheet = {x0, y0, x0 + paper.width * mm, y0 + paper.height * mm};
  PaperPen pen(drawing, x0, y0);
  pen.box(kMargin, kMargin, paper.width - kMargin, paper.height - kMargin, DrawingRole::frame);
  title_block(pen, text, drawing, paper.width - kMargin - kBlockWidth, kMargin);
}

}  // namespace ilot
