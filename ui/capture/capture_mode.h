// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/capture/camera_finder.h"
#include "ui/capture/capture_desk.h"
#include "ui/capture/sounds.h"
#include "ui/shell/mode.h"

#include <memory>

class QLabel;
class QListWidget;
class QPushButton;

namespace spherewalk::ui {

class BigText;
class CapturePlanView;
class CameraPanel;

/// Takes the photos: the next station large, one key, and what became of each shot. Readable from three
/// metres, and used with one hand: Space, Return, Page Down or a presenter's button is the key.
class CaptureMode : public Mode {
    Q_OBJECT

  public:
    explicit CaptureMode(TaskList& tasks, QWidget* parent = nullptr);
    ~CaptureMode() override;

    void setSession(SurveySession* session) override;
    void activated() override;

    CaptureDesk& desk() { return m_desk; }

    CameraFinder& finder() { return m_finder; }

    void setSounds(std::unique_ptr<Sounds> sounds) { m_sounds = std::move(sounds); }

    /// Connects to the practice camera and takes all photos by itself.
    void runPractice();

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    QWidget* makeTarget();
    QWidget* makeFigures();
    QWidget* makeVerdict();
    QWidget* makeAgain();
    void showAll();
    void takeFocus();
    void showVerdict();
    void showAgain();
    QString stateText() const;
    QString keyText() const;
    void toggleAgain();

    CaptureDesk m_desk;
    CameraFinder m_finder;
    std::unique_ptr<Sounds> m_sounds;
    bool m_startsWhenReady = false;
    CaptureDesk::State m_shownState = CaptureDesk::State::NoCamera;
    Verdict m_shownVerdict = Verdict::None;
    CapturePlanView* m_plan;
    CameraPanel* m_camera;
    QLabel* m_state = nullptr;
    BigText* m_next = nullptr;
    QLabel* m_way = nullptr;
    QPushButton* m_key = nullptr;
    QPushButton* m_stop = nullptr;
    QLabel* m_verdictIcon = nullptr;
    QLabel* m_verdict = nullptr;
    BigText* m_photosLeft = nullptr;
    BigText* m_timeLeft = nullptr;
    BigText* m_pace = nullptr;
    QListWidget* m_again = nullptr;
    QPushButton* m_takeAgain = nullptr;
    QLabel* m_againTitle = nullptr;
};

} // namespace spherewalk::ui
