// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/changed_reader.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/formats/crs.h"
#include "engine/formats/crs_transform.h"

namespace ilot {
namespace {

class ReaderAround : public PointReader {
 public:
  explicit ReaderAround(std::unique_ptr<PointReader> inner) : inner_(std::move(inner)), info_(inner_->info()) {}

  const CloudInfo& info() const override { return info_; }
  bool random_access() const override { return inner_->random_access(); }
  std::vector<std::uint64_t> boundaries() const override { return inner_->boundaries(); }
  void limit_to(std::uint32_t fields) override { inner_->limit_to(fields); }
  std::size_t read(std::uint64_t first, std::span<std::byte> records, std::span<std::uint8_t> valid) override {
    return inner_->read(first, records, valid);
  }

 protected:
  std::unique_ptr<PointReader> inner_;
  CloudInfo info_;
};

class InCrs final : public ReaderAround {
 public:
  InCrs(std::unique_ptr<PointReader> inner, const Crs& crs) : ReaderAround(std::move(inner)) {
    replace_crs(info_, crs);
  }
  const PointReader& within() const { return *inner_; }
};

class HeightsInUnit final : public ReaderAround {
 public:
  HeightsInUnit(std::unique_ptr<PointReader> inner, double factor) : ReaderAround(std::move(inner)) {
    info_.layout.scale[2] *= factor;
    info_.layout.offset[2] *= factor;
    for (Station& station : info_.stations) station.position.z *= factor;
    info_.crs.metres_per_unit_z = info_.crs.metres_per_unit;
  }
  const PointReader& within() const { return *inner_; }
};

// Writes coordinates as integers of a layout; false when they do not fit.
bool put_place(const RecordLayout& layout, Vec3 p, std::byte* row) {
  const double place[3] = {p.x, p.y, p.z};
  std::int32_t raw[3];
  for (std::size_t i = 0; i < 3; ++i) {
    const double steps = std::nearbyint((place[i] - layout.offset[i]) / layout.scale[i]);
    if (!(steps >= INT32_MIN && steps <= INT32_MAX)) return false;
    raw[i] = static_cast<std::int32_t>(steps);
  }
  for (std::size_t i = 0; i < 3; ++i) store(row + 4 * i, raw[i]);
  return true;
}

Vec3 place_of(const RecordLayout& layout, const std::byte* row) {
  const auto axis = [&](std::size_t i) { return load<std::int32_t>(row + 4 * i) * layout.scale[i] + layout.offset[i]; };
  return {axis(0), axis(1), axis(2)};
}

class Reprojected final : public ReaderAround {
 public:
  Reprojected(std::unique_ptr<PointReader> inner, const Crs& source, const Crs& target, Vec3 near)
      : ReaderAround(std::move(inner)), transform_(source, target) {
    constexpr double kRaster = 1000, kUsual = 1e-3, kFine = 1e-4, kHalf = 5e-4, kDegree = 111320;  // metres; a degree
    const double step = inner_->info().layout.scale[0] * (source.geographic ? kDegree : source.metres_per_unit);
    const Vec3 above{near.x, near.y, near.z + kRaster};  // heights of 0 may stay where others change
    std::array<Vec3, 2> moved{near, above};
    transform_.apply(moved);
    const Vec3 there = moved[0];
    RecordLayout& layout = info_.layout;
    layout.scale[0] = layout.scale[1] = (step < kHalf ? kFine : kUsual) / target.metres_per_unit;
    layout.offset = {std::floor(there.x / kRaster) * kRaster, std::floor(there.y / kRaster) * kRaster,
                     layout.offset[2]};
    if (there.z != near.z || moved[1].z != above.z) {
      layout.scale[2] = layout.scale[0];
      layout.offset[2] = std::floor(there.z / kRaster) * kRaster;
    } else {
      unit_of_heights_ = source.metres_per_unit_z / target.metres_per_unit_z;
      layout.scale[2] *= unit_of_heights_;
      layout.offset[2] *= unit_of_heights_;
    }
    std::vector<Vec3> stations;
    for (const Station& station : info_.stations) stations.push_back(station.position);
    move(stations);
    for (std::size_t i = 0; i < stations.size(); ++i) info_.stations[i].position = stations[i];
    replace_crs(info_, target);
    // The cubes of the octree of a COPC file are in the source CRS.
    std::erase_if(info_.vlrs, [](const Vlr& vlr) { return vlr.user_id == "copc"; });
  }

  std::size_t read(std::uint64_t first, std::span<std::byte> records, std::span<std::uint8_t> valid) override {
    const std::size_t got = inner_->read(first, records, valid), length = info_.layout.record_length;
    std::vector<Vec3> places(got);
    for (std::size_t i = 0; i < got; ++i) places[i] = place_of(inner_->info().layout, &records[i * length]);
    move(places);
    for (std::size_t i = 0; i < got; ++i)
      if (valid[i] != 0 && !put_place(info_.layout, places[i], &records[i * length])) valid[i] = 0;
    return got;
  }

 private:
  void move(std::span<Vec3> places) const {
    transform_.apply(places);
    for (Vec3& place : places) place.z *= unit_of_heights_;
  }

  CrsTransform transform_;
  double unit_of_heights_ = 1;  // in that of the target, where PROJ does not change heights
};

}  // namespace

std::unique_ptr<PointReader> in_crs(std::unique_ptr<PointReader> reader, const Crs& crs) {
  return std::make_unique<InCrs>(std::move(reader), crs);
}

std::unique_ptr<PointReader> with_heights_in_unit(std::unique_ptr<PointReader> reader, double factor) {
  return std::make_unique<HeightsInUnit>(std::move(reader), factor);
}

const PointReader& reader_of_records(const PointReader& reader) {
  const auto* changed = dynamic_cast<const HeightsInUnit*>(&reader);
  return changed != nullptr ? changed->within() : reader;
}

const PointReader& reader_of_file(const PointReader& reader) {
  const PointReader& records = reader_of_records(reader);
  const auto* said = dynamic_cast<const InCrs*>(&records);
  return said != nullptr ? said->within() : records;
}

std::unique_ptr<PointReader> reprojected(std::unique_ptr<PointReader> reader, const Crs& source, const Crs& target,
                                         Vec3 near) {
  return std::make_unique<Reprojected>(std::move(reader), source, target, near);
}

}  // namespace ilot
