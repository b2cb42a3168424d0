// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/tables/pcd.h"

#include <algorithm>
#include <charconv>
#include <string>

#include "engine/error.h"
#include "engine/formats/las/extra_bytes.h"
#include "engine/formats/tables/lines.h"
#include "engine/formats/tables/table.h"

namespace ilot {
namespace {

constexpr std::uint64_t kMostInMemory = std::uint64_t{1} << 30;
constexpr int kMostPcdLines = 100;

struct PcdHeader {
  std::vector<std::string> fields, types, data;
  std::vector<std::uint64_t> sizes, counts, width, height, points;
  std::uint64_t offset = 0, lines = 0;
};

// One field of the file: `count` values of one type side by side.
struct Group {
  std::string name;
  FieldType type = FieldType::opaque;
  std::size_t count = 1;
  std::size_t bytes() const { return count * type_size(type); }
};

[[noreturn]] void refuse(const InputFile& file, const std::string& why) {
  throw Error(file.path().string() + ": the PCD header " + why);
}

std::vector<std::uint64_t> numbers(const InputFile& file, std::span<const std::string_view> words) {
  std::vector<std::uint64_t> values;
  for (const std::string_view word : words) {
    std::uint64_t value = 0;
    if (std::from_chars(word.data(), word.data() + word.size(), value).ptr != word.data() + word.size())
      refuse(file, "has " + std::string(word.substr(0, 40)) + " where a count is due");
    values.push_back(value);
  }
  return values;
}

void take_line(const InputFile& file, const std::vector<std::string_view>& words, PcdHeader& header) {
  const std::span rest = std::span(words).subspan(1);
  const std::vector<std::string> texts(rest.begin(), rest.end());
  if (words[0] == "FIELDS" || words[0] == "COLUMNS") header.fields = texts;
  if (words[0] == "TYPE") header.types = texts;
  if (words[0] == "DATA") header.data = texts;
  if (words[0] == "SIZE") header.sizes = numbers(file, rest);
  if (words[0] == "COUNT") header.counts = numbers(file, rest);
  if (words[0] == "WIDTH") header.width = numbers(file, rest);
  if (words[0] == "HEIGHT") header.height = numbers(file, rest);
  if (words[0] == "POINTS") header.points = numbers(file, rest);
}

PcdHeader read_pcd_header(const InputFile& file) {
  LineReader lines(file, 0);
  PcdHeader header;
  std::string_view line;
  std::vector<std::string_view> words;
  for (int i = 0; i < kMostPcdLines && lines.next(line); ++i) {
    ++header.lines;
    split_fields(line, kMostColumns + 1, words);
    if (words.empty() || words[0].front() == '#') continue;
    take_line(file, words, header);
    if (words[0] != "DATA") continue;
    header.offset = lines.offset();
    return header;
  }
  refuse(file, "is missing or has no DATA line; is this a PCD file?");
}

FieldType type_of(const InputFile& file, const std::string& kind, std::uint64_t size) {
  const bool real = kind == "F", whole = kind == "I", natural = kind == "U";
  if (real && size == 4) return FieldType::f32;
  if (real && size == 8) return FieldType::f64;
  if (whole && size == 1) return FieldType::i8;
  if (whole && size == 2) return FieldType::i16;
  if (whole && size == 4) return FieldType::i32;
  if (whole && size == 8) return FieldType::i64;
  if (natural && size == 1) return FieldType::u8;
  if (natural && size == 2) return FieldType::u16;
  if (natural && size == 4) return FieldType::u32;
  if (natural && size == 8) return FieldType::u64;
  refuse(file, "has the unknown type " + kind + " of " + std::to_string(size) + " bytes");
}

std::vector<Group> groups_of(const InputFile& file, const PcdHeader& header) {
  const std::size_t n = header.fields.size();
  if (n == 0 || header.sizes.size() != n || header.types.size() != n ||
      (!header.counts.empty() && header.counts.size() != n))
    refuse(file, "has FIELDS, SIZE, TYPE and COUNT of different lengths");
  std::vector<Group> groups;
  std::uint64_t total = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint64_t count = header.counts.empty() ? 1 : header.counts[i];
    total += std::min<std::uint64_t>(count, kMostColumns + 1);
    if (count == 0 || total > kMostColumns) refuse(file, "has a COUNT that is zero or too large");
    groups.push_back(
        {header.fields[i], type_of(file, header.types[i], header.sizes[i]), static_cast<std::size_t>(count)});
  }
  return groups;
}

std::uint64_t declared_points(const InputFile& file, const PcdHeader& header) {
  if (header.points.size() == 1) return header.points[0];
  if (header.width.size() != 1) refuse(file, "has neither POINTS nor WIDTH");
  const std::uint64_t height = header.height.size() == 1 ? header.height[0] : 1;
  std::uint64_t points = 0;
  if (__builtin_mul_overflow(header.width[0], height, &points)) refuse(file, "has an absurd WIDTH and HEIGHT");
  return points;
}

// Returns the columns of the groups and their places in a row. Padding fields are named "_".
std::vector<TableColumn> columns_of(const std::vector<Group>& groups, BinaryBody& body) {
  std::vector<TableColumn> columns;
  for (const Group& group : groups) {
    for (std::size_t i = 0; i < group.count; ++i) {
      const std::string name = group.count == 1 ? group.name : group.name + "_" + std::to_string(i);
      if (group.name != "_") {
        columns.push_back({name, group.type});
        body.places.push_back(body.stride);
      }
      body.stride += type_size(group.type);
    }
  }
  return columns;
}

// The compressed block has one field after the other; this puts the rows together again.
std::vector<std::byte> expand_rows(const InputFile& file, const PcdHeader& header, const std::vector<Group>& groups,
                                   std::size_t stride, std::uint64_t rows) {
  std::byte head[8];
  if (file.read_at(header.offset, head) < sizeof head) refuse(file, "is not followed by the compressed block");
  const std::uint64_t packed_size = load<std::uint32_t>(head), size = load<std::uint32_t>(head + 4);
  if (packed_size > file.size() - header.offset - sizeof head || size > kMostInMemory || rows > size / stride ||
      rows * stride != size || size > packed_size * 264)
    refuse(file, "and the sizes of the compressed block contradict each other, or it exceeds 1 GiB");
  std::vector<std::byte> packed(packed_size), fields(size), out(size);
  file.read_at(header.offset + sizeof head, packed);
  if (!expand_lzf(packed, fields)) throw Error(file.path().string() + ": the compressed block is damaged");
  std::size_t from = 0, place = 0;
  for (const Group& group : groups) {
    for (std::uint64_t row = 0; row < rows; ++row, from += group.bytes())
      std::copy_n(&fields[from], group.bytes(), &out[static_cast<std::size_t>(row) * stride + place]);
    place += group.bytes();
  }
  return out;
}

std::unique_ptr<PointReader> open_binary(std::unique_ptr<InputFile> file, CloudInfo info, const PcdHeader& header,
                                         const std::vector<Group>& groups) {
  BinaryBody body;
  std::vector<TableColumn> columns = columns_of(groups, body);
  if (header.data[0] == "binary") {
    body.offset = header.offset;
    body.rows = std::min(info.declared_points, (file->size() - header.offset) / body.stride);
    const std::shared_ptr<InputFile> shared = std::move(file);
    body.read_at = [shared](std::uint64_t offset, std::span<std::byte> out) { return shared->read_at(offset, out); };
  } else {
    body.rows = info.declared_points;
    const auto rows = std::make_shared<std::vector<std::byte>>(
        body.rows == 0 ? std::vector<std::byte>{} : expand_rows(*file, header, groups, body.stride, body.rows));
    body.read_at = [rows](std::uint64_t offset, std::span<std::byte> out) {
      const std::size_t from = std::min<std::uint64_t>(offset, rows->size());
      const std::size_t count = std::min(out.size(), rows->size() - from);
      std::copy_n(rows->begin() + static_cast<std::ptrdiff_t>(from), count, out.begin());
      return count;
    };
  }
  return open_binary_table(std::move(info), std::move(columns), std::move(body));
}

std::unique_ptr<PointReader> open_ascii(std::unique_ptr<InputFile> file, CloudInfo info, const PcdHeader& header,
                                        const std::vector<Group>& groups) {
  std::vector<TableColumn> columns;
  for (const Group& group : groups)
    for (std::size_t i = 0; i < group.count; ++i)
      columns.push_back({group.count == 1 ? group.name : group.name + "_" + std::to_string(i), group.type});
  TextBody body;
  body.offset = header.offset;
  body.first_line = header.lines + 1;
  body.most_rows = info.declared_points;
  return open_text_table(std::move(file), std::move(info), std::move(columns), std::move(body));
}

}  // namespace

bool looks_like_pcd(std::span<const std::byte> beginning) {
  const std::string_view text(reinterpret_cast<const char*>(beginning.data()), beginning.size());
  return text.starts_with("# .PCD") || text.starts_with("VERSION 0.") || text.starts_with("VERSION .");
}

bool expand_lzf(std::span<const std::byte> in, std::span<std::byte> out) {
  std::size_t from = 0, to = 0;
  while (from < in.size()) {
    const auto control = std::to_integer<std::size_t>(in[from++]);
    if (control < 32) {
      const std::size_t length = control + 1;
      if (length > in.size() - from || length > out.size() - to) return false;
      std::copy_n(&in[from], length, &out[to]);
      from += length;
      to += length;
      continue;
    }
    std::size_t length = control >> 5;
    if (length == 7) {
      if (from == in.size()) return false;
      length += std::to_integer<std::size_t>(in[from++]);
    }
    length += 2;
    if (from == in.size()) return false;
    const std::size_t back = ((control & 31) << 8 | std::to_integer<std::size_t>(in[from++])) + 1;
    if (back > to || length > out.size() - to) return false;
    for (std::size_t i = 0; i < length; ++i, ++to) out[to] = out[to - back];
  }
  return to == out.size();
}

std::unique_ptr<PointReader> open_pcd(std::unique_ptr<InputFile> file) {
  const PcdHeader header = read_pcd_header(*file);
  const std::vector<Group> groups = groups_of(*file, header);
  CloudInfo info;
  info.path = file->path();
  info.format = "pcd";
  info.declared_points = declared_points(*file, header);
  if (header.data.size() == 1 && header.data[0] == "ascii")
    return open_ascii(std::move(file), std::move(info), header, groups);
  if (header.data.size() == 1 && (header.data[0] == "binary" || header.data[0] == "binary_compressed"))
    return open_binary(std::move(file), std::move(info), header, groups);
  refuse(*file, "has an unknown DATA coding (ascii, binary and binary_compressed are known)");
}

}  // namespace ilot
