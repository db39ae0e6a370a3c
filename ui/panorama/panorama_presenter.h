// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/panorama/photo_pictures.h"

#include "spherewalk/geometry/angle.h"
#include "spherewalk/geometry/camera_model.h"
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

/// An area of a photo that somebody must look at. Frames: the photo's panorama frame.
struct PhotoArea {
    Radians azimuth; ///< Of the middle, counter-clockwise from the picture's middle.
    Radians elevation;
    Radians halfWidth;
    Radians halfHeight;

    bool operator==(const PhotoArea& other) const = default;
};

/// A photo that the viewer shows.
struct ShownPhoto {
    std::filesystem::path file;
    QString name; ///< Station and file, for people.
    Rigid3 roomFromPhoto;
    bool isAligned = true; ///< Whether the rotation of roomFromPhoto is known.
    std::vector<PhotoArea> areas = {};

    bool operator==(const ShownPhoto& other) const {
        return file == other.file && name == other.name && isAligned == other.isAligned &&
               areas == other.areas &&
               roomFromPhoto.rotation.coeffs() == other.roomFromPhoto.rotation.coeffs() &&
               roomFromPhoto.translation == other.roomFromPhoto.translation;
    }
};

/// Ways to compare two photos.
enum class Comparison {
    Off,
    Blink,  ///< The photos are shown in turn.
    Slider, ///< The photos lie left and right of a line.
};

/// Shows one photo, or compares two, from the place of the first photo. A difference is then an error of the
/// alignment or a change in the room. Threads: the GUI thread; a background thread decodes photos.
class PanoramaPresenter : public QObject {
    Q_OBJECT

  public:
    explicit PanoramaPresenter(QObject* parent = nullptr);

    /// Shows this photo, or none. The look turns to the first area of another photo, and stays without one.
    void show(const std::optional<ShownPhoto>& photo);
    /// Sets the photo to compare with, or none.
    void setOther(const std::optional<ShownPhoto>& photo);
    /// Sets the radius of the sphere on which the other photo is moved to the place of the first one;
    /// nothing: it is only turned.
    void setSphereRadius(std::optional<double> radiusM);

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

    /// Whether two photos are compared of which one is not aligned, so that they can be turned differently.
    bool isComparingUnaligned() const;

    /// Says that a photo is being decoded, or why it cannot be; empty otherwise.
    QString remark() const;

  signals:
    /// picture() returns another image than before.
    void changed();
    void comparisonChanged();

  private:
    void want();
    void lookAt(const PhotoArea& area);
    QImage render(const ShownPhoto& photo, const QSize& sizePx);
    void move();

    std::optional<ShownPhoto> m_photo;
    std::optional<ShownPhoto> m_other;
    std::optional<double> m_sphereRadiusM;
    Comparison m_comparison = Comparison::Off;
    double m_share = 0.5;
    bool m_isOtherShown = false;
    Look m_look;
    PhotoDecoder m_decoder;
    render::PanoramaRenderer m_renderer;
    RgbImage m_pixels;
    QTimer m_blinking;
    QTimer m_settling; ///< Runs while the view moves, which is then rendered with cheaper sampling.
};

} // namespace spherewalk::ui
