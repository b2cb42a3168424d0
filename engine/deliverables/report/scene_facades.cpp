// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/report/scene_facades.h"

#include <algorithm>
#include <cmath>

#include "engine/deliverables/report/packed.h"
#include "engine/model/stated_errors.h"

namespace ilot {
namespace {

using Json = nlohmann::ordered_json;

std::int64_t in_steps(double metres, double per_metre) {
  return std::isfinite(metres) ? std::llround(metres * per_metre) : 0;
}

Json centimetres(Vec3 scene) {
  return {in_steps(scene.x, 100), in_steps(scene.y, 100), in_steps(scene.z, 100)};
}

Json direction(Vec3 v) {
  constexpr double kPer = 1e5;
  return {std::round(v.x * kPer) / kPer, std::round(v.y * kPer) / kPer, std::round(v.z * kPer) / kPer};
}

double largest_error(const FacadeElement& element) {
  double error = 0;
  for (const FacadeEdge& edge : element.edges) error = std::max(error, edge.error_m);
  return error;
}

Json scene_element(const Facade& facade, const FacadeElement& e, double metres_per_unit) {
  Json ring = Json::array();
  for (const Vec3& corner : e.ring) {
    const Vec3 from = metres_per_unit * (corner - facade.origin);
    for (const Vec3& axis : {facade.right, facade.up, facade.out}) ring.push_back(in_steps(dot(from, axis), 100));
  }
  return {{"id", e.id},
          {"kind", e.kind},
          {"status", static_cast<int>(e.status)},
          {"opening", e.opening},
          {"at", {e.row, e.column, e.family}},
          {"mm", {in_steps(e.width_m, 1000), in_steps(e.height_m, 1000), in_steps(e.depth_m, 1000)}},
          {"error_mm",
           {in_steps(e.width_error_m, 1000), in_steps(e.height_error_m, 1000), in_steps(e.depth_error_m, 1000),
            in_steps(largest_error(e), 1000)}},
          {"points", e.points},
          {"reason", e.reason},
          {"ring", ring}};
}

Json scene_parts(const std::vector<FacadePart>& parts, const SceneFrame& frame) {
  Json list = Json::array();
  for (const FacadePart& part : parts) {
    const Vec3 from = frame.at(part.from), to = frame.at(part.to);
    list.push_back({part.stretch, part.number, in_steps(from.x, 100), in_steps(from.y, 100), in_steps(to.x, 100),
                    in_steps(to.y, 100), in_steps(part.length_m, 100), in_steps(part.height_m, 100)});
  }
  return list;
}

}  // namespace

Json scene_facade(const Facade& facade, const SceneFrame& frame) {
  Json elements = Json::array();
  for (const FacadeElement& e : facade.elements) elements.push_back(scene_element(facade, e, frame.metres_per_unit));
  return {{"id", facade.id},
          {"origin", centimetres(frame.at(facade.origin))},
          {"right", direction(facade.right)},
          {"up", direction(facade.up)},
          {"out", direction(facade.out)},
          {"size_mm", {in_steps(facade.width_m, 1000), in_steps(facade.height_m, 1000)}},
          {"error_mm", in_steps(seen_error_95(facade), 1000)},
          {"elements", elements}};
}

Json scene_street(const StreetPlan& plan, const SceneFrame& frame) {
  Json objects = Json::array();
  for (const StreetObject& o : plan.objects) {
    const Vec3 base = frame.at(o.base), middle = frame.at(o.middle);
    objects.push_back({o.id, static_cast<int>(o.label), in_steps(o.probability, 1000), in_steps(middle.x, 100),
                       in_steps(middle.y, 100), in_steps(base.z, 100), in_steps(o.height_m, 100),
                       in_steps(o.length_m, 100), in_steps(o.width_m, 100), in_steps(o.heading_deg, 10), o.points,
                       o.stretch, o.block});
  }
  return {{"objects", objects}, {"blocks", scene_parts(plan.blocks, frame)}, {"gaps", scene_parts(plan.gaps, frame)}};
}

Json scene_planes(const std::vector<Segment>& planes, const SceneFrame& frame) {
  Json columns{{"id", Json::array()},         {"points", Json::array()},    {"rms_um", Json::array()},
               {"epsilon_mm", Json::array()}, {"area_dm2", Json::array()},  {"confidence_pm", Json::array()},
               {"neighbours", Json::array()}, {"normal_e4", Json::array()}, {"centre_cm", Json::array()}};
  for (const Segment& s : planes) {
    columns["id"].push_back(s.id);
    columns["points"].push_back(s.points);
    columns["rms_um"].push_back(in_steps(s.rms_m, 1e6));
    columns["epsilon_mm"].push_back(in_steps(s.epsilon_m, 1000));
    columns["area_dm2"].push_back(in_steps(s.area_m2, 100));
    columns["confidence_pm"].push_back(in_steps(s.confidence, 1000));
    columns["neighbours"].push_back(s.neighbours);
    const Vec3 centre = frame.at(s.centroid);
    for (const double n : {s.plane.n.x, s.plane.n.y, s.plane.n.z}) columns["normal_e4"].push_back(in_steps(n, 1e4));
    for (const double c : {centre.x, centre.y, centre.z}) columns["centre_cm"].push_back(in_steps(c, 100));
  }
  return columns;
}

std::string packed_outlines(const LargestOutlines& outlines, const SceneFrame& frame) {
  std::string bytes;
  put_whole(bytes, outlines.outlines().size());
  for (const Outline& outline : outlines.outlines()) {
    put_whole(bytes, outline.plane_id);
    put_whole(bytes, outline.parts.size());
    std::array<std::int64_t, 3> last{};
    for (const auto& part : outline.parts) {
      put_whole(bytes, part.size());
      for (const auto& ring : part) {
        put_whole(bytes, ring.size());
        for (const Vec3& corner : ring) {
          const Vec3 at = frame.at(corner);
          const std::array<std::int64_t, 3> cm{in_steps(at.x, 100), in_steps(at.y, 100), in_steps(at.z, 100)};
          for (std::size_t i = 0; i < 3; ++i) put_signed(bytes, cm[i] - last[i]);
          last = cm;
        }
      }
    }
  }
  return bytes;
}

}  // namespace ilot
