// SPDX-License-Identifier: Apache-2.0
#include "scan/districts/district.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "kernels/core/union_find.h"

namespace ilot::scan {
namespace {

constexpr double kCellSide = 160;    // metres, approximately
constexpr double kStreetPitch = 50;  // metres from the axis of one street to the next
constexpr double kHalfStreet = 5;
constexpr double kMaxRise = 7;         // metres of a roof above its eaves
constexpr double kSameNormal = 0.966;  // cosine of 15 degrees
constexpr double kClearStep = 0.4;     // metres between nearly parallel roofs of neighbours

// A house with its faces while its row is being made.
struct Draft {
  HouseForm form;
  double eave_height = 0;  // above the foot of its terrace
  double setback = 3;      // from the street
  std::vector<Face> faces;
};

enum class Touch { apart, coplanar, doubtful };

// Compares two faces of adjoining houses. They are in one plane, clearly apart, or so close that they cannot be
// distinguished.
Touch compare(const Face& a, const Face& b) {
  if (a.surface != b.surface) return Touch::apart;
  const double cosine = dot(a.plane.n, b.plane.n);
  if (cosine < kSameNormal) return Touch::apart;
  double low = 1e9, high = -1e9;
  for (Vec3 p : b.ring) {
    const double distance = signed_distance(a.plane, p);
    low = std::min(low, distance);
    high = std::max(high, distance);
  }
  if (cosine > 1 - 1e-9 && std::max(std::abs(low), std::abs(high)) < 1e-6) return Touch::coplanar;
  return low > kClearStep || high < -kClearStep ? Touch::apart : Touch::doubtful;
}

bool doubtful(const Draft& a, const Draft& b) {
  for (const Face& fa : a.faces)
    for (const Face& fb : b.faces)
      if (compare(fa, fb) == Touch::doubtful || compare(fb, fa) == Touch::doubtful) return true;
  return false;
}

class CellBuilder {
 public:
  CellBuilder(const DistrictParams& params, const Ground& ground, Rect area, std::uint64_t index)
      : params_(params), ground_(ground), rng_(params.seed, mix64(index)) {
    cell_.area = area;
    centre_x_ = (area.x0 + area.x1) / 2;
    centre_y_ = (area.y0 + area.y1) / 2;
    inner_ = {area.x0 + params.clearance, area.y0 + params.clearance, area.x1 - params.clearance,
              area.y1 - params.clearance};
    heading_ = sin_cos_deg(90 * rng_.uniform());
  }

  Cell build() {
    const double reach = 0.75 * (cell_.area.x1 - cell_.area.x0);
    const int streets = static_cast<int>(reach / kStreetPitch) + 1;
    for (int street = -streets; street <= streets; ++street)
      for (int side : {-1, 1}) add_row(street * kStreetPitch, side, reach);
    number_planes();
    add_trees();
    return std::move(cell_);
  }

 private:
  double step(double from, double by, std::uint64_t choices) {
    return from + by * static_cast<double>(rng_.below(choices));
  }

  void add_row(double street, int side, double reach) {
    double u = -reach + 4 * rng_.uniform();
    while (u < reach) {
      const bool terrace = rng_.uniform() < params_.adjoining;
      const std::uint64_t houses = terrace ? 2 + rng_.below(4) : 1;
      u = add_group(street, side, u, houses) + step(3, 0.5, 11);
    }
  }

  // Adds houses that adjoin one another, starting at u. Returns where the last one ends.
  double add_group(double street, int side, double u, std::uint64_t houses) {
    std::optional<Draft> previous;
    double foot = 0;
    for (std::uint64_t i = 0; i < houses; ++i) {
      Draft draft = draw_house(houses > 1);
      if (previous && rng_.uniform() < 0.25) imitate(draft, *previous);
      place(draft, street, side, u);
      if (i == 0) foot = ground_.height(draft.form.x, draft.form.y);
      if (!choose_eave_height(draft, foot, previous)) break;
      u += draft.form.width;
      previous = accept(draft, previous.has_value()) ? std::optional(std::move(draft)) : std::nullopt;
    }
    return u;
  }

  Draft draw_house(bool in_terrace) {
    Draft draft;
    HouseForm& form = draft.form;
    form.heading = heading_;
    form.width = step(7, 0.5, 15);
    form.depth = step(8, 0.5, 9);
    draft.setback = step(3, 0.5, 3);
    draft.eave_height = step(3, 0.5, 13);
    const double shape = rng_.uniform();
    form.roof = shape < params_.flat                 ? RoofShape::flat
                : shape < params_.flat + params_.hip ? RoofShape::hip
                                                     : RoofShape::gable;
    form.ridge = in_terrace || rng_.uniform() < 0.7 ? Ridge::along_street : Ridge::across_street;
    form.pitch_deg = step(20, 5, 7);
    while (tan_deg(form.pitch_deg) * roof_span(form) / 2 > kMaxRise) form.pitch_deg -= 5;
    return draft;
  }

  // Makes the house like its neighbour, with the same walls and the same roof, so that each pair of faces is one plane.
  // Hips are not continued, because a hip has ends.
  static void imitate(Draft& draft, const Draft& model) {
    if (model.form.roof == RoofShape::hip) return;
    const double width = draft.form.width;
    draft.form = model.form;
    draft.form.width = width;
    draft.eave_height = model.eave_height;
    draft.setback = model.setback;
  }

  void place(Draft& draft, double street, int side, double u) const {
    const double along = u + draft.form.width / 2;
    const double across = street + side * (kHalfStreet + draft.setback + draft.form.depth / 2);
    draft.form.x = centre_x_ + along * heading_.cos - across * heading_.sin;
    draft.form.y = centre_y_ + along * heading_.sin + across * heading_.cos;
  }

  // Chooses the height of the eaves, starting at the drawn one, so that no roof nearly continues the roof of the
  // neighbour.
  bool choose_eave_height(Draft& draft, double foot, const std::optional<Draft>& previous) const {
    for (int attempt = 0; attempt < 13; ++attempt) {
      draft.form.eave = foot + draft.eave_height;
      draft.faces = house_faces(draft.form, ground_);
      if (!previous || !doubtful(*previous, draft)) return true;
      draft.eave_height = draft.eave_height < 9 ? draft.eave_height + 0.5 : 3;
    }
    return false;
  }

  // Adds the house to the cell if it is completely within the inner square.
  bool accept(const Draft& draft, bool adjoins) {
    for (const Face& face : draft.faces)
      for (Vec3 p : face.ring)
        if (p.x < inner_.x0 || p.y < inner_.y0 || p.x > inner_.x1 || p.y > inner_.y1) return false;
    const auto building = static_cast<std::uint32_t>(cell_.houses.size());
    const auto first = static_cast<std::uint32_t>(cell_.faces.size());
    cell_.houses.push_back(draft.form);
    cell_.solids.push_back(house_solid(draft.faces, first));
    adjoins_.push_back(adjoins);
    for (const Face& face : draft.faces) {
      cell_.faces.push_back(face);
      cell_.face_building.push_back(building);
    }
    return true;
  }

  // Faces of adjoining houses in one plane meet at their party wall, so they are one plane.
  void number_planes() {
    std::vector<std::uint32_t> parents(cell_.faces.size());
    UnionFind sets(parents);
    for (std::size_t house = 1; house < cell_.solids.size(); ++house) {
      if (!adjoins_[house]) continue;
      const ConvexSolid &before = cell_.solids[house - 1], &here = cell_.solids[house];
      for (std::uint32_t a = before.first_face; a < before.first_face + before.face_count; ++a)
        for (std::uint32_t b = here.first_face; b < here.first_face + here.face_count; ++b)
          if (compare(cell_.faces[a], cell_.faces[b]) == Touch::coplanar) sets.unite(a, b);
    }
    cell_.face_plane.resize(parents.size());
    for (std::uint32_t face = 0; face < parents.size(); ++face) {
      const std::uint32_t root = sets.find(face);
      cell_.face_plane[face] = root == face ? cell_.plane_count++ : cell_.face_plane[root];
    }
  }

  void add_trees() {
    const double width = inner_.x1 - inner_.x0, height = inner_.y1 - inner_.y0;
    if (width <= 8 || height <= 8) return;
    const double area = (cell_.area.x1 - cell_.area.x0) * (cell_.area.y1 - cell_.area.y0);
    const auto wanted = static_cast<std::size_t>(params_.trees * area / 1e4 + rng_.uniform());
    for (std::size_t attempt = 0; attempt < 4 * wanted && cell_.crowns.size() < wanted; ++attempt) {
      const double radius = 1.5 + 2 * rng_.uniform();
      const double top = 5 + 6 * rng_.uniform();
      const double half = top * (0.3 + 0.1 * rng_.uniform());
      const double x = inner_.x0 + radius + (width - 2 * radius) * rng_.uniform();
      const double y = inner_.y0 + radius + (height - 2 * radius) * rng_.uniform();
      if (tree_fits(x, y, radius))
        cell_.crowns.push_back({{x, y, ground_.height(x, y) + top - half}, {radius, radius, half}});
    }
  }

  bool tree_fits(double x, double y, double radius) const {
    for (const HouseForm& house : cell_.houses)
      if (distance_to_footprint(house, x, y) < radius + 0.5) return false;
    for (const Crown& other : cell_.crowns) {
      const double dx = x - other.centre.x, dy = y - other.centre.y, apart = radius + other.radii.x;
      if (dx * dx + dy * dy < apart * apart) return false;
    }
    return true;
  }

  const DistrictParams& params_;
  const Ground& ground_;
  Rng rng_;
  Cell cell_;
  Rect inner_;
  double centre_x_ = 0, centre_y_ = 0;
  SinCos heading_;
  std::vector<bool> adjoins_;  // for each house: whether it adjoins the one before it
};

}  // namespace

District::District(const DistrictParams& params) : params_(params) {
  cells_per_side_ = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(params.side / kCellSide + 0.5));
  const SinCos downhill = sin_cos_deg(360 * Rng(params.seed, 0).uniform() - 180);
  const double slope = params.slope_percent / 100;
  ground_ = {50 + slope * params.side, slope * downhill.cos, slope * downhill.sin};
}

Cell District::build_cell(std::uint64_t index) const {
  const auto n = static_cast<double>(cells_per_side_);
  const auto column = static_cast<double>(index % cells_per_side_), row = static_cast<double>(index / cells_per_side_);
  const Rect area{params_.side * column / n, params_.side * row / n, params_.side * (column + 1) / n,
                  params_.side * (row + 1) / n};
  return CellBuilder(params_, ground_, area, index + 1).build();
}

}  // namespace ilot::scan
