// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/render/simd_target.h"

#include <hwy/highway.h>

namespace spherewalk::render {

std::string simdTarget() {
    const auto usable = hwy::SupportedTargets() & HWY_TARGETS; // the best has the lowest bit
    return hwy::TargetName(usable & -usable);
}

} // namespace spherewalk::render
