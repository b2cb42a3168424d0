// SPDX-License-Identifier: Apache-2.0
// The coordinate reference system of a cloud. It is found in the records of the cloud, interpreted by PROJ, and written
// back into records.
#pragma once
#include <string>
#include <vector>

#include "engine/cloud/cloud_info.h"

namespace ilot {

// Reads WKT (record 2112, or 4224 from some writers, under any user id) and GeoTIFF keys (34735 to 34737). The global
// encoding bit of the header says which one comes first. If that bit is wrong, the records that exist and are
// understood are used, with a warning. If nothing is known, metres are assumed and unit_assumed is true. Never throws
// on bad content.
Crs crs_from_vlrs(const std::vector<Vlr>& vlrs, bool wkt_flag, std::vector<std::string>& warnings);

// Throws Error when PROJ's database does not know the code.
Crs crs_from_epsg(int code);

// Takes "EPSG:2154", "2154", "EPSG:2154+5720" or WKT, as --crs does. Throws Error when the text is not understood.
Crs crs_from_text(const std::string& text);

// Returns the CRS of x and y alone, with heights in their unit. It is the same CRS when there is no separate CRS for
// heights.
Crs horizontal_crs(const Crs& crs);

// True when x, y and z are metres from the centre of the Earth. `geographic` is then true too, as no product works on
// them.
bool is_geocentric(const Crs& crs);

// False for degrees that are outside their range, and in a geocentric CRS for places far from the surface of the Earth.
bool can_be_at(const Crs& crs, Vec3 place);

bool is_crs_record(const Vlr& vlr);

// Returns the records of this CRS: WKT (LAS 1.4) or GeoTIFF keys. Empty when it has no WKT, or when EPSG has no code
// for it or for a part of it that keys would need.
std::vector<Vlr> crs_records(const Crs& crs, bool as_wkt);

// Removes the cloud's own CRS records and puts `crs` in their place (for --crs).
void replace_crs(CloudInfo& info, const Crs& crs);

}  // namespace ilot
