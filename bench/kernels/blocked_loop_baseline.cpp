// SPDX-License-Identifier: Apache-2.0
#define BLOCKED_LOOP blocked_loop_baseline
#include "bench/kernels/blocked_loop.inl"
