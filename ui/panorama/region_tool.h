// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/survey/private_region.h"

#include <Eigen/Geometry>
#include <QObject>
#include <QPolygonF>
#include <QRectF>

#include <cstdint>
#include <optional>
#include <vector>

namespace spherewalk::ui {

/// A part of a photo that exports show blurred.
struct ShownRegion {
    std::int64_t id = 0;
    survey::PrivateRegion region;
    bool isFound = false; ///< A search has found it; otherwise a person has marked it.

    bool operator==(const ShownRegion&) const = default;
};

/// Where directions of a photo lie in a picture of it. Frames: the photo's panorama frame. Units: pixels.
struct PhotoProjection {
    CameraModel camera; ///< A pinhole.
    Eigen::Quaterniond cameraFromPhoto;

    /// Range: any pixel.
    Eigen::Vector3d direction(const QPointF& pixel) const;
};

/// Returns the outline of a region as far as it lies before the camera; empty if none of it does.
QPolygonF outlineOf(const survey::PrivateRegion& region, const PhotoProjection& view);

/// Returns the smallest region around a box in the picture, of the sizes that regions may have. Range: any
/// box, also across the seam and at the poles.
survey::PrivateRegion regionAround(const QRectF& box, const PhotoProjection& view);

/// Which private region of the shown photo is selected, and the box with which a person marks another one.
class RegionTool : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;

    const std::vector<ShownRegion>& regions() const { return m_regions; }

    /// Takes the regions of a photo. The selection stays with a region that is still there.
    void setRegions(std::vector<ShownRegion> regions);

    /// Returns the selected region; null without one.
    const ShownRegion* selected() const;
    /// Nothing, and the identity of no region, end the selection.
    void select(std::optional<std::int64_t> region);
    /// Goes to the next region, or with -1 to the one before. Returns false at the end, and changes nothing.
    bool selectNext(int by);

    bool isMarking() const { return m_isMarking; }

    /// Begins with a box in the middle of the view and no region selected, or ends.
    void setMarking(bool isMarking);

    /// Returns the box in shares of the view's width and height.
    const QRectF& box() const { return m_box; }

    /// Takes the box as far as it lies in the view.
    void setBox(const QRectF& box);
    /// Moves the box within the view. Returns the part of the way on which the box would have left the view.
    QPointF moveBox(const QPointF& by);
    /// Makes the box wider and higher around its middle.
    void growBox(const QPointF& by);

  signals:
    void changed();

  private:
    std::vector<ShownRegion> m_regions;
    std::optional<std::int64_t> m_selected;
    bool m_isMarking = false;
    QRectF m_box;
};

} // namespace spherewalk::ui
