// SPDX-License-Identifier: GPL-3.0-or-later
#include "median_filter.h"

#include "spherewalk/base/parallel.h"

#include <algorithm>
#include <array>

namespace spherewalk::scene {

Plane median3x3(const Plane& plane, int threads) {
    Plane result(plane.width(), plane.height());
    parallelFor(plane.height(), 16, threads, [&](int begin, int end) {
        std::array<float, 9> around{};
        for (int y = begin; y < end; ++y) {
            for (int x = 0; x < plane.width(); ++x) {
                for (int i = 0; i < 9; ++i) {
                    const int column = (x + i % 3 - 1 + plane.width()) % plane.width();
                    const int row = std::clamp(y + i / 3 - 1, 0, plane.height() - 1);
                    around[static_cast<std::size_t>(i)] = *plane.at(column, row);
                }
                std::nth_element(around.begin(), around.begin() + 4, around.end());
                *result.at(x, y) = around[4];
            }
        }
    });
    return result;
}

} // namespace spherewalk::scene
