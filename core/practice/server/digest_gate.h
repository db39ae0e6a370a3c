// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <string_view>

namespace spherewalk::practice {

/// HTTP digest authentication of a camera in client mode: MD5, qop=auth, nonces that end, and counters that
/// are good once. Source: RFC 7616. Threads: any.
class DigestGate {
  public:
    /// user: empty to let everybody pass. nonceRequests: each nonce is good for so many requests; 0: for
    /// ever.
    DigestGate(std::string realm, std::string user, std::string password, int nonceRequests,
               std::uint64_t seed);

    /// The value of "WWW-Authenticate" for a 401, or "" if the request may pass. authorization: the request's
    /// header of this name, or "". uri: path and query of the request.
    std::string challenge(std::string_view method, std::string_view uri, const std::string& authorization);

    /// Makes all nonces so far stale.
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
    std::mutex m_mutex; ///< Guards all below.
    std::uint64_t m_count;
    std::string m_nonce;
    std::set<std::string> m_countersSeen; ///< Client nonces with their counters, of this nonce.
};

} // namespace spherewalk::practice
