// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/facades/drawing_edits.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "engine/compare/facades/drawing_control.h"
#include "engine/error.h"

namespace ilot {
namespace {

// Choice: a tenth of a millimetre, what evaluate --corrected calls moved; programs write more digits than that.
constexpr double kUnmoved = 1e-4;  // metres

double shared_area(const FlatBox& a, const FlatBox& b) {
  const double w = std::min(a.max.x, b.max.x) - std::max(a.min.x, b.min.x);
  const double h = std::min(a.max.y, b.max.y) - std::max(a.min.y, b.min.y);
  if (!(w > 0 && h > 0)) return 0;
  return w * h / (a.width() * a.height() + b.width() * b.height() - w * h);
}

bool same_box(const FlatBox& a, const FlatBox& b) {
  const auto same = [](double p, double q) { return std::abs(p - q) <= kUnmoved; };
  return same(a.min.x, b.min.x) && same(a.min.y, b.min.y) && same(a.max.x, b.max.x) && same(a.max.y, b.max.y);
}

struct OpeningMatch {
  int rank = 0;  // how they belong together, the surest first
  double apart = 0;
  std::size_t ours = 0, corrected = 0;
};

std::vector<OpeningMatch> matches_of(const std::vector<DrawnOpening>& ours,
                                     const std::vector<DrawnOpening>& corrected) {
  constexpr double kMostly = 0.5;  // Derived: only one of several openings that do not overlap can have more
  std::vector<OpeningMatch> matches;
  for (std::size_t i = 0; i < ours.size(); ++i)
    for (std::size_t k = 0; k < corrected.size(); ++k) {
      const double shared = shared_area(ours[i].box, corrected[k].box);
      const bool same_id = !ours[i].id.empty() && ours[i].id == corrected[k].id;
      const int rank = same_box(ours[i].box, corrected[k].box) ? 0
                       : shared >= kMostly                     ? 1
                       : same_id                               ? 2
                       : shared > 0                            ? 3
                                                               : 4;
      const double apart = rank == 2 ? distance(ours[i].box.middle(), corrected[k].box.middle()) : 1 - shared;
      if (rank < 4) matches.push_back({rank, apart, i, k});
    }
  std::sort(matches.begin(), matches.end(), [](const OpeningMatch& a, const OpeningMatch& b) {
    return std::tie(a.rank, a.apart, a.ours, a.corrected) < std::tie(b.rank, b.apart, b.ours, b.corrected);
  });
  return matches;
}

// Metres per unit of the CRS: sizes of elements are metres, their rings are in the CRS.
double metres_per_unit_of(const Facade& facade) {
  double metres = 0, units = 0;
  for (const FacadeElement& e : facade.elements) {
    if (!e.opening || e.ring.size() != 4) continue;
    metres += e.width_m;
    units += dot(e.ring[1] - e.ring[0], facade.right);
  }
  return metres > 0 && units > 0 ? metres / units : 1;
}

class EditMaker {
 public:
  explicit EditMaker(const Facade& facade) : facade_(facade), metres_per_unit_(metres_per_unit_of(facade)) {}

  Edit make(EditAction action, const DrawnOpening& opening) const {
    Edit edit;
    edit.product = "facades";
    edit.action = action;
    edit.kind = opening.kind.empty() ? "window" : opening.kind;
    edit.at = corners(opening.box);
    edit.note = "facade " + std::to_string(facade_.id) + (opening.id.empty() ? "" : ", opening " + opening.id);
    return edit;
  }

  // The lower left and the upper right corner on the wall.
  std::vector<Vec3> corners(const FlatBox& box) const { return {place(box.min), place(box.max)}; }

 private:
  Vec3 place(FlatPoint p) const {
    return facade_.origin + (p.x / metres_per_unit_) * facade_.right +
           (p.y / metres_per_unit_ - facade_.origin.z) * facade_.up;
  }

  const Facade& facade_;
  double metres_per_unit_ = 1;
};

}  // namespace

DrawingEdits drawing_edits(const DxfDrawing& ours, const DxfDrawing& corrected, const Facade& facade,
                           const DrawingLayers& layers) {
  check_drawing_units(ours, "our drawing");
  check_drawing_units(corrected, "the corrected drawing");
  const DrawnOpenings before = drawn_openings(ours, layers), after = drawn_openings(corrected, layers);
  const EditMaker maker(facade);
  DrawingEdits result;
  result.loose = after.loose;
  std::vector<char> taken_before(before.openings.size()), taken(after.openings.size());
  for (const OpeningMatch& match : matches_of(before.openings, after.openings)) {
    if (taken_before[match.ours] || taken[match.corrected]) continue;
    taken_before[match.ours] = taken[match.corrected] = 1;
    const DrawnOpening &was = before.openings[match.ours], &now = after.openings[match.corrected];
    const bool renamed = !now.kind.empty() && !was.kind.empty() && now.kind != was.kind;
    if (match.rank == 0 && !renamed) {
      ++result.unchanged;
      continue;
    }
    if (!was.certain) continue;
    Edit edit = maker.make(match.rank == 0 ? EditAction::kind : EditAction::moved, was);
    if (match.rank != 0) edit.to = maker.corners(now.box);
    if (renamed) edit.to_kind = now.kind;
    result.edits.push_back(std::move(edit));
  }
  for (std::size_t i = 0; i < before.openings.size(); ++i)
    if (!taken_before[i] && before.openings[i].certain)
      result.edits.push_back(maker.make(EditAction::deleted, before.openings[i]));
  for (std::size_t i = 0; i < after.openings.size(); ++i)
    if (!taken[i] && after.openings[i].certain)
      result.edits.push_back(maker.make(EditAction::added, after.openings[i]));
  return result;
}

}  // namespace ilot
