// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/las/extra_bytes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

namespace ilot {
namespace {

constexpr std::size_t kLargestOpaque = 255;
constexpr std::size_t kNameAt = 4, kNameLength = 32;  // in a descriptor

// A size of 0 means that the descriptor cannot be used.
ExtraField parse_descriptor(const std::byte* p) {
  const auto type = load<std::uint8_t>(p + 2), options = load<std::uint8_t>(p + 3);
  ExtraField field;
  field.name = text_at(p + kNameAt, kNameLength);
  field.description = text_at(p + 160, 32);
  if (type == 0) {
    field.size = options;
  } else if (type <= 10) {
    field.type = static_cast<FieldType>(type);
    field.size = static_cast<std::uint16_t>(type_size(field.type));
    const double scale = load<double>(p + 112), shift = load<double>(p + 136);
    if ((options & 8) && std::isfinite(scale) && scale != 0) field.scale = scale;
    if ((options & 16) && std::isfinite(shift)) field.shift = shift;
  } else if (type <= 30) {
    const auto element = static_cast<FieldType>((type - 1) % 10 + 1);
    field.size = static_cast<std::uint16_t>(type_size(element) * static_cast<std::size_t>((type - 1) / 10 + 1));
  }
  return field;
}

void append_descriptor(const ExtraField& field, std::size_t size, std::vector<std::byte>& out) {
  std::byte d[kDescriptorSize]{};
  const bool scaled = field.type != FieldType::opaque && field.scale != 1;
  const bool shifted = field.type != FieldType::opaque && field.shift != 0;
  store<std::uint8_t>(d + 2, static_cast<std::uint8_t>(field.type));
  store<std::uint8_t>(
      d + 3, static_cast<std::uint8_t>(field.type == FieldType::opaque ? size : (scaled ? 8 : 0) | (shifted ? 16 : 0)));
  put_text(d + kNameAt, field.name, kNameLength);
  if (scaled) store(d + 112, field.scale);
  if (shifted) store(d + 136, field.shift);
  put_text(d + 160, field.description, 32);
  out.insert(out.end(), d, d + kDescriptorSize);
}

ExtraBytes malformed(const std::string& reason) {
  ExtraBytes result;
  result.warnings.push_back("the description of extra bytes " + reason + "; they are kept as undocumented bytes");
  return result;
}

}  // namespace

std::string text_at(const std::byte* p, std::size_t length) {
  const char* begin = reinterpret_cast<const char*>(p);
  return {begin, std::find(begin, begin + length, '\0')};
}

void put_text(std::byte* p, const std::string& text, std::size_t length) {
  std::memset(p, 0, length);
  std::memcpy(p, text.data(), std::min(text.size(), length));
}

bool is_extra_bytes(const Vlr& vlr) {
  return vlr.record_id == 4 && vlr.user_id == "LASF_Spec";
}

std::size_t type_size(FieldType type) {
  constexpr std::size_t kSizes[] = {0, 1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

ExtraBytes parse_extra_bytes(const std::vector<Vlr>& vlrs, std::size_t standard_bytes, std::size_t record_length) {
  ExtraBytes result;
  std::size_t offset = standard_bytes;
  for (const Vlr& vlr : vlrs) {
    if (!is_extra_bytes(vlr)) continue;
    if (vlr.payload.size() % kDescriptorSize != 0) return malformed("is not a multiple of 192 bytes");
    for (std::size_t at = 0; at < vlr.payload.size(); at += kDescriptorSize) {
      ExtraField field = parse_descriptor(vlr.payload.data() + at);
      if (field.size == 0) return malformed("has a field of unknown type or no size");
      if (offset + field.size > record_length) return malformed("is longer than the point record");
      field.offset = static_cast<std::uint16_t>(offset);
      offset += field.size;
      result.fields.push_back(std::move(field));
    }
    result.descriptors.insert(result.descriptors.end(), vlr.payload.begin(), vlr.payload.end());
  }
  return result;
}

void set_apart(CloudInfo& info, std::span<const ExtraField> ours) {
  const auto is_ours = [&](const std::string& name) {
    return std::ranges::any_of(ours, [&](const ExtraField& f) { return f.name == name; });
  };
  std::set<std::string> used;
  for (const ExtraField& f : info.layout.extra) used.insert(f.name);
  std::vector<std::string> names;  // of the fields that are renamed, in their order
  for (ExtraField& f : info.layout.extra) {
    if (!is_ours(f.name)) continue;
    const std::string base = f.name + "_input";
    std::string name = base;
    for (int n = 2; is_ours(name) || !used.insert(name).second; ++n) name = base + std::to_string(n);
    f.name = name;
    names.push_back(name);
  }
  std::size_t next = 0;
  for (Vlr& vlr : info.vlrs) {
    if (!is_extra_bytes(vlr)) continue;
    for (std::size_t at = 0; at + kDescriptorSize <= vlr.payload.size(); at += kDescriptorSize) {
      std::byte* name = vlr.payload.data() + at + kNameAt;
      if (next < names.size() && is_ours(text_at(name, kNameLength))) put_text(name, names[next++], kNameLength);
    }
  }
}

std::vector<std::byte> describe(std::span<const ExtraField> fields) {
  std::vector<std::byte> out;
  for (const ExtraField& field : fields) {
    if (field.type != FieldType::opaque) {
      append_descriptor(field, field.size, out);
      continue;
    }
    for (std::size_t left = field.size; left > 0;) {
      const std::size_t part = std::min(left, kLargestOpaque);
      append_descriptor(field, part, out);
      left -= part;
    }
  }
  return out;
}

}  // namespace ilot
