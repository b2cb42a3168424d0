// SPDX-License-Identifier: Apache-2.0
// A few keys in ascending order, by insertion.

namespace {

inline void sort_keys(std::uint64_t* key, std::uint32_t size) {
  for (std::uint32_t i = 1; i < size; ++i) {
    const std::uint64_t v = key[i];
    std::uint32_t j = i;
    for (; j > 0 && key[j - 1] > v; --j) key[j] = key[j - 1];
    key[j] = v;
  }
}

}  // namespace
