// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/las/las_plan.h"

#include <algorithm>
#include <cstring>
#include <string>

#include "engine/error.h"
#include "engine/formats/crs.h"
#include "engine/formats/las/extra_bytes.h"
#include "engine/formats/las/las_header.h"

namespace ilot {
namespace {

constexpr std::size_t kDescriptorsPerVlr = las::kLargestVlr / kDescriptorSize;

bool describes_compression(const Vlr& vlr) {
  return (vlr.user_id == "laszip encoded" && vlr.record_id == 22204) || vlr.user_id == "copc";
}

// True when only WKT can say the CRS that was assigned to a cloud. Only LAS 1.4 has it.
bool needs_wkt(const CloudInfo& like) {
  return !like.crs.wkt.empty() && std::ranges::none_of(like.vlrs, is_crs_record) &&
         crs_records(like.crs, false).empty();
}

int output_minor(const CloudInfo& like) {
  if (like.header.empty() || like.layout.point_format >= 6 || like.points > UINT32_MAX || needs_wkt(like)) return 4;
  const int needed = like.layout.point_format >= 4 ? 3 : like.layout.point_format >= 2 ? 2 : 0;
  return std::clamp<int>(like.version_minor, needed, 4);
}

std::vector<std::byte> plan_header(const CloudSpec& spec, const RecordLayout& layout) {
  const int minor = output_minor(spec.like);
  std::vector<std::byte> header = spec.like.header;
  header.resize(std::max(header.size(), las::header_size(minor)));
  std::memcpy(header.data(), "LASF", 4);
  if (minor > spec.like.version_minor && !spec.like.header.empty())
    std::fill(header.begin() + static_cast<std::ptrdiff_t>(las::header_size(spec.like.version_minor)), header.end(),
              std::byte{0});
  store<std::uint8_t>(&header[las::kMajor], 1);
  store(&header[las::kMinor], static_cast<std::uint8_t>(minor));
  if (spec.like.header.empty()) put_text(&header[las::kSystem], "OTHER", 32);
  if (!spec.software.empty()) put_text(&header[las::kSoftware], spec.software, 32);
  store(&header[las::kHeaderSize], static_cast<std::uint16_t>(header.size()));
  store(&header[las::kFormat], layout.point_format);
  store(&header[las::kRecordLength], layout.record_length);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    store(&header[las::kScale + 8 * axis], layout.scale[axis]);
    store(&header[las::kOffset + 8 * axis], layout.offset[axis]);
  }
  std::memset(&header[las::kLegacyCount], 0, las::kScale - las::kLegacyCount);
  std::memset(&header[las::kBounds], 0, las::kWaveform - las::kBounds);
  if (minor >= 4) std::memset(&header[las::kEvlrOffset], 0, las::header_size(4) - las::kEvlrOffset);
  return header;
}

// Returns the fields, with the bytes of the record that no descriptor covers as opaque fields between and behind the
// described ones.
std::vector<ExtraField> with_gaps(const std::vector<ExtraField>& fields, std::size_t begin, std::size_t end) {
  std::vector<ExtraField> sorted = fields, out;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const ExtraField& a, const ExtraField& b) { return a.offset < b.offset; });
  std::size_t at = begin;
  const auto fill_to = [&](std::size_t to) {
    if (to <= at) return;
    ExtraField gap;
    gap.name = "undocumented";
    gap.offset = static_cast<std::uint16_t>(at);
    gap.size = static_cast<std::uint16_t>(to - at);
    out.push_back(gap);
    at = to;
  };
  for (const ExtraField& field : sorted) {
    if (field.offset < at || field.offset + field.size > end) continue;
    fill_to(field.offset);
    out.push_back(field);
    at += field.size;
  }
  fill_to(end);
  return out;
}

// Appends our descriptors behind those of the input: first the undocumented rest of its record, then the appended
// fields.
void append_to(std::vector<Vlr>& vlrs, const std::vector<std::byte>& added, int minor) {
  const auto last = std::find_if(vlrs.rbegin(), vlrs.rend(), is_extra_bytes);
  if (last != vlrs.rend() && (last->extended || last->payload.size() + added.size() <= las::kLargestVlr)) {
    last->payload.insert(last->payload.end(), added.begin(), added.end());
    return;
  }
  Vlr vlr;
  vlr.user_id = "LASF_Spec";
  vlr.record_id = 4;
  vlr.description = "Extra bytes";
  vlr.extended = minor >= 4 && added.size() > las::kLargestVlr;
  const std::size_t step = vlr.extended ? added.size() : kDescriptorsPerVlr * kDescriptorSize;
  for (std::size_t at = 0; at < added.size(); at += step) {
    const auto begin = added.begin() + static_cast<std::ptrdiff_t>(at);
    vlr.payload.assign(begin, begin + static_cast<std::ptrdiff_t>(std::min(step, added.size() - at)));
    vlrs.push_back(vlr);
  }
}

void plan_extra_bytes(const CloudSpec& spec, const RecordLayout& layout, int minor, std::vector<Vlr>& vlrs) {
  const RecordLayout& before = spec.like.layout;
  const std::size_t standard = standard_size(before.point_format);
  const bool described = std::any_of(vlrs.begin(), vlrs.end(), is_extra_bytes);
  const ExtraBytes old = parse_extra_bytes(vlrs, standard, before.record_length);
  if (described && spec.appended.empty()) return;
  if (!old.warnings.empty()) std::erase_if(vlrs, is_extra_bytes);
  std::vector<ExtraField> known = old.descriptors.empty() ? before.extra : std::vector<ExtraField>{};
  std::size_t begin = standard;
  for (const ExtraField& field : old.fields) begin += field.size;
  known.insert(known.end(), layout.extra.begin() + static_cast<std::ptrdiff_t>(before.extra.size()),
               layout.extra.end());
  const std::vector<std::byte> added = describe(with_gaps(known, begin, layout.record_length));
  const bool worth = !spec.appended.empty() || !before.extra.empty();
  if (worth && !added.empty()) append_to(vlrs, added, minor);
}

// An input without its own CRS gets the one that was assigned to it.
void plan_crs(const CloudSpec& spec, std::vector<Vlr>& vlrs, std::vector<std::byte>& header) {
  if (std::any_of(vlrs.begin(), vlrs.end(), is_crs_record)) return;
  const bool as_wkt = load<std::uint8_t>(&header[las::kMinor]) >= 4 && !spec.like.crs.wkt.empty();
  for (Vlr& vlr : crs_records(spec.like.crs, as_wkt)) vlrs.push_back(std::move(vlr));
  if (as_wkt)
    store(&header[las::kGlobalEncoding],
          static_cast<std::uint16_t>(load<std::uint16_t>(&header[las::kGlobalEncoding]) | las::kWktBit));
}

bool is_waveforms(const Vlr& vlr) {
  return vlr.user_id == "LASF_Spec" && vlr.record_id == 65535;
}

void append_record(const Vlr& vlr, std::vector<std::byte>& out) {
  const std::size_t head = vlr.extended ? las::kEvlrHeader : las::kVlrHeader;
  std::byte raw[las::kEvlrHeader]{};
  store(raw, vlr.reserved);
  put_text(raw + 2, vlr.user_id, 16);
  store(raw + 18, vlr.record_id);
  if (vlr.extended)
    store(raw + 20, static_cast<std::uint64_t>(vlr.payload.size()));
  else
    store(raw + 20, static_cast<std::uint16_t>(vlr.payload.size()));
  put_text(raw + head - 32, vlr.description, 32);
  out.insert(out.end(), raw, raw + head);
  out.insert(out.end(), vlr.payload.begin(), vlr.payload.end());
}

void store_bounds(LasPlan& plan, const PointStatistics& statistics) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double scale = plan.layout.scale[axis], offset = plan.layout.offset[axis];
    store(&plan.header[las::kBounds + 16 * axis], statistics.max[axis] * scale + offset);
    store(&plan.header[las::kBounds + 16 * axis + 8], statistics.min[axis] * scale + offset);
  }
}

}  // namespace

void PointStatistics::add(std::span<const std::byte> records, const RecordLayout& layout) {
  const std::uint8_t mask = layout.point_format < 6 ? 7 : 15;
  for (std::size_t at = 0; at + layout.record_length <= records.size(); at += layout.record_length) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto value = load<std::int32_t>(&records[at + 4 * axis]);
      min[axis] = std::min(min[axis], value);
      max[axis] = std::max(max[axis], value);
    }
    const unsigned number = load<std::uint8_t>(&records[at + 14]) & mask;
    if (number > 0) ++by_return[number - 1];
    ++count;
  }
}

void PointStatistics::merge(const PointStatistics& other) {
  count += other.count;
  for (std::size_t i = 0; i < by_return.size(); ++i) by_return[i] += other.by_return[i];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    min[axis] = std::min(min[axis], other.min[axis]);
    max[axis] = std::max(max[axis], other.max[axis]);
  }
}

RecordLayout output_layout(const CloudSpec& spec) {
  RecordLayout layout = spec.like.layout;
  std::size_t length = layout.record_length;
  for (ExtraField field : spec.appended) {
    if (field.type != FieldType::opaque) field.size = static_cast<std::uint16_t>(type_size(field.type));
    field.offset = static_cast<std::uint16_t>(length);
    length += field.size;
    if (length > UINT16_MAX)
      throw Error(spec.like.path.string() + ": field " + field.name + " does not fit behind its rows of " +
                  std::to_string(spec.like.layout.record_length) +
                  " bytes: a LAS record has 65535 at most; leave out the labelled cloud (--no-clouds)");
    layout.extra.push_back(field);
  }
  layout.record_length = static_cast<std::uint16_t>(length);
  return layout;
}

LasPlan plan_las(const CloudSpec& spec) {
  LasPlan plan;
  plan.layout = output_layout(spec);
  plan.header = plan_header(spec, plan.layout);
  const int minor = load<std::uint8_t>(&plan.header[las::kMinor]);
  std::vector<Vlr> records = spec.like.vlrs;
  std::erase_if(records, describes_compression);
  plan_extra_bytes(spec, plan.layout, minor, records);
  plan_crs(spec, records, plan.header);
  for (Vlr& vlr : records) {
    const bool behind = vlr.extended && (minor >= 4 || (minor == 3 && is_waveforms(vlr)));
    (behind ? plan.evlrs : plan.vlrs).push_back(std::move(vlr));
  }
  return plan;
}

std::vector<std::byte> las_prefix(LasPlan& plan) {
  std::vector<std::byte> out = plan.header;
  for (Vlr& vlr : plan.vlrs) {
    vlr.extended = false;
    if (vlr.payload.size() > las::kLargestVlr)
      throw Error("record " + vlr.user_id + " " + std::to_string(vlr.record_id) +
                  " exceeds 65535 bytes; it needs LAS 1.4");
    append_record(vlr, out);
  }
  if (load<std::uint8_t>(&plan.header[las::kMinor]) == 0) out.insert(out.end(), {std::byte{0xDD}, std::byte{0xCC}});
  if (out.size() > UINT32_MAX) throw Error("the VLRs exceed 4 GiB; drop some");
  store(&plan.header[las::kVlrCount], static_cast<std::uint32_t>(plan.vlrs.size()));
  store(&plan.header[las::kPointOffset], static_cast<std::uint32_t>(out.size()));
  std::copy(plan.header.begin(), plan.header.end(), out.begin());
  return out;
}

void finish_header(LasPlan& plan, const PointStatistics& statistics, std::uint64_t evlr_offset) {
  const int minor = load<std::uint8_t>(&plan.header[las::kMinor]);
  const bool legacy = plan.layout.point_format < 6 && statistics.count <= UINT32_MAX;
  if (!legacy && minor < 4) throw Error("LAS before 1.4 can have at most 4294967295 points; write several files");
  if (legacy) {
    store(&plan.header[las::kLegacyCount], static_cast<std::uint32_t>(statistics.count));
    for (std::size_t i = 0; i < 5; ++i)
      store(&plan.header[las::kLegacyReturns + 4 * i], static_cast<std::uint32_t>(statistics.by_return[i]));
  }
  if (minor >= 4) {
    store(&plan.header[las::kCount], statistics.count);
    for (std::size_t i = 0; i < statistics.by_return.size(); ++i)
      store(&plan.header[las::kReturns + 8 * i], statistics.by_return[i]);
    store(&plan.header[las::kEvlrOffset], plan.evlrs.empty() ? std::uint64_t{0} : evlr_offset);
    store(&plan.header[las::kEvlrCount], static_cast<std::uint32_t>(plan.evlrs.size()));
  }
  if (statistics.count > 0) store_bounds(plan, statistics);
  std::uint64_t waveforms = 0, at = evlr_offset;
  for (const Vlr& vlr : plan.evlrs) {
    if (is_waveforms(vlr)) waveforms = at;
    at += las::kEvlrHeader + vlr.payload.size();
  }
  if (minor >= 3) store(&plan.header[las::kWaveform], waveforms);
}

std::vector<std::byte> las_suffix(const LasPlan& plan) {
  std::vector<std::byte> out;
  for (const Vlr& vlr : plan.evlrs) append_record(vlr, out);
  return out;
}

}  // namespace ilot
