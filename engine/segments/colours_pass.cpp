// SPDX-License-Identifier: Apache-2.0
#include "engine/segments/colours_pass.h"

#include <algorithm>
#include <array>
#include <string>

#include "engine/cloud/record.h"
#include "engine/error.h"
#include "engine/formats/fields.h"
#include "engine/pass/pass.h"
#include "kernels/core/radix_sort.h"
#include "kernels/core/rng.h"
#include "kernels/planes/colour_classes.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kBytesPerPoint = 40;
constexpr std::uint64_t kRows = 1 << 16;     // read or gathered at a time
constexpr std::uint64_t kStretch = 1 << 19;  // rows in a file of colours, at least
constexpr std::uint64_t kSample = std::uint64_t{1} << 17;

struct RawColour {
  std::uint16_t r = 0, g = 0, b = 0;
};

// Rows of one input whose colours stand in one file: the colours by row, then the largest channel of them.
struct Stretch {
  std::size_t file = 0;
  std::uint64_t first = 0, count = 0;
};

// In the order of files and rows. Inputs without random access are one stretch each.
std::vector<Stretch> stretches(const std::vector<std::unique_ptr<PointReader>>& inputs) {
  std::vector<Stretch> all;
  for (std::size_t f = 0; f < inputs.size(); ++f) {
    if (!rgb_offset(inputs[f]->info().layout.point_format) || inputs[f]->info().points == 0) continue;
    if (!inputs[f]->random_access()) {
      all.push_back({f, 0, inputs[f]->info().points});
      continue;
    }
    std::uint64_t first = 0;
    for (const std::uint64_t cut : inputs[f]->boundaries()) {
      if (cut - first < kStretch && cut != inputs[f]->info().points) continue;
      if (cut > first) all.push_back({f, first, cut - first});
      first = cut;
    }
  }
  return all;
}

fs::path colour_file(const Store& store, const Stretch& s) {
  return store.folder() / "colours" / (std::to_string(s.file) + "_" + std::to_string(s.first));
}

void write_colours(PointReader& input, const Stretch& s, const fs::path& path) {
  const RecordLayout& layout = input.info().layout;
  const std::size_t at = *rgb_offset(layout.point_format);
  std::vector<std::byte> records(kRows * layout.record_length);
  std::vector<std::uint8_t> valid(kRows);
  std::vector<RawColour> colours;
  RawColour most;
  ColumnWriter writer(path);
  for (std::uint64_t done = 0; done < s.count; done += kRows) {
    const std::uint64_t n = std::min(kRows, s.count - done);
    if (input.read(s.first + done, std::span(records).first(n * layout.record_length), std::span(valid).first(n)) != n)
      throw Error(input.info().path.string() + ": can no longer be read in full; the file changed during the run");
    colours.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      const std::byte* rgb = records.data() + i * layout.record_length + at;
      colours[i] = {load<std::uint16_t>(rgb), load<std::uint16_t>(rgb + 2), load<std::uint16_t>(rgb + 4)};
      if (valid[i] != 0) most.r = std::max({most.r, colours[i].r, colours[i].g, colours[i].b});
    }
    writer.append<RawColour>(colours);
  }
  writer.append<RawColour>(std::span(&most, 1));
  writer.commit();
}

std::uint16_t largest_channel(const Store& store, const Stretch& s) {
  RawColour most;
  ColumnReader(colour_file(store, s)).read<RawColour>(s.count, std::span(&most, 1));
  return most.r;
}

// Colours by file and row, asked for in rising order, read a window at a time.
class Colours {
 public:
  Colours(const Store& store, const std::vector<Stretch>& stretches, const std::vector<int>& shifts)
      : store_(store), stretches_(stretches), shifts_(shifts) {}

  StoredColour at(std::uint64_t file, std::uint64_t row) {
    while (next_ < stretches_.size() && before(stretches_[next_], file, row)) ++next_, window_.clear();
    if (next_ == stretches_.size() || stretches_[next_].file != file) return kNoColour;
    const Stretch& s = stretches_[next_];
    if (row < first_ || row >= first_ + window_.size() || window_.empty()) {
      first_ = row;
      window_.resize(std::min(kRows, s.first + s.count - row));
      ColumnReader(colour_file(store_, s)).read<RawColour>(row - s.first, window_);
    }
    const RawColour& c = window_[row - first_];
    const auto byte = [&](std::uint16_t v) { return static_cast<StoredColour>(v >> shifts_[file]); };
    return byte(c.r) << 16 | byte(c.g) << 8 | byte(c.b);
  }

 private:
  static bool before(const Stretch& s, std::uint64_t file, std::uint64_t row) {
    return s.file != file ? s.file < file : s.first + s.count <= row;
  }

  const Store& store_;
  const std::vector<Stretch>& stretches_;
  const std::vector<int>& shifts_;
  std::size_t next_ = 0;
  std::uint64_t first_ = 0;
  std::vector<RawColour> window_;
};

void gather(const Store& store, std::uint32_t block, const std::vector<Stretch>& stretches,
            const std::vector<int>& shifts) {
  const auto order = store.read<InputOrder>(block, "order");
  std::vector<StoredColour> colour(order.size());
  Colours colours(store, stretches, shifts);
  for (const std::uint32_t i : sorted_order(order)) colour[i] = colours.at(file_of(order[i]), row_of(order[i]));
  store.write<StoredColour>(block, "colour", colour);
}

Lab lab_of(StoredColour c) {
  return ilot::lab_of(static_cast<std::uint8_t>(c >> 16), static_cast<std::uint8_t>(c >> 8),
                      static_cast<std::uint8_t>(c));
}

}  // namespace

bool colours_pass(const Store& store, const std::vector<std::unique_ptr<PointReader>>& inputs,
                  const PassContext& context) {
  const std::vector<Stretch> parts = stretches(inputs);
  if (parts.empty()) return false;
  fs::create_directories(store.folder() / "colours");
  std::vector<PassTask> tasks;
  for (const Stretch& s : parts)
    tasks.push_back({kRows * (inputs[s.file]->info().layout.record_length + sizeof(RawColour)), s.count});
  for (const auto& input : inputs) input->limit_to(kFieldRgb);
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    const fs::path path = colour_file(store, parts[i]);
    if (!fs::exists(path)) write_colours(*inputs[parts[i].file], parts[i], path);
  });
  for (const auto& input : inputs) input->limit_to(kAllFields);
  std::vector<int> shifts(inputs.size(), 0);
  for (const Stretch& s : parts)
    if (largest_channel(store, s) > 255) shifts[s.file] = 8;
  tasks.clear();
  for (const Block& b : store.blocks()) tasks.push_back({b.points * kBytesPerPoint, b.points});
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    const auto block = static_cast<std::uint32_t>(i);
    if (!store.has(block, "colour")) gather(store, block, parts, shifts);
  });
  return true;
}

std::uint32_t ColourPalette::class_of(StoredColour colour) const {
  if (colour == kNoColour) return 0;
  const Lab lab = lab_of(colour);
  std::uint32_t best = 0;
  double least = 0;
  for (std::uint32_t c = 0; c < centre.size(); ++c) {
    double d2 = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double d = lab[axis] - centre[c][axis];
      d2 += d * d;
    }
    if (best != 0 && d2 >= least) continue;
    best = c + 1;
    least = d2;
  }
  return best;
}

ColourPalette colour_palette(const Store& store, std::uint32_t k, std::uint64_t seed) {
  const std::uint64_t stride = std::max<std::uint64_t>(1, store.points() / kSample);
  std::vector<std::uint8_t> r, g, b;
  for (std::uint32_t block = 0; block < store.blocks().size(); ++block) {
    const std::uint32_t points = store.blocks()[block].points;
    for (std::uint32_t first = 0; first < points; first += kRows) {
      const auto n = std::min(static_cast<std::uint32_t>(kRows), points - first);
      const auto codes = store.read<std::uint64_t>(block, "codes", first, n);
      const auto colours = store.read<StoredColour>(block, "colour", first, n);
      for (std::size_t i = 0; i < n; ++i) {
        if (colours[i] == kNoColour || mix64(codes[i]) % stride != 0) continue;
        r.push_back(static_cast<std::uint8_t>(colours[i] >> 16));
        g.push_back(static_cast<std::uint8_t>(colours[i] >> 8));
        b.push_back(static_cast<std::uint8_t>(colours[i]));
      }
    }
  }
  ColourClassParams params;
  params.k = k;
  params.key = seed;
  return {colour_classes({r, g, b, {}}, params).centre};
}

}  // namespace ilot
