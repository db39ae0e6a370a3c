// SPDX-License-Identifier: Apache-2.0
// What the lattice's sources share; included once for each kind of processor, as Highway's own -inl.h files.
#include "sphere/lattice_simd.h"

#include <hwy/highway.h>

#if defined(SPHEREWALK_LATTICE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SPHEREWALK_LATTICE_INL_H
#undef SPHEREWALK_LATTICE_INL_H
#else
#define SPHEREWALK_LATTICE_INL_H
#endif

HWY_BEFORE_NAMESPACE();

namespace spherewalk::render::simd::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::ScalableTag<double>;
using V = hn::Vec<D>;

// Not hn::MulAdd: where the processor has one, it rounds once instead of twice.
template <class Vector>
HWY_INLINE Vector mulAdd(Vector a, Vector b, Vector c) {
    return hn::Add(hn::Mul(a, b), c);
}

} // namespace spherewalk::render::simd::HWY_NAMESPACE

HWY_AFTER_NAMESPACE();

#endif
