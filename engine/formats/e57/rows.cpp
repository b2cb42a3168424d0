// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/e57/rows.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kernels/core/portable_math.h"

namespace ilot::e57 {
namespace {

constexpr std::size_t kFixed = 4;  // x, y, z, number of the scan

Vec3 turned(const Scan& scan, Vec3 v) {
  if (!scan.pose) return v;
  const auto& r = scan.pose->rotation;
  return {dot(r[0], v), dot(r[1], v), dot(r[2], v)};
}

// Returns NaN when the angles are not finite.
Vec3 from_spherical(double range, double azimuth, double elevation) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  if (!(std::abs(azimuth) < 1e6 && std::abs(elevation) < 1e6)) return {NAN, NAN, NAN};
  const double a = azimuth * kDegrees, e = elevation * kDegrees;
  const double flat = range * cos_degrees(e);
  return {flat * cos_degrees(a), flat * cos_degrees(a - 90), range * cos_degrees(e - 90)};
}

double stretched(double value, const Range& range) {
  const double share = (value - range.low) / (range.high - range.low);
  return std::isfinite(share) ? std::round(std::clamp(share, 0.0, 1.0) * 65535) : 0;
}

bool flagged(const Scan& scan, Use use, const Batch& batch, std::size_t i) {
  return scan.has(use) && batch[use][i] != 0;
}

double value_of(const Scan& scan, Use use, const Batch& batch, std::size_t i) {
  if (!scan.has(use)) return 0;
  const double value = batch[use][i];
  if (use == kIntensity) return flagged(scan, kIntensityState, batch, i) ? 0 : stretched(value, scan.intensity);
  if (use == kTime) return flagged(scan, kTimeState, batch, i) ? 0 : value;
  if (use == kReturnIndex) return value + 1;
  if (use >= kRed && use <= kBlue)
    return flagged(scan, kColourState, batch, i) ? 0 : stretched(value, scan.colour[use - kRed]);
  if (use < kNormalX) return value;
  const Vec3 normal = turned(scan, {batch[kNormalX][i], batch[kNormalY][i], batch[kNormalZ][i]});
  return use == kNormalX ? normal.x : use == kNormalY ? normal.y : normal.z;
}

}  // namespace

std::optional<Vec3> local_position(const Scan& scan, const Batch& batch, std::size_t i) {
  const bool cartesian = scan.cartesian();
  if (flagged(scan, cartesian ? kCartesianState : kSphericalState, batch, i)) return std::nullopt;
  if (cartesian) return Vec3{batch[kX][i], batch[kY][i], batch[kZ][i]};
  return from_spherical(batch[kRange][i], batch[kAzimuth][i], batch[kElevation][i]);
}

Rows::Rows(const std::vector<Scan>& scans)
    : columns_{
          {"x", FieldType::f64}, {"y", FieldType::f64}, {"z", FieldType::f64}, {"point source id", FieldType::u16}} {
  const auto any = [&](std::initializer_list<Use> uses) {
    return std::any_of(scans.begin(), scans.end(), [&](const Scan& scan) {
      return scan.problem.empty() && std::all_of(uses.begin(), uses.end(), [&](Use use) { return scan.has(use); });
    });
  };
  const bool colours = any({kRed, kGreen, kBlue}), normals = any({kNormalX, kNormalY, kNormalZ});
  add("intensity", FieldType::u16, kIntensity, any({kIntensity}));
  add("return number", FieldType::u8, kReturnIndex, any({kReturnIndex}));
  add("number of returns", FieldType::u8, kReturnCount, any({kReturnCount}));
  add("red", FieldType::u16, kRed, colours);
  add("green", FieldType::u16, kGreen, colours);
  add("blue", FieldType::u16, kBlue, colours);
  add("rowIndex", FieldType::i32, kRow, any({kRow}));
  add("columnIndex", FieldType::i32, kColumn, any({kColumn}));
  add("timeStamp", FieldType::f64, kTime, any({kTime}));
  add("NormalX", FieldType::f32, kNormalX, normals);
  add("NormalY", FieldType::f32, kNormalY, normals);
  add("NormalZ", FieldType::f32, kNormalZ, normals);
}

void Rows::add(const char* name, FieldType type, Use use, bool wanted) {
  if (!wanted) return;
  columns_.push_back({name, type});
  uses_.push_back(use);
}

bool Rows::fill(const Scan& scan, std::size_t number, const Batch& batch, std::size_t i,
                std::span<double> values) const {
  const auto local = local_position(scan, batch, i);
  if (!local) return false;
  const Vec3 world = turned(scan, *local) + (scan.pose ? scan.pose->translation : Vec3{});
  values[0] = world.x;
  values[1] = world.y;
  values[2] = world.z;
  values[3] = static_cast<double>(number);
  const bool normals = scan.has(kNormalX) && scan.has(kNormalY) && scan.has(kNormalZ);
  const bool colours = scan.has(kRed) && scan.has(kGreen) && scan.has(kBlue);
  for (std::size_t c = 0; c < uses_.size(); ++c) {
    const bool part = uses_[c] >= kNormalX ? normals : uses_[c] < kRed || uses_[c] > kBlue || colours;
    values[kFixed + c] = part ? value_of(scan, uses_[c], batch, i) : 0;
  }
  return true;
}

}  // namespace ilot::e57
