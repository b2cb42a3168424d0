// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/layers/trees_gpkg.h"

#include "engine/deliverables/layers/gpkg_file.h"
#include "engine/model/street_geometry.h"

namespace ilot {
namespace {

void add_tree_fields(OGRLayer& layer) {
  GpkgFile::add_field(layer, "tree_id", OFTInteger64);
  GpkgFile::add_field(layer, "trunk_seen", OFTInteger, OFSTBoolean);
  for (const char* name : {"height_m", "crown_radius_m", "crown_base_m", "trunk_radius_m", "unseen_share"})
    GpkgFile::add_field(layer, name, OFTReal);
  GpkgFile::add_field(layer, "points", OFTInteger64);
}

void set_fields(OGRFeature& feature, const StreetTree& t) {
  feature.SetField("tree_id", static_cast<GIntBig>(t.id));
  feature.SetField("trunk_seen", t.trunk_seen ? 1 : 0);
  feature.SetField("height_m", t.height_m);
  feature.SetField("crown_radius_m", t.crown_radius_m);
  feature.SetField("crown_base_m", t.crown_base_m);
  if (t.trunk_seen) feature.SetField("trunk_radius_m", t.trunk_radius_m);
  feature.SetField("unseen_share", t.unseen_share);
  feature.SetField("points", static_cast<GIntBig>(t.points));
}

}  // namespace

void write_trees_gpkg(const std::filesystem::path& path, const StreetPlan& plan, const Crs& crs) {
  GpkgFile file(path);
  OGRLayer& trees = file.add_layer("trees", wkbPoint25D, crs);
  add_tree_fields(trees);
  OGRLayer& crowns = file.add_layer("crowns", wkbPolygon, crs);
  add_tree_fields(crowns);
  file.set_style(trees, style_of_trees(StyleSymbol::marker));
  file.set_style(crowns, style_of_trees(StyleSymbol::fill));
  for (const StreetTree& t : plan.trees) {
    OGRFeature feature(trees.GetLayerDefn());
    set_fields(feature, t);
    file.add_point(trees, feature, t.position);
  }
  for (const StreetTree& t : plan.trees) {
    OGRFeature feature(crowns.GetLayerDefn());
    set_fields(feature, t);
    file.add_area(crowns, feature, crown_of(t, crs.metres_per_unit));
  }
  file.finish();
}

}  // namespace ilot
