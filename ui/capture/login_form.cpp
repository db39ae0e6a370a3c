// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/capture/login_form.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace spherewalk::ui {

LoginForm::LoginForm(const camera::Endpoint& endpoint, bool wasRefused, QWidget* parent)
    : QDialog(parent),
      m_user(new QLineEdit(this)),
      m_password(new QLineEdit(this)),
      m_keep(new QCheckBox(tr("&Keep them in the system's keychain"), this)) {
    setWindowTitle(tr("The camera asks who is there"));
    const QString address = QString::fromStdString(endpoint.name());
    auto* words = new QLabel(
        wasRefused
            ? tr("The camera at %1 did not accept this user name and password.").arg(address)
            : tr("The camera at %1 is in client mode, and wants a user name and a password.").arg(address),
        this);
    words->setObjectName("loginWords");
    words->setWordWrap(true);
    m_user->setObjectName("cameraUser");
    m_user->setPlaceholderText("THETAYL00123456");
    m_user->setToolTip(tr("As set in the camera; at first THETA and its serial number."));
    m_password->setObjectName("cameraPassword");
    m_password->setEchoMode(QLineEdit::Password);
    m_password->setToolTip(tr("As set in the camera; at first the digits of its serial number."));
    m_keep->setObjectName("keepPassword");
    m_keep->setChecked(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    QPushButton* connectButton = buttons->button(QDialogButtonBox::Ok);
    connectButton->setText(tr("&Connect"));
    connectButton->setEnabled(false);
    auto* form = new QFormLayout(this);
    form->addRow(words);
    form->addRow(tr("&User name:"), m_user);
    form->addRow(tr("&Password:"), m_password);
    form->addRow(m_keep);
    form->addRow(buttons);
    connect(m_user, &QLineEdit::textChanged, this,
            [connectButton](const QString& user) { connectButton->setEnabled(!user.trimmed().isEmpty()); });
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

camera::Credentials LoginForm::credentials() const {
    return {m_user->text().trimmed().toStdString(), m_password->text().toStdString()};
}

bool LoginForm::isKept() const {
    return m_keep->isChecked();
}

} // namespace spherewalk::ui
