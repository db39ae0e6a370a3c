// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/map/plan_view.h"

#include "spherewalk/survey/shot.h"

#include <QWidget>

namespace spherewalk::ui {

class CaptureDesk;

/// The plan of the survey with the next station as a large target, the tapes that find the rail to be laid,
/// and letters at the corners of the room, which tape distances name.
class CapturePlanView : public SurveyPlanView {
    Q_OBJECT

  public:
    explicit CapturePlanView(const CaptureDesk& desk, QWidget* parent = nullptr);

  protected:
    std::vector<StationMark> marks(const SurveyState& survey) const override;
    bool isPlaced(const store::StationRecord& station) const override;
    void paintFloor(QPainter& painter, const QTransform& widgetFromRoom) override;

  private:
    void paintCorners(QPainter& painter, const QTransform& widgetFromRoom);
    void paintTapes(QPainter& painter, const QTransform& widgetFromRoom) const;

    const CaptureDesk& m_desk;
    Polygon m_labelled;                    ///< The outline that m_labels belong to.
    double m_labelScale = 0;               ///< Pixels a metre that m_labels belong to.
    std::vector<Eigen::Vector2d> m_labels; ///< Places of the letters in the room.
};

/// A line of text that fills its widget, so that it can be read from three metres.
class BigText : public QWidget {
    Q_OBJECT

  public:
    explicit BigText(QWidget* parent = nullptr);

    const QString& text() const { return m_text; }

    void setText(const QString& text);

    QSize sizeHint() const override { return {420, 110}; }

    QSize minimumSizeHint() const override { return {160, 56}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QString m_text;
};

/// Tells the result of a shot by sound, as the operator looks at the cart and not at the screen.
class Sounds {
  public:
    virtual ~Sounds() = default;

    virtual void play(survey::Quality quality) = 0;
    /// Sounds once for each second of the countdown.
    virtual void tick() = 0;
};

/// Rings the desktop's bell once for a good photo, twice for a doubtful one, three times for a failed one.
class BellSounds : public Sounds {
  public:
    void play(survey::Quality quality) override;
    void tick() override;
};

} // namespace spherewalk::ui
