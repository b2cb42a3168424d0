// SPDX-License-Identifier: Apache-2.0
#include "engine/products/planes/cells/cell_shapes.h"

#include <algorithm>
#include <filesystem>

namespace ilot {
namespace {

// The header of the file; the shapes, the samples and the labels follow.
struct Header {
  std::uint64_t shapes = 0, samples = 0, labels = 0;
};

using Place = std::array<std::int32_t, 3>;

Place place_of(const CellPoints& cp, std::uint32_t i) {
  return {static_cast<std::int32_t>(cp.x[i]), static_cast<std::int32_t>(cp.y[i]), static_cast<std::int32_t>(cp.z[i])};
}

// Adds the part of a shape that is in the cell itself.
void add_shape(CellShapes& out, const CellPoints& cp, const FoundShape& found,
               const std::vector<std::uint32_t>& members, const PlaneParams& params) {
  CellShape s{found.shape, params.epsilon, params.connectivity};
  s.min = s.max = place_of(cp, members[0]);
  for (const std::uint32_t i : members) {
    const Place p = place_of(cp, i);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      s.min[axis] = std::min(s.min[axis], p[axis]);
      s.max[axis] = std::max(s.max[axis], p[axis]);
    }
  }
  s.points = static_cast<std::uint32_t>(members.size());
  s.first_sample = static_cast<std::uint32_t>(out.samples.size());
  s.samples = std::min(s.points, kShapeSamples);
  for (std::uint64_t k = 0; k < s.samples; ++k)
    out.samples.push_back(place_of(cp, members[static_cast<std::size_t>(k * s.points / s.samples)]));
  out.shapes.push_back(s);
}

}  // namespace

std::filesystem::path shapes_path(const Store& store, const Cell& cell) {
  return store.folder() / "cells" / (cell.node.name() + ".shapes");
}

void write_cell_shapes(const Store& store, const Cell& cell, const CellPoints& cp, const ShapeSegments& found,
                       const PlaneParams& params) {
  std::vector<std::vector<std::uint32_t>> members(found.shapes.size());
  for (std::uint32_t i = 0; i < cp.size; ++i)
    if (cp.core[i] && found.label[i] != 0) members[found.label[i] - 1].push_back(i);
  CellShapes out;
  std::vector<std::uint32_t> number(found.shapes.size() + 1, 0);
  for (std::size_t s = 0; s < found.shapes.size(); ++s) {
    if (members[s].empty()) continue;
    add_shape(out, cp, found.shapes[s], members[s], params);
    number[s + 1] = static_cast<std::uint32_t>(out.shapes.size());
  }
  if (!out.shapes.empty())
    for (std::uint32_t i = 0; i < cp.size; ++i)
      if (cp.core[i]) out.labels.push_back(number[found.label[i]]);
  const Header header{out.shapes.size(), out.samples.size(), out.labels.size()};
  RecordWriter writer(shapes_path(store, cell));
  writer.append(std::as_bytes(std::span(&header, 1)));
  writer.append(std::as_bytes(std::span(out.shapes)));
  writer.append(std::as_bytes(std::span(out.samples)));
  writer.append(std::as_bytes(std::span(out.labels)));
  writer.commit();
}

CellShapes read_cell_shapes(const Store& store, const Cell& cell, CellPart part) {
  CellShapes out;
  const std::filesystem::path path = shapes_path(store, cell);
  if (!std::filesystem::exists(path)) return out;
  const RecordReader reader(path);
  Header header;
  reader.read(0, std::as_writable_bytes(std::span(&header, 1)));
  out.shapes.resize(header.shapes);
  std::uint64_t at = sizeof header;
  reader.read(at, std::as_writable_bytes(std::span(out.shapes)));
  at += header.shapes * sizeof(CellShape);
  if (part == CellPart::shapes) {
    out.samples.resize(header.samples);
    reader.read(at, std::as_writable_bytes(std::span(out.samples)));
  } else {
    out.labels.resize(header.labels);
    reader.read(at + header.samples * sizeof(Place), std::as_writable_bytes(std::span(out.labels)));
  }
  return out;
}

}  // namespace ilot
