// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/panorama/look.h"
#include "ui/panorama/photo_decoder.h"

#include "spherewalk/render/panorama.h"

#include <QImage>
#include <QTimer>

#include <optional>

namespace spherewalk::ui {

/// A photo as the viewer needs it.
struct ShownPhoto {
    std::filesystem::path file;
    QString name; ///< for people: station and file
    Rigid3 roomFromPhoto;

    bool operator==(const ShownPhoto& other) const {
        return file == other.file && name == other.name &&
               roomFromPhoto.rotation.coeffs() == other.roomFromPhoto.rotation.coeffs() &&
               roomFromPhoto.translation == other.roomFromPhoto.translation;
    }
};

/// How two photos are compared.
enum class Comparison {
    Off,
    Blink,  ///< one in place of the other, in turn
    Slider, ///< one left of a line, the other right of it
};

/// One photo, or two, that somebody looks around in. Both are seen from the first one's place: what differs
/// is what the alignment does not explain, and what really differs. Threads: the GUI thread; photos are
/// decoded in the background.
class PanoramaPresenter : public QObject {
    Q_OBJECT

  public:
    explicit PanoramaPresenter(QObject* parent = nullptr);

    /// Nothing: no photo is shown. The direction of the look is kept.
    void show(const std::optional<ShownPhoto>& photo);
    void setOther(const std::optional<ShownPhoto>& photo);
    /// Of the sphere that things are taken to lie on when the other photo is seen from the first one's place.
    void setSphereRadius(std::optional<double> radiusM);

    const std::optional<ShownPhoto>& photo() const { return m_photo; }

    const std::optional<ShownPhoto>& other() const { return m_other; }

    Comparison comparison() const { return m_comparison; }

    void setComparison(Comparison comparison);

    /// Where the line is: the share of the width that the first photo has, in [0, 1].
    double share() const { return m_share; }

    void setShare(double share);

    /// Whether the other photo is shown now, in Comparison::Blink.
    bool isOtherShown() const { return m_isOtherShown; }

    void blink();

    const Look& look() const { return m_look; }

    void setLook(const Look& look);
    void turn(Radians left, Radians higher);
    void zoom(double factor);
    void lookLevel();

    /// The view, black where nothing is decoded yet. Range: a size of at least 1 x 1; larger than 8 million
    /// pixels gives a null image.
    QImage picture(const QSize& sizePx);

    /// What is to be said over the picture: that it is being decoded, or why it cannot be; or empty.
    QString remark() const;

  signals:
    /// The picture is another one.
    void changed();
    void comparisonChanged();

  private:
    void want();
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
    QTimer m_settling; ///< runs while the view moves: then it is rendered more cheaply
};

} // namespace spherewalk::ui
