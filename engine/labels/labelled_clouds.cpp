// SPDX-License-Identifier: Apache-2.0
#include "engine/labels/labelled_clouds.h"

#include <algorithm>
#include <map>
#include <set>
#include <type_traits>

#include "engine/error.h"
#include "engine/formats/arrays/array_reader.h"
#include "engine/formats/arrays/npy_writer.h"
#include "engine/formats/changed_reader.h"
#include "engine/formats/las/extra_bytes.h"
#include "engine/formats/laz/laz_extender.h"
#include "engine/formats/row_buffer.h"
#include "engine/formats/writer.h"
#include "engine/pass/pass.h"
#include "engine/pass/resident.h"
#include "engine/store/row_places.h"
#include "engine/version.h"
#include "kernels/core/parallel.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kStretch = 50000;  // rows labelled at a time, at most, where the input has no chunks

// A field of a product, or the field `label`, whose source is the number of products.
struct AppendedField {
  std::size_t source = 0;
  LabelField field;
};

// The fields of all products in the order of their places.
std::vector<AppendedField> appended_fields(std::span<const ProductLabels> products) {
  std::vector<AppendedField> fields;
  for (std::size_t p = 0; p < products.size(); ++p)
    for (const LabelField& field : products[p].fields) fields.push_back({p, field});
  if (std::ranges::any_of(products, &ProductLabels::gives_classes))
    fields.push_back(
        {products.size(), label_field<PointLabel>(FieldPlace::label, "label", "1 ground, 2 roof, 5 facade...",
                                                  [](PointLabel label) { return static_cast<std::uint8_t>(label); })});
  std::ranges::stable_sort(fields, {}, [](const AppendedField& f) { return f.field.place; });
  return fields;
}

// Writes the fields of the valid rows; those of row i begin at to.first + i * to.stride.
void write_fields(std::span<const AppendedField> fields, const StretchLabels& labels, const LabelledRows& rows,
                  FieldOutput to) {
  for (const AppendedField& f : fields) {
    f.field.write(f.source < labels.labels.size() ? labels.labels[f.source] : std::as_bytes(std::span(labels.classes)),
                  rows, to);
    to.first += type_size(f.field.field.type);
  }
}

// Rows of one input and the labels of each.
struct Stretch {
  std::vector<std::byte> rows, appended;
  std::vector<std::uint8_t> valid;
  std::uint64_t labelled = 0;
};

enum class Kept { valid_rows, all_rows };
enum class Reads { places, all_fields };

// Gives the rows that nobody classified (0 and 1) the class of the ASPRS that follows from their label. Other classes
// stay.
void write_classes(const StretchLabels& labels, std::uint8_t point_format, std::size_t length, Stretch& s) {
  constexpr std::uint8_t kUnclassified = 1, kGround = 2, kBuilding = 6;
  for (std::size_t i = 0; i < s.valid.size(); ++i) {
    if (s.valid[i] == 0) continue;
    const PointLabel label = labels.classes[i];
    const bool building = label == PointLabel::roof || label == PointLabel::wall || label == PointLabel::facade;
    if (!building && label != PointLabel::ground) continue;
    const std::span row(s.rows.data() + i * length, length);
    PointFields fields = decode_fields(row, point_format);
    if (fields.classification > kUnclassified) continue;
    fields.classification = building ? kBuilding : kGround;
    encode_fields(fields, row, point_format);
  }
}

// The rows, each with its labels after it.
std::vector<std::byte> joined_rows(const Stretch& s, std::size_t length, std::size_t appended_length, Kept kept) {
  std::vector<std::byte> out;
  out.reserve(s.rows.size() + s.appended.size());
  for (std::size_t i = 0; i < s.valid.size(); ++i) {
    if (s.valid[i] == 0 && kept == Kept::valid_rows) continue;
    const auto row = s.rows.begin() + static_cast<std::ptrdiff_t>(i * length);
    const auto ours = s.appended.begin() + static_cast<std::ptrdiff_t>(i * appended_length);
    out.insert(out.end(), row, row + static_cast<std::ptrdiff_t>(length));
    out.insert(out.end(), ours, ours + static_cast<std::ptrdiff_t>(appended_length));
  }
  return out;
}

// Writes the labelled cloud of one input.
class Labeller {
 public:
  Labeller(const Store& store, const std::vector<BlockRows>& blocks, std::span<const ProductLabels> products,
           const LabelledCloudParams& params, PointReader& input, std::uint32_t file)
      : store_(store),
        blocks_(blocks),
        products_(products),
        fields_(appended_fields(products)),
        context_(params.context),
        classes_(params.classes),
        rows_(params.rows),
        input_(input),
        file_(file) {}

  // Returns the number of rows that have a label.
  std::uint64_t write(const fs::path& path) const {
    CloudSpec spec;
    spec.like = reader_of_records(input_).info();
    spec.software = "ilot " + version();
    for (const AppendedField& f : fields_) spec.appended.push_back(f.field.field);
    set_apart(spec.like, spec.appended);
    spec.waiting_bytes = affordable(context_.budget_bytes) / 2;  // the other half is for stretches
    if (is_in_memory(spec.like)) return copy(*create_npy(path, spec), Kept::all_rows);
    // Where classes change, the compressed fields of the input cannot be kept.
    if (!classes_)
      if (const auto extender = LazExtender::open(reader_of_file(input_), path, spec)) return extend(*extender);
    return copy(*create_cloud(path, spec), Kept::valid_rows);
  }

 private:
  // Makes one chunk of the output from each chunk of the input; only the added fields are encoded.
  std::uint64_t extend(LazExtender& output) const {
    const std::vector<std::uint64_t> bounds = input_.boundaries();
    input_.limit_to(kFieldZ);
    const std::uint64_t labelled = by_stretches(
        bounds, output.appended_length(), Reads::places,
        [&](std::size_t chunk, const Stretch& s) { return output.extend(chunk, s.rows, s.appended); },
        [&](const LazExtender::Chunk& chunk) { output.append(chunk); });
    input_.limit_to(kAllFields);
    output.finish();
    return labelled;
  }

  std::uint64_t copy(PointWriter& output, Kept kept) const {
    const std::uint64_t points = input_.info().points;
    const std::size_t length = input_.info().layout.record_length, ours = output.record_length() - length;
    const std::uint64_t stretch = rows_at_a_time(length + ours, kStretch);
    std::vector<std::uint64_t> bounds{0};
    while (bounds.back() < points) bounds.push_back(std::min(bounds.back() + stretch, points));
    const std::uint64_t labelled = by_stretches(
        bounds, ours, Reads::all_fields,
        [&](std::size_t, const Stretch& s) { return joined_rows(s, length, ours, kept); },
        [&](const std::vector<std::byte>& rows) { output.write(rows); });
    output.finish();
    return labelled;
  }

  // Reads, labels and prepares the stretches between bounds in parallel, a few at a time. Calls `put` with the prepared
  // stretches in order.
  template <class Prepare, class Put>
  std::uint64_t by_stretches(std::span<const std::uint64_t> bounds, std::size_t appended_length, Reads reads,
                             const Prepare& prepare, const Put& put) const {
    const std::size_t together = stretches_at_once(bounds, appended_length);
    std::vector<std::invoke_result_t<Prepare, std::size_t, const Stretch&>> prepared(together);
    std::vector<std::uint64_t> labelled(together);
    std::uint64_t all = 0;
    for (std::size_t at = 0; at + 1 < bounds.size(); at += together) {
      stop_if_asked();
      const std::size_t count = std::min(together, bounds.size() - 1 - at);
      parallel_for(count, [&](std::size_t i) {
        const Stretch s = read_stretch(bounds[at + i], bounds[at + i + 1] - bounds[at + i], appended_length, reads);
        labelled[i] = s.labelled;
        prepared[i] = prepare(at + i, s);
      });
      for (std::size_t i = 0; i < count; ++i) {
        put(prepared[i]);
        all += labelled[i];
        context_.advance(bounds[at + i + 1] - bounds[at + i]);
      }
    }
    return all;
  }

  // The number of stretches that keep the threads busy and fit into memory.
  std::size_t stretches_at_once(std::span<const std::uint64_t> bounds, std::size_t appended_length) const {
    if (!input_.random_access()) return 1;
    constexpr std::uint64_t kCodersOfStretch = 1u << 20;  // models and buffers to read and write one stretch
    std::uint64_t longest = 0;
    for (std::size_t i = 0; i + 1 < bounds.size(); ++i) longest = std::max(longest, bounds[i + 1] - bounds[i]);
    const std::uint64_t row = 2 * (input_.info().layout.record_length + appended_length) + bytes_of_row(products_);
    const std::uint64_t room = affordable(context_.budget_bytes) / 2 / (longest * row + kCodersOfStretch);
    return static_cast<std::size_t>(std::clamp<std::uint64_t>(room, 1, 2 * static_cast<std::uint64_t>(thread_count())));
  }

  Stretch read_stretch(std::uint64_t first, std::uint64_t count, std::size_t appended_length, Reads reads) const {
    const std::size_t length = input_.info().layout.record_length;
    Stretch s;
    s.rows.resize(count * length);
    s.valid.assign(count, 1);
    const bool kept = reads == Reads::places && take_places(store_.folder(), file_, first, length, s.rows);
    if (!kept && input_.read(first, s.rows, s.valid) != count)
      throw Error(input_.info().path.string() + ": can no longer be read in full; the file changed during the run");
    const InputOrder from = input_order(file_, first);
    const StretchLabels labels = rows_ != nullptr ? collect_labels(*rows_, from, count, products_)
                                                  : collect_labels(store_, blocks_, from, count, products_);
    const LabelledRows rows{s.rows, length, s.valid, LatticeMap(input_.info().layout, store_.unit()),
                            store_.unit() * context_.metres_per_unit};
    s.appended.resize(count * appended_length);
    write_fields(fields_, labels, rows, {s.appended.data(), appended_length});
    if (classes_) write_classes(labels, input_.info().layout.point_format, length, s);
    for (std::size_t i = 0; i < count; ++i)
      if (s.valid[i] != 0) s.labelled += labels.labelled[i];
    return s;
  }

  const Store& store_;
  const std::vector<BlockRows>& blocks_;
  std::span<const ProductLabels> products_;
  std::vector<AppendedField> fields_;
  const PassContext& context_;
  bool classes_;
  const RowsInMemory* rows_;
  PointReader& input_;
  std::uint32_t file_;
};

}  // namespace

std::vector<std::string> labelled_names(std::span<const fs::path> clouds) {
  std::map<std::string, int> stems;
  for (const fs::path& cloud : clouds) ++stems[cloud_stem(cloud)];
  std::set<std::string> used;
  for (const auto& [stem, count] : stems)
    if (count == 1) used.insert(stem);
  std::vector<std::string> names;
  for (const fs::path& cloud : clouds) {
    const fs::path path = fs::absolute(cloud);
    std::string name = cloud_stem(path);
    if (stems[name] > 1) {
      const std::string base = path.parent_path().filename().string() + "_" + name;
      name = base;
      for (int n = 2; !used.insert(name).second; ++n) name = base + "_" + std::to_string(n);
    }
    names.push_back(name + kCloudExtension);
  }
  return names;
}

std::vector<std::string> labelled_names(const std::vector<std::unique_ptr<PointReader>>& inputs) {
  std::vector<fs::path> files;
  for (const auto& input : inputs)
    if (!is_in_memory(input->info())) files.push_back(input->info().path);
  const std::vector<std::string> of_files = labelled_names(files);
  auto next = of_files.begin();
  std::vector<std::string> names;
  for (const auto& input : inputs)  // a cloud in memory is called as it is: a dot in its name is nothing special
    names.push_back(is_in_memory(input->info()) ? input->info().path.string() + kNpyExtension : *next++);
  return names;
}

std::uint64_t write_labelled_cloud(const Store& store, PointReader& input, std::uint32_t file,
                                   std::span<const ProductLabels> products, const fs::path& path,
                                   const LabelledCloudParams& params) {
  const std::vector<BlockRows> blocks = params.rows != nullptr ? std::vector<BlockRows>{} : sample_rows(store);
  return Labeller(store, blocks, products, params, input, file).write(path);
}

void check_labelled_clouds(const std::vector<std::unique_ptr<PointReader>>& inputs, const PassContext& context) {
  for (const auto& input : inputs) {
    const CloudInfo& info = input->info();
    const std::uint64_t needed = cloud_writer_bytes(info.layout, info.points);
    if (needed > context.budget_bytes)
      throw Error(info.path.string() + ": its rows of " + std::to_string(info.layout.record_length) + " bytes take " +
                  std::to_string(needed >> 20) + " MiB to be compressed with their labels, and --memory leaves " +
                  std::to_string(context.budget_bytes >> 20) + " MiB; give a larger --memory, or --no-clouds");
  }
}

std::uint64_t write_labelled_clouds(const Store& store, const std::vector<std::unique_ptr<PointReader>>& inputs,
                                    std::span<const ProductLabels> products, const fs::path& folder,
                                    const LabelledCloudParams& params) {
  fs::create_directories(folder);
  const std::vector<BlockRows> blocks = params.rows != nullptr ? std::vector<BlockRows>{} : sample_rows(store);
  const std::vector<std::string> names = labelled_names(inputs);
  std::uint64_t labelled = 0;
  for (std::uint32_t f = 0; f < inputs.size(); ++f)
    labelled += Labeller(store, blocks, products, params, *inputs[f], f).write(folder / names[f]);
  return labelled;
}

}  // namespace ilot
