// SPDX-License-Identifier: Apache-2.0
// The description of extra bytes: records LASF_Spec 4 with a payload of 192-byte descriptors. (ASPRS LAS 1.4 R15, table
// 24)
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/cloud/cloud_info.h"

namespace ilot {

constexpr std::size_t kDescriptorSize = 192;

bool is_extra_bytes(const Vlr& vlr);

struct ExtraBytes {
  std::vector<ExtraField> fields;      // in record order; offsets from the start of the record
  std::vector<std::byte> descriptors;  // verbatim, for `fields`; empty when malformed
  std::vector<std::string> warnings;
};

// Reads the descriptors of all such VLRs in their order. If descriptors do not fit the record, or a payload is not a
// multiple of 192 bytes, the whole description is malformed: it has no fields and one warning. O(descriptors).
ExtraBytes parse_extra_bytes(const std::vector<Vlr>& vlrs, std::size_t standard_bytes, std::size_t record_length);

// Returns one descriptor for each field (several for opaque fields above 255 bytes), ready to be a payload.
std::vector<std::byte> describe(std::span<const ExtraField> fields);

// Gives each field of a cloud that has the name of one of `ours` the name NAME_input (NAME_input2 where that is taken
// too), in its layout and in its records.
void set_apart(CloudInfo& info, std::span<const ExtraField> ours);

// Returns the number of bytes of a field type; 0 for opaque.
std::size_t type_size(FieldType type);

// Reads and writes a text in a field of `length` bytes, padded with zeros; a longer text is cut.
std::string text_at(const std::byte* p, std::size_t length);
void put_text(std::byte* p, const std::string& text, std::size_t length);

}  // namespace ilot
