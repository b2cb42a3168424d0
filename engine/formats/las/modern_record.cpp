// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/las/modern_record.h"

#include <algorithm>
#include <optional>
#include <string>

#include "engine/error.h"
#include "engine/formats/crs.h"

namespace ilot {
namespace {

constexpr std::size_t kRgbBytes = 6, kNirBytes = 2;

bool describes_waveforms(const Vlr& vlr) {
  return vlr.user_id == "LASF_Spec" && ((vlr.record_id >= 100 && vlr.record_id < 355) || vlr.record_id == 65535);
}

bool is_wkt_of_any_kind(const Vlr& vlr) {
  return is_crs_record(vlr) && (vlr.record_id == 2112 || vlr.record_id == 4224);
}

void copy_part(const std::byte* from, std::optional<std::size_t> at, std::byte* to, std::optional<std::size_t> place,
               std::size_t bytes) {
  if (at && place) std::copy_n(from + *at, bytes, to + *place);
}

}  // namespace

std::uint8_t modern_format(std::uint8_t point_format) {
  if (nir_offset(point_format)) return 8;
  return rgb_offset(point_format) ? 7 : 6;
}

CloudSpec modern_spec(const CloudSpec& spec) {
  CloudSpec modern = spec;
  RecordLayout& layout = modern.like.layout;
  const std::size_t before = standard_size(layout.point_format);
  layout.point_format = modern_format(layout.point_format);
  const std::size_t after = standard_size(layout.point_format);
  const std::size_t length = layout.record_length - before + after;
  if (length > UINT16_MAX)
    throw Error("rows of point format " + std::to_string(layout.point_format) + " would have " +
                std::to_string(length) + " bytes and a LAS record can have at most 65535; drop extra bytes first");
  layout.record_length = static_cast<std::uint16_t>(length);
  for (ExtraField& field : layout.extra) field.offset = static_cast<std::uint16_t>(field.offset - before + after);
  std::vector<Vlr>& vlrs = modern.like.vlrs;
  std::erase_if(vlrs, describes_waveforms);
  if (!modern.like.crs.wkt.empty() && std::none_of(vlrs.begin(), vlrs.end(), is_wkt_of_any_kind))
    replace_crs(modern.like, Crs(modern.like.crs));
  return modern;
}

void modernise(std::span<const std::byte> from, std::uint8_t from_format, std::size_t extra, std::span<std::byte> to) {
  const std::uint8_t format = modern_format(from_format);
  const std::size_t before = standard_size(from_format), after = standard_size(format);
  for (std::size_t rows = from.size() / (before + extra), i = 0; i < rows; ++i) {
    const auto old_row = from.subspan(i * (before + extra), before + extra);
    const auto row = to.subspan(i * (after + extra), after + extra);
    const std::byte* p = old_row.data();
    std::fill_n(row.begin(), after, std::byte{0});
    encode_fields(decode_fields(old_row, from_format), row, format);
    copy_part(p, gps_time_offset(from_format), row.data(), gps_time_offset(format), sizeof(double));
    copy_part(p, rgb_offset(from_format), row.data(), rgb_offset(format), kRgbBytes);
    copy_part(p, nir_offset(from_format), row.data(), nir_offset(format), kNirBytes);
    std::copy_n(p + before, extra, row.data() + after);
  }
}

}  // namespace ilot
