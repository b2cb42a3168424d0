// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <set>

#include "engine/compare/facades/drawing_edits.h"
#include "engine/deliverables/drawings/facade_plan.h"
#include "kernels/core/portable_math.h"

namespace ilot {
namespace {

constexpr double kMeet = 1e-3;  // metres; Choice: ends of lines that a draughtsman snapped are closer, others are not

// The box around a line with its arcs.
FlatBox box_around(const std::vector<DrawingCorner>& corners, bool closed) {
  FlatElement line;
  line.corners = corners;
  if (!closed && !line.corners.empty()) line.corners.back().bulge = 0;
  FlatBox box = FlatBox::none();
  for (const FlatPoint& p : chords_of(line)) box.add(p);
  return box;
}

std::vector<DrawingCorner> corners_of(const DxfEntity& e) {
  if (e.type == "LINE" || e.type == "LWPOLYLINE" || e.type == "POLYLINE") return e.corners;
  if (e.type != "ARC" || e.corners.empty()) return {};
  const auto at = [&](double degrees) {
    return FlatPoint{e.corners[0].x + e.radius * cos_degrees(degrees),
                     e.corners[0].y + e.radius * cos_degrees(degrees - 90)};
  };
  double span = e.to_deg - e.from_deg;
  while (span <= 0) span += 360;
  const FlatPoint a = at(e.from_deg), b = at(e.to_deg);
  return {{a.x, a.y, cos_degrees(span / 4 - 90) / cos_degrees(span / 4)}, {b.x, b.y, 0}};
}

bool meet(const DrawingCorner& a, const DrawingCorner& b) {
  return std::abs(a.x - b.x) <= kMeet && std::abs(a.y - b.y) <= kMeet;
}

// A line from one end to the other, and the box around all that was joined to it.
struct OpenLine {
  DrawingCorner from, to;
  FlatBox box;
};

// Joins lines that meet end to end. Takes the closed ones out and leaves the others.
std::vector<FlatBox> closed_boxes(std::vector<OpenLine>& lines) {
  std::vector<FlatBox> closed;
  for (std::size_t i = 0; i < lines.size();) {
    bool grown = false;
    for (std::size_t j = i + 1; j < lines.size() && !grown && !meet(lines[i].from, lines[i].to); ++j) {
      OpenLine& other = lines[j];
      if (meet(other.to, lines[i].to) || meet(other.to, lines[i].from)) std::swap(other.from, other.to);
      if (!meet(other.from, lines[i].to) && !meet(other.from, lines[i].from)) continue;
      (meet(other.from, lines[i].to) ? lines[i].to : lines[i].from) = other.to;
      lines[i].box.add_box(other.box);
      lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(j));
      grown = true;
    }
    if (grown) continue;
    if (meet(lines[i].from, lines[i].to)) {
      closed.push_back(lines[i].box);
      lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
      ++i;
    }
  }
  return closed;
}

// Takes the entities of a drawing one after the other.
class OpeningReader {
 public:
  explicit OpeningReader(const DrawingLayers& layers) : layers_(layers) {
    for (const DrawingRole role :
         {DrawingRole::opening, DrawingRole::completed, DrawingRole::occluded, DrawingRole::hidden})
      of_blocks_.insert(layers[role].name);
  }

  void take(const DxfEntity& e) {
    if (!e.finite) return;
    if (e.type == "INSERT" && !e.in_block) {
      close_block();
      in_block_ = true;
      block_ = {FlatBox::none(), "", "", true};
    } else if (e.type == "ATTRIB" && in_block_) {
      if (e.text.starts_with("KIND=")) block_.kind = e.text.substr(5);
      if (e.text.starts_with("ID=")) block_.id = e.text.substr(3);
    } else if (e.in_block && in_block_) {
      const std::vector<DrawingCorner> corners = corners_of(e);
      if (!corners.empty() && of_blocks_.contains(e.layer)) block_.box.add_box(box_around(corners, e.closed));
    } else {
      close_block();
      take_loose(e);
    }
  }

  DrawnOpenings finish() {
    close_block();
    for (const FlatBox& box : closed_boxes(open_)) add({box, "", "", true});
    for (const FlatBox& box : closed_boxes(uncertain_)) add({box, "", "", false});
    found_.loose = open_.size();
    return std::move(found_);
  }

 private:
  void close_block() {
    // Blocks that are no openings, and dimensions, have no KIND.
    if (in_block_ && !block_.box.is_empty() && !block_.kind.empty()) add(block_);
    in_block_ = false;
  }

  void take_loose(const DxfEntity& e) {
    const bool certain = e.layer == layers_[DrawingRole::opening].name;
    if (!certain && e.layer != layers_[DrawingRole::completed].name) return;
    std::vector<DrawingCorner> corners = corners_of(e);
    if (corners.size() < 2) return;
    if (e.closed)
      add({box_around(corners, true), "", "", certain});
    else
      (certain ? open_ : uncertain_).push_back({corners.front(), corners.back(), box_around(corners, false)});
  }

  void add(const DrawnOpening& opening) {
    if (!(opening.box.width() > 0 && opening.box.height() > 0)) return;
    const auto key = [](double v) { return std::llround(v / kMeet); };
    const FlatBox& b = opening.box;
    if (known_.insert({key(b.min.x), key(b.min.y), key(b.max.x), key(b.max.y)}).second)
      found_.openings.push_back(opening);
  }

  const DrawingLayers& layers_;
  std::set<std::string> of_blocks_;
  std::set<std::array<long long, 4>> known_;
  DrawnOpenings found_;
  DrawnOpening block_;
  bool in_block_ = false;
  std::vector<OpenLine> open_, uncertain_;
};

}  // namespace

DrawnOpenings drawn_openings(const DxfDrawing& drawing, const DrawingLayers& layers) {
  OpeningReader reader(layers);
  for (const DxfEntity& e : drawing.entities) reader.take(e);
  return reader.finish();
}

}  // namespace ilot
