// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/capture/camera_login.h"

#include <QJsonDocument>
#include <QJsonObject>
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

/// Nothing if anybody else has changed it to something else.
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

/// In the keychain, once; after that, and if that was wrong, a person is asked.
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

} // namespace spherewalk::ui
