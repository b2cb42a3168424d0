// SPDX-License-Identifier: Apache-2.0
// The parts of the module; each adds the functions of some public headers. Everything that takes long releases the
// interpreter's lock.
#pragma once
#include <pybind11/pybind11.h>

namespace ilot {

void bind_clouds(pybind11::module_& m);   // clouds.h
void bind_points(pybind11::module_& m);   // neighbours.h, clusters.h, plane_search.h, delaunay.h
void bind_runs(pybind11::module_& m);     // run.h, parameters.h
void bind_results(pybind11::module_& m);  // planes.h, roofs.h, facades.h, streets.h

}  // namespace ilot
