// SPDX-License-Identifier: Apache-2.0
// What the tests of formats share: a folder that goes away, the real data, rows by the dozen.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "engine/error.h"
#include "engine/formats/las/las.h"
#include "kernels/core/rng.h"

namespace ilot::test {

class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "ilot formats č XXXXXX").string();
    if (!mkdtemp(name.data())) throw Error("no temporary folder");
    path_ = name;
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(path_), {}));
  }

 private:
  std::filesystem::path path_;
};

inline std::vector<std::byte> slurp(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(in)), {});
  const auto* begin = reinterpret_cast<const std::byte*>(text.data());
  return {begin, begin + text.size()};
}

inline void spill(const std::filesystem::path& path, const std::vector<std::byte>& bytes) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

inline void spill_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

struct Rows {
  std::vector<std::byte> bytes;
  std::vector<std::uint8_t> valid;
};

// All rows, read front to back in pieces of `step`.
inline Rows read_all(PointReader& reader, std::size_t step = 1000) {
  const std::size_t length = reader.info().layout.record_length;
  Rows rows;
  std::vector<std::byte> piece(step * length);
  std::vector<std::uint8_t> valid(step);
  for (std::uint64_t first = 0;;) {
    const std::size_t got = reader.read(first, piece, valid);
    rows.bytes.insert(rows.bytes.end(), piece.begin(), piece.begin() + static_cast<std::ptrdiff_t>(got * length));
    rows.valid.insert(rows.valid.end(), valid.begin(), valid.begin() + static_cast<std::ptrdiff_t>(got));
    first += got;
    if (got == 0) return rows;
  }
}

// What damaged files came to.
struct DamageTally {
  int read = 0, refused = 0;
};

enum class DamageFound { at_open, while_reading };

// A file of any bytes is refused with a message that begins with its path, or read: no more rows than declared, fewer
// only with a warning, the same ones in pieces of any size and alone, and all that info() counts unless the damage is
// found while reading.
inline void expect_refused_or_read(const std::filesystem::path& path, DamageFound found, DamageTally& tally) {
  try {
    const auto reader = open_cloud(path);
    const CloudInfo& info = reader->info();
    ASSERT_LE(info.points, info.declared_points);
    ASSERT_TRUE(info.points == info.declared_points || !info.warnings.empty());
    const std::vector<std::uint64_t> boundaries = reader->boundaries();
    ASSERT_EQ(boundaries.front(), 0u);
    ASSERT_EQ(boundaries.back(), info.points);
    const Rows rows = read_all(*reader, 150), again = read_all(*reader, 7);
    for (const std::size_t count : {rows.valid.size(), again.valid.size()}) {
      ASSERT_LE(count, info.points);
      ASSERT_TRUE(count == info.points || found == DamageFound::while_reading);
    }
    const auto length = static_cast<std::ptrdiff_t>(info.layout.record_length);
    for (std::size_t i = 0; i < std::min(rows.valid.size(), again.valid.size()); ++i) {
      ASSERT_EQ(rows.valid[i], again.valid[i]);
      const auto row = rows.bytes.begin() + static_cast<std::ptrdiff_t>(i) * length;
      ASSERT_TRUE(!rows.valid[i] ||
                  std::equal(row, row + length, again.bytes.begin() + static_cast<std::ptrdiff_t>(i) * length))
          << "row " << i;
    }
    if (const std::size_t middle = rows.valid.size() / 2; reader->random_access() && middle > 0) {
      std::vector<std::byte> row(info.layout.record_length);
      std::vector<std::uint8_t> valid(1);
      ASSERT_EQ(reader->read(middle, row, valid), 1u);
      ASSERT_EQ(valid[0], rows.valid[middle]);
      ASSERT_TRUE(!valid[0] || std::equal(row.begin(), row.end(),
                                          rows.bytes.begin() + static_cast<std::ptrdiff_t>(middle) * length));
    }
    ++tally.read;
  } catch (const Error& error) {
    ASSERT_EQ(std::string(error.what()).rfind(path.string(), 0), 0u) << error.what();
    ++tally.refused;
  }
}

inline Vec3 world(const Rows& rows, const RecordLayout& layout, std::size_t row) {
  const std::byte* p = &rows.bytes[row * layout.record_length];
  return {load<std::int32_t>(p) * layout.scale[0] + layout.offset[0],
          load<std::int32_t>(p + 4) * layout.scale[1] + layout.offset[1],
          load<std::int32_t>(p + 8) * layout.scale[2] + layout.offset[2]};
}

// Bytes without meaning, the same for the same key.
inline std::vector<std::byte> random_bytes(std::size_t count, std::uint64_t key) {
  Rng rng(key);
  std::vector<std::byte> bytes(count);
  for (std::byte& b : bytes) b = static_cast<std::byte>(rng.below(256));
  return bytes;
}

// The folder of real data, or a loud skip.
#define ILOT_DATA_OR_SKIP(folder)                                                                  \
  const char* folder##_env = std::getenv("ILOT_DATA");                                             \
  if (!folder##_env) GTEST_SKIP() << "ILOT_DATA is not set: real data is absent, nothing checked"; \
  const std::filesystem::path folder = folder##_env

}  // namespace ilot::test
