// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/camera/endpoint.h"
#include "spherewalk/camera/http.h"

#include <QDialog>
#include <QObject>

#include <map>
#include <memory>
#include <string>

class QCheckBox;
class QLineEdit;
class QPushButton;

namespace spherewalk::ui {

/// Keeps user names and passwords of cameras in client mode, in memory and, if wanted, in the system's
/// keychain. What a person typed goes before what the keychain knows. Threads: the GUI thread; clients call
/// their sources on any thread. Owner: it outlives the clients.
class CameraLogin : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;

    /// Returns what the clients of one camera ask for credentials. While none are known, it answers with
    /// nothing and asks the keychain; known() or wanted() follows.
    camera::CredentialsSource sourceFor(const camera::Endpoint& endpoint);

    /// Takes what a person typed. isKept: whether the keychain keeps it, too.
    void give(const camera::Endpoint& endpoint, const camera::Credentials& credentials, bool isKept);

  signals:
    /// The keychain knows this camera, so that connecting again can succeed.
    void known(const spherewalk::camera::Endpoint& endpoint);
    /// A person must type user name and password. wasRefused: the camera refused the last ones.
    void wanted(const spherewalk::camera::Endpoint& endpoint, bool wasRefused);
    /// The keychain kept nothing; the sentence says why.
    void trouble(const QString& sentence);

  private:
    /// What is known of one camera.
    struct Entry {
        camera::CredentialsMemory memory;
        bool isSought = false; ///< The keychain has been asked.
    };

    Entry& entry(const camera::Endpoint& endpoint);
    void look(const camera::Endpoint& endpoint, bool wasRefused);

    std::map<std::string, std::unique_ptr<Entry>>
        m_entries; ///< By the endpoint's name. Sources refer to entries, so none is removed.
};

/// A dialog for the user name and the password of a camera in client mode.
class LoginForm : public QDialog {
    Q_OBJECT

  public:
    /// wasRefused: the dialog says that the camera refused the last ones.
    LoginForm(const camera::Endpoint& endpoint, bool wasRefused, QWidget* parent = nullptr);

    camera::Credentials credentials() const;
    /// Whether the keychain keeps them.
    bool isKept() const;

  private:
    QLineEdit* m_user;
    QLineEdit* m_password;
    QCheckBox* m_keep;
};

} // namespace spherewalk::ui
