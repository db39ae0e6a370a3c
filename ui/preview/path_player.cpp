// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/preview/path_player.h"

#include "ui/look/icon.h"
#include "ui/preview/preview_presenter.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>

#include <algorithm>

namespace spherewalk::ui {

PathPlayer::PathPlayer(PreviewPresenter& presenter, QWidget* parent)
    : QWidget(parent),
      m_presenter(presenter),
      m_play(new QPushButton(ui::icon("play"), tr("Pla&y"), this)),
      m_slider(new QSlider(Qt::Horizontal, this)),
      m_time(new QLabel(this)) {
    m_play->setObjectName("playPath");
    m_play->setCheckable(true);
    m_play->setToolTip(tr("Drive the recorded path again, as fast as it was driven"));
    m_slider->setObjectName("pathPosition");
    m_slider->setAccessibleName(tr("Place on the recorded path"));
    m_slider->setToolTip(tr("Go to any pose of the recorded path"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_play);
    row->addWidget(m_slider, 1);
    row->addWidget(m_time);
    constexpr int kTickMs = 30;
    m_ticking.setInterval(kTickMs);
    connect(&m_ticking, &QTimer::timeout, this, &PathPlayer::tick);
    connect(m_play, &QPushButton::toggled, this, &PathPlayer::play);
    connect(m_slider, &QSlider::sliderPressed, this, [this] { m_play->setChecked(false); });
    connect(m_slider, &QSlider::valueChanged, this, &PathPlayer::goTo);
    connect(&presenter, &PreviewPresenter::recordingChanged, this, &PathPlayer::showAll);
    connect(&presenter, &PreviewPresenter::datasetChanged, this, &PathPlayer::showAll);
    showAll();
}

void PathPlayer::play(bool isOn) {
    if (!isOn || m_presenter.path().empty()) {
        return m_ticking.stop();
    }
    if (m_slider->value() == m_slider->maximum()) {
        m_slider->setValue(0);
    }
    m_fromS = m_presenter.path()[static_cast<std::size_t>(m_slider->value())].timeS;
    m_clock.start();
    m_ticking.start();
}

void PathPlayer::tick() {
    const std::vector<TimedPose>& path = m_presenter.path();
    const double now = m_fromS + 0.001 * static_cast<double>(m_clock.elapsed());
    const auto next = std::upper_bound(path.begin(), path.end(), now,
                                       [](double time, const TimedPose& pose) { return time < pose.timeS; });
    m_slider->setValue(static_cast<int>(std::max<std::ptrdiff_t>(0, next - path.begin() - 1)));
    if (next == path.end()) {
        m_play->setChecked(false);
    }
}

void PathPlayer::goTo(int pose) {
    const std::vector<TimedPose>& path = m_presenter.path();
    if (pose >= 0 && pose < static_cast<int>(path.size())) {
        m_presenter.goTo(static_cast<std::size_t>(pose));
        m_time->setText(tr("%L1 s").arg(path[static_cast<std::size_t>(pose)].timeS, 0, 'f', 1));
    }
}

void PathPlayer::showAll() {
    const bool hasPath = m_presenter.path().size() > 1 && !m_presenter.isRecording();
    setVisible(hasPath);
    if (!hasPath) {
        m_play->setChecked(false);
        return;
    }
    const QSignalBlocker quiet(m_slider);
    m_slider->setRange(0, static_cast<int>(m_presenter.path().size()) - 1);
    const int shown = m_presenter.hasRobotPictures() ? 0 : m_slider->maximum(); // where the robot is
    m_slider->setValue(shown);
    m_time->setText(tr("%L1 s").arg(m_presenter.path()[static_cast<std::size_t>(shown)].timeS, 0, 'f', 1));
}

} // namespace spherewalk::ui
