// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/facade_proofs.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/pass/pass.h"
#include "engine/pass/resident.h"
#include "engine/products/facades/elements/facade_elements.h"
#include "engine/proof/facade_proof.h"
#include "engine/proof/facade_sight.h"

namespace ilot {
namespace {

// Choice: about 100,000 points a task; time and memory alone depend on it.
constexpr double kStrip = 4;                    // metres along a wall that one task reads
constexpr std::uint64_t kStripBytes = 4 << 20;  // memory of one task
// Choice: the width of kForemostSheet: nearer surfaces cannot be separated.
constexpr double kReach = 0.03;  // metres, at least: smaller relief cannot be separated from the wall
// Derived: an edge is known to one step; two contain the nearest points on either side of it.
constexpr double kEdgeSteps = 2;  // steps of the scan around an edge, at least

struct Strip {
  std::size_t facade = 0;
  double from = 0, to = 0;  // values of u: `from` is included, `to` is not
};

FacadeProofParams proof_params(const WallGroup& wall, double metres_per_unit) {
  const double step = std::sqrt(wall.area_m2 / static_cast<double>(wall.points));
  return {std::max(kReach, epsilon_of(wall)), std::max(kReach, kEdgeSteps * step), metres_per_unit};
}

std::vector<Strip> strips_of(std::span<const FoundFacade> found, std::span<const WallGroup> walls, double beside) {
  std::vector<Strip> strips;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto count = static_cast<std::size_t>(walls[i].width / kStrip) + 1;
    const double width = walls[i].width / static_cast<double>(count);
    for (std::size_t k = 0; k < count; ++k)
      strips.push_back({i, k == 0 ? -beside : static_cast<double>(k) * width,
                        k + 1 == count ? walls[i].width + beside : static_cast<double>(k + 1) * width});
  }
  return strips;
}

// The box around a strip of a wall, in CRS units.
Box3<Vec3> box_of(const FacadeWork& work, const WallGroup& wall, const Strip& strip) {
  auto box = Box3<Vec3>::none();
  const double units = 1 / work.metres_per_unit;
  const FacadeAxes& axes = wall.axes;
  for (const double u : {strip.from, strip.to})
    for (const double v : {-work.beside, wall.height + std::max(work.beside, wall.above)})
      for (const double w : {-work.behind, work.before}) {
        const Vec3 p = axes.origin + units * (u * axes.right + v * axes.up + w * axes.out);
        box.add(p);
      }
  return box;
}

ProofTally tally_of(const FacadeWork& work, const WallGroup& wall, const Strip& strip, const Facade& facade,
                    const FacadeProof& proof) {
  ProofTally tally = proof.no_points();
  const double m = work.metres_per_unit;
  const Vec3 from_wall = m * (wall.axes.origin - facade.origin);  // corners may have moved the facade's origin
  const double shift = dot(from_wall, facade.right);
  std::vector<Vec3> places;
  points_around(work, wall)(box_of(work, wall, strip), [&](std::span<const ImagePoint> points) {
    places.clear();
    for (const ImagePoint& p : points) {
      const Vec3 d = m * (p.position - facade.origin);
      const Vec3 at{dot(d, facade.right), dot(d, facade.up), dot(d, facade.out)};
      if (at.x - shift >= strip.from && at.x - shift < strip.to && at.z >= -work.behind && at.z <= work.before)
        places.push_back(at);
    }
    proof.add(places, tally);
  });
  return tally;
}

// Everything that may stand between a station and a facade, face by face.
void for_each_obstacle(std::span<const FoundFacade> found, std::span<const Outline> outlines, double metres_per_unit,
                       const std::function<void(const SectionFace&)>& visit) {
  for (const Outline& outline : outlines)
    for (const Outline::Part& part : outline.parts) visit({part});
  for (const FoundFacade& f : found)
    for (const SurfaceFace& face : facade_surfaces(f.facade, metres_per_unit)) {
      SectionFace flat{{{}}};
      for (const Vec3& p : face.corners)
        flat.rings[0].push_back(f.facade.origin + (1 / metres_per_unit) *
                                                      (p.x * f.facade.right + p.y * f.facade.up + p.z * f.facade.out));
      visit(flat);
    }
}

// Counts the points of some facades; `proofs`: theirs.
void count_points_of(const FacadeWork& work, std::span<const WallGroup> walls, std::span<FoundFacade> found,
                     std::span<const FacadeProof> proofs, const PassContext& context) {
  const std::vector<Strip> strips = strips_of(found, walls, work.beside);
  std::vector<ProofTally> parts(strips.size()), tallies;
  const std::vector<PassTask> tasks(strips.size(), PassTask{kStripBytes, 0});
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    const Strip& strip = strips[i];
    parts[i] = tally_of(work, walls[strip.facade], strip, found[strip.facade].facade, proofs[strip.facade]);
  });
  for (const FacadeProof& proof : proofs) tallies.push_back(proof.no_points());
  for (std::size_t i = 0; i < strips.size(); ++i) tallies[strips[i].facade].add(parts[i]);
  for (std::size_t i = 0; i < found.size(); ++i) proofs[i].write(tallies[i], found[i].facade);
}

// As many facades at once as a share of the budget holds the proofs of.
void count_points(const FacadeWork& work, std::span<const WallGroup> walls, std::span<FoundFacade> found,
                  const PassContext& context) {
  for (std::size_t first = 0; first < found.size();) {
    std::vector<FacadeProof> proofs;
    std::uint64_t bytes = 0;
    for (std::size_t i = first; i < found.size() && (proofs.empty() || bytes < context.budget_bytes / 8); ++i) {
      proofs.emplace_back(found[i].facade, proof_params(walls[i], work.metres_per_unit));
      bytes += proofs.back().bytes();
    }
    count_points_of(work, walls.subspan(first, proofs.size()), found.subspan(first, proofs.size()), proofs, context);
    first += proofs.size();
  }
}

// The sides of an element: its edges, but the chords of a head between the two jambs are one side.
std::vector<std::span<FacadeEdge>> sides_of(FacadeElement& e) {
  const std::span<FacadeEdge> edges(e.edges);
  std::vector<std::span<FacadeEdge>> sides;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const bool head = e.opening && edges.size() > 4 && i == 2;
    sides.push_back(edges.subspan(i, head ? edges.size() - 3 : 1));
    i += sides.back().size() - 1;
  }
  return sides;
}

// Recesses and what stands out, but for the steps between two walls, which are as well known as the outline of the
// other wall and have no error of depth.
bool is_relief_of_its_own(const FacadeElement& e) {
  return (e.kind == "recess" || e.kind == "protrusion") && e.depth_error_m > 0 && e.edges.size() == 4 &&
         e.ring.size() == e.edges.size();
}

// Whether points lie along less than half of the outline of an element, and along half of only one of its sides or of
// none.
bool is_hardly_seen(const FacadeElement& e) {
  // Choice: half of it; a side of which less was seen is `weak` in the evidence too.
  constexpr double kHalf = 0.5;
  double length = 0, covered = 0;
  int sides = 0;
  for (std::size_t i = 0; i < e.edges.size(); ++i) {
    const Vec3 along = e.ring[(i + 1) % e.ring.size()] - e.ring[i];
    const double share = e.edges[i].points > 0 ? e.edges[i].covered_share : 0;
    length += std::sqrt(dot(along, along)), covered += share * std::sqrt(dot(along, along));
    sides += share >= kHalf;
  }
  return sides < 2 && covered < kHalf * length;
}

}  // namespace

void mark_bare_sides(FoundFacade& found, double reach) {
  for (FacadeElement& e : found.facade.elements) {
    const bool relief = is_relief_of_its_own(e);
    if ((!e.opening && e.kind != "outline" && !relief) || e.status != DrawnStatus::seen) continue;
    std::size_t bare = 0, seen = 0;
    for (const std::span<FacadeEdge> side : sides_of(e)) {
      const auto has_points = [](const FacadeEdge& edge) { return edge.points > 0; };
      if (side.front().status == DrawnStatus::seen && std::none_of(side.begin(), side.end(), has_points)) {
        for (FacadeEdge& edge : side) {
          edge.status = DrawnStatus::occluded;
          edge.error_m = std::max(edge.error_m, reach);
        }
        ++bare;
      }
      seen += side.front().status != DrawnStatus::occluded;
    }
    const bool hardly = relief && is_hardly_seen(e);
    if (hardly) e.status = DrawnStatus::completed;  // its face may have thousands of points
    const auto add_reason = [&](const char* words) { e.reason += (e.reason.empty() ? "" : "; ") + std::string(words); };
    if (hardly) add_reason("points lie along too little of its sides");
    if (bare == 0) continue;
    if (e.kind != "outline") state_size_errors(e);
    found.occluded_edges += bare;
    if (seen == 0 && e.kind != "outline") e.status = DrawnStatus::occluded;
    add_reason("no point lies along a side of it");
  }
}

void prove_facades(const FacadeWork& work, std::span<const WallGroup> walls, std::span<const Outline> outlines,
                   std::vector<FoundFacade>& found, const PassContext& context) {
  count_points(work, walls, found, context);
  for (std::size_t i = 0; i < found.size(); ++i)
    mark_bare_sides(found[i], proof_params(walls[i], work.metres_per_unit).edge_reach_m);
  if (work.stations.empty()) return;
  trim_memory();
  const LineOfSight sight = LineOfSight::past([&](const std::function<void(const SectionFace&)>& visit) {
    for_each_obstacle(found, outlines, work.metres_per_unit, visit);
  });
  for (std::size_t i = 0; i < found.size(); ++i) {
    FacadeSightParams params;
    params.margin_m = 2 * epsilon_of(walls[i]);
    params.metres_per_unit = work.metres_per_unit;
    measure_sight(work.stations, sight, params, found[i].facade);
  }
}

}  // namespace ilot
