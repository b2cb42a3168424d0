// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/arrays/array_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstring>
#include <functional>

#include "engine/error.h"
#include "engine/formats/arrays/array_rows.h"
#include "engine/formats/crs.h"
#include "kernels/core/parallel.h"

namespace ilot {
namespace {

constexpr std::size_t kStretch = std::size_t{1} << 18;  // points looked at by one thread at a time, read in one go

std::size_t stretches_of(std::size_t points) {
  return (points + kStretch - 1) / kStretch;
}

class ArrayReader final : public PointReader {
 public:
  ArrayReader(const ArrayCloud& cloud, CloudInfo info) : cloud_(cloud), info_(std::move(info)) {}

  const CloudInfo& info() const override { return info_; }
  bool random_access() const override { return true; }

  std::vector<std::uint64_t> boundaries() const override {
    std::vector<std::uint64_t> places{0};
    while (places.back() < info_.points) places.push_back(std::min(places.back() + kStretch, info_.points));
    return places;
  }

  std::size_t read(std::uint64_t first, std::span<std::byte> records, std::span<std::uint8_t> valid) override {
    const std::size_t length = info_.layout.record_length;
    const std::size_t rows = static_cast<std::size_t>(
        std::min<std::uint64_t>(records.size() / length, info_.points - std::min(first, info_.points)));
    fill_rows(cloud_, info_.layout, static_cast<std::size_t>(first), records.first(rows * length));
    std::fill_n(valid.begin(), rows, std::uint8_t{1});
    return rows;
  }

 private:
  ArrayCloud cloud_;
  CloudInfo info_;
};

// Finds a coordinate that no row can have before the run begins, when nothing is lost by it.
void check_places(const ArrayCloud& cloud, const RecordLayout& layout) {
  std::vector<std::string> faults(stretches_of(cloud.x.size()));
  parallel_for(faults.size(), [&](std::size_t s) {
    const std::size_t first = s * kStretch, last = std::min(first + kStretch, cloud.x.size());
    const auto fits = [&](double value, double offset) {
      return std::abs(value - offset) < 2147483647.0 * layout.scale[0];
    };
    for (std::size_t i = first; i < last; ++i) {
      if (fits(cloud.x[i], layout.offset[0]) && fits(cloud.y[i], layout.offset[1]) &&
          fits(cloud.z[i], layout.offset[2]))
        continue;
      std::vector<std::byte> row(layout.record_length);
      try {
        fill_rows(cloud, layout, i, row);
      } catch (const Error& fault) {
        faults[s] = fault.what();
        return;
      }
    }
  });
  for (const std::string& fault : faults)
    if (!fault.empty()) throw Error(fault, ExitCode::usage);
}

std::uint64_t mixed(std::uint64_t sum, std::uint64_t word) {
  return std::rotl((sum ^ word) * 0x9e3779b97f4a7c15u,
                   29);  // Choice: an odd number without pattern, 2^64 / golden ratio
}

std::uint64_t sum_of(std::span<const std::byte> bytes) {
  std::uint64_t sum = bytes.size(), word = 0;
  std::size_t at = 0;
  for (; at + sizeof word <= bytes.size(); at += sizeof word) {
    std::memcpy(&word, &bytes[at], sizeof word);
    sum = mixed(sum, word);
  }
  for (; at < bytes.size(); ++at) sum = mixed(sum, std::to_integer<std::uint64_t>(bytes[at]));
  return sum;
}

// The sums of stretches of a fixed length, so that the threads have no part in the result.
template <class T>
std::uint64_t sum_of_array(std::span<const T> values) {
  std::vector<std::uint64_t> sums(stretches_of(values.size()));
  parallel_for(sums.size(), [&](std::size_t s) {
    sums[s] = sum_of(std::as_bytes(values.subspan(s * kStretch, std::min(kStretch, values.size() - s * kStretch))));
  });
  return sum_of(std::as_bytes(std::span(sums)));
}

}  // namespace

std::unique_ptr<PointReader> open_arrays(const ArrayCloud& cloud) {
  if (cloud.name.empty() || cloud.name.find('/') != cloud.name.npos || cloud.name.starts_with('.'))
    throw Error("\"" + cloud.name + "\": is no name for a cloud in memory: it becomes the name of a file",
                ExitCode::usage);
  check_array_lengths(cloud);
  if (cloud.x.empty()) throw Error(cloud.name + ": contains no points", ExitCode::usage);
  CloudInfo info;
  info.path = cloud.name;
  info.format = kArrayFormat;
  info.points = info.declared_points = cloud.x.size();
  if (!cloud.crs.empty()) info.crs = crs_from_text(cloud.crs);
  const auto below = [](double value) { return std::isfinite(value) ? std::floor(value) : 0.0; };
  info.layout = array_layout(!cloud.red.empty() || !cloud.green.empty() || !cloud.blue.empty(), cloud.scale,
                             {below(cloud.x[0]), below(cloud.y[0]), below(cloud.z[0])});
  check_places(cloud, info.layout);
  return std::make_unique<ArrayReader>(cloud, std::move(info));
}

std::string content_sum(const ArrayCloud& cloud) {
  std::uint64_t sum = std::bit_cast<std::uint64_t>(cloud.scale);
  for (const std::uint64_t part :
       {sum_of_array(cloud.x), sum_of_array(cloud.y), sum_of_array(cloud.z), sum_of_array(cloud.intensity),
        sum_of_array(cloud.classification), sum_of_array(cloud.red), sum_of_array(cloud.green),
        sum_of_array(cloud.blue), sum_of(std::as_bytes(std::span(cloud.crs)))})
    sum = mixed(sum, part);
  return fmt::format("{:016x}", sum);
}

}  // namespace ilot
