// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/capture/cameras.h"
#include "ui/capture/capture_desk.h"
#include "ui/capture/live_preview.h"

#include <QPointer>
#include <QWidget>

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace spherewalk::ui {

class LoginForm;
class ProfileForm;
class ToldLabel;

/// Connects a camera, and shows its status, its exposure settings and its live preview. An operator edits
/// here what CaptureDesk works with.
class CameraPanel : public QWidget {
    Q_OBJECT

  public:
    CameraPanel(CaptureDesk& desk, CameraFinder& finder, QWidget* parent = nullptr);

    /// Shows whether a phone can be the remote.
    void showRemote(bool isOn);

    /// Puts the focus on the field of the address ("address") or on the settings of the photos ("exposure").
    void showPart(const QString& part);

  signals:
    void remoteWanted();

  private:
    QWidget* makeStatus();
    QWidget* makeFinder();
    QWidget* makeExposure();
    void togglePractice();
    void connectAt(const QString& address);
    void editProfile();
    void askLogin(const camera::Endpoint& endpoint, bool wasRefused);
    void showAll();
    void showFound();

    CaptureDesk& m_desk;
    CameraFinder& m_finder;
    QLineEdit* m_address;
    QPushButton* m_connect;
    QPushButton* m_practice;
    QLabel* m_practiceWords;
    QSpinBox* m_hide;
    QCheckBox* m_automatic;
    QPushButton* m_remote;
    QLabel* m_model = nullptr;
    QLabel* m_battery = nullptr;
    QLabel* m_storage = nullptr;
    QLabel* m_heat = nullptr;
    QPushButton* m_find = nullptr;
    QComboBox* m_found = nullptr;
    ToldLabel* m_findWords = nullptr;
    QPushButton* m_profile = nullptr;
    QPushButton* m_showPreview = nullptr;
    PreviewView* m_preview = nullptr;
    QPointer<LoginForm> m_login;
    QPointer<ProfileForm> m_form;
};

} // namespace spherewalk::ui
