// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/labels/label_counts.h"

#include "engine/proof/point_stream.h"

namespace ilot {
namespace {

// An integer field that may be missing. If it is missing, every value is 0.
class OptionalField {
 public:
  OptionalField(const RecordLayout& layout, const std::string& name) : field_(find_integer_field(layout, name)) {}
  explicit operator bool() const { return field_.has_value(); }
  std::uint32_t of(const std::byte* record) const {
    return field_ ? static_cast<std::uint32_t>(integer_of(record, *field_)) : 0;
  }

 private:
  std::optional<ExtraField> field_;
};

// The number of a plane, or of a sphere, cylinder or cone; these shapes have numbers of their own. A point has at most
// one of them. 0 = none.
std::uint32_t segment_of(std::uint32_t plane, std::uint32_t shape) {
  constexpr std::uint32_t kShape = 1u << 31;
  return plane != 0 || shape == 0 ? plane : kShape | shape;
}

// Counts a point by the labels of facades. A run for facades gives no label to what is no facade, so a found label 0
// counts as other.
void add_in_words(const FacadeTruthLabels& words, std::uint32_t kind, std::uint32_t element, std::uint32_t label,
                  LabelCounts& counts) {
  constexpr auto kOther = static_cast<std::uint32_t>(PointLabel::other);
  counts.facade_labels.add(static_cast<std::uint32_t>(words.of(kind, element)), label == 0 ? kOther : label);
}

}  // namespace

void count_labels(const std::filesystem::path& cloud, const std::string& found_field,
                  const std::unordered_set<std::uint32_t>& objects, const FacadeTruthLabels* words,
                  LabelCounts& counts) {
  const std::unique_ptr<PointReader> reader = open_cloud(cloud);
  reader->limit_to(kFieldExtra);
  const RecordLayout& layout = reader->info().layout;
  const OptionalField true_plane(layout, "true_plane"), true_class(layout, "true_class");
  const OptionalField true_element(layout, "true_element"), plane(layout, found_field), label(layout, "label");
  const OptionalField shape(layout, "shape_id");
  const OptionalField object(layout, "object_id"), boundary(layout, "boundary");
  counts.metres_per_unit = reader->info().crs.metres_per_unit;
  counts.has_true_plane |= static_cast<bool>(true_plane);
  counts.has_true_class |= static_cast<bool>(true_class);
  counts.has_true_element |= static_cast<bool>(true_element);
  counts.has_planes |= static_cast<bool>(plane);
  counts.has_labels |= static_cast<bool>(label);
  counts.has_objects |= static_cast<bool>(object);
  counts.has_boundary |= static_cast<bool>(boundary);
  for_each_record(*reader, [&](const std::byte* record) {
    const std::uint32_t truth = true_plane.of(record), kind = true_class.of(record);
    const std::uint32_t found = segment_of(plane.of(record), shape.of(record));
    ++counts.points;
    if (true_plane && plane) counts.planes.add(truth, found);
    if (true_class && plane) counts.class_segments.add(kind, found);
    if (truth != 0) {
      counts.class_of.emplace(truth, kind);
      ++counts.points_of_plane[truth];
    }
    if (label) {
      counts.class_labels.add(kind, label.of(record));
      counts.any_label |= label.of(record) != 0;
      if (words) add_in_words(*words, kind, true_element.of(record), label.of(record), counts);
    }
    if (!object) return;
    const std::uint32_t element = true_element.of(record);
    counts.objects.add(objects.contains(element) ? element : 0, object.of(record));
    if (label) counts.object_labels.add(object.of(record), label.of(record));
  });
}

}  // namespace ilot
