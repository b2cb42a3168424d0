// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/las/las_claims.h"

#include <algorithm>

#include "engine/formats/las/extra_bytes.h"
#include "engine/formats/las/las_header.h"

namespace ilot {
namespace {

bool is_geotiff(const Vlr& vlr) {
  return vlr.user_id == "LASF_Projection" && vlr.record_id == 34735;
}
bool is_wkt(const Vlr& vlr) {
  return vlr.user_id == "LASF_Projection" && vlr.record_id == 2112;
}

int minor_that_knows(std::uint8_t point_format) {
  if (point_format >= 6) return 4;
  if (point_format >= 4) return 3;
  return point_format >= 2 ? 2 : 0;
}

void claim_counts(const std::vector<std::byte>& header, LasClaims& claims) {
  claims.legacy_count = load<std::uint32_t>(&header[las::kLegacyCount]);
  for (std::size_t i = 0; i < claims.legacy_returns.size(); ++i)
    claims.legacy_returns[i] = load<std::uint32_t>(&header[las::kLegacyReturns + 4 * i]);
  if (!claims.has_counts) return;
  claims.count = load<std::uint64_t>(&header[las::kCount]);
  for (std::size_t i = 0; i < claims.returns.size(); ++i)
    claims.returns[i] = load<std::uint64_t>(&header[las::kReturns + 8 * i]);
}

void claim_extra_bytes(const CloudInfo& info, LasClaims& claims) {
  const std::size_t standard = standard_size(info.layout.point_format);
  const ExtraBytes extra = parse_extra_bytes(info.vlrs, standard, info.layout.record_length);
  if (!extra.warnings.empty()) claims.extra_bytes_fault = extra.warnings.front();
  std::size_t described = standard;
  for (const ExtraField& field : extra.fields) described += field.size;
  claims.undescribed_bytes = info.layout.record_length - described;
}

}  // namespace

bool has_las_header(const CloudInfo& info) {
  return info.header.size() >= las::header_size(0);
}

LasClaims claims_of(const CloudInfo& info) {
  const std::vector<std::byte>& header = info.header;
  LasClaims claims;
  claims.has_counts = info.version_minor >= 4 && header.size() >= las::header_size(4);
  claim_counts(header, claims);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    claims.max[axis] = load<double>(&header[las::kBounds + 16 * axis]);
    claims.min[axis] = load<double>(&header[las::kBounds + 16 * axis + 8]);
  }
  claims.header_bytes = header.size();
  claims.needed_header_bytes = las::header_size(info.version_minor);
  claims.needed_minor = minor_that_knows(info.layout.point_format);
  claims.vlrs = load<std::uint32_t>(&header[las::kVlrCount]);
  const auto before = [](const Vlr& vlr) { return !vlr.extended; };
  claims.whole_vlrs = static_cast<std::uint64_t>(std::count_if(info.vlrs.begin(), info.vlrs.end(), before));
  claims.wkt_flag = load<std::uint16_t>(&header[las::kGlobalEncoding]) & las::kWktBit;
  claims.has_wkt = std::any_of(info.vlrs.begin(), info.vlrs.end(), is_wkt);
  claims.has_geotiff = std::any_of(info.vlrs.begin(), info.vlrs.end(), is_geotiff);
  claim_extra_bytes(info, claims);
  return claims;
}

}  // namespace ilot
