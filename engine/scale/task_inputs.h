// SPDX-License-Identifier: Apache-2.0
// How tasks open the inputs of a plan, and what a merge knows of them.
#pragma once
#include <cstdint>
#include <span>

#include "engine/pass/context.h"
#include "engine/run/inputs/open_inputs.h"
#include "engine/scale/plan.h"
#include "engine/scale/run_task.h"

namespace ilot {

// Throws Error where one of these inputs, by number, is not the one that the plan was made from.
void check_inputs(const Plan& plan, std::span<const std::uint32_t> numbers);

// The options of a run over these inputs with the settings of the plan.
RunOptions run_options(const TaskOptions& task, const Plan& plan, std::span<const std::uint32_t> numbers);

// Opens the inputs of the options, which are those with these numbers. Throws Error where they do not open as they did
// for the plan.
RunInputs open_needed(const RunOptions& options, const Plan& plan, std::span<const std::uint32_t> numbers);

// What the plan knows of all inputs; none is opened.
RunInputs frozen_inputs(const Plan& plan);

// The context of passes, with what the plan froze.
PassContext frozen_context(const RunOptions& options, const RunInputs& inputs, const Plan& plan, Progress& progress);

}  // namespace ilot
