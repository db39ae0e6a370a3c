// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

class QLabel;
class QPushButton;
class QSlider;

namespace spherewalk::ui {

class PreviewPresenter;

/// Plays the recorded path of a robot, or goes to any pose of it. It is hidden without a path.
class PathPlayer : public QWidget {
    Q_OBJECT

  public:
    explicit PathPlayer(PreviewPresenter& presenter, QWidget* parent = nullptr);

    bool isPlaying() const { return m_ticking.isActive(); }

  private:
    void play(bool isOn);
    void tick();
    void goTo(int pose);
    void showAll();

    PreviewPresenter& m_presenter;
    QPushButton* m_play;
    QSlider* m_slider;
    QLabel* m_time;
    QTimer m_ticking;
    QElapsedTimer m_clock;
    double m_fromS = 0; ///< Time of the path at which playing began.
};

} // namespace spherewalk::ui
