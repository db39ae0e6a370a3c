// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plan/snapping.h"

#include <cmath>

namespace spherewalk::ui {

using Eigen::Vector2d;

namespace {

/// The nearest of the points within reach; null if there is none.
const Vector2d* nearest(const Vector2d& point, const std::vector<Vector2d>& candidates, double reachM) {
    const Vector2d* best = nullptr;
    for (const Vector2d& candidate : candidates) {
        const double distance = (candidate - point).norm();
        if (distance <= reachM) {
            best = &candidate;
            reachM = distance;
        }
    }
    return best;
}

double onGrid(double value, double gridM) {
    return gridM > 0 ? std::round(value / gridM) * gridM : value;
}

} // namespace

Vector2d snapped(const Vector2d& point, const Snapping& snapping) {
    if (const Vector2d* corner = nearest(point, snapping.corners, snapping.reachM)) {
        return *corner;
    }
    Vector2d result;
    for (int axis = 0; axis < 2; ++axis) {
        result[axis] = onGrid(point[axis], snapping.gridM);
        double reachM = snapping.reachM;
        for (const Vector2d& neighbour : snapping.neighbours) {
            const double distance = std::abs(neighbour[axis] - point[axis]);
            if (distance <= reachM) {
                result[axis] = neighbour[axis];
                reachM = distance;
            }
        }
    }
    return result;
}

} // namespace spherewalk::ui
