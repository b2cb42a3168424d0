// SPDX-License-Identifier: Apache-2.0
#include "engine/proof/point_stream.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "engine/error.h"
#include "engine/formats/row_buffer.h"
#include "engine/pass/stop.h"

namespace ilot {
namespace {

const char* name_of(FieldType type) {
  constexpr const char* names[] = {"opaque", "u8", "i8", "u16", "i16", "u32", "i32", "u64", "i64", "f32", "f64"};
  return names[static_cast<std::size_t>(type)];
}

const ExtraField* find(const RecordLayout& layout, const std::string& name) {
  for (const ExtraField& field : layout.extra)
    if (field.name == name) return &field;
  return nullptr;
}

}  // namespace

std::optional<ExtraField> find_integer_field(const RecordLayout& layout, const std::string& name) {
  const ExtraField* field = find(layout, name);
  if (!field || field->type < FieldType::u8 || field->type > FieldType::i64) return std::nullopt;
  return *field;
}

ExtraField require_field(const CloudInfo& info, const std::string& name, FieldType type) {
  const ExtraField* field = find(info.layout, name);
  if (!field || field->type != type)
    throw Error(fmt::format("{}: no extra bytes '{}' of the type {}; give a cloud that carries them",
                            info.path.string(), name, name_of(type)));
  return *field;
}

std::int64_t integer_of(const std::byte* record, const ExtraField& field) {
  const std::byte* at = record + field.offset;
  switch (field.type) {
    case FieldType::u8:
      return load<std::uint8_t>(at);
    case FieldType::i8:
      return load<std::int8_t>(at);
    case FieldType::u16:
      return load<std::uint16_t>(at);
    case FieldType::i16:
      return load<std::int16_t>(at);
    case FieldType::u32:
      return load<std::uint32_t>(at);
    case FieldType::i32:
      return load<std::int32_t>(at);
    default:
      return load<std::int64_t>(at);
  }
}

Vec3 position_of(const std::byte* record, const RecordLayout& layout) {
  const auto world = [&](std::size_t axis) {
    return load<std::int32_t>(record + 4 * axis) * layout.scale[axis] + layout.offset[axis];
  };
  return {world(0), world(1), world(2)};
}

void for_each_record(PointReader& reader, const std::function<void(const std::byte*)>& visit) {
  const CloudInfo& info = reader.info();
  const std::size_t length = info.layout.record_length;
  const std::size_t most = rows_at_a_time(length);
  std::vector<std::byte> records(most * length);
  std::vector<std::uint8_t> valid(most);
  for (std::uint64_t first = 0; first < info.points;) {
    if (stop_requested()) throw Error("evaluate: interrupted", ExitCode::interrupted);
    const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(most, info.points - first));
    const std::size_t got =
        reader.read(first, std::span(records).first(wanted * length), std::span(valid).first(wanted));
    for (std::size_t i = 0; i < got; ++i)
      if (valid[i]) visit(&records[i * length]);
    if (got < wanted) break;
    first += got;
  }
}

}  // namespace ilot
