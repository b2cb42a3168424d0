// SPDX-License-Identifier: Apache-2.0
// The parameters of passes that follow from the options and inputs of a run.
#pragma once
#include "engine/pass/context.h"
#include "engine/pass/input_lattice.h"
#include "engine/report/progress.h"
#include "engine/run/inputs/open_inputs.h"

namespace ilot {

// Returns the context without the fields that depend on the lattice.
PassContext pass_context(const RunOptions& options, const RunInputs& inputs, std::uint64_t block_points,
                         Progress& progress);

// Sets the fields of the context that depend on the lattice. The context refers to options.area.
void set_lattice(const RunOptions& options, const RunInputs& inputs, const InputLattice& lattice, PassContext& context);

}  // namespace ilot
