// SPDX-License-Identifier: Apache-2.0
#define BLOCKED_LOOP blocked_loop_avx512
#include "bench/kernels/blocked_loop.inl"
