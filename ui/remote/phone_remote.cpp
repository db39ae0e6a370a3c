// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/remote/phone_remote.h"

#include "ui/look/words.h"

#include <QFile>
#include <QJsonDocument>
#include <QRandomGenerator>

#include <algorithm>
#include <utility>

/// The linker keeps the resources of a static library only if they are asked for; in no namespace, as Qt
/// wants it.
static void keepPage() {
    Q_INIT_RESOURCE(remote);
}

namespace spherewalk::ui {

namespace {

constexpr std::string_view kCookie = "spherewalk_remote";

/// Headers of every answer: nothing is kept, framed or guessed, and the page loads nothing from elsewhere.
http::Answer guarded(http::Answer answer) {
    answer.headers.insert(answer.headers.end(), {{"Cache-Control", "no-store"},
                                                 {"X-Content-Type-Options", "nosniff"},
                                                 {"X-Frame-Options", "DENY"},
                                                 {"Referrer-Policy", "no-referrer"},
                                                 {"Cross-Origin-Resource-Policy", "same-origin"}});
    return answer;
}

http::Answer json(int status, const QJsonObject& content) {
    return {status, "application/json", QJsonDocument(content).toJson(QJsonDocument::Compact).toStdString()};
}

http::Answer told(int status, const QString& sentence) {
    return json(status, {{"sentence", sentence}});
}

/// The value of this program's cookie; empty without it. Source: RFC 6265, 5.4.
std::string_view cookieIn(std::string_view header) {
    while (!header.empty()) {
        std::string_view pair = header.substr(0, header.find(';'));
        header.remove_prefix(std::min(header.size(), pair.size() + 1));
        pair.remove_prefix(std::min(pair.size(), pair.find_first_not_of(' ')));
        if (pair.size() > kCookie.size() && pair.starts_with(kCookie) && pair[kCookie.size()] == '=') {
            return pair.substr(kCookie.size() + 1);
        }
    }
    return {};
}

/// The press that a body spells, or nothing for any other body.
std::optional<DeskRemote::Press> pressIn(const std::string& body) {
    constexpr qsizetype kLongestId = 64;
    const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(body)).object();
    const DeskRemote::Press press{json["id"].toString(), json["about"].toInteger(-1),
                                  json["seen"].toInteger(-1)};
    const bool isWhole = !press.id.isEmpty() && press.id.size() <= kLongestId && press.about >= 0;
    return isWhole && press.seen >= 0 ? std::optional(press) : std::nullopt;
}

} // namespace

PhoneRemote::PhoneRemote(CaptureDesk& desk, const Clock& clock, quint16 port, QObject* parent)
    : QObject(parent),
      m_desk(desk, clock),
      m_server([this](const http::Request& request, const QHostAddress& peer) {
          return guarded(answer(request, peer));
      }),
      m_port(port) {
    keepPage();
}

void PhoneRemote::turnOn(const QHostAddress& address) {
    m_pairing.renew();
    m_sentence = m_server.open(address, m_port)
                     ? QString()
                     : tr("Could not listen at %1: %2.").arg(address.toString(), m_server.sentence());
    emit changed();
}

void PhoneRemote::turnOff() {
    m_server.close();
    m_pairing.renew();
    emit changed();
}

void PhoneRemote::renewCode() {
    m_pairing.renew();
    emit changed();
}

/// Whether the request names this server as the browser's address line does, and comes from no other site. A
/// name that somebody points at this address (DNS rebinding) is refused.
bool PhoneRemote::isFromHere(const http::Request& request) const {
    const std::string host = m_server.host().toStdString();
    const std::string origin = request.header("Origin");
    return request.header("Host") == host && (origin.empty() || origin == "http://" + host);
}

http::Answer PhoneRemote::answer(const http::Request& request, const QHostAddress& peer) {
    if (!isFromHere(request)) {
        return told(403, tr("This is not the address that the window shows."));
    }
    if (request.method != "GET" && request.method != "POST") {
        return {405, "text/plain", {}};
    }
    const bool isPost = request.method == "POST";
    if (request.path == "/" && !isPost) {
        return page();
    }
    if (request.path == "/pair" && isPost) {
        return pair(request, peer);
    }
    if (!m_pairing.isSession(cookieIn(request.header("Cookie")))) {
        return told(403, tr("This device is not paired."));
    }
    return forDevice(request);
}

http::Answer PhoneRemote::forDevice(const http::Request& request) {
    if (request.method == "GET" && request.path == "/state") {
        QJsonObject state = m_desk.state();
        state["token"] = QString::fromStdString(m_pairing.token());
        return json(200, state);
    }
    if (request.method == "GET" && request.path == "/photo" && !m_desk.photo().isEmpty()) {
        return {200, "image/jpeg", m_desk.photo().toStdString()};
    }
    const bool isShoot = request.path == "/shoot";
    if (request.method == "POST" && (isShoot || request.path == "/again")) {
        return press(isShoot ? DeskRemote::Wish::Shoot : DeskRemote::Wish::TakeAgain, request);
    }
    return {404, "text/plain", {}};
}

http::Answer PhoneRemote::press(DeskRemote::Wish wish, const http::Request& request) {
    if (!m_pairing.isToken(request.header("X-Spherewalk-Token"))) {
        return told(403, tr("This device is not paired."));
    }
    const auto press = pressIn(request.body);
    if (!press) {
        return {400, "text/plain", {}};
    }
    const DeskRemote::Answer answer = m_desk.press(wish, *press);
    return told(answer.isDone ? 200 : 409, answer.sentence);
}

http::Answer PhoneRemote::pair(const http::Request& request, const QHostAddress& peer) {
    switch (m_pairing.pair(request.body)) {
    case Pairing::Answer::Wrong:
        return told(403, tr("The code is wrong."));
    case Pairing::Answer::Void:
        emit changed();
        return told(403, tr("There were too many wrong codes. Make a new code in the window."));
    case Pairing::Answer::Taken:
        return told(403, tr("Another device is the remote. Let go of it in the window first."));
    case Pairing::Answer::Paired:
        break;
    }
    m_device = peer;
    emit changed();
    http::Answer paired = json(200, {});
    paired.headers.emplace_back("Set-Cookie", std::string(kCookie) + "=" + m_pairing.session() +
                                                  "; Path=/; HttpOnly; SameSite=Strict");
    return paired;
}

/// The page, with its words in the window's language. It has no content before the device is paired.
http::Answer PhoneRemote::page() const {
    const QString nonce = QString::number(QRandomGenerator::system()->generate64(), 16);
    const std::pair<QString, QString> words[] = {
        {"language", tr("en", "the code of the language of these words")},
        {"nonce", nonce},
        {"title", tr("Spherewalk: remote")},
        {"pairTitle", tr("Pair this device")},
        {"pairHint", tr("Type the code that the window on the computer shows.")},
        {"code", tr("Code of six digits")},
        {"pair", tr("Pair")},
        {"lastPhoto", tr("Last photo")},
        {"noPhoto", tr("No photo yet.")},
        {"takeAgain", tr("Take it again")},
        {"lost", tr("No connection to the computer. Trying again...")},
        {"unsent", tr("The press did not reach the computer. Press again.")},
        {"good", tr("good")},
        {"doubtful", standingText(Standing::Doubtful)},
        {"failed", standingText(Standing::Failed)},
    };
    QFile file(":/remote/remote.html");
    QString text = file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
    for (const auto& [name, word] : words) {
        text.replace("{{" + name + "}}", word.toHtmlEscaped());
    }
    http::Answer page{200, "text/html; charset=utf-8", text.toStdString()};
    page.headers.emplace_back(
        "Content-Security-Policy",
        QString("default-src 'none'; script-src 'nonce-%1'; style-src 'nonce-%1'; "
                "img-src 'self'; connect-src 'self'; form-action 'none'; base-uri 'none'; "
                "frame-ancestors 'none'")
            .arg(nonce)
            .toStdString());
    return page;
}

} // namespace spherewalk::ui
