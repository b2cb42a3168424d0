// SPDX-License-Identifier: Apache-2.0
// Footprints of buildings from any vector file that GDAL reads.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "engine/cloud/cloud_info.h"
#include "engine/model/footprint.h"

namespace ilot {

struct FootprintFile {
  std::vector<Footprint> footprints;  // in the file's order: every feature, whatever its content
  std::string id_attribute;           // the source of the ids; empty = features were numbered from 1
  bool transformed = false;           // the file is in another CRS than the clouds
  std::vector<std::string> warnings;
};

// The place of the outlines of a file.
struct FootprintSource {
  Crs crs;  // unknown: the file does not give it, or it gives degrees although the places are outside their range
  double min_x = 0, min_y = 0, max_x = 0, max_y = 0;  // of the layer that read_footprints reads
};

// Throws Error as read_footprints does.
FootprintSource footprint_source(const std::filesystem::path& path);

// Reads the first layer that has features and transforms it into the CRS of the clouds. Ids come from the attribute
// `id_field`. Where it is empty, they come from the first existing one of identificatie, id, building, gid, fid,
// lokaalid, gml_id, osm_id, objectid (in any case). Equal ids get -2, -3 ... appended. All attributes are kept; those
// with the name of an attribute of buildings (docs/outputs.md) get "footprint_" before it. When one of the two CRS is
// unknown, they are assumed to be the same, with a warning. Features without a usable polygon are returned with a
// fault. Throws Error, with ExitCode::usage when there is no such file, layer or id_field.
FootprintFile read_footprints(const std::filesystem::path& path, const Crs& crs, const std::string& id_field = {});

}  // namespace ilot
