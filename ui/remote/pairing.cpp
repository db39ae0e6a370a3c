// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/remote/pairing.h"

#include <QByteArray>
#include <QRandomGenerator>
#include <QString>

#include <array>
#include <cstddef>

namespace spherewalk::ui {

namespace {

std::string randomDigits() {
    constexpr quint32 kCodes = 1'000'000;
    constexpr int kDigits = 6;
    const quint32 number = QRandomGenerator::system()->bounded(kCodes);
    return QString::number(number).rightJustified(kDigits, '0').toStdString();
}

/// 256 bits in hexadecimal digits.
std::string randomSecret() {
    std::array<quint32, 8> words{};
    QRandomGenerator::system()->fillRange(words.data(), words.size());
    return QByteArray::fromRawData(reinterpret_cast<const char*>(words.data()), sizeof words)
        .toHex()
        .toStdString();
}

/// Cost: it depends on the lengths only, which are no secret. An empty text equals none.
bool isSameSecret(std::string_view secret, std::string_view given) {
    if (secret.empty() || secret.size() != given.size()) {
        return false;
    }
    unsigned difference = 0;
    for (std::size_t i = 0; i < secret.size(); ++i) {
        difference |= static_cast<unsigned char>(secret[i]) ^ static_cast<unsigned char>(given[i]);
    }
    return difference == 0;
}

} // namespace

void Pairing::renew() {
    m_session.clear();
    m_token.clear();
    m_code = randomDigits();
    m_triesLeft = kTries;
}

Pairing::Answer Pairing::pair(std::string_view code) {
    if (isPaired()) {
        return Answer::Taken;
    }
    if (m_code.empty()) {
        return Answer::Void;
    }
    if (!isSameSecret(m_code, code)) {
        --m_triesLeft;
        if (m_triesLeft == 0) {
            m_code.clear();
            return Answer::Void;
        }
        return Answer::Wrong;
    }
    m_code.clear();
    m_session = randomSecret();
    m_token = randomSecret();
    return Answer::Paired;
}

bool Pairing::isSession(std::string_view given) const {
    return isSameSecret(m_session, given);
}

bool Pairing::isToken(std::string_view given) const {
    return isSameSecret(m_token, given);
}

} // namespace spherewalk::ui
