// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/tables/table.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>

#include "engine/error.h"
#include "engine/formats/field_roles.h"
#include "engine/formats/las/extra_bytes.h"

namespace ilot {
namespace {

using namespace field_roles;

const std::map<std::string, FieldRole>& names() {
  static const std::map<std::string, FieldRole> kNames{{"x", kX},
                                                       {"easting", kX},
                                                       {"y", kY},
                                                       {"northing", kY},
                                                       {"z", kZ},
                                                       {"elevation", kZ},
                                                       {"i", kIntensity},
                                                       {"intensity", kIntensity},
                                                       {"scalarintensity", kIntensity},
                                                       {"returnnumber", kReturnNumber},
                                                       {"numberofreturns", kReturnCount},
                                                       {"returncount", kReturnCount},
                                                       {"classification", kClassification},
                                                       {"class", kClassification},
                                                       {"scalarclassification", kClassification},
                                                       {"synthetic", kSynthetic},
                                                       {"keypoint", kKeyPoint},
                                                       {"withheld", kWithheld},
                                                       {"overlap", kOverlap},
                                                       {"scannerchannel", kChannel},
                                                       {"scanchannel", kChannel},
                                                       {"scandirection", kDirection},
                                                       {"scandirectionflag", kDirection},
                                                       {"edgeofflightline", kEdge},
                                                       {"userdata", kUserData},
                                                       {"scanangle", kAngle},
                                                       {"scananglerank", kAngle},
                                                       {"sourceid", kSourceId},
                                                       {"pointsourceid", kSourceId},
                                                       {"gpstime", kGpsTime},
                                                       {"r", kRed},
                                                       {"red", kRed},
                                                       {"diffusered", kRed},
                                                       {"g", kGreen},
                                                       {"green", kGreen},
                                                       {"diffusegreen", kGreen},
                                                       {"b", kBlue},
                                                       {"blue", kBlue},
                                                       {"diffuseblue", kBlue},
                                                       {"nir", kNir},
                                                       {"infrared", kNir},
                                                       {"rgb", kPackedRgb},
                                                       {"rgba", kPackedRgb}};
  return kNames;
}

FieldRole role_of(const std::string& name) {
  std::string plain;
  for (const char c : name)
    if (std::isalnum(static_cast<unsigned char>(c)))
      plain.push_back(static_cast<char>(std::tolower(static_cast<unsigned char>(c))));
  const auto found = names().find(plain);
  return found == names().end() ? kExtra : found->second;
}

bool is_colour(int role) {
  return role >= kRed && role <= kNir;
}

template <class T>
T saturated(double value) {
  if (std::isnan(value)) return 0;
  constexpr double kLow = static_cast<double>(std::numeric_limits<T>::min());
  constexpr double kHigh = static_cast<double>(std::numeric_limits<T>::max());
  const double rounded = std::round(value);
  if (rounded <= kLow) return std::numeric_limits<T>::min();
  return rounded >= kHigh ? std::numeric_limits<T>::max() : static_cast<T>(rounded);
}

void store_as(FieldType type, double value, std::byte* p) {
  switch (type) {
    case FieldType::u8:
      return store(p, saturated<std::uint8_t>(value));
    case FieldType::i8:
      return store(p, saturated<std::int8_t>(value));
    case FieldType::u16:
      return store(p, saturated<std::uint16_t>(value));
    case FieldType::i16:
      return store(p, saturated<std::int16_t>(value));
    case FieldType::u32:
      return store(p, saturated<std::uint32_t>(value));
    case FieldType::i32:
      return store(p, saturated<std::int32_t>(value));
    case FieldType::u64:
      return store(p, saturated<std::uint64_t>(value));
    case FieldType::i64:
      return store(p, saturated<std::int64_t>(value));
    case FieldType::f32:
      return store(p, static_cast<float>(value));
    case FieldType::f64:
      return store(p, value);
    case FieldType::opaque:
      return;
  }
}

// Returns the bits of the packed colour of the PCL: a float or an unsigned integer whose lower bytes are r, g, b.
std::uint32_t packed_bits(double value, bool as_float) {
  if (!as_float) return saturated<std::uint32_t>(value);
  std::uint32_t bits;
  const auto narrow = static_cast<float>(value);
  std::memcpy(&bits, &narrow, sizeof bits);
  return bits;
}

void set_field(PointFields& f, int role, double value) {
  switch (role) {
    case kIntensity:
      f.intensity = saturated<std::uint16_t>(value);
      return;
    case kReturnNumber:
      f.return_number = saturated<std::uint8_t>(value);
      return;
    case kReturnCount:
      f.return_count = saturated<std::uint8_t>(value);
      return;
    case kClassification:
      f.classification = saturated<std::uint8_t>(value);
      return;
    case kSynthetic:
      f.synthetic = value != 0;
      return;
    case kKeyPoint:
      f.key_point = value != 0;
      return;
    case kWithheld:
      f.withheld = value != 0;
      return;
    case kOverlap:
      f.overlap = value != 0;
      return;
    case kChannel:
      f.scanner_channel = saturated<std::uint8_t>(value) & 3;
      return;
    case kDirection:
      f.scan_direction = value != 0;
      return;
    case kEdge:
      f.edge_of_flight_line = value != 0;
      return;
    case kUserData:
      f.user_data = saturated<std::uint8_t>(value);
      return;
    case kAngle:
      f.scan_angle_deg = value;
      return;
    case kSourceId:
      f.source_id = saturated<std::uint16_t>(value);
      return;
    default:
      return;
  }
}

// Returns the lattice of two samples. The number of decimals of binary numbers is not known.
TableLattice lattice_of(std::span<const TableColumn> columns, std::span<const double> sample,
                        std::span<const double> spread) {
  const auto [x, y, z] = coordinate_columns(columns);
  LatticeSurvey survey;
  for (const std::span<const double> rows : {sample, spread})
    for (std::size_t row = 0; row + columns.size() <= rows.size(); row += columns.size())
      survey.add({rows[row + x], rows[row + y], rows[row + z]});
  return survey.choose_for_sample();
}

}  // namespace

std::array<std::size_t, 3> coordinate_columns(std::span<const TableColumn> columns) {
  std::array<std::size_t, 3> found{columns.size(), columns.size(), columns.size()};
  for (std::size_t i = columns.size(); i-- > 0;) {
    const int role = role_of(columns[i].name);
    if (role >= kX && role <= kZ) found[static_cast<std::size_t>(role - kX)] = i;
  }
  return found;
}

bool has_coordinates(std::span<const TableColumn> columns) {
  return std::ranges::all_of(coordinate_columns(columns), [&](std::size_t i) { return i < columns.size(); });
}

TablePlan::TablePlan(const std::filesystem::path& path, std::span<const TableColumn> columns,
                     std::span<const double> sample, std::span<const double> spread,
                     const std::optional<TableLattice>& lattice) {
  if (!has_coordinates(columns)) throw Error(path.string() + ": has no columns x, y and z; name them in its header");
  if (columns.size() > kMostColumns) throw Error(path.string() + ": has more than 1000 columns");
  bool taken[kPackedRgb + 1] = {};
  for (const TableColumn& column : columns) {
    Target target;
    target.role = role_of(column.name);
    if (taken[target.role]) target.role = kExtra;
    if (target.role != kExtra) taken[target.role] = true;
    targets_.push_back(target);
  }
  choose_format();
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (targets_[i].role == kNir && layout_.point_format != 8) targets_[i].role = kExtra;
    if (targets_[i].role == kExtra) add_extra(path, columns[i], targets_[i]);
    if (targets_[i].role == kPackedRgb) targets_[i].factor = columns[i].type <= FieldType::i64 ? 0 : 1;
  }
  choose_factors(columns, sample);
  lattice_ = lattice ? *lattice : lattice_of(columns, sample, spread);
  layout_.scale = lattice_.scale;
  layout_.offset = lattice_.offset;
}

void TablePlan::choose_format() {
  bool colours = false, nir = false;
  for (const Target& target : targets_) {
    colours = colours || (target.role >= kRed && target.role <= kBlue) || target.role == kPackedRgb;
    nir = nir || target.role == kNir;
  }
  layout_.point_format = colours ? (nir ? 8 : 7) : 6;
  layout_.record_length = static_cast<std::uint16_t>(standard_size(layout_.point_format));
}

void TablePlan::add_extra(const std::filesystem::path& path, const TableColumn& column, Target& target) {
  ExtraField field;
  field.name = column.name.substr(0, 32);
  field.type = column.type;
  field.size = static_cast<std::uint16_t>(type_size(column.type));
  field.offset = layout_.record_length;
  if (layout_.record_length + field.size > UINT16_MAX) throw Error(path.string() + ": has too many columns");
  layout_.record_length = static_cast<std::uint16_t>(layout_.record_length + field.size);
  target.extra = layout_.extra.size();
  layout_.extra.push_back(std::move(field));
}

void TablePlan::choose_factors(std::span<const TableColumn> columns, std::span<const double> sample) {
  double most_colour = 0, most_intensity = 0;
  bool colour_fraction = false, intensity_fraction = false;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const int role = targets_[i % targets_.size()].role;
    const double value = sample[i];
    if (!std::isfinite(value)) continue;
    if (is_colour(role)) {
      most_colour = std::max(most_colour, value);
      colour_fraction = colour_fraction || value != std::round(value);
    } else if (role == kIntensity) {
      most_intensity = std::max(most_intensity, value);
      intensity_fraction = intensity_fraction || value != std::round(value);
    }
  }
  const double by_values = colour_fraction && most_colour <= 1 ? 65535 : most_colour <= 255 ? 257 : 1;
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    const FieldType type = columns[i].type;
    const bool real = type == FieldType::f32 || type == FieldType::f64;
    if (is_colour(targets_[i].role)) targets_[i].factor = real ? by_values : type_size(type) == 1 ? 257 : 1;
    if (targets_[i].role == kIntensity && real && intensity_fraction && most_intensity <= 1) targets_[i].factor = 65535;
  }
}

void set_points(CloudInfo& info, std::uint64_t points) {
  info.points = points;
  if (info.declared_points == 0) info.declared_points = points;
  if (points < info.declared_points)
    info.warnings.push_back("the header declares " + std::to_string(info.declared_points) +
                            " points but the file contains " + std::to_string(points) + " whole ones; these are kept");
}

void note_lattice(CloudInfo& info, const TableLattice& lattice) {
  constexpr int kUsual = 4;
  if (lattice.zeros_beyond > 0)
    info.warnings.push_back(std::to_string(lattice.zeros_beyond) +
                            (lattice.zeros_beyond == 1 ? " row is" : " rows are") +
                            " 0 0 0, far from all others (rays without an echo): rejected");
  if (lattice.beyond > 0)
    info.warnings.push_back(std::to_string(lattice.beyond) + (lattice.beyond == 1 ? " row is" : " rows are") +
                            " so far from all others that 32 bits do not reach so far: rejected");
  const bool rounds = lattice.decimals == TableLattice::kUnknown || lattice.decimals > lattice.kept;
  if (lattice.kept < kUsual && rounds)
    info.warnings.push_back("the points are so far apart that only " + std::to_string(lattice.kept) +
                            " decimals of their coordinates fit in 32 bits; split the file where more are needed");
}

bool TablePlan::encode(std::span<const double> values, std::span<std::byte> row) const {
  std::fill(row.begin(), row.end(), std::byte{0});
  PointFields fields;
  std::int32_t* const axes[3] = {&fields.x, &fields.y, &fields.z};
  std::uint16_t colours[4] = {};
  double gps_time = 0;
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    const Target& target = targets_[i];
    const double value = values[i];
    if (target.role == kExtra) {
      const ExtraField& extra = layout_.extra[target.extra];
      store_as(extra.type, value, &row[extra.offset]);
    } else if (target.role <= kZ) {
      const auto axis = static_cast<std::size_t>(target.role - kX);
      const double raw = std::round((value - layout_.offset[axis]) / layout_.scale[axis]);
      if (!(raw >= INT32_MIN && raw <= INT32_MAX)) {
        std::fill(row.begin(), row.end(), std::byte{0});
        return false;
      }
      *axes[axis] = static_cast<std::int32_t>(raw);
    } else if (is_colour(target.role)) {
      colours[target.role - kRed] = saturated<std::uint16_t>(value * target.factor);
    } else if (target.role == kPackedRgb) {
      const std::uint32_t bits = packed_bits(value, target.factor != 0);
      for (unsigned c = 0; c < 3; ++c) colours[c] = static_cast<std::uint16_t>(((bits >> (16 - 8 * c)) & 255) * 257);
    } else if (target.role == kGpsTime) {
      gps_time = value;
    } else {
      set_field(fields, target.role, target.role == kIntensity ? value * target.factor : value);
    }
  }
  encode_fields(fields, row, layout_.point_format);
  store(&row[*gps_time_offset(layout_.point_format)], gps_time);
  if (const auto rgb = rgb_offset(layout_.point_format)) std::memcpy(&row[*rgb], colours, 6);
  if (const auto nir = nir_offset(layout_.point_format)) std::memcpy(&row[*nir], &colours[3], 2);
  return true;
}

}  // namespace ilot
