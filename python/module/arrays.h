// SPDX-License-Identifier: Apache-2.0
// NumPy arrays in and out. Arrays of the right type and order are read where they are; others are refused, so that no
// copy is made that nobody asked for. What the library returns in vectors becomes arrays that own these vectors.
#pragma once
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "ilot/array_cloud.h"
#include "ilot/error.h"
#include "ilot/geometry.h"

namespace ilot {

namespace py = pybind11;

// Returns the values of a one-dimensional contiguous array of T. `name` stands for it in messages.
template <typename T>
std::span<const T> values_of(const py::object& given, const char* name) {
  const std::string what = name;
  const std::string type = py::str(py::dtype::of<T>());
  const auto refuse_type = [&](const std::string& found) {
    throw Error(what + ": an array of " + type + " is expected, not " + found + "; numpy.ascontiguousarray(" + what +
                    ", dtype=\"" + type + "\") makes one",
                ExitCode::usage);
  };
  if (!py::isinstance<py::array>(given)) refuse_type(py::str(py::type::of(given).attr("__name__")));
  const auto array = py::reinterpret_borrow<py::array>(given);
  if (!py::isinstance<py::array_t<T>>(array) || array.dtype().byteorder() == '>')
    refuse_type("of " + py::str(array.dtype()).cast<std::string>());
  if (py::hasattr(array, "mask"))
    throw Error(what + ": the mask of a masked array would be ignored; choose the points by " + what +
                    ".data[~mask], with one mask for all arrays",
                ExitCode::usage);
  if (array.ndim() != 1)
    throw Error(what + ": one dimension is expected, not " + std::to_string(array.ndim()), ExitCode::usage);
  const auto count = static_cast<std::size_t>(array.size());
  if (count > 1 && array.strides(0) != static_cast<py::ssize_t>(sizeof(T)))
    throw Error(what + ": a contiguous array is expected; numpy.ascontiguousarray(" + what + ") makes one",
                ExitCode::usage);
  return {static_cast<const T*>(array.data()), count};
}

// Returns x, y and z as the functions over points in memory take them.
inline PointArrays points_of(const py::object& x, const py::object& y, const py::object& z) {
  return {values_of<double>(x, "x"), values_of<double>(y, "y"), values_of<double>(z, "z")};
}

// The caller's array of an attribute; None: no values.
template <typename T>
std::span<const T> values_or_none(const py::object& array, const char* name) {
  if (array.is_none()) return {};
  return values_of<T>(array, name);
}

// The arrays of a cloud in Python's memory, which must be kept alive. `attributes` has intensity, classification, red,
// green and blue.
inline ArrayCloud cloud_of(const py::object& x, const py::object& y, const py::object& z, const py::dict& attributes) {
  ArrayCloud cloud;
  cloud.x = values_of<double>(x, "x");
  cloud.y = values_of<double>(y, "y");
  cloud.z = values_of<double>(z, "z");
  cloud.intensity = values_or_none<std::uint16_t>(attributes["intensity"], "intensity");
  cloud.classification = values_or_none<std::uint8_t>(attributes["classification"], "classification");
  cloud.red = values_or_none<std::uint16_t>(attributes["red"], "red");
  cloud.green = values_or_none<std::uint16_t>(attributes["green"], "green");
  cloud.blue = values_or_none<std::uint16_t>(attributes["blue"], "blue");
  return cloud;
}

// Moves the vector into an array of the given shape, which frees it. Empty shape: one dimension.
template <typename T>
py::array_t<T> array_from(std::vector<T>&& values, std::vector<py::ssize_t> shape = {}) {
  auto owned = std::make_unique<std::vector<T>>(std::move(values));
  if (shape.empty()) shape.push_back(static_cast<py::ssize_t>(owned->size()));
  T* data = owned->data();
  const py::capsule owner(owned.release(), [](void* p) { delete static_cast<std::vector<T>*>(p); });
  return py::array_t<T>(shape, data, owner);
}

inline py::tuple tuple_of(Vec3 p) {
  return py::make_tuple(p.x, p.y, p.z);
}

// An array of shape (points, 3).
inline py::array_t<double> array_of(const std::vector<Vec3>& points) {
  std::vector<double> values;
  values.reserve(3 * points.size());
  for (const Vec3& p : points) values.insert(values.end(), {p.x, p.y, p.z});
  return array_from(std::move(values), {static_cast<py::ssize_t>(points.size()), 3});
}

}  // namespace ilot
