// SPDX-License-Identifier: Apache-2.0
// An E57 file as the reader gives it, for tests.
#pragma once
#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "engine/error.h"
#include "tests/engine/formats/fixtures.h"
#include "tests/support/e57_writer.h"

namespace ilot::test {

struct OpenedE57 {
  std::unique_ptr<PointReader> reader;
  Rows rows;
  const RecordLayout& layout() const { return reader->info().layout; }
  Vec3 point(std::size_t row) const { return world(rows, layout(), row); }
  const std::byte* record(std::size_t row) const { return &rows.bytes[row * layout().record_length]; }
  PointFields fields(std::size_t row) const {
    return decode_fields({record(row), layout().record_length}, layout().point_format);
  }
  std::array<int, 3> colour(std::size_t row) const {
    const std::byte* p = record(row) + *rgb_offset(layout().point_format);
    return {load<std::uint16_t>(p), load<std::uint16_t>(p + 2), load<std::uint16_t>(p + 4)};
  }
  const std::byte* extra(std::size_t row, const std::string& name) const {
    for (const ExtraField& field : layout().extra)
      if (field.name == name) return record(row) + field.offset;
    throw Error("no extra field " + name);
  }
};

inline OpenedE57 open_bytes(const Folder& folder, const std::string& bytes, std::size_t step = 700) {
  spill_text(folder / "t.e57", bytes);
  OpenedE57 opened{open_cloud(folder / "t.e57"), {}};
  opened.rows = read_all(*opened.reader, step);
  return opened;
}

inline std::string message_of(const Folder& folder, const std::string& bytes) {
  try {
    open_bytes(folder, bytes);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

inline bool mentions(const std::vector<std::string>& warnings, const std::string& text) {
  return std::any_of(warnings.begin(), warnings.end(),
                     [&](const std::string& w) { return w.find(text) != std::string::npos; });
}

}  // namespace ilot::test
