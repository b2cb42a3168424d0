// SPDX-License-Identifier: Apache-2.0
// Reads the points of a cloud for evaluation, one after the other, with extra bytes by name.
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "engine/formats/reader.h"

namespace ilot {

// Returns the extra bytes field with this name if it contains integers; nullopt when there is none.
std::optional<ExtraField> find_integer_field(const RecordLayout& layout, const std::string& name);

// The same for a field of exactly this type; otherwise throws an Error that names cloud, field and type.
ExtraField require_field(const CloudInfo& info, const std::string& name, FieldType type);

// The value of an integer field; u64 values of 2^63 and more wrap.
std::int64_t integer_of(const std::byte* record, const ExtraField& field);

// World coordinates of a record.
Vec3 position_of(const std::byte* record, const RecordLayout& layout);

// Calls `visit` with each usable record, front to back, on the calling thread. If a file is damaged after some point,
// the reading ends there. O(points), a few MiB.
void for_each_record(PointReader& reader, const std::function<void(const std::byte*)>& visit);

}  // namespace ilot
