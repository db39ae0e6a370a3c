// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/camera/credentials.h"
#include "spherewalk/camera/endpoint.h"

#include <QObject>

#include <map>
#include <memory>
#include <string>

namespace spherewalk::ui {

/// The user names and passwords of cameras that ask who is there (client mode): what a person has said since
/// the program began, before that what the system's keychain knows. They are written nowhere else. Threads:
/// the GUI thread, but for the sources. Owner: it outlives the clients that ask.
class CameraLogin : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;

    /// For the clients of one camera. It says nothing where nothing is known yet, and looks for it meanwhile:
    /// known() or wanted() follows.
    camera::CredentialsSource sourceFor(const camera::Endpoint& endpoint);

    /// What a person has said. isKept: also in the keychain.
    void give(const camera::Endpoint& endpoint, const camera::Credentials& credentials, bool isKept);

  signals:
    /// The keychain has it: it is worth connecting again.
    void known(const spherewalk::camera::Endpoint& endpoint);
    /// A person must be asked. wasRefused: what was given is wrong.
    void wanted(const spherewalk::camera::Endpoint& endpoint, bool wasRefused);
    /// What could not be kept, and why.
    void trouble(const QString& sentence);

  private:
    /// Of one camera.
    struct Entry {
        camera::CredentialsMemory memory;
        bool isSought = false; ///< in the keychain
    };

    Entry& entry(const camera::Endpoint& endpoint);
    void look(const camera::Endpoint& endpoint, bool wasRefused);

    std::map<std::string, std::unique_ptr<Entry>> m_entries; ///< by the endpoint's name; they stay
};

} // namespace spherewalk::ui
