// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panorama/region_tool.h"

#include "spherewalk/geometry/equirect.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace spherewalk::ui {

using Eigen::Vector2d;
using Eigen::Vector3d;
using survey::PrivateRegion;
using survey::RegionFrame;

namespace {

constexpr QRectF kWholeView(0, 0, 1, 1);
constexpr QRectF kFirstBox(0.4, 0.4, 0.2, 0.2);
constexpr double kLeastBox = 0.02; ///< Share of the view's width and height.

/// The part of a convex polygon that lies at least so far before the camera. Frames: optical.
std::vector<Vector3d> partAhead(const std::vector<Vector3d>& corners) {
    constexpr double kLeastAhead = 1e-3;
    std::vector<Vector3d> result;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vector3d& here = corners[i];
        const Vector3d& next = corners[(i + 1) % corners.size()];
        const bool isAhead = here.z() >= kLeastAhead;
        if (isAhead) {
            result.push_back(here);
        }
        if (isAhead != (next.z() >= kLeastAhead)) {
            const double share = (kLeastAhead - here.z()) / (next.z() - here.z());
            result.push_back(here + share * (next - here));
        }
    }
    return result;
}

/// The least and the greatest tangents of directions to the middle of a frame.
struct Tangents {
    Vector2d least = Vector2d::Constant(std::numeric_limits<double>::max());
    Vector2d greatest = -least;
};

std::optional<Tangents> tangentsOf(const std::array<Vector3d, 4>& corners, const Vector3d& middle) {
    const RegionFrame frame(survey::regionAround(middle, Degrees(90), Degrees(90)));
    Tangents result;
    for (const Vector3d& corner : corners) {
        const auto at = frame.at(corner);
        if (!at) {
            return std::nullopt;
        }
        result.least = result.least.cwiseMin(*at);
        result.greatest = result.greatest.cwiseMax(*at);
    }
    return result;
}

/// The tangent of the angle half-way between two.
double halfWay(double a, double b) {
    return std::tan(0.5 * (std::atan(a) + std::atan(b)));
}

Radians sideFor(double halfTangent) {
    return std::clamp(Radians(2 * std::atan(halfTangent)), Radians(survey::kLeastRegion),
                      Radians(survey::kLargestRegion));
}

} // namespace

Vector3d PhotoProjection::direction(const QPointF& pixel) const {
    const CameraIntrinsics& pinhole = camera.intrinsics();
    const Vector3d inCamera((pixel.x() - pinhole.cx) / pinhole.fx, (pixel.y() - pinhole.cy) / pinhole.fy, 1);
    return cameraFromPhoto.conjugate() * inCamera.normalized();
}

// Great circles are straight lines in the picture of a pinhole, so that four corners are enough.
QPolygonF outlineOf(const PrivateRegion& region, const PhotoProjection& view) {
    const RegionFrame frame(region);
    std::vector<Vector3d> corners;
    for (const Vector2d& corner : {Vector2d(-1, 1), Vector2d(1, 1), Vector2d(1, -1), Vector2d(-1, -1)}) {
        corners.emplace_back(view.cameraFromPhoto * frame.direction(corner));
    }
    QPolygonF outline;
    for (const Vector3d& corner : partAhead(corners)) {
        if (const auto pixel = view.camera.project(corner)) {
            outline << QPointF(pixel->x(), pixel->y());
        }
    }
    if (outline.size() < 3) {
        return {};
    }
    outline << outline.front();
    return outline;
}

PrivateRegion regionAround(const QRectF& box, const PhotoProjection& view) {
    const std::array<Vector3d, 4> corners{view.direction(box.topLeft()), view.direction(box.topRight()),
                                          view.direction(box.bottomRight()),
                                          view.direction(box.bottomLeft())};
    Vector3d middle = (corners[0] + corners[1] + corners[2] + corners[3]).normalized();
    // The middle of the box is not half-way between its sides: pixels beside the axis are narrower.
    constexpr int kRounds = 4;
    for (int round = 0; round < kRounds; ++round) {
        if (const auto tangents = tangentsOf(corners, middle)) {
            const RegionFrame frame(survey::regionAround(middle, Degrees(90), Degrees(90)));
            middle = frame.direction({halfWay(tangents->least.x(), tangents->greatest.x()),
                                      halfWay(tangents->least.y(), tangents->greatest.y())});
        }
    }
    const auto tangents = tangentsOf(corners, middle);
    if (!tangents) {
        return survey::regionAround(middle, survey::kLargestRegion, survey::kLargestRegion);
    }
    const Vector2d half = tangents->greatest.cwiseMax(-tangents->least);
    return survey::regionAround(middle, sideFor(half.x()), sideFor(half.y()));
}

void RegionTool::setRegions(std::vector<ShownRegion> regions) {
    m_regions = std::move(regions);
    if (selected() == nullptr) {
        m_selected.reset();
    }
    emit changed();
}

const ShownRegion* RegionTool::selected() const {
    const auto found = std::find_if(m_regions.begin(), m_regions.end(),
                                    [this](const ShownRegion& region) { return region.id == m_selected; });
    return found != m_regions.end() ? &*found : nullptr;
}

void RegionTool::select(std::optional<std::int64_t> region) {
    m_selected = region;
    if (selected() == nullptr) {
        m_selected.reset();
    }
    emit changed();
}

bool RegionTool::selectNext(int by) {
    const ShownRegion* here = selected();
    const auto next = here != nullptr ? (here - m_regions.data()) + by : (by > 0 ? 0 : -1);
    if (next < 0 || next >= std::ssize(m_regions)) {
        return false;
    }
    select(m_regions[static_cast<std::size_t>(next)].id);
    return true;
}

void RegionTool::setMarking(bool isMarking) {
    if (isMarking != m_isMarking) {
        m_isMarking = isMarking;
        m_box = kFirstBox;
        if (isMarking) {
            m_selected.reset();
        }
        emit changed();
    }
}

void RegionTool::setBox(const QRectF& box) {
    m_box = box.normalized().intersected(kWholeView);
    emit changed();
}

QPointF RegionTool::moveBox(const QPointF& by) {
    const QPointF within(std::clamp(by.x(), -m_box.left(), 1 - m_box.right()),
                         std::clamp(by.y(), -m_box.top(), 1 - m_box.bottom()));
    setBox(m_box.translated(within));
    return by - within;
}

void RegionTool::growBox(const QPointF& by) {
    const auto grown = [](double side, double more) { return std::clamp(side + more, kLeastBox, 1.0); };
    QRectF box(0, 0, grown(m_box.width(), by.x()), grown(m_box.height(), by.y()));
    box.moveCenter(m_box.center());
    // A box at the rim grows into the view.
    box.moveLeft(std::clamp(box.left(), 0.0, 1 - box.width()));
    box.moveTop(std::clamp(box.top(), 0.0, 1 - box.height()));
    setBox(box);
}

} // namespace spherewalk::ui
