// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/camera/http.h"

#include <QDialog>

class QCheckBox;
class QLineEdit;
class QPushButton;

namespace spherewalk::ui {

/// Asks by which name and password a camera in client mode knows its users.
class LoginForm : public QDialog {
    Q_OBJECT

  public:
    /// wasRefused: what was said before is wrong.
    LoginForm(const camera::Endpoint& endpoint, bool wasRefused, QWidget* parent = nullptr);

    camera::Credentials credentials() const;
    bool isKept() const;

  private:
    QLineEdit* m_user;
    QLineEdit* m_password;
    QCheckBox* m_keep;
};

} // namespace spherewalk::ui
