// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "capture_fixture.h"
#include "manual_clock.h"
#include "ui/remote/phone_remote.h"
#include "ui/remote/remote_form.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QPushButton>
#include <QTcpSocket>
#include <QTest>
#include <QUrl>

#include <memory>
#include <stdexcept>

namespace spherewalk::ui {

/// What a server has answered before it closed the connection.
struct Reply {
    int status = 0; ///< 0: the connection was closed without an answer.
    QByteArray head;
    QByteArray body;

    QJsonObject json() const { return QJsonDocument::fromJson(body).object(); }

    QString sentence() const { return json()["sentence"].toString(); }
};

/// Sends these bytes, and returns what comes until the connection ends. The event loop runs meanwhile.
inline Reply sendRaw(const QUrl& server, const QByteArray& bytes) {
    QTcpSocket socket;
    socket.connectToHost(server.host(), static_cast<quint16>(server.port()));
    socket.write(bytes);
    constexpr int kMostMs = 100'000;
    QByteArray received;
    QObject::connect(&socket, &QTcpSocket::readyRead, [&] { received += socket.readAll(); });
    if (!QTest::qWaitFor([&] { return socket.state() == QAbstractSocket::UnconnectedState; }, kMostMs)) {
        throw std::runtime_error("the server keeps the connection");
    }
    const qsizetype end = received.indexOf("\r\n\r\n");
    return {received.mid(9, 3).toInt(), received.left(end), end < 0 ? QByteArray() : received.mid(end + 4)};
}

/// A browser on another device, with its cookie.
class Phone {
  public:
    explicit Phone(const QString& url) : m_url(url) {}

    /// Types another address, and keeps the cookie.
    void goTo(const QString& url) { m_url = url; }

    Reply get(const QByteArray& path) const { return send("GET", path, {}, {}); }

    Reply post(const QByteArray& path, const QByteArray& body, const QByteArray& headers = {}) const {
        return send("POST", path, body, headers);
    }

    Reply pair(const std::string& code) {
        const Reply reply = post("/pair", QByteArray::fromStdString(code));
        const qsizetype at = reply.head.indexOf("Set-Cookie: ");
        if (at >= 0) {
            const QByteArray cookie = reply.head.mid(at + 12);
            m_cookie = "Cookie: other=1; " + cookie.left(cookie.indexOf(';')) + "\r\n";
        }
        return reply;
    }

    /// What the page would show. It is of the paired device only.
    QJsonObject look() {
        const QJsonObject state = get("/state").json();
        m_token = "X-Spherewalk-Token: " + state["token"].toString().toUtf8() + "\r\n";
        return state;
    }

    static QByteArray press(const QString& id, const QJsonValue& about, const QJsonObject& state) {
        return QJsonDocument(QJsonObject{{"id", id}, {"about", about}, {"seen", state["seen"]}}).toJson();
    }

    Reply shoot(const QString& id, const QJsonObject& state) {
        return post("/shoot", press(id, state["turn"], state), m_token);
    }

    Reply again(const QString& id, const QJsonObject& state) {
        return post("/again", press(id, state["latest"].toObject()["photo"], state), m_token);
    }

  private:
    Reply send(const QByteArray& method, const QByteArray& path, const QByteArray& body,
               const QByteArray& headers) const {
        const QByteArray host = m_url.authority().toUtf8();
        const QByteArray length = QByteArray::number(body.size());
        return sendRaw(m_url, method + " " + path + " HTTP/1.1\r\nHost: " + host + "\r\nContent-Length: " +
                                  length + "\r\n" + m_cookie + headers + "\r\n" + body);
    }

    QUrl m_url;
    QByteArray m_cookie;
    QByteArray m_token;
};

/// The capture page with a remote that was turned on through its form.
class RemoteFixture : public CaptureFixture {
  protected:
    RemoteFixture() {
        form.show();
        press("toggleRemote");
    }

    void press(const char* button) { form.findChild<QPushButton*>(button)->click(); }

    QString label(const char* name) const { return form.findChild<QLabel*>(name)->text(); }

    /// Returns the code as a person reads it.
    std::string code() const { return label("remoteCode").remove(' ').toStdString(); }

    Phone pairedPhone() {
        Phone phone(label("remoteAddress"));
        EXPECT_EQ(phone.pair(code()).status, 200);
        return phone;
    }

    std::int64_t exposures() { return desk().practice()->camera().stats().exposures; }

    /// Starts a run and waits for its first station.
    void begin() {
        connectPractice();
        desk().trigger();
        waitFor(CaptureDesk::State::AtStation);
    }

    /// Waits until the cart may be brought to the next station, with this many photos told.
    void waitForPhotos(std::size_t photos) {
        waitUntil([&] { return desk().state() == CaptureDesk::State::AtStation && played.size() == photos; });
    }

    test::ManualClock clock;
    PhoneRemote remote{desk(), clock, 0}; // at a port of its own: tests run beside each other
    RemoteForm form{remote, {QHostAddress(QHostAddress::LocalHost)}};
};

} // namespace spherewalk::ui
