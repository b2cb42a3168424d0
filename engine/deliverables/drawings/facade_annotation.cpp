// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/drawings/facade_annotation.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <tuple>

#include "engine/deliverables/drawings/dimension_style.h"
#include "engine/deliverables/drawings/sheet_texts.h"
#include "kernels/geometry/flat_segment.h"
#include "kernels/geometry/ring.h"

namespace ilot {
namespace {

// Millimetres on paper.
constexpr double kNumber = 2.5, kSmall = 1.8, kAround = 0.4, kOffset = 9, kChain = 8, kLead = 4;
constexpr double kSameLevel = 0.5;

// Returns metres with two decimals. Halves are rounded up; a value within a tenth of a millimetre of a half counts as a
// half.
std::string in_centimetres(double metres, const Drawing& drawing) {
  return number_text(std::floor(std::round(metres * 1e4) / 100 + 0.5) / 100, 2, drawing.decimal_comma);
}

// The places where texts may be: not across a line of an element, not on another text.
class FreePlaces {
 public:
  explicit FreePlaces(std::span<const FlatElement> flat) {
    for (const FlatElement& element : flat) rings_.push_back({element.box, chords_of(element)});
  }
  bool is_free(const FlatBox& box) const {
    for (const FlatBox& text : taken_)
      if (text.overlaps(box)) return false;
    for (const auto& [around, ring] : rings_) {
      if (!around.overlaps(box)) continue;
      for (std::size_t i = 0; i < ring.size(); ++i)
        if (meets(ring[i], ring[(i + 1) % ring.size()], box)) return false;
    }
    return true;
  }
  bool is_inside_of(std::size_t element, const FlatBox& box) const {
    return contains_by_share(rings_[element].second, box.middle());
  }
  void take(const FlatBox& box) { taken_.push_back(box); }

 private:
  std::vector<std::pair<FlatBox, std::vector<FlatPoint>>> rings_;
  std::vector<FlatBox> taken_;
};

// Places one or two lines of text, one below the other, centred in a box.
std::optional<FlatBox> place_label(const std::vector<std::string>& lines, double height, std::size_t element,
                                   const FlatElement& flat, const FreePlaces& places, const Drawing& drawing) {
  double width = 0;
  for (const std::string& line : lines) width = std::max(width, text_width(line, height));
  const double tall = height * (1.6 * static_cast<double>(lines.size()) - 0.6), air = drawing.paper_mm(kAround);
  for (const double up : {0.5, 0.25, 0.75})
    for (const double right : {0.5, 0.25, 0.75}) {
      const double x = flat.box.min.x + right * flat.box.width(), y = flat.box.min.y + up * flat.box.height();
      const FlatBox box{{x - width / 2, y - tall / 2}, {x + width / 2, y + tall / 2}};
      const FlatBox airy = box.grown(air);
      if (flat.box.contains(airy) && places.is_inside_of(element, box) && places.is_free(airy)) return box;
    }
  return std::nullopt;
}

bool is_numbered(const FacadeElement& e) {
  return e.kind != "outline" && e.kind != "joint" && e.status != DrawnStatus::occluded &&
         e.region != FacadeRegion::irregularity;
}

struct Extent {
  double low = 0, high = 0;
};

// Returns groups in the order of their lowest ends. Each member shares at least half of the smaller extent with the
// first member of its group.
std::vector<std::vector<std::size_t>> groups_along(const std::vector<Extent>& extents) {
  std::vector<std::size_t> order(extents.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::tie(extents[a].low, extents[a].high, a) < std::tie(extents[b].low, extents[b].high, b);
  });
  std::vector<std::vector<std::size_t>> groups;
  for (const std::size_t i : order) {
    const auto alike = [&](const std::vector<std::size_t>& group) {
      const Extent &a = extents[group[0]], &b = extents[i];
      return std::min(a.high, b.high) - std::max(a.low, b.low) > 0.5 * std::min(a.high - a.low, b.high - b.low);
    };
    const auto found = std::find_if(groups.begin(), groups.end(), alike);
    if (found == groups.end())
      groups.push_back({i});
    else
      found->push_back(i);
  }
  return groups;
}

// Returns the ends of the measured extents, ascending: those of the plan and those of extents that do not overlap an
// earlier one.
std::vector<double> stops_of(std::vector<Extent> extents, Extent whole, double least) {
  std::sort(extents.begin(), extents.end(),
            [](Extent a, Extent b) { return std::tie(a.low, a.high) < std::tie(b.low, b.high); });
  std::vector<double> stops{whole.low};
  for (const Extent& e : extents) {
    if (e.low < stops.back() - least) continue;
    for (const double stop : {e.low, e.high})
      if (stop > stops.back() + least) stops.push_back(stop);
  }
  if (whole.high > stops.back() + least) stops.push_back(whole.high);
  return stops;
}

// Draws a chain of dimensions in its own axes, s along it and t across it away from the plan, in horizontal or vertical
// direction. The plan ends at `foot`.
class ChainPen {
 public:
  enum class Way { horizontal, vertical };
  ChainPen(Way way, double foot, double at, double outwards, Drawing& drawing)
      : way_(way), foot_(foot), at_(at), outwards_(outwards), drawing_(drawing) {}

  void draw(const std::vector<double>& stops) {
    const double tick = drawing_.paper_mm(kDimensionTick), height = drawing_.paper_mm(kDimensionText);
    bool raised = false;
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
      const double length = stops[i + 1] - stops[i];
      const std::string words = in_centimetres(length, drawing_);
      // A text that is longer than its stretch is put farther out, on a line of its own.
      const bool narrow = text_width(words, height) + 2 * tick > length;
      raised = narrow && !raised;
      dimension(stops[i], stops[i + 1], raised ? 2.0 * height : drawing_.paper_mm(kDimensionGap), words);
      if (!narrow) raised = false;
    }
  }

 private:
  FlatPoint place(double s, double across) const {
    return way_ == Way::horizontal ? FlatPoint{s, across} : FlatPoint{across, s};
  }
  void dimension(double from, double to, double above, const std::string& words) {
    DrawingDimension made{place(from, foot_), place(to, foot_), way_ == Way::vertical, at_, {}, {}};
    const auto line = [&](FlatPoint a, FlatPoint b) {
      made.lines.push_back({DrawingRole::dimension, {{a.x, a.y}, {b.x, b.y}}, false});
    };
    line(place(from, at_), place(to, at_));
    const double tick = drawing_.paper_mm(kDimensionTick);
    for (const double stop : {from, to}) {
      line(place(stop, foot_ + outwards_ * drawing_.paper_mm(kDimensionOffset)),
           place(stop, at_ + outwards_ * drawing_.paper_mm(kDimensionBeyond)));
      const FlatPoint p = place(stop, at_);
      line({p.x - tick, p.y - tick}, {p.x + tick, p.y + tick});
    }
    // Texts are above a horizontal chain and left of a vertical one, on either side of the plan.
    const double middle = (from + to) / 2, height = drawing_.paper_mm(kDimensionText);
    if (way_ == Way::horizontal)
      made.text = {DrawingRole::dimension, middle, at_ + above, height, 0, TextAnchor::middle, words};
    else
      made.text = {DrawingRole::dimension, at_ - above, middle, height, 90, TextAnchor::middle, words};
    drawing_.dimensions.push_back(std::move(made));
  }
  Way way_;
  double foot_, at_, outwards_;
  Drawing& drawing_;
};

// Returns centres that keep a pitch from each other and stay as near as possible to the wanted places (groups of
// neighbours that touch move together).
std::vector<double> spread(const std::vector<double>& wanted, double pitch) {
  struct Pool {
    double sum = 0;
    std::size_t first = 0, count = 0;
    double middle() const { return sum / static_cast<double>(count); }
  };
  std::vector<Pool> pools;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    // After the pitch of the earlier ones is subtracted, the wanted places only have to ascend.
    pools.push_back({wanted[i] - pitch * static_cast<double>(i), i, 1});
    while (pools.size() > 1 && pools[pools.size() - 2].middle() > pools.back().middle()) {
      pools[pools.size() - 2].sum += pools.back().sum;
      pools[pools.size() - 2].count += pools.back().count;
      pools.pop_back();
    }
  }
  std::vector<double> places;
  for (const Pool& pool : pools)
    for (std::size_t k = 0; k < pool.count; ++k)
      places.push_back(pool.middle() + pitch * static_cast<double>(pool.first + k));
  return places;
}

// The box around the outlines of the walls; that of the plan where no outline is drawn.
FlatBox box_of_outlines(const Facade& facade, std::span<const FlatElement> flat, const FlatBox& plan) {
  FlatBox box = FlatBox::none();
  for (std::size_t i = 0; i < flat.size(); ++i)
    if (facade.elements[i].kind == "outline" && !flat[i].corners.empty()) box.add_box(flat[i].box);
  return box.is_empty() ? plan : box;
}

// Whether an element is a wall of the house above or below the outline: the front of a dormer, a storey that stands
// back or out.
bool is_further_wall(const FacadeElement& e, const FlatElement& flat, const FlatBox& outlines) {
  if (flat.corners.empty() || e.status == DrawnStatus::occluded) return false;
  const bool storey = e.kind == "recess" || e.kind == "protrusion";
  const double middle = flat.box.middle().y;
  return e.kind == "dormer" || (storey && (middle > outlines.max.y || middle < outlines.min.y));
}

// The box of all that is wall: what lies beside it or on it has no part in the overall sizes.
FlatBox box_of_walls(const Facade& facade, std::span<const FlatElement> flat, const FlatBox& plan) {
  const FlatBox outlines = box_of_outlines(facade, flat, plan);
  FlatBox box = outlines;
  for (std::size_t i = 0; i < flat.size(); ++i)
    if (is_further_wall(facade.elements[i], flat[i], outlines)) box.add_box(flat[i].box);
  return box;
}

bool has_level(const FacadeElement& e, const FlatElement& flat, const FlatBox& outlines) {
  const DrawingRole role = role_of_kind(e.kind);
  return e.status != DrawnStatus::occluded &&
         (is_opening(e) || role == DrawingRole::outline || role == DrawingRole::band || role == DrawingRole::balcony ||
          is_further_wall(e, flat, outlines));
}

struct Height {
  double y = 0;
  bool outline = false;  // of the wall itself
};

// The height that stands for those of a group, lowest first, which are too near to each other to be written each: the
// lowest of the outline, otherwise the one that is written most often, the lowest of such. It is one of them: a mean of
// different things would be the height of none.
double level_of(std::span<const Height> group, const Drawing& drawing) {
  const auto outline = std::find_if(group.begin(), group.end(), [](const Height& h) { return h.outline; });
  if (outline != group.end()) return outline->y;
  double best = group.front().y;
  std::size_t most = 0;
  for (std::size_t i = 0; i < group.size();) {
    const std::string written = in_centimetres(group[i].y, drawing);
    std::size_t end = i;
    while (end < group.size() && in_centimetres(group[end].y, drawing) == written) ++end;
    if (end - i > most) most = end - i, best = group[i].y;
    i = end;
  }
  return best;
}

}  // namespace

void add_numbers(const Facade& facade, std::span<const FlatElement> flat, Drawing& drawing) {
  FreePlaces places(flat);
  std::vector<std::size_t> order(flat.size());  // openings choose their places first
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_partition(order.begin(), order.end(), [&](std::size_t i) { return is_opening(facade.elements[i]); });
  for (const std::size_t i : order) {
    const FacadeElement& e = facade.elements[i];
    if (!is_numbered(e) || flat[i].corners.size() < 3) continue;
    const std::string id = std::to_string(e.id);
    const std::string size = in_centimetres(e.width_m, drawing) + " x " + in_centimetres(e.height_m, drawing);
    std::vector<std::pair<double, std::vector<std::string>>> tries{{kNumber, {id}}, {kSmall, {id}}};
    if (is_opening(e) && e.width_m > 0 && e.height_m > 0) tries.insert(tries.begin(), {kSmall, {id, size}});
    for (const auto& [mm, lines] : tries) {
      const double height = drawing.paper_mm(mm);
      const auto box = place_label(lines, height, i, flat[i], places, drawing);
      if (!box) continue;
      for (std::size_t k = 0; k < lines.size(); ++k)
        drawing.texts.push_back({DrawingRole::number, (box->min.x + box->max.x) / 2,
                                 box->max.y - height * (1 + 1.6 * static_cast<double>(k)), height, 0,
                                 TextAnchor::middle, lines[k]});
      places.take(*box);
      break;
    }
  }
}

void add_levels(const Facade& facade, std::span<const FlatElement> flat, const FlatBox& plan, Drawing& drawing) {
  std::vector<Height> heights;
  const FlatBox outlines = box_of_outlines(facade, flat, plan);
  for (std::size_t i = 0; i < flat.size(); ++i)
    if (has_level(facade.elements[i], flat[i], outlines) && !flat[i].corners.empty()) {
      const bool outline = facade.elements[i].kind == "outline";
      heights.push_back({flat[i].box.max.y, outline});
      // A storey begins where the outline ends.
      if (!is_further_wall(facade.elements[i], flat[i], outlines)) heights.push_back({flat[i].box.min.y, outline});
      if (outline)  // feet of gables, steps
        for (const DrawingCorner& corner : flat[i].corners) heights.push_back({corner.y, true});
    }
  std::sort(heights.begin(), heights.end(), [](const Height& a, const Height& b) { return a.y < b.y; });
  const double same = drawing.paper_mm(kSameLevel), height = drawing.paper_mm(kSmall);
  std::vector<double> levels;
  for (std::size_t i = 0; i < heights.size();) {
    std::size_t end = i;
    while (end < heights.size() && heights[end].y - heights[i].y <= same) ++end;
    const double level = level_of(std::span(heights).subspan(i, end - i), drawing);
    if (levels.empty() || in_centimetres(levels.back(), drawing) != in_centimetres(level, drawing))
      levels.push_back(level);
    i = end;
  }
  const std::vector<double> places = spread(levels, 1.5 * height);
  const double x0 = plan.max.x + drawing.paper_mm(2), lead = drawing.paper_mm(kLead);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    drawing.lines.push_back(
        {DrawingRole::level,
         {{x0, levels[i]}, {x0 + lead, levels[i]}, {x0 + 2 * lead, places[i]}, {x0 + 2.5 * lead, places[i]}},
         false});
    drawing.texts.push_back({DrawingRole::level, x0 + 2.7 * lead, places[i] - height / 2, height, 0, TextAnchor::left,
                             in_centimetres(levels[i], drawing)});
  }
}

void add_dimensions(const Facade& facade, std::span<const FlatElement> flat, const FlatBox& plan, Drawing& drawing) {
  std::vector<Extent> across, up;
  for (std::size_t i = 0; i < flat.size(); ++i) {
    const FacadeElement& e = facade.elements[i];
    if (!is_opening(e) || e.status == DrawnStatus::occluded || flat[i].corners.size() < 3) continue;
    across.push_back({flat[i].box.min.x, flat[i].box.max.x});
    up.push_back({flat[i].box.min.y, flat[i].box.max.y});
  }
  const double least = drawing.paper_mm(kSameLevel), offset = drawing.paper_mm(kOffset),
               step = drawing.paper_mm(kChain);
  const FlatBox walls = box_of_walls(facade, flat, plan);
  const Extent wide{walls.min.x, walls.max.x}, tall{walls.min.y, walls.max.y};
  const auto picked = [](const std::vector<Extent>& from, const std::vector<std::size_t>& group) {
    std::vector<Extent> chosen;
    for (const std::size_t i : group) chosen.push_back(from[i]);
    return chosen;
  };
  const auto fullest = [](const std::vector<std::vector<std::size_t>>& groups) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < groups.size(); ++i)
      if (groups[i].size() > groups[best].size()) best = i;
    return best;
  };
  const auto rows = groups_along(up), columns = groups_along(across);
  const auto horizontal = [&](double at, double outwards, const std::vector<double>& stops) {
    ChainPen(ChainPen::Way::horizontal, outwards < 0 ? plan.min.y : plan.max.y, at, outwards, drawing).draw(stops);
  };
  const auto vertical = [&](double at, const std::vector<double>& stops) {
    ChainPen(ChainPen::Way::vertical, plan.min.x, at, -1, drawing).draw(stops);
  };
  double below = plan.min.y - offset, left = plan.min.x - offset;
  std::vector<double> lowest;
  if (!rows.empty()) {
    lowest = stops_of(picked(across, rows[0]), wide, least);
    horizontal(below, -1, lowest);
    below -= step;
    const std::vector<double> stops = stops_of(picked(across, rows[fullest(rows)]), wide, least);
    if (stops != lowest) horizontal(plan.max.y + offset, 1, stops);
    vertical(left, stops_of(picked(up, columns[fullest(columns)]), tall, least));
    left -= step;
  }
  if (wide.high - wide.low > least) horizontal(below, -1, {wide.low, wide.high});
  if (tall.high - tall.low > least) vertical(left, {tall.low, tall.high});
}

}  // namespace ilot
