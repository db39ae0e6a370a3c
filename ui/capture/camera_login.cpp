// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/capture/camera_login.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <qt6keychain/keychain.h>

#include <optional>
#include <utility>

namespace spherewalk::ui {

namespace {

constexpr auto kService = "Spherewalk";
constexpr auto kUserKey = "user";
constexpr auto kPasswordKey = "password";

QString keyOf(const camera::Endpoint& endpoint) {
    return QString("camera %1").arg(QString::fromStdString(endpoint.name()));
}

QByteArray secretOf(const camera::Credentials& credentials) {
    const QJsonObject json{{kUserKey, QString::fromStdString(credentials.user)},
                           {kPasswordKey, QString::fromStdString(credentials.password)}};
    return QJsonDocument(json).toJson(QJsonDocument::Compact);
}

/// Reads an entry of the keychain; nothing if another program has changed its format.
std::optional<camera::Credentials> credentialsIn(const QByteArray& secret) {
    const QJsonObject json = QJsonDocument::fromJson(secret).object();
    const QString user = json[kUserKey].toString();
    if (user.isEmpty()) {
        return std::nullopt;
    }
    return camera::Credentials{user.toStdString(), json[kPasswordKey].toString().toStdString()};
}

} // namespace

CameraLogin::Entry& CameraLogin::entry(const camera::Endpoint& endpoint) {
    std::unique_ptr<Entry>& entry = m_entries[endpoint.name()];
    if (!entry) {
        entry = std::make_unique<Entry>();
    }
    return *entry;
}

camera::CredentialsSource CameraLogin::sourceFor(const camera::Endpoint& endpoint) {
    return [this, endpoint, &memory = entry(endpoint).memory, given = 0]() mutable {
        const bool wasRefused = given > 0;
        auto known = memory.newer(given);
        if (!known) {
            QMetaObject::invokeMethod(
                this, [this, endpoint, wasRefused] { look(endpoint, wasRefused); }, Qt::QueuedConnection);
        }
        return known;
    };
}

/// Asks the keychain once. A person is asked if it knows nothing or something wrong.
void CameraLogin::look(const camera::Endpoint& endpoint, bool wasRefused) {
    if (std::exchange(entry(endpoint).isSought, true) || wasRefused) {
        emit wanted(endpoint, wasRefused);
        return;
    }
    auto* job = new QKeychain::ReadPasswordJob(kService, this);
    job->setKey(keyOf(endpoint));
    connect(job, &QKeychain::Job::finished, this, [this, job, endpoint] {
        const auto credentials =
            job->error() == QKeychain::NoError ? credentialsIn(job->binaryData()) : std::nullopt;
        if (!credentials) { // also without a keychain: then a person knows
            emit wanted(endpoint, false);
            return;
        }
        entry(endpoint).memory.set(*credentials);
        emit known(endpoint);
    });
    job->start();
}

void CameraLogin::give(const camera::Endpoint& endpoint, const camera::Credentials& credentials,
                       bool isKept) {
    entry(endpoint).memory.set(credentials);
    if (!isKept) {
        return;
    }
    auto* job = new QKeychain::WritePasswordJob(kService, this);
    job->setKey(keyOf(endpoint));
    job->setBinaryData(secretOf(credentials));
    connect(job, &QKeychain::Job::finished, this, [this, job] {
        if (job->error() != QKeychain::NoError) {
            emit trouble(
                tr("The system's keychain did not keep the password (%1); it is asked for again when "
                   "the program starts next.")
                    .arg(job->errorString()));
        }
    });
    job->start();
}

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
