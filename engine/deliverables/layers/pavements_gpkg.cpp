// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/layers/pavements_gpkg.h"

#include <array>
#include <initializer_list>

#include "engine/deliverables/layers/gpkg_file.h"

namespace ilot {

namespace {

constexpr std::array kEnds{"open", "unsure", "wall", "barrier", "step"};

void add_reals(OGRLayer& layer, std::initializer_list<const char*> names) {
  for (const char* name : names) GpkgFile::add_field(layer, name, OFTReal);
}

void add_area(GpkgFile& file, OGRLayer& areas, const Pavement& p) {
  OGRFeature feature(areas.GetLayerDefn());
  feature.SetField("pavement_id", static_cast<GIntBig>(p.id));
  feature.SetField("kerb_id", static_cast<GIntBig>(p.kerb));
  feature.SetField("length_m", p.length_m);
  feature.SetField("area_m2", p.area_m2);
  feature.SetField("width_m", p.width_m);
  feature.SetField("passable_m", p.passable_m);
  feature.SetField("unseen_share", p.unseen_share);
  OGRLinearRing ring;
  for (const Vec3& v : p.ring) ring.addPoint(v.x, v.y, v.z);
  ring.closeRings();
  OGRPolygon polygon;
  polygon.addRing(&ring);
  feature.SetGeometry(&polygon);
  file.add(areas, feature);
}

OGRLinearRing flat_ring(const std::vector<Vec3>& corners) {
  OGRLinearRing ring;
  for (const Vec3& v : corners) ring.addPoint(v.x, v.y);
  ring.closeRings();
  return ring;
}

void add_carriageway(GpkgFile& file, OGRLayer& roads, const Carriageway& c) {
  OGRFeature feature(roads.GetLayerDefn());
  feature.SetField("carriageway_id", static_cast<GIntBig>(c.id));
  feature.SetField("area_m2", c.area_m2);
  feature.SetField("width_m", c.width_m);
  feature.SetField("narrowest_m", c.narrowest_m);
  feature.SetField("seen_share", c.seen_share);
  OGRPolygon polygon;
  OGRLinearRing outer = flat_ring(c.ring);
  polygon.addRing(&outer);
  for (const std::vector<Vec3>& hole : c.holes) {
    OGRLinearRing inner = flat_ring(hole);
    polygon.addRing(&inner);
  }
  feature.SetGeometry(&polygon);
  file.add(roads, feature);
}

void add_width(GpkgFile& file, OGRLayer& widths, const PavementWidth& w) {
  OGRFeature feature(widths.GetLayerDefn());
  feature.SetField("kerb_id", static_cast<GIntBig>(w.kerb));
  feature.SetField("number", static_cast<GIntBig>(w.number));
  feature.SetField("kerb_seen", w.kerb_seen ? 1 : 0);
  feature.SetField("ends_at", name_of(w.end));
  // An open pavement has no width: it is at least as wide as ground was seen.
  feature.SetField(w.end == PavementEnd::open ? "at_least_m" : "width_m", w.width_m);
  if (w.error_m > 0) feature.SetField("error_m", w.error_m);
  feature.SetField("passable_m", w.passable_m);
  feature.SetField("passable_from_m", w.passable_from_m);
  feature.SetField("unseen_share", w.unseen_share);
  if (w.road_m > 0) feature.SetField("road_m", w.road_m);
  OGRLineString line;
  for (const Vec3& v : {w.from, w.to}) line.addPoint(v.x, v.y, v.z);
  feature.SetGeometry(&line);
  file.add(widths, feature);
}

void add_edge(GpkgFile& file, OGRLayer& edges, const StreetKerb& kerb, double metres_per_unit) {
  OGRFeature feature(edges.GetLayerDefn());
  feature.SetField("kerb_id", static_cast<GIntBig>(kerb.id));
  feature.SetField("seen", kerb.seen ? 1 : 0);
  feature.SetField("length_m", kerb.length_m);
  OGRLineString line;
  for (std::size_t i = 0; i < kerb.line.size(); ++i)
    line.addPoint(kerb.line[i].x, kerb.line[i].y, kerb.line[i].z - kerb.heights_m[i] / metres_per_unit);
  feature.SetGeometry(&line);
  file.add(edges, feature);
}

}  // namespace

const char* name_of(PavementEnd end) {
  return kEnds[static_cast<std::size_t>(end)];
}

std::optional<PavementEnd> pavement_end_named(std::string_view name) {
  for (std::size_t i = 0; i < kEnds.size(); ++i)
    if (name == kEnds[i]) return static_cast<PavementEnd>(i);
  return std::nullopt;
}

void write_pavements_gpkg(const std::filesystem::path& path, const StreetPlan& plan, double metres_per_unit,
                          const Crs& crs) {
  GpkgFile file(path);
  OGRLayer& areas = file.add_layer("pavements", wkbPolygon25D, crs);
  for (const char* name : {"pavement_id", "kerb_id"}) GpkgFile::add_field(areas, name, OFTInteger64);
  add_reals(areas, {"length_m", "area_m2", "width_m", "passable_m", "unseen_share"});
  OGRLayer& widths = file.add_layer("widths", wkbLineString25D, crs);
  for (const char* name : {"kerb_id", "number"}) GpkgFile::add_field(widths, name, OFTInteger64);
  GpkgFile::add_field(widths, "kerb_seen", OFTInteger, OFSTBoolean);
  GpkgFile::add_field(widths, "ends_at", OFTString);
  add_reals(widths, {"width_m", "error_m", "at_least_m", "passable_m", "passable_from_m", "unseen_share", "road_m"});
  OGRLayer& edges = file.add_layer("road_edges", wkbLineString25D, crs);
  GpkgFile::add_field(edges, "kerb_id", OFTInteger64);
  GpkgFile::add_field(edges, "seen", OFTInteger, OFSTBoolean);
  add_reals(edges, {"length_m"});
  OGRLayer& roads = file.add_layer("carriageways", wkbPolygon, crs);
  GpkgFile::add_field(roads, "carriageway_id", OFTInteger64);
  add_reals(roads, {"area_m2", "width_m", "narrowest_m", "seen_share"});
  file.set_style(areas, style_of_pavements());
  file.set_style(widths, style_of_pavement_widths());
  file.set_style(edges, style_of_road_edges());
  file.set_style(roads, style_of_carriageways());
  for (const Pavement& pavement : plan.pavements) add_area(file, areas, pavement);
  for (const PavementWidth& width : plan.widths) add_width(file, widths, width);
  for (const StreetKerb& kerb : plan.kerbs) add_edge(file, edges, kerb, metres_per_unit);
  for (const Carriageway& road : plan.carriageways) add_carriageway(file, roads, road);
  file.finish();
}

}  // namespace ilot
