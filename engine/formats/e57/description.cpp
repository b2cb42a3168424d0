// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/e57/description.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <pugixml.hpp>
#include <set>
#include <string_view>

#include "engine/error.h"
#include "engine/formats/tables/lines.h"

namespace ilot::e57 {
namespace {

constexpr std::ptrdiff_t kMostElements = 1'000'000;  // tags; the limit bounds the memory of the parsed document
constexpr std::size_t kMostFields = 1000;
constexpr int kDeepest = 8;
constexpr std::uint64_t kMostPoints = std::uint64_t{1} << 44;

constexpr std::array<std::string_view, kUses> kNames{"cartesianX",
                                                     "cartesianY",
                                                     "cartesianZ",
                                                     "sphericalRange",
                                                     "sphericalAzimuth",
                                                     "sphericalElevation",
                                                     "cartesianInvalidState",
                                                     "sphericalInvalidState",
                                                     "intensity",
                                                     "isIntensityInvalid",
                                                     "colorRed",
                                                     "colorGreen",
                                                     "colorBlue",
                                                     "isColorInvalid",
                                                     "rowIndex",
                                                     "columnIndex",
                                                     "returnIndex",
                                                     "returnCount",
                                                     "timeStamp",
                                                     "isTimeStampInvalid",
                                                     "normalX",
                                                     "normalY",
                                                     "normalZ"};

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r\n") - begin + 1);
}

// Empty text is zero: the standard allows this abbreviation.
bool to_number(std::string_view text, double& value) {
  text = trimmed(text);
  value = 0;
  return text.empty() || (parse_number(text, value) && std::isfinite(value));
}

template <class T>
bool to_integer(std::string_view text, T& value) {
  text = trimmed(text);
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  return std::from_chars(text.data(), text.data() + text.size(), value).ptr == text.data() + text.size() &&
         !text.empty();
}

double number_of(const pugi::xml_node& node, double otherwise) {
  double value = 0;
  return node && to_number(node.text().get(), value) ? value : otherwise;
}

std::string_view local_name(std::string_view name) {
  return name.substr(name.find(':') + 1);
}

// Returns minimum and maximum of an element such as intensityLimits; `otherwise` when they are absent or the range is
// empty.
Range limits_of(const pugi::xml_node& node, const std::string& name, const Range& otherwise) {
  const pugi::xml_node low = node.child((name + "Minimum").c_str()), high = node.child((name + "Maximum").c_str());
  const Range range{number_of(low, 0), number_of(high, 0)};
  return low && high && range.low < range.high ? range : otherwise;
}

// Fills coding, bits and range. Returns a sentence when it cannot.
std::string read_integer(const pugi::xml_node& node, Field& field, bool scaled) {
  std::int64_t low = INT64_MIN, high = INT64_MAX;
  const pugi::xml_attribute from = node.attribute("minimum"), to = node.attribute("maximum");
  if ((from && !to_integer(from.value(), low)) || (to && !to_integer(to.value(), high)) || low > high)
    return "field " + field.name + " has limits that are not two ordered integers";
  field.coding = Coding::integer;
  field.minimum = low;
  const std::uint64_t span = static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low);
  field.bits = static_cast<unsigned>(std::bit_width(span));
  if (scaled && ((node.attribute("scale") && !to_number(node.attribute("scale").value(), field.scale)) ||
                 !to_number(node.attribute("offset").value(), field.offset) || field.scale == 0))
    return "field " + field.name + " has a scale or offset that is not a usable number";
  const double a = static_cast<double>(low) * field.scale + field.offset;
  const double b = static_cast<double>(high) * field.scale + field.offset;
  if (from && to && a != b) field.range = Range{std::min(a, b), std::max(a, b)};
  return {};
}

void read_float(const pugi::xml_node& node, Field& field) {
  const bool single = std::string_view(node.attribute("precision").value()) == "single";
  field.coding = single ? Coding::f32 : Coding::f64;
  field.bits = single ? 32 : 64;
  double low = 0, high = 0;
  const pugi::xml_attribute from = node.attribute("minimum"), to = node.attribute("maximum");
  if (from && to && to_number(from.value(), low) && to_number(to.value(), high) && low < high)
    field.range = Range{low, high};
}

std::string read_field(const pugi::xml_node& node, Scan& scan) {
  const std::string_view type = node.attribute("type").value();
  Field field;
  field.name = node.name();
  if (scan.fields.size() == kMostFields) return "it has more than 1000 fields";
  std::string problem;
  if (type == "Float")
    read_float(node, field);
  else if (type == "Integer" || type == "ScaledInteger")
    problem = read_integer(node, field, type == "ScaledInteger");
  else if (type == "String")
    field.coding = Coding::text;
  else
    return "field " + field.name + " has the unknown type " + std::string(type.substr(0, 40));
  if (!problem.empty()) return problem;
  const auto found = std::find(kNames.begin(), kNames.end(), local_name(field.name));
  const auto use = static_cast<std::size_t>(found - kNames.begin());
  if (use < kUses && field.coding != Coding::text && !scan.places[use]) {
    field.use = use;
    scan.places[use] = scan.fields.size();
  }
  scan.fields.push_back(std::move(field));
  return {};
}

// The leaves in document order are the streams of the points.
std::string read_prototype(const pugi::xml_node& parent, Scan& scan, int depth) {
  for (const pugi::xml_node& node : parent.children()) {
    if (node.type() != pugi::node_element) continue;
    const std::string_view type = node.attribute("type").value();
    const bool inner = type == "Structure" || type == "Vector";
    if (inner && depth == kDeepest) return "its prototype is nested too deeply";
    std::string problem = inner ? read_prototype(node, scan, depth + 1) : read_field(node, scan);
    if (!problem.empty()) return problem;
  }
  return {};
}

std::optional<Pose> read_pose(const pugi::xml_node& node, const std::string& where,
                              std::vector<std::string>& warnings) {
  if (!node) return std::nullopt;
  Pose pose;
  const pugi::xml_node move = node.child("translation"), turn = node.child("rotation");
  pose.translation = {number_of(move.child("x"), 0), number_of(move.child("y"), 0), number_of(move.child("z"), 0)};
  if (!turn) return pose;
  double w = number_of(turn.child("w"), 0), x = number_of(turn.child("x"), 0), y = number_of(turn.child("y"), 0),
         z = number_of(turn.child("z"), 0);
  const double length = std::sqrt(w * w + x * x + y * y + z * z);
  if (!(length > 1e-6) || !std::isfinite(length)) {
    warnings.push_back(where + ": its rotation is no quaternion and is not applied");
    return pose;
  }
  if (std::abs(length - 1) > 1e-6) warnings.push_back(where + ": its rotation is not of unit length; it is normalised");
  w /= length, x /= length, y /= length, z /= length;
  pose.rotation = {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
                    {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
                    {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
  return pose;
}

const std::optional<Range>& range_of(const Scan& scan, Use use) {
  static const std::optional<Range> kNone;
  return scan.has(use) ? scan.fields[*scan.places[use]].range : kNone;
}

// Limits are those of the scan; else those of the field; else the usual ones.
void read_limits(const pugi::xml_node& node, Scan& scan) {
  const Range usual{0, 1};
  const pugi::xml_node intensity = node.child("intensityLimits"), colour = node.child("colorLimits");
  scan.intensity = limits_of(intensity, "intensity", range_of(scan, kIntensity).value_or(usual));
  const char* names[3] = {"colorRed", "colorGreen", "colorBlue"};
  for (std::size_t i = 0; i < 3; ++i)
    scan.colour[i] = limits_of(colour, names[i], range_of(scan, static_cast<Use>(kRed + i)).value_or(Range{0, 255}));
}

Scan read_scan(const pugi::xml_node& node, std::size_t number, std::vector<std::string>& warnings) {
  Scan scan;
  const std::string name(trimmed(node.child("name").text().get()));
  scan.name = name.empty() ? "scan " + std::to_string(number) : name.substr(0, 200);
  const std::string where = "scan " + std::to_string(number) + " (" + scan.name + ")";
  const pugi::xml_node points = node.child("points");
  if (!points) return scan;
  const bool counted = to_integer(points.attribute("recordCount").value(), scan.declared);
  if (!counted || scan.declared > kMostPoints || !to_integer(points.attribute("fileOffset").value(), scan.section)) {
    scan.declared = 0;
    warnings.push_back(where + ": has no usable recordCount and fileOffset and is left out");
    return scan;
  }
  scan.problem = read_prototype(points.child("prototype"), scan, 0);
  if (scan.problem.empty() && !scan.cartesian() && !scan.spherical())
    scan.problem = "it has neither cartesianX, Y, Z nor sphericalRange, Azimuth, Elevation";
  if (points.child("codecs").first_child().type() == pugi::node_element)
    scan.problem = "it names a codec, of which none is known";
  scan.pose = read_pose(node.child("pose"), where, warnings);
  read_limits(node, scan);
  return scan;
}

void warn_of_unused(const std::vector<Scan>& scans, std::vector<std::string>& warnings) {
  std::set<std::string> unused;
  for (const Scan& scan : scans)
    for (const Field& field : scan.fields)
      if (field.use == kUses && unused.size() < 20) unused.insert(field.name.substr(0, 60));
  if (unused.empty()) return;
  std::string list;
  for (const std::string& name : unused) list += (list.empty() ? "" : ", ") + name;
  warnings.push_back("fields that are not kept: " + list);
}

}  // namespace

Description parse_description(const std::filesystem::path& path, const std::string& xml) {
  if (std::count(xml.begin(), xml.end(), '<') > kMostElements)
    throw Error(path.string() + ": its XML section has more than a million tags; split the file into fewer scans");
  pugi::xml_document document;
  const pugi::xml_parse_result result = document.load_buffer(xml.data(), xml.size());
  if (!result)
    throw Error(path.string() + ": its XML section is not well-formed (" + result.description() + " at byte " +
                std::to_string(result.offset) + " of it); export the file again");
  const pugi::xml_node root = document.child("e57Root");
  if (!root) throw Error(path.string() + ": its XML section has no e57Root; export the file again");
  Description description;
  description.coordinates = trimmed(root.child("coordinateMetadata").text().get());
  for (const pugi::xml_node& node : root.child("data3D").children()) {
    if (node.type() != pugi::node_element) continue;
    description.scans.push_back(read_scan(node, description.scans.size() + 1, description.warnings));
  }
  warn_of_unused(description.scans, description.warnings);
  return description;
}

}  // namespace ilot::e57
