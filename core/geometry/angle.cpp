// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/geometry/angle.h"

namespace spherewalk {

Radians wrapped(Radians angle) {
    // remainder() is exact and gives [-pi, pi].
    const double rest = std::remainder(angle.value(), 2 * std::numbers::pi);
    return Radians(rest <= -std::numbers::pi ? std::numbers::pi : rest);
}

} // namespace spherewalk
