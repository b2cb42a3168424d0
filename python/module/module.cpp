// SPDX-License-Identifier: Apache-2.0
#include <pybind11/pybind11.h>

#include "ilot/error.h"
#include "ilot/version.h"
#include "python/module/bindings.h"

namespace py = pybind11;

// The compiled half of the package ilot. People call it through ilot/__init__.py.
PYBIND11_MODULE(_ilot, m) {
  static py::exception<ilot::Error> error(m, "Error", PyExc_RuntimeError);
  error.attr("__doc__") =
      "What is wrong, where, and what to do. `code` is the exit code of the program: 1 failed, 2 usage, 130 "
      "interrupted.";
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const ilot::Error& fault) {
      py::object made = py::reinterpret_borrow<py::object>(error)(fault.what());
      made.attr("code") = static_cast<int>(fault.code());
      PyErr_SetObject(error.ptr(), made.ptr());
    }
  });
  m.attr("version") = ilot::version();
  ilot::bind_clouds(m);
  ilot::bind_points(m);
  ilot::bind_runs(m);
  ilot::bind_results(m);
}
