// SPDX-License-Identifier: Apache-2.0
// Ground plans of buildings out of any vector file that GDAL reads.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "engine/cloud/cloud_info.h"
#include "engine/model/footprint.h"

namespace ilot {

struct FootprintFile {
  std::vector<Footprint> footprints;  // in the file's order: every feature, whatever it holds
  std::string id_attribute;           // that ids come from; empty = features were numbered from 1
  bool transformed = false;           // the file is in another CRS than the clouds
  std::vector<std::string> warnings;
};

// Where the outlines of a file are.
struct FootprintSource {
  Crs crs;  // unknown: the file does not say, or says degrees of places that are none
  double min_x = 0, min_y = 0, max_x = 0, max_y = 0;  // of the layer that read_footprints reads
};

// Throws Error as read_footprints does.
FootprintSource footprint_source(const std::filesystem::path& path);

// Reads the first layer that holds features, into the CRS of the clouds. Ids come from the first of the attributes
// identificatie, id, building, gid, fid (any case) that exists; equal ones get -2, -3 ... behind them. Where one of the
// two CRS is unknown they are taken to be the same, with a warning. Features without a usable polygon come back with a
// fault. Throws Error, of ExitCode::usage when there is no such file or no layer.
FootprintFile read_footprints(const std::filesystem::path& path, const Crs& crs);

}  // namespace ilot
