// SPDX-License-Identifier: Apache-2.0
// Points of a cloud as evaluation reads them: one after the other, extra bytes by name.
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "engine/formats/reader.h"

namespace ilot {

// A described extra byte field of this name that holds whole numbers; nullopt when there is none.
std::optional<ExtraField> find_integer_field(const RecordLayout& layout, const std::string& name);

// The same, of exactly this type; else an Error that names cloud, field and type.
ExtraField require_field(const CloudInfo& info, const std::string& name, FieldType type);

// The value of a whole-number field; u64 above 2^63 wrap.
std::int64_t integer_of(const std::byte* record, const ExtraField& field);

// World coordinates of a record.
Vec3 position_of(const std::byte* record, const RecordLayout& layout);

// Calls `visit` with each usable record, front to back, on the calling thread. A file damaged behind some point ends
// there. O(points), a few MiB.
void for_each_record(PointReader& reader, const std::function<void(const std::byte*)>& visit);

}  // namespace ilot
