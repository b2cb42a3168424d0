// SPDX-License-Identifier: Apache-2.0
#include "study/cut_reader.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "engine/proof/point_stream.h"
#include "kernels/core/rng.h"

namespace ilot {
namespace {

// Rejects points of another reader.
class SomePoints : public PointReader {
 public:
  explicit SomePoints(std::unique_ptr<PointReader> reader) : reader_(std::move(reader)) {}

  const CloudInfo& info() const override { return reader_->info(); }
  bool random_access() const override { return reader_->random_access(); }
  std::vector<std::uint64_t> boundaries() const override { return reader_->boundaries(); }
  void limit_to(std::uint32_t fields) override { reader_->limit_to(fields); }

  std::size_t read(std::uint64_t first, std::span<std::byte> records, std::span<std::uint8_t> valid) override {
    const std::size_t rows = reader_->read(first, records, valid);
    for (std::size_t i = 0; i < rows; ++i)
      if (valid[i] != 0 && !keeps(first + i, records.data() + i * info().layout.record_length)) valid[i] = 0;
    return rows;
  }

 private:
  virtual bool keeps(std::uint64_t number, const std::byte* record) const = 0;

  std::unique_ptr<PointReader> reader_;
};

class CutReader : public SomePoints {
 public:
  CutReader(std::unique_ptr<PointReader> reader, const CutPlane& plane, double height)
      : SomePoints(std::move(reader)), plane_(plane), height_(height) {}

 private:
  bool keeps(std::uint64_t, const std::byte* record) const override { return above(record) <= height_; }
  double above(const std::byte* record) const {
    std::int32_t raw[3];
    std::memcpy(raw, record, sizeof raw);
    const RecordLayout& layout = info().layout;
    const auto at = [&](std::size_t axis) { return raw[axis] * layout.scale[axis] + layout.offset[axis]; };
    return (plane_.a * at(0) + plane_.b * at(1) + plane_.c * at(2) + plane_.d) / plane_.c;
  }

  CutPlane plane_;
  double height_;
};

class ThinReader : public SomePoints {
 public:
  ThinReader(std::unique_ptr<PointReader> reader, std::uint32_t of) : SomePoints(std::move(reader)), of_(of) {}

 private:
  bool keeps(std::uint64_t number, const std::byte*) const override { return Rng(number, of_).below(of_) == 0; }
  std::uint64_t of_;
};

class BareReader : public SomePoints {
 public:
  explicit BareReader(std::unique_ptr<PointReader> reader)
      : SomePoints(std::move(reader)), true_class_(*find_integer_field(info().layout, "true_class")) {}

  void limit_to(std::uint32_t fields) override { SomePoints::limit_to(fields | kFieldExtra); }

 private:
  static constexpr std::int64_t kGround = 1;
  bool keeps(std::uint64_t, const std::byte* record) const override {
    return integer_of(record, true_class_) != kGround;
  }
  ExtraField true_class_;
};

// Puts one point in `of` of the objects onto the ground below it, and rejects all others.
class FloorReader : public PointReader {
 public:
  FloorReader(std::unique_ptr<PointReader> reader, std::uint32_t of, std::map<std::uint32_t, double> ground)
      : reader_(std::move(reader)),
        of_(of),
        ground_(std::move(ground)),
        true_element_(*find_integer_field(info().layout, "true_element")) {}

  const CloudInfo& info() const override { return reader_->info(); }
  bool random_access() const override { return reader_->random_access(); }
  std::vector<std::uint64_t> boundaries() const override { return reader_->boundaries(); }
  void limit_to(std::uint32_t fields) override { reader_->limit_to(fields | kFieldExtra); }

  std::size_t read(std::uint64_t first, std::span<std::byte> records, std::span<std::uint8_t> valid) override {
    const std::size_t rows = reader_->read(first, records, valid);
    const RecordLayout& layout = info().layout;
    for (std::size_t i = 0; i < rows; ++i) {
      std::byte* record = records.data() + i * layout.record_length;
      const auto below = ground_.find(static_cast<std::uint32_t>(integer_of(record, true_element_)));
      if (below == ground_.end() || Rng(first + i, of_).below(of_) != 0) {
        valid[i] = 0;
        continue;
      }
      const auto z = static_cast<std::int32_t>(std::lround((below->second - layout.offset[2]) / layout.scale[2]));
      std::memcpy(record + 2 * sizeof z, &z, sizeof z);
    }
    return rows;
  }

 private:
  std::unique_ptr<PointReader> reader_;
  std::uint64_t of_;
  std::map<std::uint32_t, double> ground_;  // heights by object
  ExtraField true_element_;
};

nlohmann::json truth_of(const std::filesystem::path& cloud) {
  const std::filesystem::path path = std::filesystem::path(cloud).replace_extension(".truth.json");
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path.string() + ": no truth");
  return nlohmann::json::parse(file);
}

// The heights of the ground below the objects of a truth.
std::map<std::uint32_t, double> ground_of_objects(const std::filesystem::path& cloud) {
  std::map<std::uint32_t, double> out;
  const nlohmann::json truth = truth_of(cloud);
  for (const auto& object : truth.at("objects")) out[object.at("id")] = object.at("base").at(2);
  return out;
}

}  // namespace

std::unique_ptr<PointReader> cut_above(std::unique_ptr<PointReader> reader, const CutPlane& plane, double height) {
  return std::make_unique<CutReader>(std::move(reader), plane, height);
}

std::unique_ptr<PointReader> thinned(std::unique_ptr<PointReader> reader, std::uint32_t of) {
  return std::make_unique<ThinReader>(std::move(reader), of);
}

std::unique_ptr<PointReader> without_ground(std::unique_ptr<PointReader> reader) {
  return std::make_unique<BareReader>(std::move(reader));
}

std::string Leaving::name() const {
  return (cut > 0 ? fmt::format(".cut{}", cut) : "") + (ground ? ".bare" : "") +
         (one_in > 1 ? fmt::format(".thin{}", one_in) : "") + (floor > 0 ? fmt::format(".floor{}", floor) : "");
}

std::string Leaving::option() const {
  if (one_in > 1) return fmt::format(" --thin {}", one_in);
  if (floor > 0) return fmt::format(" --floor {}", floor);
  return cut > 0 ? fmt::format(" --{} {}", ground ? "bare" : "cut", cut) : "";
}

bool is_leaving(const std::string& word) {
  return word == "--cut" || word == "--bare" || word == "--thin" || word == "--floor";
}

Leaving leaving_of(const std::string& word, const std::string& value) {
  if (word == "--thin") return {0, static_cast<std::uint32_t>(std::stoul(value)), false};
  if (word == "--floor") return {.floor = static_cast<std::uint32_t>(std::stoul(value))};
  return {std::stod(value), 1, word == "--bare"};
}

CutPlane road_plane(const std::filesystem::path& cloud) {
  const nlohmann::json root = truth_of(cloud);
  CutPlane road;
  std::uint64_t most = 0;
  for (const auto& p : root.at("planes")) {
    if (p.at("class") != "ground" || p.at("points") <= most) continue;
    most = p.at("points");
    const auto& v = p.at("plane");
    road = {v[0], v[1], v[2], v[3]};
  }
  return road;
}

std::vector<std::unique_ptr<PointReader>> open_street(const std::filesystem::path& cloud, const Leaving& leaving) {
  std::unique_ptr<PointReader> reader = open_cloud(cloud);
  if (leaving.cut > 0) reader = cut_above(std::move(reader), road_plane(cloud), leaving.cut);
  if (leaving.ground) reader = without_ground(std::move(reader));
  if (leaving.one_in > 1) reader = thinned(std::move(reader), leaving.one_in);
  std::vector<std::unique_ptr<PointReader>> readers;
  readers.push_back(std::move(reader));
  if (leaving.floor > 0)
    readers.push_back(std::make_unique<FloorReader>(open_cloud(cloud), leaving.floor, ground_of_objects(cloud)));
  return readers;
}

}  // namespace ilot
