// SPDX-License-Identifier: Apache-2.0
#include "engine/products/planes/plane_labels.h"

#include <memory>

namespace ilot {
namespace {

std::vector<PlaneLabel> labels_of_points(const Store& store, std::uint32_t block, const PlaneLabelParams& params) {
  const auto plane = store.read(block, columns::kPlane);
  const auto boundary = store.read(block, columns::kBoundary);
  std::vector<PlaneLabel> labels(plane.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    labels[i].plane = params.final_id[plane[i]];
    labels[i].boundary = boundary[i];
  }
  if (!params.final_shape.empty()) {
    const auto shape = store.read(block, columns::kShape);
    for (std::size_t i = 0; i < labels.size(); ++i) labels[i].shape = params.final_shape[shape[i]];
  }
  if (params.write_normals) {
    const auto normals = store.read(block, columns::kNormals);
    for (std::size_t i = 0; i < labels.size(); ++i) labels[i].normal = normals[i];
  }
  return labels;
}

// In metres, from the coordinates as they are in the input.
float residual(const PlaneLabel& label, const std::byte* record, const LabelledRows& rows,
               const PlaneLabelParams& params) {
  if (label.plane == 0) return 0;
  const JoinedPlane& plane = params.planes[label.plane - 1];
  const Vec3 offset = rows.lattice.offset_from(plane.anchor, load<std::int32_t>(record), load<std::int32_t>(record + 4),
                                               load<std::int32_t>(record + 8));
  return static_cast<float>(rows.metres * signed_distance(plane.plane, offset));
}

LabelField normal_field(const char* name, std::int16_t PackedNormal::*axis) {
  return label_field<PlaneLabel>(FieldPlace::normal, name, "unit normal, 0 0 0 = none",
                                 [axis](const PlaneLabel& l) { return static_cast<float>(l.normal.*axis) / 32767.0f; });
}

}  // namespace

ProductLabels plane_labels(PlaneLabelParams given) {
  const auto params = std::make_shared<const PlaneLabelParams>(std::move(given));
  using Label = PlaneLabel;
  std::vector<LabelField> fields{
      label_field<Label>(FieldPlace::plane, "plane_id", "0 = none", [](const Label& l) { return l.plane; }),
      label_field<Label>(FieldPlace::plane, "residual", "signed distance to plane, m",
                         [params](const Label& l, const std::byte* record, const LabelledRows& rows) {
                           return residual(l, record, rows, *params);
                         }),
      label_field<Label>(FieldPlace::plane, "boundary", "1 = on its plane's outline",
                         [](const Label& l) { return l.boundary; })};
  if (!params->final_shape.empty())
    fields.push_back(label_field<Label>(FieldPlace::plane, "shape_id", "sphere, cylinder, cone; 0 = none",
                                        [](const Label& l) { return l.shape; }));
  if (params->write_normals)
    for (const auto& [name, axis] : {std::pair{"NormalX", &PackedNormal::x}, std::pair{"NormalY", &PackedNormal::y},
                                     std::pair{"NormalZ", &PackedNormal::z}})
      fields.push_back(normal_field(name, axis));
  return product_labels<Label>(
      [params](const Store& store, std::uint32_t block) { return labels_of_points(store, block, *params); },
      columns::kPlaneRows,
      [](const Label& l) {
        return PointClass{PointLabel::none, false, l.plane != 0 || l.shape != 0};
      },
      std::move(fields));
}

}  // namespace ilot
