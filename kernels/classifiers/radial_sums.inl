// SPDX-License-Identifier: Apache-2.0
// Body of radial_sums. It processes sixteen rows at once, each in its own lane, so that a lane adds in the order of the
// vectors whatever the width of a register. The kernels of a few vectors are stored and then added to one sum after the
// other.

namespace {

constexpr std::size_t kKept = 64;                       // vectors
constexpr std::size_t kParts = kRadialRows / kDoubles;  // registers that hold one value of all rows

// Returns e to the power of v, for v from -700 to 0, by a Taylor series about the nearest multiple of ln 2.
inline D exp_of(D v) {
  const D high = splat_d(0x1.62e42feep-1), low = splat_d(0x1.a39ef35793c76p-33);  // of ln 2, the first with zeros last
  const D round = splat_d(0x1.8p52);
  const D turns = (v * splat_d(1.4426950408889634) + round) - round;
  const D rest = (v - turns * high) - turns * low;
  // Derived: the Taylor series of the exponential.
  constexpr double kTerms[] = {1.0 / 6227020800, 1.0 / 479001600, 1.0 / 39916800, 1.0 / 3628800, 1.0 / 362880,
                               1.0 / 40320,      1.0 / 5040,      1.0 / 720,      1.0 / 120,     1.0 / 24,
                               1.0 / 6,          0.5,             1,              1};
  D sum = splat_d(kTerms[0]);
  for (int i = 1; i < 14; ++i) sum = sum * rest + splat_d(kTerms[i]);
  return sum * power_of_two(turns);
}

// Stores the kernels of the rows with some vectors, kRadialRows for each vector.
inline void keep_kernels(const RadialArgs& a, std::size_t from, std::size_t to, double* kernels) {
  const D least = splat_d(-700), gamma = splat_d(-a.gamma);
  for (std::size_t v = from; v < to; ++v, kernels += kRadialRows) {
    const double* vector = a.vectors + v * a.dimensions;
    D d2[kParts];
    for (D& d : d2) d = splat_d(0);
    for (std::size_t i = 0; i < a.dimensions; ++i) {
      const D at = splat_d(vector[i]);
      for (std::size_t p = 0; p < kParts; ++p) {
        const D d = load_d(a.rows + i * kRadialRows + p * kDoubles) - at;
        d2[p] = d2[p] + d * d;
      }
    }
    for (std::size_t p = 0; p < kParts; ++p) {
      const D power = gamma * d2[p];
      const D kernel = exp_of(select(power < least, least, power)), before = load_d(a.nearest + p * kDoubles);
      store_d(kernels + p * kDoubles, kernel);
      store_d(a.nearest + p * kDoubles, select(before < kernel, kernel, before));
    }
  }
}

inline void add_kernels(const RadialArgs& a, std::size_t from, std::size_t to, const double* kernels) {
  for (std::size_t s = 0; s < a.sums; ++s) {
    double* out = a.totals + s * kRadialRows;
    D total[kParts];
    for (std::size_t p = 0; p < kParts; ++p) total[p] = load_d(out + p * kDoubles);
    for (std::size_t v = from; v < to; ++v) {
      const D weight = splat_d(a.weights[v * a.sums + s]);
      for (std::size_t p = 0; p < kParts; ++p)
        total[p] = total[p] + weight * load_d(kernels + (v - from) * kRadialRows + p * kDoubles);
    }
    for (std::size_t p = 0; p < kParts; ++p) store_d(out + p * kDoubles, total[p]);
  }
}

}  // namespace

void radial_sums(const RadialArgs& a) {
  double kernels[kKept * kRadialRows];
  for (std::size_t i = 0; i < a.sums * kRadialRows; ++i) a.totals[i] = 0;
  for (std::size_t r = 0; r < kRadialRows; ++r) a.nearest[r] = 0;
  for (std::size_t from = 0; from < a.vector_count; from += kKept) {
    const std::size_t to = from + kKept < a.vector_count ? from + kKept : a.vector_count;
    keep_kernels(a, from, to, kernels);
    add_kernels(a, from, to, kernels);
  }
}

// The last line exports the bodies compiled here under one name.
extern const RadialSumsBody kRadialSums;
const RadialSumsBody kRadialSums{radial_sums};
