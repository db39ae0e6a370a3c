// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/remote/desk_remote.h"
#include "ui/remote/local_server.h"
#include "ui/remote/pairing.h"

#include <QHostAddress>
#include <QObject>
#include <QString>

namespace spherewalk::ui {

/// The remote of a capture desk on a phone or tablet: a page that this program serves on the local network
/// while a person wants it. Everything that comes is hostile until it proves to be of the paired device:
/// before that, only the page without content is served. Requests that change something also need the
/// session's token. No text of a request is ever a file's name. Threads: the GUI thread.
class PhoneRemote : public QObject {
    Q_OBJECT

  public:
    /// Owner: desk and clock outlive this. port: see LocalServer::open().
    explicit PhoneRemote(CaptureDesk& desk, const Clock& clock = systemClock(),
                         quint16 port = LocalServer::kUsualPort, QObject* parent = nullptr);

    /// Serves the page at this address of the computer, with a new code. If that fails, sentence() says why.
    void turnOn(const QHostAddress& address);
    /// Serves nothing any more, and lets go of the paired device.
    void turnOff();

    bool isOn() const { return m_server.isOpen(); }

    /// Returns what is typed into the phone's browser; empty while off.
    QString url() const { return isOn() ? "http://" + m_server.host() : QString(); }

    const Pairing& pairing() const { return m_pairing; }

    /// Returns the paired device's address; null without one.
    QHostAddress device() const { return m_pairing.isPaired() ? m_device : QHostAddress(); }

    /// Makes another code, and lets go of the paired device.
    void renewCode();

    QString sentence() const { return m_sentence; }

  signals:
    /// The remote was turned on or off, a device was paired, or the code is another one.
    void changed();

  private:
    http::Answer answer(const http::Request& request, const QHostAddress& peer);
    http::Answer page() const;
    http::Answer pair(const http::Request& request, const QHostAddress& peer);
    http::Answer forDevice(const http::Request& request);
    http::Answer press(DeskRemote::Wish wish, const http::Request& request);
    bool isFromHere(const http::Request& request) const;

    DeskRemote m_desk;
    Pairing m_pairing;
    LocalServer m_server;
    quint16 m_port;
    QHostAddress m_device;
    QString m_sentence;
};

} // namespace spherewalk::ui
