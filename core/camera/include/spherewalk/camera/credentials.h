// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <mutex>
#include <optional>
#include <string>

namespace spherewalk::camera {

/// By which a camera in client mode knows its users.
struct Credentials {
    std::string user;
    std::string password;

    bool operator==(const Credentials&) const = default;
};

/// Asked when a camera wants to know who asks, and again when it does not accept what was said: from a
/// keychain, the environment, a person. Nothing: there are none. Threads: the client's.
using CredentialsSource = std::function<std::optional<Credentials>()>;

/// What all clients of one camera have been told. Threads: any, also at a time.
class CredentialsMemory {
  public:
    void set(const Credentials& credentials);

    /// Nothing if there is nothing newer than what this client was given last. given: of the client, 0 at
    /// first, and counted on here.
    std::optional<Credentials> newer(int& given) const;

  private:
    mutable std::mutex m_mutex;
    std::optional<Credentials> m_credentials;
    int m_revision = 0;
};

/// A source whose copies ask once for all of them, and anew only after a refusal. ask: one at a time.
CredentialsSource rememberingCredentials(CredentialsSource ask);

} // namespace spherewalk::camera
