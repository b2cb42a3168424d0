// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/facade_edits.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "engine/products/facades/elements/edited_element.h"
#include "engine/products/facades/elements/facade_elements.h"
#include "engine/products/facades/wall_sides.h"

namespace ilot {
namespace {

// An element, what it was when it was found, and the edits that changed it.
struct EditedElement {
  FacadeElement element;
  std::optional<Box2> found;  // none: an edit drew it
  Box2 now;
  bool deleted = false;
  const Edit *placed = nullptr, *named = nullptr;  // the last edit of its place (or existence), and of its kind
};

struct EditedFacade {
  Facade* facade = nullptr;
  std::vector<EditedElement> elements;
  bool touched = false;
  bool bounded = true;  // false: the wall has no known extent
};

// A rectangle of an edit on a facade.
struct OnWall {
  std::size_t facade = 0;
  Box2 box;
  double away_m = 0;  // from the plane of the wall
};

// How well the rectangle of an edit fits an element.
struct Fit {
  std::size_t facade = 0, element = 0;
  double found = 0, now = 0;  // shares of the area
  bool same_kind = false;
  double away_m = 0;

  double best() const { return std::max(found, now); }
};

bool is_opening_kind(const std::string& kind) {
  constexpr std::array<const char*, 4> kKinds{"window", "door", "shop", "opening"};
  return std::find(kKinds.begin(), kKinds.end(), kind) != kKinds.end();
}

// Whether an edit can be one of this element. A window may have become a door by itself, but no sill.
bool may_be(const Edit& edit, const FacadeElement& e) {
  if (e.kind == "outline" || e.ring.size() < 3) return false;
  if (edit.kind.empty() || is_opening_kind(edit.kind)) return e.opening;
  return edit.kind == e.kind;
}

class FacadeEditor {
 public:
  // With `invent` an edit without a partner makes one: so edits are held against each other before anything is known.
  FacadeEditor(std::span<Facade* const> facades, const FacadeEditParams& params, bool invent)
      : params_(params), invent_(invent) {
    for (Facade* facade : facades) {
      EditedFacade& edited = facades_.emplace_back();
      edited.facade = facade;
      for (const FacadeElement& e : facade->elements) {
        EditedElement& element = edited.elements.emplace_back();
        element.element = e;
        if (e.ring.size() < 3) continue;
        element.now = box_in(*facade, e, params.metres_per_unit);
        element.found = element.now;
      }
    }
  }

  EditResult make(const Edit& edit) {
    if (edit.action == EditAction::added) return add(edit);
    std::optional<Fit> fit = best_fit(edit);
    if (!fit && invent_) fit = invented(edit);
    if (!fit)
      return {EditOutcome::without_partner,
              fmt::format("no {} of any facade has half of its area in common with the rectangle of this edit",
                          edit.kind.empty() ? "opening" : edit.kind)};
    EditedElement& e = facades_[fit->facade].elements[fit->element];
    if (e.deleted) {
      if (edit.action != EditAction::deleted) return contradicted(*e.placed, edit, fit->facade);
      return {EditOutcome::repeated, {}};
    }
    facades_[fit->facade].touched = true;
    if (edit.action == EditAction::deleted) return remove(edit, *fit, e);
    if (edit.action == EditAction::moved) return move(edit, *fit, e);
    return rename(edit, *fit, e);
  }

  void write() const {
    for (const EditedFacade& edited : facades_) {
      if (!edited.touched) continue;
      edited.facade->elements.clear();
      for (const EditedElement& e : edited.elements)
        if (!e.deleted) edited.facade->elements.push_back(e.element);
      for (std::uint32_t i = 0; i < edited.facade->elements.size(); ++i) edited.facade->elements[i].id = i + 1;
    }
  }

  // Invents the wall of a rectangle that is on no wall yet.
  void invent_wall(const Edit& edit, std::vector<std::unique_ptr<Facade>>& walls) {
    if (!on_walls(edit.at).empty()) return;
    Facade& wall = *walls.emplace_back(std::make_unique<Facade>());
    const Vec3 across = edit.at[1] - edit.at[0];
    const Vec3 level{across.x, across.y, 0};
    wall.origin = edit.at[0];
    wall.right = (1 / norm(level)) * level;
    wall.up = {0, 0, 1};
    wall.out = cross(wall.right, wall.up);
    EditedFacade& edited = facades_.emplace_back();
    edited.facade = &wall;
    edited.bounded = false;
  }

 private:
  // The walls whose plane the two corners lie on.
  std::vector<OnWall> on_walls(const std::vector<Vec3>& corners) const {
    std::vector<OnWall> walls;
    const double m = params_.metres_per_unit;
    const Vec3 across = corners[1] - corners[0];
    const double width = m * std::sqrt(across.x * across.x + across.y * across.y);
    for (std::size_t f = 0; f < facades_.size(); ++f) {
      const Facade& facade = *facades_[f].facade;
      const Vec3 a = m * (corners[0] - facade.origin), b = m * (corners[1] - facade.origin);
      const double away = std::max(std::abs(dot(a, facade.out)), std::abs(dot(b, facade.out)));
      const Box2 box = box_of(std::array<Place2, 2>{
          {{dot(a, facade.right), dot(a, facade.up)}, {dot(b, facade.right), dot(b, facade.up)}}});
      const double more = params_.beyond_m;
      const bool along = box.width() >= params_.same_area * width;
      const bool inside = !facades_[f].bounded || (box.u1 > -more && box.u0 < facade.width_m + more && box.v1 > -more &&
                                                   box.v0 < facade.height_m + more);
      if (away <= params_.plane_m && along && inside) walls.push_back({f, box, away});
    }
    std::stable_sort(walls.begin(), walls.end(), [](const OnWall& a, const OnWall& b) { return a.away_m < b.away_m; });
    return walls;
  }

  std::optional<Fit> best_fit(const Edit& edit) const {
    std::optional<Fit> best;
    const auto better = [&](const Fit& a, const Fit& b) {
      if (a.best() != b.best()) return a.best() > b.best();
      if (a.same_kind != b.same_kind) return a.same_kind;
      return a.away_m < b.away_m;
    };
    for (const OnWall& wall : on_walls(edit.at))
      for (std::size_t i = 0; i < facades_[wall.facade].elements.size(); ++i) {
        const EditedElement& e = facades_[wall.facade].elements[i];
        if (!may_be(edit, e.element)) continue;
        const Fit fit{wall.facade,
                      i,
                      e.found ? shared_area(wall.box, *e.found) : 0,
                      shared_area(wall.box, e.now),
                      edit.kind == e.element.kind,
                      wall.away_m};
        if (fit.best() >= params_.same_area && (!best || better(fit, *best))) best = fit;
      }
    return best;
  }

  Fit invented(const Edit& edit) {
    const OnWall wall = on_walls(edit.at).front();
    EditedFacade& edited = facades_[wall.facade];
    EditedElement& e = edited.elements.emplace_back();
    e.element =
        drawn_opening(*edited.facade, edit.kind.empty() ? "window" : edit.kind, wall.box, params_.metres_per_unit);
    e.element.opening = is_opening_kind(e.element.kind);
    e.found = e.now = wall.box;
    return {wall.facade, edited.elements.size() - 1, 1, 1, true, 0};
  }

  Box2 box_of_corners(const Facade& facade, const std::vector<Vec3>& corners) const {
    const auto place = [&](Vec3 p) {
      const Vec3 d = params_.metres_per_unit * (p - facade.origin);
      return Place2{dot(d, facade.right), dot(d, facade.up)};
    };
    return box_of(std::array<Place2, 2>{{place(corners[0]), place(corners[1])}});
  }

  // Two edits contradict each other if they are of one opening by themselves. If only the opening that was found has
  // both as partners, it was two where they were drawn (one on each sheet of a wall): the later one has none.
  EditResult contradicted(const Edit& earlier, const Edit& later, std::size_t on) const {
    const Facade& facade = *facades_[on].facade;
    const Box2 box = box_of_corners(facade, later.at);
    bool of_one = invent_ || shared_area(box_of_corners(facade, earlier.at), box) >= params_.same_area;
    if (earlier.to.size() == 2) of_one |= shared_area(box_of_corners(facade, earlier.to), box) >= params_.same_area;
    if (of_one) refuse_contradiction(earlier, later);
    return {EditOutcome::without_partner, fmt::format("it was one opening with that of {}", earlier.where)};
  }

  EditResult add(const Edit& edit) {
    const std::vector<OnWall> walls = on_walls(edit.at);
    if (walls.empty()) return {EditOutcome::without_partner, "no facade is where this opening would be added"};
    EditedFacade& edited = facades_[walls[0].facade];
    const Box2& box = walls[0].box;
    EditedElement* same = nullptr;
    for (EditedElement& e : edited.elements) {
      if (e.deleted || !e.element.opening || shared_area(box, e.now) < params_.same_area) continue;
      if (same == nullptr || shared_area(box, e.now) > shared_area(box, same->now)) same = &e;
    }
    if (same != nullptr && same->placed != nullptr) {
      if (!alike(box, same->now) || same->element.kind != edit.kind)
        return contradicted(*same->placed, edit, walls[0].facade);
      return {EditOutcome::repeated, {}};
    }
    edited.touched = true;
    if (same == nullptr) {
      same = &edited.elements.emplace_back();
      same->element = drawn_opening(*edited.facade, edit.kind, box, params_.metres_per_unit);
    } else {  // the run found it by itself
      move_element(*edited.facade, box, params_.same_m, params_.metres_per_unit, same->element);
      if (same->element.kind != edit.kind) rename_opening(edit.kind, same->element);
    }
    same->placed = &edit;
    same->now = box;
    if (!invent_) clear_unseen(box, edited);
    return {};
  }

  EditResult remove(const Edit& edit, const Fit& fit, EditedElement& e) {
    if (e.placed != nullptr && e.found && !(fit.now > fit.found)) return contradicted(*e.placed, edit, fit.facade);
    if (e.named != nullptr && !edit.kind.empty() && edit.kind != e.element.kind)
      return contradicted(*e.named, edit, fit.facade);
    e.deleted = true;
    e.placed = &edit;
    return {};
  }

  EditResult move(const Edit& edit, const Fit& fit, EditedElement& e) {
    EditedFacade& edited = facades_[fit.facade];
    const Facade& facade = *edited.facade;
    const Box2 to = box_of_corners(facade, edit.to);
    if (e.placed != nullptr && alike(to, e.now)) return {EditOutcome::repeated, {}};
    if (e.placed != nullptr && e.found && !(fit.now > fit.found)) return contradicted(*e.placed, edit, fit.facade);
    move_element(facade, to, params_.same_m, params_.metres_per_unit, e.element);
    e.now = to;
    e.placed = &edit;
    if (!edit.to_kind.empty()) rename(edit, fit, e);
    clear_unseen(to, edited);
    return {};
  }

  EditResult rename(const Edit& edit, const Fit& fit, EditedElement& e) {
    if (e.named != nullptr && e.element.kind == edit.to_kind) return {EditOutcome::repeated, {}};
    if (e.named != nullptr && edit.kind != e.element.kind) return contradicted(*e.named, edit, fit.facade);
    rename_opening(edit.to_kind, e.element);
    e.named = &edit;
    return {};
  }

  void clear_unseen(const Box2& box, EditedFacade& edited) const {
    std::erase_if(edited.elements, [&](const EditedElement& e) {
      if (!is_unseen_place(e.element)) return false;
      return common_area(box, e.now) > params_.same_area * area_of(e.now);
    });
  }

  bool alike(const Box2& a, const Box2& b) const {
    const auto same = [&](double p, double q) { return std::abs(p - q) <= params_.same_m; };
    return same(a.u0, b.u0) && same(a.u1, b.u1) && same(a.v0, b.v0) && same(a.v1, b.v1);
  }

  FacadeEditParams params_;
  bool invent_;
  std::vector<EditedFacade> facades_;
};

// The wall that a place lies on, the nearest of several.
std::optional<std::size_t> wall_at(Vec3 place, std::span<const WallGroup> walls, const FacadeEditParams& params) {
  std::optional<std::size_t> best;
  double nearest = params.plane_m;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const Vec3 d = params.metres_per_unit * (place - walls[i].axes.origin);
    const double u = dot(d, walls[i].axes.right), v = dot(d, walls[i].axes.up),
                 away = std::abs(dot(d, walls[i].axes.out));
    const double more = params.beyond_m;
    if (u < -more || u > walls[i].width + more || v < -more || v > walls[i].height + more) continue;
    if (away > nearest || (best && away == nearest)) continue;
    nearest = away;
    best = i;
  }
  return best;
}

}  // namespace

std::vector<EditResult> edit_facades(std::span<const Edit* const> edits, std::span<Facade* const> facades,
                                     const FacadeEditParams& params) {
  FacadeEditor editor(facades, params, false);
  std::vector<EditResult> results;
  for (const Edit* edit : edits)
    results.push_back(edit->action == EditAction::side ? EditResult{} : editor.make(*edit));
  editor.write();
  return results;
}

void check_facade_edits(std::span<const Edit> edits, double metres_per_unit) {
  FacadeEditParams params;
  params.metres_per_unit = metres_per_unit;
  std::vector<std::unique_ptr<Facade>> walls;
  FacadeEditor editor({}, params, true);
  for (const Edit* edit : edits_of(edits, "facades")) {
    if (edit->action == EditAction::side) continue;
    editor.invent_wall(*edit, walls);
    editor.make(*edit);
  }
}

std::vector<std::optional<std::size_t>> edit_sides(std::span<const Edit* const> edits, std::span<WallGroup> walls,
                                                   const FacadeEditParams& params) {
  std::vector<std::optional<std::size_t>> turned;
  std::vector<const Edit*> by(walls.size(), nullptr);
  for (const Edit* edit : edits) {
    turned.emplace_back();
    if (edit->action != EditAction::side) continue;
    const std::optional<std::size_t> at = wall_at(edit->at[0], walls, params);
    if (!at) continue;
    turned.back() = at;
    WallGroup& wall = walls[*at];
    const bool away = dot(edit->at[1] - wall.axes.origin, wall.axes.out) < 0;
    if (by[*at] != nullptr && away) refuse_contradiction(*by[*at], *edit);
    if (away) turn_wall(wall, params.metres_per_unit);
    by[*at] = edit;
    wall.side_odds = INFINITY;
  }
  return turned;
}

}  // namespace ilot
