// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/las/las_header.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <string>

#include "engine/error.h"
#include "engine/formats/crs.h"
#include "engine/formats/las/extra_bytes.h"

namespace ilot {
namespace {

constexpr std::uint64_t kKeptPayload = std::uint64_t{64} << 20;

// At the finest scale, all values of 32 bits span 4 mm, and degrees of that step are smaller than atoms. At the
// coarsest scale, a step is a kilometre. A scale outside this range comes from a damaged header.
constexpr double kFinestScale = 1e-12, kCoarsestScale = 1000;

struct HeaderView {
  std::vector<std::byte> bytes;
  template <class T>
  T at(std::size_t offset) const {
    return load<T>(bytes.data() + offset);
  }
  bool has_bytes(std::size_t end) const { return bytes.size() >= end; }
};

[[noreturn]] void refuse(const InputFile& file, const std::string& why) {
  throw Error(file.path().string() + ": " + why);
}

HeaderView read_header(const InputFile& file) {
  if (file.size() == 0) refuse(file, "is empty; fetch or export it again");
  HeaderView header;
  header.bytes.resize(las::header_size(0));
  const std::size_t got = file.read_at(0, header.bytes);
  if (got < 4 || !looks_like_las(header.bytes)) refuse(file, "is not a LAS file (no LASF at byte 0)");
  if (got < header.bytes.size()) refuse(file, "ends inside the LAS header (227 bytes are needed)");
  const std::size_t size = header.at<std::uint16_t>(las::kHeaderSize);
  if (size < las::header_size(0) || size > file.size())
    refuse(file, "header size " + std::to_string(size) + " at byte 94 does not fit the file");
  header.bytes.resize(size);
  if (file.read_at(0, header.bytes) < size) refuse(file, "ends inside the LAS header");
  return header;
}

void read_version(const InputFile& file, const HeaderView& header, CloudInfo& info) {
  info.version_major = header.at<std::uint8_t>(las::kMajor);
  info.version_minor = header.at<std::uint8_t>(las::kMinor);
  const std::string version = std::to_string(info.version_major) + "." + std::to_string(info.version_minor);
  if (info.version_major != 1 || info.version_minor > 5)
    refuse(file, "LAS version " + version + " is not known; versions 1.0 to 1.4 are read");
  if (!header.has_bytes(las::header_size(info.version_minor)))
    info.warnings.push_back("the header is shorter than version " + version + " requires; its late fields are ignored");
}

std::array<double, 3> read_triple(const HeaderView& header, std::size_t offset) {
  return {header.at<double>(offset), header.at<double>(offset + 8), header.at<double>(offset + 16)};
}

void read_transform(const InputFile& file, const HeaderView& header, CloudInfo& info) {
  info.layout.scale = read_triple(header, las::kScale);
  info.layout.offset = read_triple(header, las::kOffset);
  for (int axis = 0; axis < 3; ++axis) {
    const double scale = info.layout.scale[static_cast<std::size_t>(axis)];
    const double offset = info.layout.offset[static_cast<std::size_t>(axis)];
    const std::string name(1, static_cast<char>('x' + axis));
    if (!(scale >= kFinestScale && scale <= kCoarsestScale)) {
      char text[64];
      std::snprintf(text, sizeof text, " is %g; %g to %g are read", scale, kFinestScale, kCoarsestScale);
      refuse(file, "scale of " + name + " at byte " +
                       std::to_string(las::kScale + std::size_t{8} * static_cast<unsigned>(axis)) + text);
    }
    if (!std::isfinite(std::abs(offset) + scale * 2147483648.0))
      refuse(file, "offset of " + name + " at byte " +
                       std::to_string(las::kOffset + std::size_t{8} * static_cast<unsigned>(axis)) + " is not usable");
  }
  info.declared_max = {header.at<double>(las::kBounds), header.at<double>(las::kBounds + 16),
                       header.at<double>(las::kBounds + 32)};
  info.declared_min = {header.at<double>(las::kBounds + 8), header.at<double>(las::kBounds + 24),
                       header.at<double>(las::kBounds + 40)};
}

void read_point_format(const InputFile& file, const HeaderView& header, LasContainer& las_file) {
  const auto byte = header.at<std::uint8_t>(las::kFormat);
  RecordLayout& layout = las_file.info.layout;
  layout.point_format = byte & 0x3F;
  layout.record_length = header.at<std::uint16_t>(las::kRecordLength);
  las_file.compressed = byte & 0x80;
  las_file.info.format = las_file.compressed ? "laz" : "las";
  if (byte & 0x40) refuse(file, "was written by a pre-release compressor of LAZ, which nothing reads any more");
  const std::size_t needed = standard_size(layout.point_format);
  if (needed == 0)
    refuse(file, "point format " + std::to_string(layout.point_format) + " at byte 104 is not known (0 to 10 are)");
  if (layout.record_length < needed)
    refuse(file, "record length " + std::to_string(layout.record_length) + " at byte 105 is less than the " +
                     std::to_string(needed) + " bytes of point format " + std::to_string(layout.point_format));
}

std::uint64_t declared_count(const HeaderView& header, const CloudInfo& info) {
  const std::uint64_t legacy = header.at<std::uint32_t>(las::kLegacyCount);
  if (info.version_minor < 4 || !header.has_bytes(las::header_size(4))) return legacy;
  const auto count = header.at<std::uint64_t>(las::kCount);
  return count == 0 ? legacy : count;
}

// Reads one VLR or EVLR at `offset`; false when it does not end before `end`.
bool read_record(const InputFile& file, std::uint64_t& offset, std::uint64_t end, LasContainer& out, bool extended) {
  const std::size_t head = extended ? las::kEvlrHeader : las::kVlrHeader;
  std::byte raw[las::kEvlrHeader];
  if (offset > end || end - offset < head || file.read_at(offset, {raw, head}) < head) return false;
  const std::uint64_t length = extended ? load<std::uint64_t>(raw + 20) : load<std::uint16_t>(raw + 20);
  if (length > end - offset - head) return false;
  Vlr vlr;
  vlr.reserved = load<std::uint16_t>(raw);
  vlr.user_id = text_at(raw + 2, 16);
  vlr.record_id = load<std::uint16_t>(raw + 18);
  vlr.description = text_at(raw + head - 32, 32);
  vlr.extended = extended;
  const std::uint64_t payload_at = offset + head;
  offset = payload_at + length;
  std::uint64_t kept = length;
  for (const Vlr& other : out.info.vlrs) kept += other.payload.size();
  if (kept > kKeptPayload) {
    out.info.warnings.push_back("record " + vlr.user_id + " " + std::to_string(vlr.record_id) + " of " +
                                std::to_string(length) + " bytes is too large and not kept");
    return true;
  }
  vlr.payload.resize(length);
  if (file.read_at(payload_at, vlr.payload) < length) return false;
  out.info.vlrs.push_back(std::move(vlr));
  return true;
}

void read_vlrs(const InputFile& file, const HeaderView& header, LasContainer& out) {
  const auto count = header.at<std::uint32_t>(las::kVlrCount);
  std::uint64_t offset = header.bytes.size();
  for (std::uint32_t i = 0; i < count; ++i) {
    if (read_record(file, offset, out.point_offset, out, false)) continue;
    out.info.warnings.push_back("the header declares " + std::to_string(count) + " VLRs, but number " +
                                std::to_string(i + 1) +
                                " does not fit before the points; it and later ones are ignored");
    return;
  }
}

// LAS 1.3 has at most one EVLR, the waveforms, and only the waveform field of the header gives its place.
void read_evlrs(const InputFile& file, const HeaderView& header, LasContainer& out) {
  std::uint64_t offset = 0, count = 0;
  if (out.info.version_minor >= 4 && header.has_bytes(las::header_size(4))) {
    offset = header.at<std::uint64_t>(las::kEvlrOffset);
    count = header.at<std::uint32_t>(las::kEvlrCount);
  } else if (out.info.version_minor == 3 && header.has_bytes(las::header_size(3)) &&
             (header.at<std::uint16_t>(las::kGlobalEncoding) & las::kWaveformInternalBit)) {
    offset = header.at<std::uint64_t>(las::kWaveform);
    count = offset == 0 ? 0 : 1;
  }
  if (count == 0) return;
  if (offset >= out.point_offset && offset < file.size()) out.point_end = offset;
  for (std::uint64_t i = 0; i < count; ++i) {
    if (offset >= las::header_size(3) && read_record(file, offset, file.size(), out, true)) continue;
    out.info.warnings.push_back("the header declares " + std::to_string(count) + " EVLRs, but number " +
                                std::to_string(i + 1) + " does not fit into the file; it and later ones are ignored");
    return;
  }
}

void check_laszip_record(const InputFile& file, const LasContainer& out) {
  const bool marked = std::any_of(out.info.vlrs.begin(), out.info.vlrs.end(), [](const Vlr& vlr) {
    return vlr.record_id == 22204 && vlr.user_id == "laszip encoded";
  });
  const std::uint64_t needed = out.info.declared_points * out.info.layout.record_length;
  if (marked && !out.compressed && needed != out.point_end - out.point_offset)
    refuse(file, "has a LASzip record but the compression bit at byte 104 is not set");
}

// Counts the whole records between the header's place of the points and their end.
void count_points(LasContainer& out) {
  CloudInfo& info = out.info;
  const std::uint64_t whole = (out.point_end - out.point_offset) / info.layout.record_length;
  info.points = std::min(info.declared_points, whole);
  if (info.points < info.declared_points)
    info.warnings.push_back("the header declares " + std::to_string(info.declared_points) +
                            " points but the file contains " + std::to_string(info.points) +
                            " whole ones; these are kept");
  if (info.declared_points == 0 && whole > 0)
    info.warnings.push_back("the header declares no points although " + std::to_string(whole) +
                            " records would fit behind it; none are read");
}

}  // namespace

bool looks_like_las(std::span<const std::byte> beginning) {
  return beginning.size() >= 4 && std::memcmp(beginning.data(), "LASF", 4) == 0;
}

LasContainer parse_las(const InputFile& file) {
  const HeaderView header = read_header(file);
  LasContainer out;
  out.info.path = file.path();
  out.info.header = header.bytes;
  read_version(file, header, out.info);
  read_point_format(file, header, out);
  read_transform(file, header, out.info);
  out.point_offset = header.at<std::uint32_t>(las::kPointOffset);
  out.point_end = file.size();
  if (out.point_offset < header.bytes.size() || out.point_offset > file.size())
    refuse(file, "place of the points " + std::to_string(out.point_offset) +
                     " at byte 96 lies outside the file or inside its header");
  read_vlrs(file, header, out);
  read_evlrs(file, header, out);
  out.info.declared_points = out.info.points = declared_count(header, out.info);
  check_laszip_record(file, out);
  if (!out.compressed) count_points(out);
  ExtraBytes extra =
      parse_extra_bytes(out.info.vlrs, standard_size(out.info.layout.point_format), out.info.layout.record_length);
  out.info.layout.extra = std::move(extra.fields);
  out.info.warnings.insert(out.info.warnings.end(), extra.warnings.begin(), extra.warnings.end());
  const bool wkt_flag = header.at<std::uint16_t>(las::kGlobalEncoding) & las::kWktBit;
  out.info.crs = crs_from_vlrs(out.info.vlrs, wkt_flag, out.info.warnings);
  return out;
}

}  // namespace ilot
