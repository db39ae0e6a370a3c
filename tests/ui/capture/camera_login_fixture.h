// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "capture_fixture.h"
#include "ui/capture/camera_login.h"

#include "spherewalk/practice/practice_camera.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include <algorithm>

namespace spherewalk::ui {

/// The capture page, and a camera in client mode.
class CameraLoginFixture : public CaptureFixture {
  protected:
    static constexpr auto kUser = "THETAYL00123456";
    static constexpr auto kPassword = "00123456";

    CameraLoginFixture() { camera.start(); }

    QString address() const { return QString("127.0.0.1:%1").arg(camera.port()); }

    /// Null if there is none.
    LoginForm* form() {
        const auto forms = mode.findChildren<LoginForm*>();
        const auto shown = std::ranges::find_if(forms, [](const LoginForm* one) { return one->isVisible(); });
        return shown == forms.end() ? nullptr : *shown;
    }

    /// Null if none comes.
    LoginForm* waitForForm() {
        waitUntil([this] { return form() != nullptr; });
        return form();
    }

    /// As a person would, through the widgets.
    static void answer(LoginForm& form, const QString& password, bool isKept) {
        auto* accept = form.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
        EXPECT_FALSE(accept->isEnabled());
        form.findChild<QLineEdit*>("cameraUser")->setText(kUser);
        form.findChild<QLineEdit*>("cameraPassword")->setText(password);
        form.findChild<QCheckBox*>("keepPassword")->setChecked(isKept);
        accept->click();
    }

    static practice::PracticeCameraOptions clientMode() {
        practice::PracticeCameraOptions options;
        options.width = 1024;
        options.digestUser = kUser;
        options.digestPassword = kPassword;
        return options;
    }

    practice::PracticeCamera camera{clientMode()};
};

} // namespace spherewalk::ui
