// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <string_view>

namespace spherewalk::practice {

/// Lets requests in by HTTP digest authentication, as a camera in client mode does: MD5, qop=auth, nonces
/// that end, counters that must grow. Source: RFC 7616. Threads: any.
class DigestGate {
  public:
    /// user: empty to let everybody in. nonceRequests: how often a nonce is good; 0: for ever.
    DigestGate(std::string realm, std::string user, std::string password, int nonceRequests,
               std::uint64_t seed);

    /// What the "WWW-Authenticate" of a 401 must say; "" if the request may pass. authorization: its header
    /// of this name, or "". uri: path and query.
    std::string challenge(std::string_view method, std::string_view uri, const std::string& authorization);

    /// No nonce that was given out is good any longer.
    void renew();

  private:
    enum class Verdict { Good, Stale, Wrong };

    Verdict judge(std::string_view method, std::string_view uri,
                  const std::map<std::string, std::string>& given);
    void makeNonce();

    std::string m_realm;
    std::string m_user;
    std::string m_password;
    int m_nonceRequests;
    std::mutex m_mutex; ///< guards all below
    std::uint64_t m_count;
    std::string m_nonce;
    std::set<std::string> m_countersSeen; ///< of this nonce, with the client's own
};

} // namespace spherewalk::practice
