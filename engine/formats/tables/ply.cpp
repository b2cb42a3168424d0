// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/tables/ply.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <string>

#include "engine/error.h"
#include "engine/formats/las/extra_bytes.h"
#include "engine/formats/tables/lines.h"
#include "engine/formats/tables/table.h"

namespace ilot {
namespace {

constexpr std::size_t kMostProperties = 1000, kMostElements = 100, kMostPlyLines = 10000;

enum class Coding { unknown, ascii, little, big };

struct Property {
  std::string name;
  FieldType type = FieldType::opaque;
  std::optional<FieldType> count;  // of a list
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;

  bool has_list() const {
    return std::any_of(properties.begin(), properties.end(), [](const Property& p) { return p.count.has_value(); });
  }
  std::size_t stride() const {
    std::size_t bytes = 0;
    for (const Property& property : properties) bytes += type_size(property.type);
    return bytes;
  }
};

struct PlyHeader {
  Coding coding = Coding::unknown;
  std::vector<Element> elements;
  std::uint64_t data = 0, lines = 0;  // bytes and lines of the header
};

[[noreturn]] void refuse(const InputFile& file, std::uint64_t line, const std::string& why) {
  throw Error(file.path().string() + ": line " + std::to_string(line) + " of the PLY header " + why);
}

FieldType type_named(const InputFile& file, std::uint64_t line, std::string_view name) {
  static const std::map<std::string_view, FieldType> kTypes{
      {"char", FieldType::i8},   {"int8", FieldType::i8},     {"uchar", FieldType::u8},   {"uint8", FieldType::u8},
      {"short", FieldType::i16}, {"int16", FieldType::i16},   {"ushort", FieldType::u16}, {"uint16", FieldType::u16},
      {"int", FieldType::i32},   {"int32", FieldType::i32},   {"uint", FieldType::u32},   {"uint32", FieldType::u32},
      {"float", FieldType::f32}, {"float32", FieldType::f32}, {"double", FieldType::f64}, {"float64", FieldType::f64}};
  const auto found = kTypes.find(name);
  if (found == kTypes.end()) refuse(file, line, "has the unknown type " + std::string(name));
  return found->second;
}

void take_element(const InputFile& file, const std::vector<std::string_view>& words, PlyHeader& header) {
  Element element;
  const bool number =
      words.size() == 3 && std::from_chars(words[2].data(), words[2].data() + words[2].size(), element.count).ptr ==
                               words[2].data() + words[2].size();
  if (!number || header.elements.size() >= kMostElements) refuse(file, header.lines, "is not an element with a count");
  element.name = words[1];
  header.elements.push_back(std::move(element));
}

void take_property(const InputFile& file, const std::vector<std::string_view>& words, PlyHeader& header) {
  const bool list = words.size() == 5 && words[1] == "list";
  if (header.elements.empty() || !(list || words.size() == 3)) refuse(file, header.lines, "is not a property");
  Element& element = header.elements.back();
  if (element.properties.size() >= kMostProperties) refuse(file, header.lines, "is one property too many");
  Property property;
  property.name = words.back();
  property.type = type_named(file, header.lines, words[words.size() - 2]);
  if (list) property.count = type_named(file, header.lines, words[2]);
  if (list && *property.count >= FieldType::f32) refuse(file, header.lines, "counts a list with a fraction");
  element.properties.push_back(std::move(property));
}

void take_format(const InputFile& file, const std::vector<std::string_view>& words, PlyHeader& header) {
  if (words.size() >= 2 && words[1] == "ascii") header.coding = Coding::ascii;
  if (words.size() >= 2 && words[1] == "binary_little_endian") header.coding = Coding::little;
  if (words.size() >= 2 && words[1] == "binary_big_endian") header.coding = Coding::big;
  if (header.coding == Coding::unknown) refuse(file, header.lines, "names an unknown format");
}

PlyHeader read_ply_header(const InputFile& file) {
  LineReader lines(file, 0);
  PlyHeader header;
  std::string_view line;
  std::vector<std::string_view> words;
  while (header.lines < kMostPlyLines && lines.next(line)) {
    ++header.lines;
    split_fields(line, 6, words);
    if (header.lines == 1 || words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
    if (words[0] == "format")
      take_format(file, words, header);
    else if (words[0] == "element")
      take_element(file, words, header);
    else if (words[0] == "property")
      take_property(file, words, header);
    else if (words[0] != "end_header")
      refuse(file, header.lines, "begins with the unknown word " + std::string(words[0].substr(0, 40)));
    if (words[0] != "end_header") continue;
    if (header.coding == Coding::unknown) refuse(file, header.lines, "ends it without a format");
    header.data = lines.offset();
    return header;
  }
  throw Error(file.path().string() + ": the PLY header has no end_header");
}

// Skips elements whose rows have lists; reads only the counts.
class Walker {
 public:
  Walker(const InputFile& file, std::uint64_t at, bool big_endian) : file_(file), at_(at), big_endian_(big_endian) {}

  std::uint64_t place() const { return at_; }

  void skip(const Element& element) {
    if (!element.has_list()) {
      const std::size_t stride = element.stride();
      if (stride != 0 && element.count > (file_.size() - at_) / stride) truncated(element);
      at_ += element.count * stride;
      return;
    }
    for (std::uint64_t row = 0; row < element.count; ++row)
      for (const Property& property : element.properties) skip(element, property);
  }

 private:
  [[noreturn]] void truncated(const Element& element) const {
    throw Error(file_.path().string() + ": ends inside the element " + element.name +
                ", which stands before the vertices");
  }

  void skip(const Element& element, const Property& property) {
    std::uint64_t items = 1;
    if (property.count) {
      items = count_at(element, type_size(*property.count));
      at_ += type_size(*property.count);
    }
    if (items > (file_.size() - at_) / type_size(property.type)) truncated(element);
    at_ += items * type_size(property.type);
  }

  std::uint64_t count_at(const Element& element, std::size_t size) {
    if (size > file_.size() - at_) truncated(element);
    if (at_ < begin_ || at_ + size > begin_ + buffer_.size()) {
      buffer_.resize(1u << 16);
      begin_ = at_;
      buffer_.resize(file_.read_at(begin_, buffer_));
      if (buffer_.size() < size) truncated(element);
    }
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const std::size_t byte = big_endian_ ? i : size - 1 - i;
      value = value << 8 | std::to_integer<std::uint64_t>(buffer_[static_cast<std::size_t>(at_ - begin_) + byte]);
    }
    return value;
  }

  const InputFile& file_;
  std::uint64_t at_;
  bool big_endian_;
  std::vector<std::byte> buffer_;
  std::uint64_t begin_ = 0;
};

std::size_t vertex_index(const InputFile& file, const PlyHeader& header) {
  for (std::size_t i = 0; i < header.elements.size(); ++i) {
    if (header.elements[i].name != "vertex") continue;
    if (header.elements[i].has_list())
      throw Error(file.path().string() + ": its vertices have lists, which is not supported; remove these properties");
    return i;
  }
  throw Error(file.path().string() + ": the PLY header declares no element vertex");
}

std::unique_ptr<PointReader> open_ascii(std::unique_ptr<InputFile> file, CloudInfo info,
                                        std::vector<TableColumn> columns, const PlyHeader& header, std::size_t vertex) {
  LineReader lines(*file, header.data);
  TextBody body;
  body.first_line = header.lines + 1;
  body.most_rows = header.elements[vertex].count;
  std::string_view line;
  for (std::size_t i = 0; i < vertex; ++i)
    for (std::uint64_t row = 0; row < header.elements[i].count && lines.next(line); ++row) ++body.first_line;
  body.offset = lines.offset();
  return open_text_table(std::move(file), std::move(info), std::move(columns), std::move(body));
}

std::unique_ptr<PointReader> open_binary(std::unique_ptr<InputFile> file, CloudInfo info,
                                         std::vector<TableColumn> columns, const PlyHeader& header,
                                         std::size_t vertex) {
  Walker walker(*file, header.data, header.coding == Coding::big);
  for (std::size_t i = 0; i < vertex; ++i) walker.skip(header.elements[i]);
  BinaryBody body;
  body.offset = walker.place();
  body.stride = header.elements[vertex].stride();
  if (body.stride == 0) throw Error(file->path().string() + ": its vertices have no properties");
  body.rows = std::min(info.declared_points, (file->size() - body.offset) / body.stride);
  body.big_endian = header.coding == Coding::big;
  std::size_t place = 0;
  for (const TableColumn& column : columns) {
    body.places.push_back(place);
    place += type_size(column.type);
  }
  const std::shared_ptr<InputFile> shared = std::move(file);
  body.read_at = [shared](std::uint64_t offset, std::span<std::byte> out) { return shared->read_at(offset, out); };
  return open_binary_table(std::move(info), std::move(columns), std::move(body));
}

}  // namespace

std::unique_ptr<PointReader> open_ply(std::unique_ptr<InputFile> file) {
  const PlyHeader header = read_ply_header(*file);
  const std::size_t vertex = vertex_index(*file, header);
  std::vector<TableColumn> columns;
  for (const Property& property : header.elements[vertex].properties) columns.push_back({property.name, property.type});
  CloudInfo info;
  info.path = file->path();
  info.format = "ply";
  info.declared_points = header.elements[vertex].count;
  if (header.coding == Coding::ascii)
    return open_ascii(std::move(file), std::move(info), std::move(columns), header, vertex);
  return open_binary(std::move(file), std::move(info), std::move(columns), header, vertex);
}

}  // namespace ilot
