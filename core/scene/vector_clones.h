// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Before a function: compiles it for processors with vectors of 256 bits too, and calls what fits the
/// processor. The same bits on all: nothing is fused (-ffp-contract=off), and no sum is taken in another
/// order.
#if defined(__x86_64__) && !defined(__SANITIZE_THREAD__) && !defined(__SANITIZE_ADDRESS__)
#define SPHEREWALK_VECTOR_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define SPHEREWALK_VECTOR_CLONES
#endif
