// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/panorama/photo_mover.h"
#include "ui/panorama/photo_pictures.h"
#include "ui/panorama/region_tool.h"

#include "spherewalk/geometry/angle.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/panorama.h"

#include <QImage>
#include <QPolygonF>
#include <QTimer>

#include <optional>
#include <vector>

namespace spherewalk::ui {

/// Direction and field of view of the viewer of a panorama. Frames: room.
struct Look {
    static constexpr Degrees kNarrowest{10};
    static constexpr Degrees kWidest{120};

    Radians yaw;                 ///< Counter-clockwise from x, in (-pi, pi].
    Radians up;                  ///< Above the horizon, in [-pi/2, pi/2].
    Radians fov = Degrees(90.0); ///< Width of the picture as an angle.

    /// Turns the look. Range: any angles; up stops at the poles.
    void turn(Radians left, Radians higher);
    /// Multiplies the field of view, which stays between kNarrowest and kWidest.
    void zoom(double factor);

    /// Returns the pose of the camera's optical frame at this place.
    Rigid3 roomFromCamera(const Eigen::Vector3d& at) const;
    /// Returns a pinhole camera of this field of view. Range: sizes of at least 1 pixel.
    CameraIntrinsics camera(int width, int height) const;
};

/// Ways to compare two photos.
enum class Comparison {
    Off,
    Blink,  ///< The photos are shown in turn.
    Slider, ///< The photos lie left and right of a line.
};

/// Shows one photo, or compares two, from the place of the first photo. The other one is moved there, so that
/// a difference is an error of the alignment or a change in the room. Threads: the GUI thread; a background
/// thread decodes photos.
class PanoramaPresenter : public QObject {
    Q_OBJECT

  public:
    explicit PanoramaPresenter(QObject* parent = nullptr);

    /// Shows this photo, or none. The look turns to the first area of another photo, and stays without one.
    void show(const std::optional<ShownPhoto>& photo);
    /// Sets the photo to compare with, or none.
    void setOther(const std::optional<ShownPhoto>& photo);
    /// Sets what stands for the room where no depths of the photo are known.
    void setSurroundings(const Surroundings& surroundings);

    const std::optional<ShownPhoto>& photo() const { return m_photo; }

    const std::optional<ShownPhoto>& other() const { return m_other; }

    Comparison comparison() const { return m_comparison; }

    void setComparison(Comparison comparison);

    /// Returns the share of the width that the first photo has, in [0, 1]: there is the line.
    double share() const { return m_share; }

    void setShare(double share);

    /// Whether Comparison::Blink shows the other photo now.
    bool isOtherShown() const { return m_isOtherShown; }

    void blink();

    const Look& look() const { return m_look; }

    void setLook(const Look& look);
    void turn(Radians left, Radians higher);
    void zoom(double factor);
    void lookLevel();

    /// Renders the view; it is black before a photo is decoded. Range: at least 1 x 1 pixels. Above 8 million
    /// pixels the image is null.
    QImage picture(const QSize& sizePx);

    /// Returns the outlines of the photo's areas in such a view, as far as they lie before the camera. Units:
    /// pixels.
    std::vector<QPolygonF> outlines(const QSize& sizePx) const;

    /// The private regions of the photo, and the box that marks another one.
    RegionTool& regions() { return m_regions; }

    const RegionTool& regions() const { return m_regions; }

    /// A private region as a view of this size shows it. Units: pixels.
    struct RegionOutline {
        QPolygonF corners;
        ShownRegion region;
        bool isSelected = false;
    };

    /// Returns those before the camera, the selected one last. As exported, only the selected one is
    /// outlined.
    std::vector<RegionOutline> regionOutlines(const QSize& sizePx) const;
    /// Returns the smallest region at this pixel of such a view; nothing without one.
    std::optional<std::int64_t> regionAt(const QPointF& pixel, const QSize& sizePx) const;
    /// Selects the next region, or with -1 the one before, and turns to it. Returns false at the end.
    bool selectNextRegion(int by);
    /// Returns what the tool's box marks in such a view; nothing without a photo.
    std::optional<survey::PrivateRegion> markedRegion(const QSize& sizePx) const;
    /// Moves the tool's box, units: shares of the view. At the rim, the view turns instead.
    void moveBox(const QPointF& by, const QSize& sizePx);

    bool isAsExported() const { return m_isAsExported; }

    /// Shows the first photo with its private regions blurred, as exports have it.
    void setAsExported(bool isAsExported);

    /// Whether two photos are compared of which one is not aligned, so that they can be turned differently.
    bool isComparingUnaligned() const;

    /// Says how the other photo was moved here, for its name; empty before that.
    QString movedWords() const;

    /// Says that a photo is being decoded or moved, or why it cannot be; empty otherwise.
    QString remark() const;

  signals:
    /// picture() returns another image than before.
    void changed();
    void comparisonChanged();

  private:
    void want();
    void lookAt(const SphericalDirection& inPhoto);
    std::optional<PhotoProjection> projection(const QSize& sizePx) const;
    /// The file of the photo, as it is to be shown.
    PhotoDecoder::File shownFile() const;

    bool isComparing() const { return m_comparison != Comparison::Off && m_photo && m_other; }

    QImage render(const render::Panorama* panorama, const QSize& sizePx);
    QImage renderFirst(const QSize& sizePx);
    QImage renderOther(const QSize& sizePx);
    void move();

    std::optional<ShownPhoto> m_photo;
    std::optional<ShownPhoto> m_other;
    Surroundings m_surroundings;
    Comparison m_comparison = Comparison::Off;
    double m_share = 0.5;
    bool m_isOtherShown = false;
    bool m_isAsExported = false;
    Look m_look;
    RegionTool m_regions;
    PhotoDecoder m_decoder;
    PhotoMover m_mover;
    render::PanoramaRenderer m_renderer;
    RgbImage m_pixels;
    QTimer m_blinking;
    QTimer m_settling; ///< Runs while the view moves, which is then rendered with cheaper sampling.
};

} // namespace spherewalk::ui
