// SPDX-License-Identifier: Apache-2.0
// A GeoPackage that is being written.
#pragma once
#include <ogrsf_frmts.h>

#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/cloud/cloud_info.h"
#include "engine/deliverables/layers/layer_style.h"
#include "kernels/core/types.h"

namespace ilot {

// The file is complete after finish(); without it, no file remains. There are no time stamps. Throws Error when it
// cannot be written.
class GpkgFile {
 public:
  explicit GpkgFile(const std::filesystem::path& path);
  ~GpkgFile();
  GpkgFile(const GpkgFile&) = delete;
  GpkgFile& operator=(const GpkgFile&) = delete;

  // All layers are added first, with their fields; then the features.
  OGRLayer& add_layer(const char* name, OGRwkbGeometryType type, const Crs& crs);
  static void add_field(OGRLayer& layer, const char* name, OGRFieldType type, OGRFieldSubType detail = OFSTNone);
  void add(OGRLayer& layer, OGRFeature& feature);
  // Gives the feature a geometry and adds it: a place, or an area from its corners, the first one not repeated.
  void add_point(OGRLayer& layer, OGRFeature& feature, Vec3 place);
  void add_area(OGRLayer& layer, OGRFeature& feature, std::span<const Vec3> corners);

  // QGIS draws the layer in this style when the file is opened there (table layer_styles).
  void set_style(const OGRLayer& layer, const LayerStyle& style);
  void finish();

 private:
  void write_styles();

  [[noreturn]] void fail() const;

  std::filesystem::path path_;
  GDALDatasetUniquePtr file_;
  std::vector<std::pair<std::string, LayerStyle>> styles_;  // by layer
  int pending_ = 0;
  bool writing_ = false, whole_ = false;
};

}  // namespace ilot
