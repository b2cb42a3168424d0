// SPDX-License-Identifier: Apache-2.0
// The coordinate reference system of a cloud: found in its records, understood by PROJ, written back into records.
#pragma once
#include <string>
#include <vector>

#include "engine/cloud/cloud_info.h"

namespace ilot {

// WKT (record 2112, or 4224 of some writers, under any user id) and GeoTIFF keys (34735 to 34737); the global encoding
// bit of the header says which comes first, but what is there and understood is taken, with a warning when the bit is
// wrong. Nothing known: metres are assumed and unit_assumed is true. Never throws on bad content.
Crs crs_from_vlrs(const std::vector<Vlr>& vlrs, bool wkt_flag, std::vector<std::string>& warnings);

// Throws Error when PROJ's database does not know the code.
Crs crs_from_epsg(int code);

// "EPSG:2154", "2154", "EPSG:2154+5720" or WKT, as --crs takes it. Throws Error when it is not understood.
Crs crs_from_text(const std::string& text);

// The CRS of x and y alone, heights in their unit; the same where it has no other for heights.
Crs horizontal_crs(const Crs& crs);

// False for degrees or a place around the Earth's centre where x and y (and z) are far beyond any such.
bool can_be_at(const Crs& crs, Vec3 place);

bool is_crs_record(const Vlr& vlr);

// Records that say this CRS: WKT (LAS 1.4) or GeoTIFF keys. Empty when neither WKT nor EPSG code is known.
std::vector<Vlr> crs_records(const Crs& crs, bool as_wkt);

// Takes the cloud's own CRS records out and puts `crs` in their place (an answer to --crs).
void replace_crs(CloudInfo& info, const Crs& crs);

}  // namespace ilot
