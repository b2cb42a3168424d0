// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/layers/streets_gpkg.h"

#include <map>
#include <string>

#include "engine/deliverables/layers/gpkg_file.h"
#include "engine/model/point_label.h"
#include "engine/model/street_geometry.h"

namespace ilot {
namespace {

void add_object_fields(OGRLayer& layer) {
  GpkgFile::add_field(layer, "object_id", OFTInteger64);
  GpkgFile::add_field(layer, "class", OFTString);
  GpkgFile::add_field(layer, "label", OFTInteger64);
  for (const char* name : {"probability", "height_m", "length_m", "width_m", "heading_deg", "area_m2"})
    GpkgFile::add_field(layer, name, OFTReal);
  for (const char* name : {"points", "stretch", "block", "by_hand"}) GpkgFile::add_field(layer, name, OFTInteger64);
}

void set_fields(OGRFeature& feature, const StreetObject& o) {
  feature.SetField("object_id", static_cast<GIntBig>(o.id));
  feature.SetField("class", o.class_name.c_str());
  feature.SetField("label", static_cast<GIntBig>(o.label));
  if (!o.by_hand) feature.SetField("probability", o.probability);
  feature.SetField("height_m", o.height_m);
  feature.SetField("length_m", o.length_m);
  feature.SetField("width_m", o.width_m);
  feature.SetField("heading_deg", o.heading_deg);
  feature.SetField("area_m2", o.area_m2);
  feature.SetField("points", static_cast<GIntBig>(o.points));
  if (o.stretch > 0) feature.SetField("stretch", static_cast<GIntBig>(o.stretch));
  if (o.block > 0) feature.SetField("block", static_cast<GIntBig>(o.block));
  feature.SetField("by_hand", static_cast<GIntBig>(o.by_hand));
}

// The classes of a style: ours, and one's own among the objects.
std::map<PointLabel, std::string> classes_of(const StreetPlan& plan) {
  std::map<PointLabel, std::string> classes;
  for (const auto& [value, name] : point_label_names())
    if (is_street_object(static_cast<PointLabel>(value))) classes[static_cast<PointLabel>(value)] = name;
  for (const StreetObject& o : plan.objects)
    if (is_own_class(o.label)) classes[o.label] = o.class_name;
  return classes;
}

void write_parts(GpkgFile& file, const char* name, const std::vector<FacadePart>& parts, const Crs& crs,
                 const LayerStyle& style) {
  OGRLayer& layer = file.add_layer(name, wkbLineString25D, crs);
  file.set_style(layer, style);
  for (const char* field : {"stretch", "number"}) GpkgFile::add_field(layer, field, OFTInteger64);
  for (const char* field : {"length_m", "height_m"}) GpkgFile::add_field(layer, field, OFTReal);
  for (const FacadePart& part : parts) {
    OGRFeature feature(layer.GetLayerDefn());
    feature.SetField("stretch", static_cast<GIntBig>(part.stretch));
    feature.SetField("number", static_cast<GIntBig>(part.number));
    feature.SetField("length_m", part.length_m);
    feature.SetField("height_m", part.height_m);
    OGRLineString line;
    line.addPoint(part.from.x, part.from.y, part.from.z);
    line.addPoint(part.to.x, part.to.y, part.to.z);
    feature.SetGeometry(&line);
    file.add(layer, feature);
  }
}

}  // namespace

void write_objects_gpkg(const std::filesystem::path& path, const StreetPlan& plan, const Crs& crs) {
  GpkgFile file(path);
  OGRLayer& objects = file.add_layer("objects", wkbPoint25D, crs);
  add_object_fields(objects);
  OGRLayer& extents = file.add_layer("extents", wkbPolygon, crs);
  add_object_fields(extents);
  const std::map<PointLabel, std::string> classes = classes_of(plan);
  file.set_style(objects, style_of_objects(StyleSymbol::marker, classes));
  file.set_style(extents, style_of_objects(StyleSymbol::fill, classes));
  for (const StreetObject& o : plan.objects) {
    OGRFeature feature(objects.GetLayerDefn());
    set_fields(feature, o);
    file.add_point(objects, feature, o.base);
  }
  for (const StreetObject& o : plan.objects) {
    OGRFeature feature(extents.GetLayerDefn());
    set_fields(feature, o);
    file.add_area(extents, feature, extent_of(o, crs.metres_per_unit));
  }
  file.finish();
}

void write_blocks_gpkg(const std::filesystem::path& path, const StreetPlan& plan, const Crs& crs) {
  GpkgFile file(path);
  write_parts(file, "blocks", plan.blocks, crs, style_of_blocks());
  write_parts(file, "gaps", plan.gaps, crs, style_of_gaps());
  file.finish();
}

}  // namespace ilot
