// SPDX-License-Identifier: Apache-2.0
// Only this folder knows the instruction sets. Each kernel body is one text (kernels/FOLDER/NAME.inl) over fixed lanes
// (lanes_*.h). It is compiled once for each instruction set, and the results have the same bits in each.
// kernels/CMakeLists.txt lists the bodies. No file of this folder knows them.
#pragma once
#include <cstdint>

namespace ilot::simd {

enum class Isa : std::uint8_t { baseline, avx2, avx512 };
constexpr Isa kIsas[] = {Isa::baseline, Isa::avx2, Isa::avx512};

const char* name_of(Isa isa);

// Whether this machine has the instruction set and this build includes it.
bool has_isa(Isa isa);

// The best instruction set of this machine, chosen once. ILOT_FORCE_ISA=baseline|avx2|avx512 overrides it; any other
// name and a set that is not available give the baseline (forced_isa.h reports them).
Isa chosen_isa();

// The functions of one body for each instruction set; nullptr where the build lacks it.
template <class Body>
struct Variants {
  const Body* each[3];

  const Body& best() const { return *each[static_cast<int>(chosen_isa())]; }
  // Returns the functions for an instruction set that the machine has (has_isa).
  const Body& of(Isa isa) const { return *each[static_cast<int>(isa)]; }
};

}  // namespace ilot::simd
