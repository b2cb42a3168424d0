// SPDX-License-Identifier: Apache-2.0
// Internal to the raster kernels: visits the few of many pixels that satisfy a predicate.
#pragma once
#include <bit>
#include <cstddef>

namespace ilot {

// Calls take(i), in order, for each i below `size` for which predicate(i), an integer, is not 0. Sixteen pixels are
// tested together. Where `predicate` has no branches, this uses vector instructions, and most groups of sixteen are
// skipped at once.
template <class Predicate, class Take>
void for_each_where(std::size_t size, const Predicate& predicate, const Take& take) {
  constexpr unsigned kTogether = 16;
  std::size_t i = 0;
  for (; i + kTogether <= size; i += kTogether) {
    int any = 0;
    for (unsigned k = 0; k < kTogether; ++k) any |= predicate(i + k);
    if (any == 0) continue;
    unsigned bits = 0;
    for (unsigned k = 0; k < kTogether; ++k) bits |= predicate(i + k) != 0 ? 1u << k : 0u;
    for (; bits != 0; bits &= bits - 1) take(i + static_cast<unsigned>(std::countr_zero(bits)));
  }
  for (; i < size; ++i)
    if (predicate(i) != 0) take(i);
}

}  // namespace ilot
