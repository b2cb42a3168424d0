// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/layers/footprints.h"

#include <cpl_conv.h>
#include <ogrsf_frmts.h>

#include <array>
#include <cmath>
#include <map>
#include <set>

#include "engine/deliverables/layers/silent_gdal.h"
#include "engine/deliverables/layers/spatial_reference.h"
#include "engine/deliverables/solids/building_fields.h"
#include "engine/error.h"
#include "engine/formats/crs.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 9> kIdAttributes{"identificatie", "id",     "building", "gid",     "fid",
                                                   "lokaalid",      "gml_id", "osm_id",   "objectid"};

Error usage(const fs::path& path, const std::string& sentence) {
  return Error(path.string() + ": " + sentence, ExitCode::usage);
}

OGRLayer* first_layer_with_features(GDALDataset& file) {
  for (OGRLayer* layer : file.GetLayers())
    if (layer->GetFeatureCount() > 0) return layer;
  return nullptr;
}

// The vector file and its first layer that has features.
struct OpenedLayer {
  GDALDatasetUniquePtr file;
  OGRLayer* layer = nullptr;
};

OpenedLayer open_layer(const fs::path& path) {
  if (!fs::exists(path)) throw usage(path, "there is no such file");
  CPLSetErrorHandler(keep_silent);
  GDALAllRegister();
  CPLErrorReset();
  OpenedLayer opened{GDALDatasetUniquePtr(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY)), nullptr};
  if (!opened.file) {
    const std::string why = CPLGetLastErrorMsg();
    throw usage(path, "is no vector file that can be read" +
                          (why.empty() ? " (GeoPackage, GeoJSON, Shapefile and others of GDAL can)" : ": " + why));
  }
  opened.layer = first_layer_with_features(*opened.file);
  if (opened.layer == nullptr) throw usage(path, "contains no features");
  return opened;
}

// True for a format that always declares degrees when the coordinates cannot be degrees.
bool beyond_degrees(const OGRSpatialReference& reference, OGRLayer& layer) {
  OGREnvelope box;
  if (!reference.IsGeographic() || layer.GetExtent(&box) != OGRERR_NONE) return false;
  return box.MinX < -361 || box.MaxX > 361 || box.MinY < -91 || box.MaxY > 91;
}

// Transforms the coordinates of the file to the CRS of the clouds. It does nothing when they are in it or when a CRS is
// unknown.
class ToCloud {
 public:
  ToCloud(const fs::path& path, OGRLayer& layer, const Crs& crs, FootprintFile& out) : target_(spatial_reference(crs)) {
    const OGRSpatialReference* found = layer.GetSpatialRef();
    if (found == nullptr || target_ == nullptr || beyond_degrees(*found, layer)) {
      if (found != nullptr && found->IsGeographic() && !beyond_degrees(*found, layer))
        throw usage(path, "is in degrees, and the CRS of the clouds is not known; give --crs");
      out.warnings.push_back(path.string() + ": is taken to be in the CRS of the clouds, because " +
                             (target_ == nullptr ? "theirs is not known" : "its own is not known"));
      return;
    }
    source_.reset(found->Clone());
    source_->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    for (OGRSpatialReference* reference : {source_.get(), target_.get()}) reference->StripVertical();
    if (source_->IsSame(target_.get())) return;
    transformation_.reset(OGRCreateCoordinateTransformation(source_.get(), target_.get()));
    if (!transformation_) throw usage(path, "its CRS cannot be transformed to that of the clouds");
    out.transformed = true;
  }

  bool apply(OGRGeometry& geometry) const {
    return !transformation_ || geometry.transform(transformation_.get()) == OGRERR_NONE;
  }

 private:
  std::unique_ptr<OGRSpatialReference> source_, target_;
  std::unique_ptr<OGRCoordinateTransformation> transformation_;
};

std::vector<std::array<double, 2>> ring_of(const OGRLinearRing& ring) {
  std::vector<std::array<double, 2>> vertices;
  for (int i = 0; i < ring.getNumPoints(); ++i) vertices.push_back({ring.getX(i), ring.getY(i)});
  if (vertices.size() > 1 && vertices.front() == vertices.back()) vertices.pop_back();
  return vertices;
}

bool is_finite(const FootprintPolygon& polygon) {
  constexpr double kFarthest = 1e9;
  for (const auto& ring : polygon)
    for (const auto& [x, y] : ring)
      if (!(std::abs(x) < kFarthest && std::abs(y) < kFarthest)) return false;
  return true;
}

void collect_polygons(const OGRGeometry& geometry, Footprint& footprint) {
  if (OGR_GT_IsSubClassOf(wkbFlatten(geometry.getGeometryType()), wkbGeometryCollection)) {
    for (const OGRGeometry* part : *geometry.toGeometryCollection()) collect_polygons(*part, footprint);
    return;
  }
  if (wkbFlatten(geometry.getGeometryType()) != wkbPolygon) return;
  FootprintPolygon polygon;
  for (const OGRLinearRing* ring : *geometry.toPolygon()) polygon.push_back(ring_of(*ring));
  if (polygon.empty()) return;
  if (is_finite(polygon)) {
    footprint.parts.push_back(std::move(polygon));
  } else {
    footprint.fault = "its coordinates are not finite";
  }
}

void read_geometry(const OGRFeature& feature, const ToCloud& to_cloud, Footprint& footprint) {
  const OGRGeometry* given = feature.GetGeometryRef();
  if (given == nullptr || given->IsEmpty()) {
    footprint.fault = "it has no geometry";
    return;
  }
  const std::unique_ptr<OGRGeometry> geometry(given->getLinearGeometry());
  geometry->flattenTo2D();
  if (!to_cloud.apply(*geometry)) {
    footprint.fault = "it cannot be transformed to the CRS of the clouds";
    return;
  }
  collect_polygons(*geometry, footprint);
  if (!footprint.parts.empty()) {
    footprint.fault.clear();
  } else if (footprint.fault.empty()) {
    footprint.fault = std::string("it is a ") + OGRGeometryTypeToName(given->getGeometryType()) + ", not a polygon";
  }
}

// Returns the number of the attribute that names the features: the given one, or the first usual one; -1 = none.
int id_field_of(const OGRFeatureDefn& definition, const std::string& given, const fs::path& path) {
  if (!given.empty()) {
    if (const int field = definition.GetFieldIndex(given.c_str()); field >= 0) return field;
    std::string all;
    for (int i = 0; i < definition.GetFieldCount(); ++i)
      all += (i > 0 ? ", " : "") + std::string(definition.GetFieldDefn(i)->GetNameRef());
    throw usage(path, "has no attribute " + given + " (--id-field); it has " + (all.empty() ? "none" : all));
  }
  for (const char* name : kIdAttributes)
    if (const int field = definition.GetFieldIndex(name); field >= 0) return field;
  return -1;
}

std::string lower_case(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

// The names under which the attributes of footprints are kept. A name that a building has already gets "footprint_"
// before it. The attribute that names the features is not kept when it is called id, because buildings have an id.
std::vector<std::string> kept_names(const OGRFeatureDefn& definition, int id_field) {
  std::set<std::string> taken{"id", "fid", "geom"};
  for (const AttributeStyle style : {AttributeStyle::plain, AttributeStyle::roofer})
    for (const auto& [name, kind] : attribute_columns(style)) taken.insert(lower_case(name));
  std::vector<std::string> names;
  for (int i = 0; i < definition.GetFieldCount(); ++i) {
    std::string name = definition.GetFieldDefn(i)->GetNameRef();
    if (i == id_field && lower_case(name) == "id") {
      names.emplace_back();
      continue;
    }
    while (!taken.insert(lower_case(name)).second) name = "footprint_" + name;
    names.push_back(name);
  }
  return names;
}

std::vector<std::pair<std::string, AttributeValue>> attributes_of(const OGRFeature& feature,
                                                                  const std::vector<std::string>& names) {
  std::vector<std::pair<std::string, AttributeValue>> attributes;
  for (int i = 0; i < static_cast<int>(names.size()); ++i) {
    if (names[static_cast<std::size_t>(i)].empty() || !feature.IsFieldSetAndNotNull(i)) continue;
    const OGRFieldDefn& field = *feature.GetFieldDefnRef(i);
    AttributeValue value;
    if (field.GetSubType() == OFSTBoolean)
      value = feature.GetFieldAsInteger(i) != 0;
    else if (field.GetType() == OFTInteger || field.GetType() == OFTInteger64)
      value = static_cast<std::int64_t>(feature.GetFieldAsInteger64(i));
    else if (field.GetType() == OFTReal)
      value = feature.GetFieldAsDouble(i);
    else
      value = std::string(feature.GetFieldAsString(i));
    attributes.emplace_back(names[static_cast<std::size_t>(i)], std::move(value));
  }
  return attributes;
}

std::string id_of(const OGRFeature& feature, int field, std::size_t number) {
  if (field >= 0 && feature.IsFieldSetAndNotNull(field))
    if (std::string id = feature.GetFieldAsString(field); !id.empty()) return id;
  return std::to_string(number);
}

void make_unique(std::vector<Footprint>& footprints, const fs::path& path, std::vector<std::string>& warnings) {
  std::set<std::string> used;
  for (const Footprint& f : footprints) used.insert(f.id);
  std::map<std::string, int> seen;
  std::size_t renamed = 0;
  for (Footprint& f : footprints) {
    const std::string given = f.id;
    int& count = seen[given];
    if (++count == 1) continue;
    while (!used.insert(f.id = given + "-" + std::to_string(count)).second) ++count;
    ++renamed;
  }
  if (renamed > 0)
    warnings.push_back(path.string() + ": " + std::to_string(renamed) +
                       " footprints share the id of another; they got -2, -3 ... behind it");
}

}  // namespace

FootprintSource footprint_source(const fs::path& path) {
  const OpenedLayer opened = open_layer(path);
  FootprintSource source;
  OGREnvelope box;
  if (opened.layer->GetExtent(&box) == OGRERR_NONE) {
    source.min_x = box.MinX;
    source.min_y = box.MinY;
    source.max_x = box.MaxX;
    source.max_y = box.MaxY;
  }
  const OGRSpatialReference* found = opened.layer->GetSpatialRef();
  if (found == nullptr || beyond_degrees(*found, *opened.layer)) return source;
  char* wkt = nullptr;
  if (found->exportToWkt(&wkt) == OGRERR_NONE && wkt != nullptr) {
    try {
      source.crs = crs_from_text(wkt);
    } catch (const Error&) {
      // A CRS that PROJ does not understand is treated as unknown.
    }
  }
  CPLFree(wkt);
  return source;
}

FootprintFile read_footprints(const fs::path& path, const Crs& crs, const std::string& id_field) {
  const OpenedLayer opened = open_layer(path);
  OGRLayer* layer = opened.layer;
  FootprintFile out;
  const ToCloud to_cloud(path, *layer, crs, out);
  const int field = id_field_of(*layer->GetLayerDefn(), id_field, path);
  const std::vector<std::string> names = kept_names(*layer->GetLayerDefn(), field);
  if (field >= 0) out.id_attribute = layer->GetLayerDefn()->GetFieldDefn(field)->GetNameRef();
  CPLErrorReset();
  for (const auto& feature : *layer) {
    Footprint& footprint = out.footprints.emplace_back();
    footprint.id = id_of(*feature, field, out.footprints.size());
    footprint.attributes = attributes_of(*feature, names);
    read_geometry(*feature, to_cloud, footprint);
  }
  if (CPLGetLastErrorType() == CE_Failure && out.footprints.empty())
    throw Error(path.string() + ": cannot be read: " + CPLGetLastErrorMsg());
  make_unique(out.footprints, path, out.warnings);
  return out;
}

}  // namespace ilot
