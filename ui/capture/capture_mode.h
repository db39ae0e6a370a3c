// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/capture/cameras.h"
#include "ui/capture/capture_desk.h"
#include "ui/capture/operator_signals.h"
#include "ui/frame/mode.h"

#include <memory>

class QLabel;
class QListWidget;
class QPushButton;

namespace spherewalk::ui {

class BigText;
class CapturePlanView;
class CameraPanel;
class ToldLabel;

/// The page that takes the photos. It shows the next station, one key and the result of each shot, readable
/// from three metres. Space, Return, Page Down or a presenter's button is the key. Once every station has its
/// photo, it says what comes next. On the whole screen it is the cart's view: only what one must read from
/// afar, within an edge in the colour of the last result.
class CaptureMode : public Mode {
    Q_OBJECT

  public:
    explicit CaptureMode(TaskList& tasks, QWidget* parent = nullptr);
    ~CaptureMode() override;

    void setSession(SurveySession* session) override;
    void activated() override;
    /// Shows the field of the camera's address ("address") or the settings of its photos ("exposure").
    void showPart(const QString& part) override;

    bool takesWholeScreen() const override { return true; }

    void setWholeScreen(bool isWhole) override;
    QList<Key> keys() const override;

    CaptureDesk& desk() { return m_desk; }

    CameraFinder& finder() { return m_finder; }

    /// Shows whether a phone can be the remote.
    void showRemote(bool isOn);

    void setSounds(std::unique_ptr<Sounds> sounds) { m_sounds = std::move(sounds); }

  signals:
    /// Asks the window for the form of the phone remote.
    void remoteWanted();

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

  private:
    QWidget* makeNext();
    QWidget* makeTarget();
    QWidget* makeFigures();
    QWidget* makeVerdict();
    QWidget* makeAgain();
    void showAll();
    void showNext();
    void showFigures();
    void goOn();
    void takeFocus();
    void showVerdict();
    void showAgain();
    void toggleAgain();

    CaptureDesk m_desk;
    CameraFinder m_finder;
    std::unique_ptr<Sounds> m_sounds;
    CaptureDesk::State m_shownState = CaptureDesk::State::NoCamera;
    std::optional<survey::Quality> m_shownVerdict;
    CapturePlanView* m_plan;
    CameraPanel* m_camera;
    QLabel* m_state = nullptr;
    BigText* m_next = nullptr;
    QLabel* m_way = nullptr;
    QPushButton* m_key = nullptr;
    QPushButton* m_stop = nullptr;
    QWidget* m_whatNext = nullptr; ///< Buttons for what comes after the last photo.
    QPushButton* m_toReview = nullptr;
    QPushButton* m_retakeDoubtful = nullptr;
    QPushButton* m_toAlign = nullptr;
    QWidget* m_figures = nullptr;
    QWidget* m_againSection = nullptr;
    bool m_isWhole = false;
    QLabel* m_verdictIcon = nullptr;
    ToldLabel* m_verdict = nullptr;
    BigText* m_photosLeft = nullptr;
    QLabel* m_photosLeftName = nullptr;
    BigText* m_timeLeft = nullptr;
    QLabel* m_timeLeftName = nullptr;
    BigText* m_pace = nullptr;
    QListWidget* m_again = nullptr;
    QPushButton* m_takeAgain = nullptr;
    QLabel* m_againTitle = nullptr;
};

} // namespace spherewalk::ui
