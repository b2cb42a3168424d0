// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/layers/kerbs_gpkg.h"

#include "engine/deliverables/layers/gpkg_file.h"

namespace ilot {

void write_kerbs_gpkg(const std::filesystem::path& path, const StreetPlan& plan, const Crs& crs) {
  GpkgFile file(path);
  OGRLayer& lines = file.add_layer("kerbs", wkbLineString25D, crs);
  GpkgFile::add_field(lines, "kerb_id", OFTInteger64);
  GpkgFile::add_field(lines, "seen", OFTInteger, OFSTBoolean);
  for (const char* name : {"height_m", "length_m"}) GpkgFile::add_field(lines, name, OFTReal);
  OGRLayer& heights = file.add_layer("heights", wkbPoint25D, crs);
  for (const char* name : {"kerb_id", "vertex"}) GpkgFile::add_field(heights, name, OFTInteger64);
  GpkgFile::add_field(heights, "height_m", OFTReal);
  file.set_style(lines, style_of_kerbs());
  for (const StreetKerb& kerb : plan.kerbs) {
    OGRFeature feature(lines.GetLayerDefn());
    feature.SetField("kerb_id", static_cast<GIntBig>(kerb.id));
    feature.SetField("seen", kerb.seen ? 1 : 0);
    feature.SetField("height_m", kerb.height_m);
    feature.SetField("length_m", kerb.length_m);
    OGRLineString line;
    for (const Vec3& p : kerb.line) line.addPoint(p.x, p.y, p.z);
    feature.SetGeometry(&line);
    file.add(lines, feature);
  }
  for (const StreetKerb& kerb : plan.kerbs)
    for (std::size_t i = 0; kerb.seen && i < kerb.line.size(); ++i) {
      OGRFeature feature(heights.GetLayerDefn());
      feature.SetField("kerb_id", static_cast<GIntBig>(kerb.id));
      feature.SetField("vertex", static_cast<GIntBig>(i + 1));
      feature.SetField("height_m", kerb.heights_m[i]);
      file.add_point(heights, feature, kerb.line[i]);
    }
  file.finish();
}

}  // namespace ilot
