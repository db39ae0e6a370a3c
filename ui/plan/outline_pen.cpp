// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plan/outline_pen.h"

#include "spherewalk/base/text.h"

#include <cmath>
#include <utility>

namespace spherewalk::ui {

using Eigen::Vector2d;

namespace {

/// Returns the nearest of the points within reach; null without one.
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

constexpr double kSamePointM = 1e-6;

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

void OutlinePen::start() {
    *this = OutlinePen();
    m_isDrawing = true;
}

void OutlinePen::cancel() {
    *this = OutlinePen();
}

Polygon OutlinePen::preview() const {
    Polygon result = m_corners;
    if (result.empty() ||
        ((result.back() - m_tip).norm() > kSamePointM && (result.front() - m_tip).norm() > kSamePointM)) {
        result.push_back(m_tip);
    }
    return result;
}

void OutlinePen::moveTo(const Vector2d& point) {
    m_pointer = point;
    updateTip();
}

void OutlinePen::updateTip() {
    m_tip = m_pointer;
    const std::optional<double> metres = parseNumber(m_typed.toStdString());
    if (m_corners.empty() || !metres || !(*metres > 0)) {
        return;
    }
    const Vector2d along = m_pointer - m_corners.back();
    if (along.norm() > kSamePointM) {
        m_tip = m_corners.back() + *metres * along.normalized();
    }
}

std::optional<Polygon> OutlinePen::press() {
    if (!m_isDrawing) {
        return std::nullopt;
    }
    if (m_corners.size() >= 3 && (m_tip - m_corners.front()).norm() <= kSamePointM) {
        return close();
    }
    if (m_corners.empty() || (m_tip - m_corners.back()).norm() > kSamePointM) {
        m_corners.push_back(m_tip);
    }
    m_typed.clear();
    return std::nullopt;
}

bool OutlinePen::type(QChar character) {
    constexpr qsizetype kLongest = 10;
    const bool isDecimal = character == '.' || character == ',';
    if (!m_isDrawing || m_corners.empty() || !(character.isDigit() || isDecimal)) {
        return false;
    }
    if (m_typed.size() < kLongest && !(isDecimal && m_typed.contains('.'))) {
        m_typed += isDecimal ? QChar('.') : character;
        updateTip();
    }
    return true;
}

void OutlinePen::takeBack() {
    if (!m_typed.isEmpty()) {
        m_typed.chop(1);
    } else if (!m_corners.empty()) {
        m_corners.pop_back();
    }
    updateTip();
}

std::optional<Polygon> OutlinePen::close() {
    if (m_corners.size() < 3) {
        return std::nullopt;
    }
    Polygon result = std::move(m_corners);
    cancel();
    return result;
}

std::optional<double> OutlinePen::length() const {
    return m_corners.empty() ? std::nullopt : std::optional((m_tip - m_corners.back()).norm());
}

} // namespace spherewalk::ui
