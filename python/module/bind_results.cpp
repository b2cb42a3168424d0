// SPDX-License-Identifier: Apache-2.0
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "ilot/facades.h"
#include "ilot/planes.h"
#include "ilot/roofs.h"
#include "ilot/streets.h"
#include "python/module/arrays.h"
#include "python/module/bindings.h"

namespace ilot {

namespace {

py::dict attributes_of(const std::vector<std::pair<std::string, AttributeValue>>& attributes) {
  py::dict out;
  for (const auto& [name, value] : attributes) out[name.c_str()] = py::cast(value);
  return out;
}

py::list parts_of(const Outline& outline) {
  py::list parts;
  for (const Outline::Part& part : outline.parts) {
    py::list rings;
    for (const Outline::Ring& ring : part) rings.append(array_of(ring));
    parts.append(rings);
  }
  return parts;
}

py::list planes_python(const std::filesystem::path& folder) {
  PlaneSet set;
  {
    const py::gil_scoped_release released;
    set = read_planes(folder);
  }
  py::list out;
  for (std::size_t i = 0; i < set.segments.size(); ++i) {
    const Segment& s = set.segments[i];
    py::dict one;
    one["id"] = s.id;
    one["normal"] = tuple_of(s.plane.n);
    one["d"] = s.plane.d;
    one["points"] = s.points;
    one["centroid"] = tuple_of(s.centroid);
    one["rms_m"] = s.rms_m;
    one["epsilon_m"] = s.epsilon_m;
    one["area_m2"] = s.area_m2;
    one["confidence"] = s.confidence;
    one["outline"] = parts_of(set.outlines[i]);
    out.append(one);
  }
  return out;
}

constexpr const char* kSurfaceKinds[] = {"roof", "wall", "ground"};

py::list levels_of(const BuildingModel& model) {
  py::list levels;
  for (const Building& b : model.levels) {
    py::list surfaces;
    for (const BuildingSurface& s : b.surfaces)
      surfaces.append(py::make_tuple(kSurfaceKinds[static_cast<std::size_t>(s.kind)], s.rings));
    levels.append(py::make_tuple(b.lod, array_of(b.vertices), surfaces));
  }
  return levels;
}

py::list roofs_python(const std::filesystem::path& folder) {
  std::vector<BuildingModel> models;
  {
    const py::gil_scoped_release released;
    models = read_roofs(folder);
  }
  py::list out;
  for (const BuildingModel& m : models) out.append(py::make_tuple(m.id, attributes_of(m.attributes), levels_of(m)));
  return out;
}

constexpr const char* kStatus[] = {"seen", "completed", "occluded", "by hand"};

py::dict element_of(const FacadeElement& e) {
  py::dict one;
  one["id"] = e.id;
  one["kind"] = e.kind;
  one["opening"] = e.opening;
  one["family"] = e.family;
  one["row"] = e.row;
  one["column"] = e.column;
  one["status"] = kStatus[static_cast<std::size_t>(e.status)];
  one["reason"] = e.reason;
  one["ring"] = array_of(e.ring);
  std::vector<double> errors;
  py::list statuses;
  for (const FacadeEdge& edge : e.edges) {
    errors.push_back(edge.error_m);
    statuses.append(kStatus[static_cast<std::size_t>(edge.status)]);
  }
  one["edge_error_m"] = array_from(std::move(errors));
  one["edge_status"] = statuses;
  one["width_m"] = e.width_m;
  one["height_m"] = e.height_m;
  one["depth_m"] = e.depth_m;
  one["width_error_m"] = e.width_error_m;
  one["height_error_m"] = e.height_error_m;
  one["points"] = e.points;
  return one;
}

py::list facades_python(const std::filesystem::path& folder) {
  std::vector<Facade> facades;
  {
    const py::gil_scoped_release released;
    facades = read_facades(folder);
  }
  py::list out;
  for (const Facade& f : facades) {
    py::list elements;
    for (const FacadeElement& e : f.elements) elements.append(element_of(e));
    py::dict one;
    one["id"] = f.id;
    one["crs"] = f.crs;
    one["origin"] = tuple_of(f.origin);
    one["right"] = tuple_of(f.right);
    one["up"] = tuple_of(f.up);
    one["out"] = tuple_of(f.out);
    one["width_m"] = f.width_m;
    one["height_m"] = f.height_m;
    one["elements"] = elements;
    out.append(one);
  }
  return out;
}

py::dict object_of(const StreetObject& o) {
  py::dict one;
  one["id"] = o.id;
  one["label"] = o.class_name;
  one["probability"] = o.by_hand ? py::object(py::none()) : py::object(py::float_(o.probability));
  one["base"] = tuple_of(o.base);
  one["middle"] = tuple_of(o.middle);
  one["height_m"] = o.height_m;
  one["length_m"] = o.length_m;
  one["width_m"] = o.width_m;
  one["heading_deg"] = o.heading_deg;
  one["area_m2"] = o.area_m2;
  one["points"] = o.points;
  one["by_hand"] = o.by_hand;
  return one;
}

py::dict tree_of(const StreetTree& t) {
  py::dict one;
  one["id"] = t.id;
  one["position"] = tuple_of(t.position);
  one["trunk_seen"] = t.trunk_seen;
  one["height_m"] = t.height_m;
  one["crown_radius_m"] = t.crown_radius_m;
  one["crown_base_m"] = t.crown_base_m;
  one["trunk_radius_m"] = t.trunk_radius_m;
  one["unseen_share"] = t.unseen_share;
  one["points"] = t.points;
  return one;
}

py::dict kerb_of(const StreetKerb& k) {
  py::dict one;
  one["id"] = k.id;
  one["seen"] = k.seen;
  one["line"] = array_of(k.line);
  one["heights_m"] = array_from(std::vector<double>(k.heights_m));
  one["height_m"] = k.height_m;
  one["length_m"] = k.length_m;
  return one;
}

py::dict part_of(const FacadePart& p) {
  py::dict one;
  one["stretch"] = p.stretch;
  one["number"] = p.number;
  one["start"] = tuple_of(p.from);  // `from` is a word of Python
  one["end"] = tuple_of(p.to);
  one["length_m"] = p.length_m;
  one["height_m"] = p.height_m;
  return one;
}

py::dict width_of(const PavementWidth& w) {
  py::dict one;
  one["kerb"] = w.kerb;
  one["number"] = w.number;
  one["start"] = tuple_of(w.from);
  one["end"] = tuple_of(w.to);
  one["kerb_seen"] = w.kerb_seen;
  one["ends_at"] = pavement_end_name(w.end);
  one["width_m"] = w.width_m;
  one["error_m"] = w.error_m;
  one["passable_m"] = w.passable_m;
  one["passable_from_m"] = w.passable_from_m;
  one["unseen_share"] = w.unseen_share;
  one["road_m"] = w.road_m;
  return one;
}

py::dict pavement_of(const Pavement& p) {
  py::dict one;
  one["id"] = p.id;
  one["kerb"] = p.kerb;
  one["ring"] = array_of(p.ring);
  one["length_m"] = p.length_m;
  one["area_m2"] = p.area_m2;
  one["width_m"] = p.width_m;
  one["passable_m"] = p.passable_m;
  one["unseen_share"] = p.unseen_share;
  return one;
}

py::dict carriageway_of(const Carriageway& c) {
  py::dict one;
  one["id"] = c.id;
  one["ring"] = array_of(c.ring);
  py::list holes;
  for (const std::vector<Vec3>& hole : c.holes) holes.append(array_of(hole));
  one["holes"] = holes;
  one["area_m2"] = c.area_m2;
  one["width_m"] = c.width_m;
  one["narrowest_m"] = c.narrowest_m;
  one["seen_share"] = c.seen_share;
  return one;
}

template <typename Thing, typename ToDict>
py::list list_of(const std::vector<Thing>& things, const ToDict& to_dict) {
  py::list out;
  for (const Thing& thing : things) out.append(to_dict(thing));
  return out;
}

py::dict streets_python(const std::filesystem::path& folder) {
  StreetPlan plan;
  {
    const py::gil_scoped_release released;
    plan = read_streets(folder);
  }
  py::dict out;
  out["objects"] = list_of(plan.objects, object_of);
  out["trees"] = list_of(plan.trees, tree_of);
  out["kerbs"] = list_of(plan.kerbs, kerb_of);
  out["blocks"] = list_of(plan.blocks, part_of);
  out["gaps"] = list_of(plan.gaps, part_of);
  out["widths"] = list_of(plan.widths, width_of);
  out["pavements"] = list_of(plan.pavements, pavement_of);
  out["carriageways"] = list_of(plan.carriageways, carriageway_of);
  return out;
}

}  // namespace

void bind_results(py::module_& m) {
  m.def("read_planes", &planes_python, py::arg("folder"));
  m.def("read_roofs", &roofs_python, py::arg("folder"));
  m.def("read_facades", &facades_python, py::arg("folder"));
  m.def("read_streets", &streets_python, py::arg("folder"));
}

}  // namespace ilot
