// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/layers/gpkg_readers.h"

#include <cpl_conv.h>
#include <ogrsf_frmts.h>

#include <string>

#include "engine/deliverables/layers/pavements_gpkg.h"
#include "engine/error.h"
#include "engine/model/point_label.h"

namespace ilot {
namespace {

void say_nothing(CPLErr, CPLErrorNum, const char*) {}

// One of our own files, read layer by layer.
class LayerFile {
 public:
  explicit LayerFile(const std::filesystem::path& path) : path_(path) {
    CPLSetErrorHandler(say_nothing);
    RegisterOGRGeoPackage();
    CPLErrorReset();
    const char* drivers[] = {"GPKG", nullptr};
    file_.reset(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, drivers));
    if (!file_) fail(CPLGetLastErrorMsg());
  }

  bool has(const char* name) const { return file_->GetLayerByName(name) != nullptr; }

  // Calls use(feature, geometry) for each feature, in the file's order.
  template <class Use>
  void for_each(const char* name, const Use& use) {
    OGRLayer* layer = file_->GetLayerByName(name);
    if (layer == nullptr) fail(std::string("has no layer '") + name + "'");
    for (const OGRFeatureUniquePtr& feature : layer) {
      const OGRGeometry* geometry = feature->GetGeometryRef();
      if (geometry == nullptr) fail(std::string("layer '") + name + "': a feature has no geometry");
      use(*feature, *geometry);
    }
  }

  [[noreturn]] void fail(const std::string& what) const { throw Error(path_.string() + ": cannot be read: " + what); }

  // Returns a whole number of a feature; 0 when it is not set.
  std::uint64_t whole(const OGRFeature& feature, const char* name) const {
    const int field = feature.GetFieldIndex(name);
    if (field < 0) fail(std::string("has no column '") + name + "'");
    return feature.IsFieldSetAndNotNull(field) ? static_cast<std::uint64_t>(feature.GetFieldAsInteger64(field)) : 0;
  }

  std::uint32_t number(const OGRFeature& feature, const char* name) const {
    return static_cast<std::uint32_t>(whole(feature, name));
  }

  double real(const OGRFeature& feature, const char* name) const {
    const int field = feature.GetFieldIndex(name);
    if (field < 0) fail(std::string("has no column '") + name + "'");
    return feature.GetFieldAsDouble(field);
  }

 private:
  std::filesystem::path path_;
  GDALDatasetUniquePtr file_;
};

Outline::Ring open_ring(const OGRLinearRing& ring) {
  Outline::Ring vertices;
  for (int i = 0; i + 1 < ring.getNumPoints(); ++i) vertices.push_back({ring.getX(i), ring.getY(i), ring.getZ(i)});
  return vertices;
}

std::vector<Outline::Part> parts_of(const LayerFile& file, const OGRGeometry& geometry) {
  if (wkbFlatten(geometry.getGeometryType()) != wkbMultiPolygon) file.fail("an outline is no MultiPolygon");
  std::vector<Outline::Part> parts;
  for (const OGRPolygon* polygon : *geometry.toMultiPolygon()) {
    parts.emplace_back();
    for (const OGRLinearRing* ring : *polygon) parts.back().push_back(open_ring(*ring));
  }
  return parts;
}

// The label of an object's class. A class of one's own has it in a column; runs of earlier versions have neither.
PointLabel label_of(const LayerFile& file, const OGRFeature& feature, const std::string& name) {
  if (const auto known = label_named(name)) return *known;
  const std::uint64_t label = feature.GetFieldIndex("label") < 0 ? 0 : file.whole(feature, "label");
  if (label < kFirstOwnLabel || label >= kFirstOwnLabel + kMostOwnClasses)
    file.fail("there is no class '" + name + "'");
  return static_cast<PointLabel>(label);
}

Vec3 place_of(const OGRPoint& point) {
  return {point.getX(), point.getY(), point.getZ()};
}

std::vector<FacadePart> parts_of_layer(LayerFile& file, const char* layer) {
  std::vector<FacadePart> parts;
  file.for_each(layer, [&](const OGRFeature& feature, const OGRGeometry& geometry) {
    if (wkbFlatten(geometry.getGeometryType()) != wkbLineString || geometry.toLineString()->getNumPoints() < 2)
      file.fail("a block is no line");
    OGRPoint from, to;
    geometry.toLineString()->StartPoint(&from);
    geometry.toLineString()->EndPoint(&to);
    parts.push_back({file.number(feature, "stretch"), file.number(feature, "number"), place_of(from), place_of(to),
                     file.real(feature, "length_m"), file.real(feature, "height_m")});
  });
  return parts;
}

}  // namespace

void for_each_plane_outline(const std::filesystem::path& path,
                            const std::function<void(const Outline&, double area_m2)>& use) {
  LayerFile file(path);
  file.for_each("planes", [&](const OGRFeature& feature, const OGRGeometry& geometry) {
    use({file.number(feature, "plane_id"), parts_of(file, geometry)}, file.real(feature, "area_m2"));
  });
}

std::vector<Outline> read_planes_gpkg(const std::filesystem::path& path) {
  std::vector<Outline> outlines;
  for_each_plane_outline(path, [&](const Outline& outline, double) { outlines.push_back(outline); });
  return outlines;
}

std::vector<StreetObject> read_objects_gpkg(const std::filesystem::path& path) {
  LayerFile file(path);
  std::vector<StreetObject> objects;
  file.for_each("objects", [&](const OGRFeature& feature, const OGRGeometry& geometry) {
    if (wkbFlatten(geometry.getGeometryType()) != wkbPoint) file.fail("the place of an object is no point");
    StreetObject o;
    o.id = file.number(feature, "object_id");
    o.class_name = feature.GetFieldAsString("class");
    o.label = label_of(file, feature, o.class_name);
    o.by_hand = feature.GetFieldIndex("by_hand") >= 0 && file.number(feature, "by_hand") != 0;
    o.probability = o.by_hand ? 1 : file.real(feature, "probability");
    o.base = o.middle = place_of(*geometry.toPoint());
    o.height_m = file.real(feature, "height_m");
    o.length_m = file.real(feature, "length_m");
    o.width_m = file.real(feature, "width_m");
    o.heading_deg = file.real(feature, "heading_deg");
    o.area_m2 = file.real(feature, "area_m2");
    o.points = file.whole(feature, "points");
    o.stretch = file.number(feature, "stretch");
    o.block = file.number(feature, "block");
    objects.push_back(o);
  });
  std::size_t next = 0;  // the extents follow in the same order
  file.for_each("extents", [&](const OGRFeature& feature, const OGRGeometry& geometry) {
    if (next >= objects.size() || objects[next].id != file.number(feature, "object_id"))
      file.fail("the layers 'objects' and 'extents' do not agree");
    OGREnvelope box;
    geometry.getEnvelope(&box);  // of a rectangle, so their middles are the same
    StreetObject& o = objects[next++];
    o.middle.x = (box.MinX + box.MaxX) / 2;
    o.middle.y = (box.MinY + box.MaxY) / 2;
  });
  return objects;
}

std::vector<StreetKerb> read_kerbs_gpkg(const std::filesystem::path& path) {
  LayerFile file(path);
  std::vector<StreetKerb> kerbs;
  file.for_each("kerbs", [&](const OGRFeature& feature, const OGRGeometry& geometry) {
    if (wkbFlatten(geometry.getGeometryType()) != wkbLineString) file.fail("a kerb is no line");
    StreetKerb k;
    k.id = file.number(feature, "kerb_id");
    k.seen = file.number(feature, "seen") != 0;
    k.height_m = file.real(feature, "height_m");
    k.length_m = file.real(feature, "length_m");
    for (const OGRPoint& p : *geometry.toLineString()) k.line.push_back(place_of(p));
    k.heights_m.assign(k.line.size(), k.height_m);
    kerbs.push_back(std::move(k));
  });
  file.for_each("heights", [&](const OGRFeature& feature, const OGRGeometry&) {
    const std::uint64_t kerb = file.whole(feature, "kerb_id"), vertex = file.whole(feature, "vertex");
    if (kerb < 1 || kerb > kerbs.size() || vertex < 1 || vertex > kerbs[kerb - 1].heights_m.size())
      file.fail("the layers 'kerbs' and 'heights' do not agree");
    kerbs[kerb - 1].heights_m[vertex - 1] = file.real(feature, "height_m");
  });
  return kerbs;
}

std::vector<PavementWidth> read_pavement_widths(const std::filesystem::path& path) {
  LayerFile file(path);
  std::vector<PavementWidth> widths;
  file.for_each("widths", [&](const OGRFeature& feature, const OGRGeometry& geometry) {
    if (wkbFlatten(geometry.getGeometryType()) != wkbLineString || geometry.toLineString()->getNumPoints() != 2)
      file.fail("a width of a pavement is no line");
    OGRPoint from, to;
    geometry.toLineString()->StartPoint(&from);
    geometry.toLineString()->EndPoint(&to);
    PavementWidth w;
    w.kerb = file.number(feature, "kerb_id"), w.number = file.number(feature, "number");
    w.from = place_of(from), w.to = place_of(to);
    w.kerb_seen = file.number(feature, "kerb_seen") != 0;
    const std::string end = feature.GetFieldAsString("ends_at");
    const auto named = pavement_end_named(end);
    if (!named) file.fail("a pavement ends at '" + end + "'");
    w.end = *named;
    w.width_m = file.real(feature, w.end == PavementEnd::open ? "at_least_m" : "width_m");
    w.error_m = file.real(feature, "error_m");
    w.passable_m = file.real(feature, "passable_m");
    w.passable_from_m = file.real(feature, "passable_from_m");
    w.unseen_share = file.real(feature, "unseen_share");
    w.road_m = file.real(feature, "road_m");
    widths.push_back(w);
  });
  return widths;
}

std::vector<Pavement> read_pavements_gpkg(const std::filesystem::path& path) {
  LayerFile file(path);
  std::vector<Pavement> pavements;
  file.for_each("pavements", [&](const OGRFeature& feature, const OGRGeometry& geometry) {
    if (wkbFlatten(geometry.getGeometryType()) != wkbPolygon) file.fail("a pavement is no polygon");
    Pavement p;
    p.id = file.number(feature, "pavement_id"), p.kerb = file.number(feature, "kerb_id");
    p.ring = open_ring(*geometry.toPolygon()->getExteriorRing());
    p.length_m = file.real(feature, "length_m");
    p.area_m2 = file.real(feature, "area_m2");
    p.width_m = file.real(feature, "width_m");
    p.passable_m = file.real(feature, "passable_m");
    p.unseen_share = file.real(feature, "unseen_share");
    pavements.push_back(std::move(p));
  });
  return pavements;
}

std::vector<Carriageway> read_carriageways(const std::filesystem::path& path) {
  LayerFile file(path);
  std::vector<Carriageway> roads;
  if (!file.has("carriageways")) return roads;  // runs of earlier versions
  file.for_each("carriageways", [&](const OGRFeature& feature, const OGRGeometry& geometry) {
    if (wkbFlatten(geometry.getGeometryType()) != wkbPolygon) file.fail("a carriageway is no polygon");
    const OGRPolygon& polygon = *geometry.toPolygon();
    Carriageway c;
    c.id = file.number(feature, "carriageway_id");
    c.ring = open_ring(*polygon.getExteriorRing());
    for (int i = 0; i < polygon.getNumInteriorRings(); ++i) c.holes.push_back(open_ring(*polygon.getInteriorRing(i)));
    c.area_m2 = file.real(feature, "area_m2");
    c.width_m = file.real(feature, "width_m");
    c.narrowest_m = file.real(feature, "narrowest_m");
    c.seen_share = file.real(feature, "seen_share");
    roads.push_back(std::move(c));
  });
  return roads;
}

std::vector<StreetTree> read_trees_gpkg(const std::filesystem::path& path) {
  LayerFile file(path);
  std::vector<StreetTree> trees;
  file.for_each("trees", [&](const OGRFeature& feature, const OGRGeometry& geometry) {
    if (wkbFlatten(geometry.getGeometryType()) != wkbPoint) file.fail("the place of a tree is no point");
    StreetTree t;
    t.id = file.number(feature, "tree_id");
    t.position = place_of(*geometry.toPoint());
    t.trunk_seen = file.number(feature, "trunk_seen") != 0;
    t.height_m = file.real(feature, "height_m");
    t.crown_radius_m = file.real(feature, "crown_radius_m");
    t.crown_base_m = file.real(feature, "crown_base_m");
    t.trunk_radius_m = file.real(feature, "trunk_radius_m");
    t.unseen_share = file.real(feature, "unseen_share");
    t.points = file.whole(feature, "points");
    trees.push_back(t);
  });
  return trees;
}

void read_blocks_gpkg(const std::filesystem::path& path, StreetPlan& plan) {
  LayerFile file(path);
  plan.blocks = parts_of_layer(file, "blocks");
  plan.gaps = parts_of_layer(file, "gaps");
}

}  // namespace ilot
