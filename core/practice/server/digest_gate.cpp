// SPDX-License-Identifier: GPL-3.0-or-later
#include "server/digest_gate.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/base/fixed_random.h"
#include "spherewalk/base/text.h"

#include <utility>

namespace spherewalk::practice {

namespace {

constexpr std::string_view kScheme = "Digest ";

std::string md5Of(std::string_view words) {
    return md5Hex(bytesOf(words));
}

/// The names and values of: name="value", name=value, ...
std::map<std::string, std::string> fieldsOf(std::string_view header) {
    std::map<std::string, std::string> fields;
    while (!header.empty()) {
        const std::size_t begin = header.find_first_not_of(", ");
        const std::size_t equals = header.find('=');
        if (begin == std::string_view::npos || equals == std::string_view::npos || begin > equals) {
            break;
        }
        const std::string name(header.substr(begin, equals - begin));
        header.remove_prefix(equals + 1);
        const bool isQuoted = header.starts_with('"');
        header.remove_prefix(isQuoted ? 1 : 0);
        const std::size_t end = std::min(header.find(isQuoted ? '"' : ','), header.size());
        fields[name] = header.substr(0, end);
        header.remove_prefix(std::min(end + 1, header.size()));
    }
    return fields;
}

} // namespace

DigestGate::DigestGate(std::string realm, std::string user, std::string password, int nonceRequests,
                       std::uint64_t seed)
    : m_realm(std::move(realm)),
      m_user(std::move(user)),
      m_password(std::move(password)),
      m_nonceRequests(nonceRequests),
      m_count(FixedRandom(seed, 0xd19e57).next()) {
    makeNonce();
}

void DigestGate::makeNonce() {
    m_nonce = md5Of(text("nonce ", m_count++));
    m_countersSeen.clear();
}

void DigestGate::renew() {
    const std::scoped_lock lock(m_mutex);
    makeNonce();
}

DigestGate::Verdict DigestGate::judge(std::string_view method, std::string_view uri,
                                      const std::map<std::string, std::string>& given) {
    const auto field = [&](const char* name) {
        const auto found = given.find(name);
        return found == given.end() ? std::string() : found->second;
    };
    const std::string secret = md5Of(text(m_user, ":", m_realm, ":", m_password));
    const std::string asked = md5Of(text(method, ":", field("uri")));
    const std::string expected = md5Of(text(secret, ":", field("nonce"), ":", field("nc"), ":",
                                            field("cnonce"), ":", field("qop"), ":", asked));
    const bool isRight = field("username") == m_user && field("realm") == m_realm && field("qop") == "auth" &&
                         field("uri") == uri && field("nc").size() == 8 && field("response") == expected;
    if (!isRight) {
        return Verdict::Wrong;
    }
    const std::string counter = field("cnonce") + field("nc");
    const bool isSpent =
        m_nonceRequests > 0 && m_countersSeen.size() >= static_cast<std::size_t>(m_nonceRequests);
    if (field("nonce") != m_nonce || isSpent || !m_countersSeen.insert(counter).second) {
        return Verdict::Stale;
    }
    return Verdict::Good;
}

std::string DigestGate::challenge(std::string_view method, std::string_view uri,
                                  const std::string& authorization) {
    if (m_user.empty()) {
        return {};
    }
    const std::scoped_lock lock(m_mutex);
    const bool isAnswer = authorization.starts_with(kScheme);
    const Verdict verdict =
        isAnswer ? judge(method, uri, fieldsOf(std::string_view(authorization).substr(kScheme.size())))
                 : Verdict::Wrong;
    if (verdict == Verdict::Good) {
        return {};
    }
    if (verdict == Verdict::Stale) {
        makeNonce();
    }
    return text("Digest realm=\"", m_realm, "\", nonce=\"", m_nonce, "\", qop=\"auth\", algorithm=MD5",
                verdict == Verdict::Stale ? ", stale=true" : "");
}

} // namespace spherewalk::practice
