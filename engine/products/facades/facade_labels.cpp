// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/facade_labels.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "engine/columns/stations_pass.h"
#include "engine/pass/pass.h"

namespace ilot {
namespace {

constexpr std::uint64_t kBytesPerPoint = 24;
// Choice: a bin has some tens of entries; time alone depends on it.
constexpr double kBin = 0.5;  // metres
// Choice: cornices and bays reach so far beyond the ends of a wall; farther ones give no labels there.
constexpr double kBeside = 0.5;  // metres around the wall that elements may cover
constexpr std::uint32_t kNoStation = UINT32_MAX;

PointLabel label_of_kind(const std::string& kind) {
  static const std::map<std::string, PointLabel> labels{{"window", PointLabel::window},
                                                        {"opening", PointLabel::window},
                                                        {"door", PointLabel::door},
                                                        {"sill", PointLabel::sill},
                                                        {"balcony", PointLabel::balcony}};
  const auto found = labels.find(kind);
  return found == labels.end() ? PointLabel::facade : found->second;
}

struct FlatCircle {
  double u = 0, v = 0, radius = 0;
};

// An element as a rectangle in the axes of the wall, in metres.
struct Part {
  std::uint32_t element = 0;
  PointLabel label = PointLabel::facade;
  bool opening = false;
  Box2 box;
  double depth = 0, margin = 0;  // depth of its front; margin beside it
  std::vector<FlatCircle> arcs;  // of a round or pointed top: it is within all of them

  bool contains(Place2 p) const {
    if (!box.grown(margin).contains(p)) return false;
    return std::all_of(arcs.begin(), arcs.end(), [&](const FlatCircle& arc) {
      const double u = p.u - arc.u, v = p.v - arc.v;
      if (v <= 0 || std::abs(u) > arc.radius) return true;
      return u * u + v * v <= (arc.radius + margin) * (arc.radius + margin);
    });
  }
};

// The elements of one facade, ordered by place.
class LabelledFacade {
 public:
  LabelledFacade(const FacadeWork& work, const WallGroup& wall, const Facade& facade)
      : axes_(work, wall), id_(facade.id), width_(wall.width), height_(wall.height), epsilon_(epsilon_of(wall)) {
    columns_ = static_cast<std::size_t>((width_ + 2 * kBeside) / kBin) + 1;
    rows_ = static_cast<std::size_t>((height_ + 2 * kBeside) / kBin) + 1;
    bins_.resize(columns_ * rows_);
    for (const FacadeElement& e : facade.elements) {
      if (e.kind == "outline") outline_ = outline_ == 0 ? e.id : outline_;
      if (e.kind == "outline" || e.status == DrawnStatus::occluded) continue;
      add(part_of(facade, e, work.metres_per_unit));
    }
    for (auto& bin : bins_)  // the smallest first: a sill before the band that it stands on
      std::sort(bin.begin(), bin.end(), [&](std::uint32_t a, std::uint32_t b) {
        const double p = area(a), q = area(b);
        return p != q ? p < q : parts_[a].element < parts_[b].element;
      });
    for (std::size_t s = 0; s < work.stations.size(); ++s) eyes_.push_back(axes_.of_place(work.stations[s]));
    front_ = work.before;
    behind_ = work.behind;
  }

  static std::uint64_t bytes_of(const WallGroup& wall, const Facade& facade) {
    // Derived: sizes of the structures, rounded up; a bound of memory.
    constexpr double kBinBytes = 40, kPartBytes = 400;  // each part with its entries in bins
    const double bins = ((wall.width + 2 * kBeside) / kBin + 1) * ((wall.height + 2 * kBeside) / kBin + 1);
    return static_cast<std::uint64_t>(kBinBytes * bins + kPartBytes * static_cast<double>(facade.elements.size()));
  }

  // `station` is an index into the stations of the work; kNoStation: the station is not known.
  FacadeLabel of(Index3 place, std::uint32_t station) const {
    const Vec3 p = axes_.of(place);
    if (!(p.x >= -kBeside && p.x <= width_ + kBeside && p.y >= -kBeside && p.y <= height_ + kBeside &&
          p.z >= -behind_ && p.z <= front_))
      return {};
    if (p.z < -epsilon_) return behind(p, station);
    for (const std::uint32_t i : bin({p.x, p.y})) {
      const Part& part = parts_[i];
      if (part.opening || !part.contains({p.x, p.y}) || p.z > std::max(part.depth, 0.0) + epsilon_) continue;
      if (p.z > epsilon_ || part.depth <= epsilon_) return label(part);
    }
    return p.z <= epsilon_ ? wall(p) : FacadeLabel{};
  }

 private:
  static Part part_of(const Facade& facade, const FacadeElement& e, double metres) {
    Part part;
    part.element = e.id;
    part.label = label_of_kind(e.kind);
    part.opening = e.opening;
    part.box = {INFINITY, -INFINITY, INFINITY, -INFINITY};
    for (const Vec3& corner : e.ring) {
      const double u = metres * dot(corner - facade.origin, facade.right);
      const double v = metres * dot(corner - facade.origin, facade.up);
      part.box = {std::min(part.box.u0, u), std::max(part.box.u1, u), std::min(part.box.v0, v),
                  std::max(part.box.v1, v)};
      if (!e.opening) part.depth = std::max(part.depth, metres * dot(corner - facade.origin, facade.out));
    }
    for (const FacadeEdge& edge : e.edges)
      if (edge.status == DrawnStatus::seen) part.margin = std::max(part.margin, edge.error_m);
    part.margin = std::min(part.margin, kMostMargin);
    for (const FacadeArc& arc : e.arcs)
      part.arcs.push_back({metres * dot(arc.centre - facade.origin, facade.right),
                           metres * dot(arc.centre - facade.origin, facade.up), metres * arc.radius_m});
    return part;
  }

  void add(const Part& part) {
    const Box2 box = part.box.grown(part.margin);
    const std::size_t low = index({box.u0, box.v0}), high = index({box.u1, box.v1});
    for (std::size_t r = low / columns_; r <= high / columns_; ++r)
      for (std::size_t c = low % columns_; c <= high % columns_; ++c)
        bins_[r * columns_ + c].push_back(static_cast<std::uint32_t>(parts_.size()));
    parts_.push_back(part);
  }
  double area(std::uint32_t i) const { return parts_[i].box.width() * parts_[i].box.height(); }
  std::size_t index(Place2 p) const {
    const auto at = [](double v, std::size_t count) {
      return static_cast<std::size_t>(std::clamp((v + kBeside) / kBin, 0.0, static_cast<double>(count - 1)));
    };
    return at(p.v, rows_) * columns_ + at(p.u, columns_);
  }
  const std::vector<std::uint32_t>& bin(Place2 p) const { return bins_[index(p)]; }
  FacadeLabel label(const Part& part) const { return {part.element, static_cast<std::uint16_t>(id_), part.label}; }
  FacadeLabel behind(const Vec3& p, std::uint32_t station) const {
    Place2 crossing{p.x, p.y};
    if (station != kNoStation) {
      const Vec3& eye = eyes_[station];
      if (!(eye.z > 0)) return {};
      const double along = eye.z / (eye.z - p.z);
      crossing = {eye.x + (p.x - eye.x) * along, eye.y + (p.y - eye.y) * along};
    }
    for (const std::uint32_t i : bin(crossing))
      if (parts_[i].opening && parts_[i].contains(crossing)) return label(parts_[i]);
    return p.z > -kJoint ? wall(p) : FacadeLabel{};
  }
  FacadeLabel wall(const Vec3& p) const {
    const bool inside = p.x >= 0 && p.x <= width_ && p.y >= 0 && p.y <= height_;
    return inside ? FacadeLabel{outline_, static_cast<std::uint16_t>(id_), PointLabel::facade} : FacadeLabel{};
  }

  // Choice: twice the depth of joints of 2 cm; the backs of deeper joints get no stone.
  static constexpr double kJoint = 0.04;  // metres behind the wall, where joints of stone end
  // Choice: the error of a drawn edge; wider margins would take points of the wall.
  static constexpr double kMostMargin = 0.02;  // metres
  LatticeAxes axes_;
  std::uint32_t id_, outline_ = 0;
  double width_, height_, epsilon_, front_ = 0, behind_ = 0;
  std::size_t columns_ = 0, rows_ = 0;
  std::vector<Part> parts_;
  std::vector<std::vector<std::uint32_t>> bins_;  // indices of parts, per bin
  std::vector<Vec3> eyes_;
};

// The numbers of the facades that may label points of a block.
using Numbers = std::vector<std::uint32_t>;

void label_block(const FacadeWork& work, std::uint32_t block, const Numbers& numbers, std::span<const WallGroup> walls,
                 std::span<const FoundFacade> found, const PassContext& context) {
  std::vector<LabelledFacade> facades;
  for (const std::uint32_t f : numbers) facades.emplace_back(work, walls[f], found[f].facade);
  const auto codes = work.store.read(block, columns::kCodes);
  std::vector<StationNumber> stations;
  if (work.recorded) stations = work.store.read(block, columns::kStation);
  const std::uint32_t only = work.stations.size() == 1 ? 0 : kNoStation;
  std::vector<FacadeLabel> labels(codes.size());
  for (std::size_t i = 0; i < codes.size(); ++i) {
    const Index3 at = index_of({work.store.blocks()[block].node.tile, codes[i]});
    if (context.wanted && !context.wanted(at)) continue;
    const std::uint32_t station = work.recorded && stations[i] != 0 ? stations[i] - 1u : only;
    for (const LabelledFacade& facade : facades) {
      labels[i] = facade.of(at, station);
      if (labels[i].facade != 0) break;
    }
  }
  work.store.write(block, columns::kFacade, labels);
}

}  // namespace

void write_facade_labels(const FacadeWork& work, std::span<const WallGroup> walls, std::span<const FoundFacade> found,
                         const PassContext& context) {
  constexpr std::size_t kMost = 65535;
  std::vector<Numbers> of_block(work.store.blocks().size());
  std::vector<std::uint64_t> bytes(of_block.size(), 0);
  for (std::size_t i = 0; i < std::min(walls.size(), kMost); ++i)
    for (const std::uint32_t block : work.store.blocks_in(box_around(work, walls[i]))) {
      of_block[block].push_back(static_cast<std::uint32_t>(i));
      bytes[block] += LabelledFacade::bytes_of(walls[i], found[i].facade);
    }
  std::vector<PassTask> tasks;
  for (std::size_t b = 0; b < bytes.size(); ++b) {
    const std::uint64_t points = work.store.blocks()[b].points;
    tasks.push_back({points * kBytesPerPoint + bytes[b], points});
  }
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    label_block(work, static_cast<std::uint32_t>(i), of_block[i], walls, found, context);
  });
}

ProductLabels facade_labels() {
  ProductLabels labels = product_labels<FacadeLabel>(
      [](const Store& store, std::uint32_t block) { return store.read(block, columns::kFacade); }, columns::kFacadeRows,
      [](const FacadeLabel& l) {
        return PointClass{l.label, l.facade != 0};
      },
      {label_field<FacadeLabel>(FieldPlace::facade, "facade_id", "0 = none",
                                [](const FacadeLabel& l) { return l.facade; }),
       label_field<FacadeLabel>(FieldPlace::facade, "element_id", "on its facade, 0 = none",
                                [](const FacadeLabel& l) { return l.element; })});
  labels.gives_classes = true;
  return labels;
}

}  // namespace ilot
